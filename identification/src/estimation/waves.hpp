#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/identification/map_fit.hpp"

/// Waves that move a ship, told from her manoeuvre. Not installed.
namespace swayaw::inline identification::detail {

/// A parabola through samples about a time, by least squares; where waves move the ship with an oscillation of their
/// period beside it, which is left out.
struct Parabola {
  double value = missing;  ///< at that time
  double residual = 0.0;   ///< sum of squares
  std::size_t samples = 0;
  double freedom = 0.0;  ///< samples beyond what is fitted
};

/// Samples from `first` to before `last`.
struct Window {
  std::size_t first, last;
};

/// Those from a time to another, both with them, however times are rounded: with the clock of a file 1000 s on, samples
/// at the ends of windows came and went, noises told from them changed by 0.7 %, and a fit stood on another summit.
inline Window samples_between(const std::vector<double>& time, double from, double to) {
  if (time.empty()) return {0, 0};
  constexpr double rounding = 1e-6;  // of the time between samples
  const double room = rounding * (time.back() - time.front()) / static_cast<double>(time.size());
  const auto place = [&](auto found) { return static_cast<std::size_t>(found - time.begin()); };
  return {place(std::ranges::lower_bound(time, from - room)), place(std::ranges::upper_bound(time, to + room))};
}

/// Samples of a window that are there, about a time, in units of half the window.
/// @tparam N    3, or 5 with an oscillation
/// @param wave  its period [s]
template <int N = 3>
Parabola parabola(const std::vector<double>& time, std::span<const double> values, const Window& window, double about,
                  double half, double wave = 0.0) {
  using Row = Eigen::Matrix<double, N, 1>;
  Eigen::Matrix<double, N, N> A = Eigen::Matrix<double, N, N>::Zero();
  Row b = Row::Zero(), row;
  double squares = 0.0, origin = missing;
  Parabola p;
  for (std::size_t i = window.first; i < window.last; ++i) {
    if (std::isnan(values[i])) continue;
    if (p.samples == 0) origin = values[i];
    const double s = (time[i] - about) / half, y = values[i] - origin;
    row.template head<3>() << 1.0, s, s * s;
    if constexpr (N == 5) {
      const double phase = 2.0 * pi * (time[i] - about) / wave;
      row.template tail<2>() << std::cos(phase), std::sin(phase);
    }
    A += row * row.transpose(), b += row * y, squares += y * y;
    ++p.samples;
  }
  if (p.samples < N + 2) return p;
  const Row c = A.ldlt().solve(b);
  p.value = c[0] + origin;
  p.residual = std::max(0.0, squares - b.dot(c));
  p.freedom = static_cast<double>(p.samples - N);
  return p;
}

/// What a parabola over ± half leaves of each sample; 0 where there is none.
std::vector<double> rest_of(const std::vector<double>& time, std::span<const double> values, double half);

/// Median size of that of the samples that are there: root mean square of an oscillation.
double median_rest(const std::vector<double>& time, std::span<const double> values, double half);

/// Half of the time over which a parabola follows a ship but not the waves that move her, over L/U.
inline constexpr double half_of_the_steady = 0.35;

/// Waves that move a ship.
struct Waves {
  double period = 0.0;               ///< mean [s]; 0 where there are none
  bool clear = false;                ///< nothing but waves oscillates so
  double half = half_of_the_steady;  ///< of the parabolas beside which they show, over L/U

  /// Whether a parabola follows the ship over the time that tells them.
  bool are_short(double time_unit) const;
};

/// Waves that a ship's yaw rate shows.
///
/// What a parabola over most of L/U leaves of the yaw rate oscillates by itself where the sea moves her: its
/// autocorrelation is negative after half a period and positive after a whole one. Waves of most of L/U are followed by
/// such a parabola, as she is; they show beside one that is twice as long.
Waves waves_in(const Recording& run, double time_unit);

/// Half of a window over the period of waves in which a parabola and an oscillation are told apart: in one of a whole
/// period its value has seven times the variance that it has in this.
inline constexpr double half_beside_waves = 0.75;

inline bool Waves::are_short(double time_unit) const {
  return half_beside_waves * period <= half_of_the_steady * time_unit;
}

using Oscillation = WaveMotion::Oscillation;

/// The waves that the yaw rate shows at times: as she turns she meets them more or less often. At each the oscillation
/// beside a parabola over most of L/U that leaves least; none where its period is longer.
std::vector<Oscillation> oscillations(const Recording& run, const std::vector<double>& times, double time_unit,
                                      double mean);

inline double rows_in(const Recording& run, double time_unit) {
  return static_cast<double>(run.samples()) / (run.time.back() - run.time.front()) * time_unit;
}

}  // namespace swayaw::identification::detail
