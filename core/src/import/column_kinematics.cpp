#include "column_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"

namespace swayaw::inline core::detail {

std::optional<double> yaw_rate_ratio(std::span<const double> time, std::span<const double> psi, double turn,
                                     std::span<const double> r) {
  // a twentieth of the run: long against steps of the heading, short against the whole manoeuvre
  const double window = (time.back() - time.front()) / 20.0;
  double change = 0.0, integral = 0.0, begin = time.front();
  double sum_cc = 0.0, sum_ci = 0.0, sum_ii = 0.0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double dt = time[i] - time[i - 1];
    const double step = std::remainder(psi[i] - psi[i - 1], turn), part = 0.5 * (r[i] + r[i - 1]) * dt;
    if (!std::isfinite(step) || !std::isfinite(part) || dt <= 0.0) continue;
    change += step;
    integral += part;
    if (time[i] - begin < window) continue;
    sum_cc += change * change;
    sum_ci += change * integral;
    sum_ii += integral * integral;
    change = integral = 0.0;
    begin = time[i];
  }
  // c = Σ Δψ ∫r dt / Σ Δψ²; the correlation tells whether the two belong together at all
  constexpr double least_correlation = 0.9;
  const double correlation = std::abs(sum_ci) / std::sqrt(sum_cc * sum_ii);
  if (!(correlation > least_correlation)) return std::nullopt;
  return std::abs(sum_ci) / sum_cc;
}

std::optional<double> track_speed(std::span<const double> time, std::span<const double> x, std::span<const double> y,
                                  bool in_degrees) {
  constexpr double metres_per_degree = 60.0 * 1852.0;
  // steps of ten seconds or more: positions are rounded to metres
  constexpr double shortest = 10.0;
  double way = 0.0, spent = 0.0;
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(x[i] + y[i] + time[i])) continue;
    if (from && time[i] - time[*from] < shortest) continue;
    if (from) {
      const double north = (x[i] - x[*from]) * (in_degrees ? metres_per_degree : 1.0);
      const double east = (y[i] - y[*from]) * (in_degrees ? metres_per_degree * std::cos(radians(x[i])) : 1.0);
      way += std::hypot(north, east);
      spent += time[i] - time[*from];
    }
    from = i;
  }
  return spent > 0.0 ? std::optional(way / spent) : std::nullopt;
}

}  // namespace swayaw::core::detail
