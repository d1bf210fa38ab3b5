#include <algorithm>
#include <cmath>

#include "prepared_runs.hpp"
#include "swayaw/core/detail/over_ground.hpp"
#include "waves.hpp"

/// Runs with as few samples as tell what they tell: means over times that are short for the ship and long for the
/// errors of instruments.
namespace swayaw::inline identification {
using namespace detail;
namespace {

/// How many rows and values of a channel are kept in the time L/U, and rows of controls if more.
struct Density {
  double rows, values, controls;
};

/// Where instruments have errors with a memory, and where fast effects are told without them. With 20 rows instead of 8
/// the same effects came out of twice the time.
constexpr Density beside_memory{.rows = 8.0, .values = 8.0, .controls = 24.0},
    beside_white_noise{.rows = 24.0, .values = 24.0, .controls = 24.0};

/// Means over the time between rows that are kept of every so many, half of it before and half after each.
std::vector<double> means(std::span<const double> values, std::size_t every) {
  std::vector<double> result;
  const auto last = std::ssize(values) - 1, half = static_cast<std::ptrdiff_t>(every / 2);
  for (std::ptrdiff_t middle = 0; middle <= last; middle += static_cast<std::ptrdiff_t>(every)) {
    double sum = 0.0, weights = 0.0;
    for (auto i = std::max<std::ptrdiff_t>(0, middle - half); i <= std::min(last, middle + half); ++i) {
      const double value = values[static_cast<std::size_t>(i)];
      const bool shared = every % 2 == 0 && std::abs(i - middle) == half;  // with the row beside it
      const double weight = shared ? 0.5 : 1.0;
      if (!std::isnan(value)) sum += weight * value, weights += weight;
    }
    result.push_back(weights > 0.0 ? sum / weights : missing);
  }
  return result;
}

/// The true wind, its velocity the mean.
void average_wind(const Recording& run, std::size_t every, Recording& fewer) {
  const auto speed = run[Channel::wind_speed], from = run[Channel::wind_from];
  if (speed.empty() || from.empty()) return;
  std::vector<double> north, east;
  for (std::size_t i = 0; i < run.samples(); ++i)
    north.push_back(speed[i] * std::cos(from[i])), east.push_back(speed[i] * std::sin(from[i]));
  north = means(north, every), east = means(east, every);
  for (std::size_t k = 0; k < fewer.samples(); ++k) {
    fewer.channels[index_of(Channel::wind_speed)][k] = std::hypot(north[k], east[k]);
    fewer.channels[index_of(Channel::wind_from)][k] = std::atan2(east[k], north[k]);
  }
}

/// Every so many rows are kept, two at least; controls and wind are means.
Recording with_fewer_rows(const Recording& run, double time_unit, double rows_kept) {
  const double rows = rows_in(run, time_unit);
  const double step = std::min(std::round(rows / rows_kept), static_cast<double>(run.samples()) - 1.0);
  if (!(step >= 2.0)) return run;
  const auto every = static_cast<std::size_t>(step);
  const auto thinned = [&](const std::vector<double>& all) {
    std::vector<double> some;
    for (std::size_t k = 0; k < all.size(); k += every) some.push_back(all[k]);
    return some;
  };
  Recording fewer{.name = run.name, .facts = run.facts, .time = thinned(run.time), .channels = {}, .extra = {}};
  std::ranges::transform(run.channels, fewer.channels.begin(), thinned);
  for (const auto control : {Channel::delta, Channel::delta_order, Channel::rev, Channel::thrust, Channel::torque})
    if (run.has(control)) fewer.channels[index_of(control)] = means(run[control], every);
  average_wind(run, every, fewer);
  return fewer;
}

/// Without what a receiver makes of its own positions: velocities over ground are slopes of the same track, as late as
/// it is, and along the ship's axes they were turned by the recorded heading, right or wrong.
std::vector<Channel> own_channels(std::span<const Channel> channels) {
  std::vector<Channel> own(channels.begin(), channels.end());
  if (std::ranges::count(own, Channel::x) > 0 && std::ranges::count(own, Channel::y) > 0)
    std::erase_if(own, [](Channel c) { return std::ranges::count(core::detail::velocities_over_ground, c) > 0; });
  return own;
}

/// When samples are taken, and over which time.
struct Sampling {
  double spacing, half;  ///< [s], half of a window
  double interval;       ///< of the channel [s]
};

/// @param row   time between rows [s]: the next to one is as good
/// @param wave  period of waves that move the ship [s], or 0
Sampling sampling_of(const Recording& run, Channel channel, double time_unit, double values, double row, double wave) {
  constexpr double about_half = 0.48;  // of the spacing: windows hardly overlap
  const double duration = run.time.back() - run.time.front(),
               there =
                   static_cast<double>(std::ranges::count_if(run[channel], [](double x) { return !std::isnan(x); })),
               interval = duration / std::max(1.0, there - 1.0);
  return {.spacing = std::max(time_unit / values - 0.5 * row, 0.75 * wave),
          .half = std::min(0.5 * duration, std::max(about_half * time_unit / values, 2.05 * interval)),
          .interval = interval};
}

/// Few values of a channel at the rows of a run, missing between them, and what tells their noise.
struct FewSamples {
  std::vector<double> values;
  Eigen::Index kept = 0;
  double residual = 0.0;  ///< sum of squares about the parabolas
  double freedom = 0.0;
  double samples = 0.0;  ///< in all windows

