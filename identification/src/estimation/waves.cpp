#include "waves.hpp"

#include "swayaw/core/detail/median.hpp"

namespace swayaw::inline identification {
using namespace detail;

std::vector<double> detail::rest_of(const std::vector<double>& time, std::span<const double> values, double half) {
  std::vector<double> rest(time.size(), 0.0);
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double now = time[k];
    if (std::isnan(values[k])) continue;
    const auto p = parabola(time, values, samples_between(time, now - half, now + half), now, half);
    if (!std::isnan(p.value)) rest[k] = values[k] - p.value;
  }
  return rest;
}

double detail::median_rest(const std::vector<double>& time, std::span<const double> values, double half) {
  const auto rest = rest_of(time, values, half);
  std::vector<double> there;
  for (std::size_t k = 0; k < rest.size(); ++k)
    if (!std::isnan(values[k])) there.push_back(rest[k]);
  return core::detail::median_size_of(std::move(there));
}

namespace {

/// What comes back of an autocorrelation after half a period, and after a whole one, from which on something
/// oscillates.
struct Reach {
  double down, up;
};

/// Of anything: noise of waves, if it is one.
constexpr Reach oscillates{0.3, 0.15};

/// Of waves alone. On board of simulated ships in waves −0.69 to −0.95 and 0.25 to 0.88, but in a following sea that
/// hardly turns her; of the noise of smoothed gyros alone −0.31 to −0.65 and −0.02 to 0.29.
constexpr Reach clearly_oscillates{0.67, 0.24};

/// The same beside parabolas that are twice as long: zigzags and turns of 52 such ships in calm water −0.64 and 0.24 at
/// most; in waves of 0.6 to 1 L/U most of −0.67 to −0.93 and 0.3 to 0.82.
constexpr Reach clearly_oscillates_long{0.67, 0.3};

/// Waves that show beside parabolas.
/// @param half     of the parabolas, over L/U
/// @param clearly  what tells them from anything else
detail::Waves waves_beside(const Recording& run, Channel channel, double time_unit, double half, const Reach& clearly) {
  const auto rest = rest_of(run.time, run[channel], half * time_unit);
  const double h = (run.time.back() - run.time.front()) / static_cast<double>(run.samples() - 1);
  const auto longest = std::min(rest.size() / 3, static_cast<std::size_t>(2.0 * half * time_unit / h));
  double variance = 0.0;
  for (const double x : rest) variance += x * x;
  std::vector<double> correlation;
  for (std::size_t lag = 0; lag <= longest; ++lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < rest.size(); ++i) sum += rest[i] * rest[i - lag];
    correlation.push_back(sum / variance);
  }
  const auto lowest = std::ranges::min_element(correlation);
  const auto whole = std::max_element(lowest, correlation.end());
  const auto reaches = [&](const Reach& some) { return -*lowest > some.down && *whole > some.up; };
  if (!reaches(oscillates)) return {};
  return {.period = h * static_cast<double>(whole - correlation.begin()), .clear = reaches(clearly), .half = half};
}

}  // namespace

detail::Waves detail::waves_in(const Recording& run, double time_unit) {
  const auto channel = run.has(Channel::r) ? Channel::r : Channel::psi;
  if (!run.has(channel) || run.samples() < 50) return {};
  const auto found = waves_beside(run, channel, time_unit, half_of_the_steady, clearly_oscillates);
  // of half the parabola: it takes most of longer waves with it, of those of 2.1 of it four fifths
  constexpr double followed = 1.6;
  if (found.clear && found.period < followed * half_of_the_steady * time_unit) return found;
  const auto longer = waves_beside(run, channel, time_unit, 2.0 * half_of_the_steady, clearly_oscillates_long);
  return longer.clear ? longer : found;
}

std::vector<detail::Oscillation> detail::oscillations(const Recording& run, const std::vector<double>& times,
                                                      double time_unit, double mean) {
  constexpr int steps = 6;               // of an eighth each, to half and to twice the mean period
  constexpr double least_samples = 3.5;  // in a period
  const auto values = run[run.has(Channel::r) ? Channel::r : Channel::psi];
  const double begin = run.time.front(), end = run.time.back(),
               half = std::min(0.5 * (end - begin), half_of_the_steady * time_unit),
               h = (end - begin) / static_cast<double>(run.samples() - 1);
  std::vector<Oscillation> found;
  for (const double now : times) {
    const double middle = std::clamp(now, begin + half, end - half);
    const auto window = samples_between(run.time, middle - half, middle + half);
    double best = 0.0, least = HUGE_VAL;
    for (int step = -steps; step <= steps; ++step) {
      const double period = mean * std::exp2(static_cast<double>(step) / steps);
      if (period < least_samples * h) continue;
      const auto p = parabola<5>(run.time, values, window, middle, half, period);
      if (!std::isnan(p.value) && p.residual < least) least = p.residual, best = period;
    }
    if (best < 2.0 * half) found.push_back({best, std::min(half_beside_waves * best, half_of_the_steady * time_unit)});
    else found.emplace_back();
  }
  return found;
}

namespace {

constexpr std::size_t as_many = 6;  // samples in which she meets waves as often

std::vector<double> of_every(std::size_t every, std::span<const double> all) {
  std::vector<double> some;
  for (std::size_t k = 0; k < all.size(); k += every) some.push_back(all[k]);
  return some;
}

}  // namespace

WaveMotion::WaveMotion(const Recording& run, double time_unit) {
  constexpr double enough = 48.0;  // samples in L/U: waves of L/U/8 have six
  every_ = std::max<std::size_t>(1, static_cast<std::size_t>(rows_in(run, time_unit) / enough));
  Recording few{.name = run.name, .facts = {}, .time = of_every(every_, run.time), .channels = {}, .extra = {}};
  for (const auto yaw : {Channel::r, Channel::psi}) few.channels[index_of(yaw)] = of_every(every_, run[yaw]);
  const auto waves = waves_in(few, time_unit);
  if (!waves.clear) return;
  if (waves.half > half_of_the_steady) half_ = waves.half * time_unit;
  else oscillations_ = detail::oscillations(few, of_every(as_many, few.time), time_unit, waves.period);
  times_ = std::move(few.time);
}

double WaveMotion::size_in(std::span<const double> values) const {
  if (values.empty() || !exists()) return 0.0;
  const auto shown = of_every(every_, values);
  if (half_ > 0.0) return median_rest(times_, shown, half_);
  double squares = 0.0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const double now = times_[k];
    const auto [period, half] = oscillations_[k / as_many];
    if (std::isnan(shown[k]) || !(period > 0.0)) continue;
    const auto p = parabola<5>(times_, shown, samples_between(times_, now - half, now + half), now, half, period);
    if (!std::isnan(p.value)) squares += std::pow(shown[k] - p.value, 2);
  }
  return std::sqrt(squares / static_cast<double>(shown.size()));
}

}  // namespace swayaw::identification
