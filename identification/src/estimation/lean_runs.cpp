#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "../compatibility/channel_character.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/detail/median.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Runs with as few samples as tell what they tell: means over times that are short for the ship and long for the
/// errors of instruments.
namespace swayaw::inline identification {
using namespace detail;
namespace {

/// A parabola through samples about a time, by least squares.
struct Parabola {
  double value = missing;  ///< at that time
  double residual = 0.0;   ///< sum of squares
  std::size_t samples = 0;
};

/// Samples from `first` to before `last` that are there, about a time, over half a window.
Parabola parabola(const std::vector<double>& time, std::span<const double> values, std::size_t first, std::size_t last,
                  double about, double half) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double squares = 0.0;
  Parabola p;
  for (std::size_t i = first; i < last; ++i) {
    if (std::isnan(values[i])) continue;
    const double s = (time[i] - about) / half, y = values[i] - values[(first + last) / 2];
    const Eigen::Vector3d row{1.0, s, s * s};
    A += row * row.transpose(), b += row * y, squares += y * y;
    ++p.samples;
  }
  const double middle = values[(first + last) / 2];
  if (p.samples < 5 || std::isnan(middle)) return p;
  const Eigen::Vector3d c = A.ldlt().solve(b);
  p.value = c[0] + middle;
  p.residual = std::max(0.0, squares - b.dot(c));
  return p;
}

/// What a parabola over ± half leaves of each sample; 0 where there is none.
std::vector<double> rest_of(const Recording& run, Channel channel, double half) {
  const auto values = run[channel];
  std::vector<double> rest(run.samples(), 0.0);
  std::size_t first = 0, last = 0;
  for (std::size_t k = 0; k < run.samples(); ++k) {
    while (run.time[first] < run.time[k] - half) ++first;
    while (last < run.samples() && run.time[last] <= run.time[k] + half) ++last;
    if (std::isnan(values[k])) continue;
    const auto p = parabola(run.time, values, first, last, run.time[k], half);
    if (!std::isnan(p.value)) rest[k] = values[k] - p.value;
  }
  return rest;
}

/// Half of the time over which a parabola follows a ship but not the waves that move her, over L/U.
constexpr double half_of_the_steady = 0.35;

/// Period of the waves that a ship's yaw rate shows [s]; 0 where there are none.
///
/// What a parabola over most of L/U leaves of the yaw rate oscillates by itself where the sea moves her: its
/// autocorrelation is negative after half a period and positive after a whole one.
double wave_period(const Recording& run, double time_unit) {
  const auto channel = run.has(Channel::r) ? Channel::r : Channel::psi;
  if (!run.has(channel) || run.samples() < 50) return 0.0;
  const auto rest = rest_of(run, channel, half_of_the_steady * time_unit);
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
  const auto lowest = std::ranges::min_element(correlation);
  if (!(*lowest < -oscillates)) return 0.0;
  const auto whole = std::max_element(lowest, correlation.end());
  return *whole > comes_back ? h * static_cast<double>(whole - correlation.begin()) : 0.0;
}

/// Standard deviation by the median of sizes: motion of the ship for a few seconds does not count.
double usual_size(std::vector<double> rest) {
  for (double& x : rest) x = std::abs(x);
  return 1.4826 * core::detail::median_of(std::move(rest));
}

constexpr double rows_kept = 20.0;  ///< in the time L/U

/// Every so many rows are kept.
Recording with_fewer_rows(const Recording& run, double time_unit) {
  const double rows = static_cast<double>(run.samples()) / (run.time.back() - run.time.front()) * time_unit;
  const auto every = static_cast<std::size_t>(std::lround(rows / rows_kept));
  if (every < 2) return run;
  const auto thinned = [&](const std::vector<double>& all) {
    std::vector<double> some;
    for (std::size_t k = 0; k < all.size(); k += every) some.push_back(all[k]);
    return some;
  };
  Recording fewer{.name = run.name, .facts = run.facts, .time = thinned(run.time), .channels = {}, .extra = {}};
  std::ranges::transform(run.channels, fewer.channels.begin(), thinned);
  return fewer;
}

/// Without what a receiver makes of its own positions: velocities over ground are slopes of the same track, as late as
/// it is, and along the ship's axes they were turned by the recorded heading, right or wrong.
std::vector<Channel> own_channels(std::span<const Channel> channels) {
  std::vector<Channel> own(channels.begin(), channels.end());
  if (std::ranges::count(own, Channel::x) > 0 && std::ranges::count(own, Channel::y) > 0)
    std::erase_if(own, [](Channel c) {
      return c == Channel::u_ground || c == Channel::v_ground || c == Channel::speed_over_ground ||
             c == Channel::course_over_ground;
    });
  return own;
}

}  // namespace

std::vector<PreparedRun> lean_runs(const Ship& ship, std::span<const Recording> runs,
                                   std::span<const Channel> channels) {
  constexpr double usual_spacing = 0.125, usual_half_window = 0.06;  // of L/U
  const double time_unit = length(ship) / service_speed(ship);
  const auto used = own_channels(channels);
  auto prepared = prepared_runs(ship, runs, used);
  for (auto& run : prepared) {
    const auto& full = *run.run;
    const double begin = full.time.front(), end = full.time.back(),
                 step = (end - begin) / static_cast<double>(full.samples() - 1);
    auto lean = with_fewer_rows(full, time_unit);
    run.longest_step = 1.0 / rows_kept;
    run.measurements = 0;
    const double wave = wave_period(full, time_unit), spacing = std::max(usual_spacing * time_unit, 0.75 * wave),
                 half = std::min(0.5 * (end - begin), std::max(usual_half_window * time_unit, 2.05 * step));
    for (const auto channel : run.channels) {
      const auto values = full[channel];
      const auto out = lean.fill(channel);
      std::ranges::fill(out, missing);
      std::size_t first = 0, last = 0;
      double next = begin, residual = 0.0, freedom = 0.0, samples = 0.0, kept = 0.0;
      for (std::size_t k = 0; k < lean.samples(); ++k) {
        const double now = lean.time[k];
        if (now < next) continue;
        const double middle = std::clamp(now, begin + half, end - half);  // at either end on one side
        while (full.time[first] < middle - half) ++first;
        while (last < full.samples() && full.time[last] <= middle + half) ++last;
        const auto p = parabola(full.time, values, first, last, now, half);
        if (std::isnan(p.value)) continue;
        out[k] = p.value;
        residual += p.residual, freedom += static_cast<double>(p.samples) - 3.0,
            samples += static_cast<double>(p.samples), ++kept;
        next = now + spacing;
      }
      run.measurements += static_cast<Eigen::Index>(kept);
      auto& deviation = run.deviation[index_of(channel)];
      // the value of a parabola in the middle of n samples has 9/4n of their variance
      const double white = kept > 0.0 && freedom > 0.0 ? std::sqrt(residual / freedom) : deviation;
      const double n = std::max(5.0, kept > 0.0 ? samples / kept : 5.0);
      deviation = std::max(white, deviation) * std::sqrt(9.0 / (4.0 * n));
      // waves move her as a whole: at samples three quarters of a period apart that is as good as noise
      if (wave > 0.0)
        deviation = std::max(deviation, usual_size(rest_of(full, channel, half_of_the_steady * time_unit)));
    }
    run.run = std::make_shared<const Recording>(std::move(lean));
  }
  return prepared;
}

}  // namespace swayaw::identification