  /// The value of a parabola in the middle of n samples has 9/4n of their variance.
  /// @param least  standard deviation of a sample that is believed without the residuals
  double deviation(double least) const {
    const double white = freedom > 0.0 ? std::sqrt(residual / freedom) : least;
    const double n = std::max(5.0, kept > 0 ? samples / static_cast<double>(kept) : 5.0);
    return std::max(white, least) * std::sqrt(9.0 / (4.0 * n));
  }
};

bool any_there(std::span<const double> values, const Window& window) {
  return std::ranges::any_of(values.subspan(window.first, window.last - window.first),
                             [](double x) { return !std::isnan(x); });
}

/// From the middle of a parabola on to its end, over half of its length, its value is as sure as in the middle or
/// surer; at the end itself it has four times the variance, and all of a third derivative. Beside process noise that
/// changes in each step such values at the last row of a turn were a yaw moment eight times what was missing all along.
/// Positions keep theirs: a third derivative is little to them, and where a track begins and ends tells most of a
/// stream.
constexpr double near_end = 0.7;

/// @param waves  at each row; or nothing
FewSamples few_samples(const Recording& full, Channel channel, const std::vector<double>& rows, const Sampling& by,
                       const std::vector<Oscillation>& waves) {
  FewSamples few{.values = std::vector(rows.size(), missing)};
  const double begin = full.time.front(), end = full.time.back();
  double next = begin;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double now = rows[k];
    if (now < next) continue;
    const auto near = samples_between(full.time, now - by.interval, now + by.interval);
    if (!any_there(full[channel], near)) continue;  // in a gap
    const auto wave = waves.empty() ? Oscillation() : waves[k];
    const double half = std::min(0.5 * (end - begin), std::max(by.half, wave.half)),
                 middle = std::clamp(now, begin + half, end - half);  // near either end on one side
    if (dimension_of(channel) != Dimension::length && std::abs(now - middle) > near_end * half) continue;
    const auto window = samples_between(full.time, middle - half, middle + half);
    const auto p = wave.period > 0.0 ? parabola<5>(full.time, full[channel], window, now, half, wave.period)
                                     : parabola(full.time, full[channel], window, now, half);
    if (std::isnan(p.value)) continue;
    few.values[k] = p.value;
    few.residual += p.residual, few.freedom += p.freedom;
    few.samples += static_cast<double>(p.samples), ++few.kept;
    next = now + by.spacing;
  }
  return few;
}

/// Noise of a channel that waves move: they move her as a whole, and at samples three quarters of a period apart
/// that is as good as noise. Motion of the ship for a few seconds does not count.
/// @param half  of parabolas beside which they show [s]
double noise_of_waves(const Recording& run, Channel channel, double half) {
  return 1.4826 * median_rest(run.time, run[channel], half);
}

PreparedRun thinned(PreparedRun run, double time_unit, const Density& density, const Waves& waves) {
  const auto& full = *run.run;
  auto fewer = with_fewer_rows(full, time_unit, density.rows);
  run.measurements = 0;
  const double row = fewer.time[1] - fewer.time[0];
  const bool left_out = waves.clear && waves.are_short(time_unit);
  const auto beside = left_out ? oscillations(full, fewer.time, time_unit, waves.period) : std::vector<Oscillation>();
  for (const auto channel : run.channels) {
    auto samples = few_samples(full, channel, fewer.time,
                               sampling_of(full, channel, time_unit, density.values, row, waves.period), beside);
    auto& deviation = run.deviation[index_of(channel)];
    deviation = samples.deviation(deviation);
    if (waves.period > 0.0 && !left_out)
      deviation = std::max(deviation, noise_of_waves(full, channel, waves.half * time_unit));
    run.measurements += samples.kept;
    fewer.channels[index_of(channel)] = std::move(samples.values);
  }
  if (density.controls > density.rows && fewer.samples() < full.samples())
    run.finer_controls = std::make_shared<const Recording>(with_fewer_rows(full, time_unit, density.controls));
  run.run = std::make_shared<const Recording>(std::move(fewer));
  return run;
}

}  // namespace

std::vector<PreparedRun> lean_runs(const Ship& ship, std::span<const Recording> runs,
                                   std::span<const Channel> channels) {
  const double time_unit = time_unit_of(ship);
  auto prepared = runs_with_all_samples(ship, runs, own_channels(channels));
  for (auto& run : prepared) {
    const auto waves = waves_in(*run.run, time_unit);
    run.longest_step = 1.0 / beside_memory.rows;
    run = thinned(std::move(run), time_unit, beside_memory, waves);
    thin_heel(run, time_unit);
  }
  return prepared;
}

std::vector<PreparedRun> thinned_runs(const Ship& ship, std::span<const Recording> runs,
                                      std::span<const Channel> channels) {
  const double time_unit = time_unit_of(ship);
  auto prepared = runs_with_all_samples(ship, runs, channels);
  for (auto& run : prepared) {
    if (rows_in(*run.run, time_unit) > 2.0 * beside_white_noise.rows)
      run = thinned(std::move(run), time_unit, beside_white_noise, {});
    thin_heel(run, time_unit);
  }
  return prepared;
}

}  // namespace swayaw::identification
