#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "swayaw/core/angle.hpp"
#include "swayaw/linear/response.hpp"

/// Zeros of heading, yaw rate and their derivatives along a leg. Not installed.
namespace swayaw {

/// A few ascending numbers.
struct Few {
  std::array<double, 16> value{};
  std::size_t count = 0;

  void add(double x) {
    if (count < value.size()) value[count++] = x;
  }
};

/// psi, omega, d(omega)/ds, d²(omega)/ds² along a leg.
///
/// The highest of them that the rudder does not force obeys y'' = tr y' − det y, so its zeros are known in closed form.
/// Between two zeros of a derivative a function is monotone (Rolle), so its zeros are found one level at a time and none is missed.
class LegFunctions {
 public:
  LegFunctions(const LinearResponse<double>& ship, const LinearState<double>& start, const RudderLine<double>& rudder)
      : ship_(ship), start_(start), rudder_(rudder), free_level_(rudder.rate == 0.0 ? 2 : 3) {}

  /// Derivatives of psi of order `level` and of the next one.
  std::pair<double, double> at(int level, double s) const {
    const LinearState<double> x = state_after(ship_, start_, rudder_, s);
    if (level == 0) return {x.psi, x.omega};
    const LinearState<double> d = rates(ship_.m, x, rudder_.value + rudder_.rate * s);
    if (level == 1) return {x.omega, d.omega};
    const double second = ship_.m.a2 * d.beta + ship_.m.b2 * d.omega + ship_.m.c2 * rudder_.rate;
    if (level == 2) return {d.omega, second};
    const double drift = ship_.m.a1 * d.beta + ship_.m.b1 * d.omega + ship_.m.c1 * rudder_.rate;
    return {second, ship_.m.a2 * drift + ship_.m.b2 * second};
  }

  /// First s in (0, end] at which the derivative of that order equals `target` (0 from the second on), if there is one.
  std::optional<double> first(int level, double target, double end) const {
    if (level == free_level_) {
      const Few all = free_zeros(end);
      return all.count > 0 ? std::optional(all.value[0]) : std::nullopt;
    }
    const Few breaks = zeros(level + 1, end);
    double from = 0.0, before = at(level, from).first - target;
    for (std::size_t i = 0; i <= breaks.count; ++i) {
      const double to = i < breaks.count ? breaks.value[i] : end;
      const double after = at(level, to).first - target;
      if (before != 0.0 && (after == 0.0 || (before < 0.0) != (after < 0.0))) return root(level, target, from, to, before);
      from = to;
      before = after;
    }
    return std::nullopt;
  }

  /// Length of time within which no function has more zeros than `Few` holds, and exponentials stay in range.
  double horizon() const {
    const auto& p = ship_.p;
    if (p.q < 0.0) return 2.0 * pi / std::sqrt(-p.q);
    return p.size > 0.0 ? 30.0 / p.size : std::numeric_limits<double>::infinity();
  }

 private:
  Few zeros(int level, double end) const {
    if (level == free_level_) return free_zeros(end);
    Few found;
    const Few breaks = zeros(level + 1, end);
    double from = 0.0, before = at(level, from).first;
    for (std::size_t i = 0; i <= breaks.count; ++i) {
      const double to = i < breaks.count ? breaks.value[i] : end;
      const double after = at(level, to).first;
      if (before != 0.0 && (after == 0.0 || (before < 0.0) != (after < 0.0))) found.add(root(level, 0.0, from, to, before));
      from = to;
      before = after;
    }
    return found;
  }

  /// Zeros in (0, end] of y with y'' = tr y' − det y.
  Few free_zeros(double end) const {
    const auto [y, slope] = at(free_level_, 0.0);
    const auto& p = ship_.p;
    const double mu = 0.5 * p.tr, lead = slope - mu * y;  // y(s) = exp(mu s) (y C(s) + lead S(s))
    Few found;
    if (p.q < 0.0) {
      const double nu = std::sqrt(-p.q);
      double s = std::atan2(-y, lead / nu) / nu;
      while (s <= 0.0) s += pi / nu;
      for (; s <= end && found.count < found.value.size(); s += pi / nu) found.add(s);
      return found;
    }
    const double root_q = std::sqrt(p.q), t = -y / lead;  // tanh(root_q s)/root_q = t
    const double s = root_q * t < 1e-6 ? t : 0.5 * std::log1p(2.0 * root_q * t / (1.0 - root_q * t)) / root_q;
    if (lead != 0.0 && t > 0.0 && root_q * t < 1.0 && s <= end) found.add(s);
    return found;
  }

  /// Newton's method that never leaves a bracket on which the function is monotone.
  double root(int level, double target, double low, double high, double at_low) const {
    double s = 0.5 * (low + high);
    for (int i = 0; i < 100; ++i) {
      const auto [value, slope] = at(level, s);
      const double y = value - target;
      if (y == 0.0) return s;
      ((y < 0.0) == (at_low < 0.0) ? low : high) = s;
      double next = s - y / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - s) <= 4e-16 * std::abs(s) || next == low || next == high) return next;
      s = next;
    }
    return s;
  }

  const LinearResponse<double>& ship_;
  LinearState<double> start_;
  RudderLine<double> rudder_;
  int free_level_;
};

}  // namespace swayaw
