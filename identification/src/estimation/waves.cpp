#include "waves.hpp"

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

detail::Waves detail::waves_in(const Recording& run, double time_unit) {
  const auto channel = run.has(Channel::r) ? Channel::r : Channel::psi;
  if (!run.has(channel) || run.samples() < 50) return {};
  const auto rest = rest_of(run.time, run[channel], half_of_the_steady * time_unit);
  const double h = (run.time.back() - run.time.front()) / static_cast<double>(run.samples() - 1);
  const auto longest = std::min(rest.size() / 3, static_cast<std::size_t>(0.7 * time_unit / h));
  double variance = 0.0;
  for (const double x : rest) variance += x * x;
  std::vector<double> correlation;
  for (std::size_t lag = 0; lag <= longest; ++lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < rest.size(); ++i) sum += rest[i] * rest[i - lag];
    correlation.push_back(sum / variance);
  }
  constexpr double oscillates = 0.3, comes_back = 0.15;
  // on board of simulated ships in waves −0.69 to −0.95 and 0.25 to 0.88, but in a following sea that hardly turns her;
  // of the noise of smoothed gyros alone −0.31 to −0.65 and −0.02 to 0.29
  constexpr double clearly_oscillates = 0.67, clearly_comes_back = 0.24;
  const auto lowest = std::ranges::min_element(correlation);
  const auto whole = std::max_element(lowest, correlation.end());
  const auto reach = [&](double down, double up) { return -*lowest > down && *whole > up; };
  if (!reach(oscillates, comes_back)) return {};
  return {.period = h * static_cast<double>(whole - correlation.begin()),
          .clear = reach(clearly_oscillates, clearly_comes_back)};
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
  for (const auto& wave : detail::oscillations(few, of_every(as_many, few.time), time_unit, waves.period))
    oscillations_.push_back({wave.period, wave.half});
  times_ = std::move(few.time);
}

double WaveMotion::size_in(std::span<const double> values) const {
  if (values.empty() || !exists()) return 0.0;
  const auto shown = of_every(every_, values);
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
