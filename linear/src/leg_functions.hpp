#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "modes.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/response.hpp"

/// Zeros of heading, yaw rate and their derivatives along a leg. Not installed.
namespace swayaw::inline linear::detail {

/// A place on a leg: s, psi with its first four derivatives, and beta.
struct Knot {
  double s;
  std::array<double, 5> f;
  double beta;
};

/// A response with its modes, prepared for many legs.
struct LegShip {
  LinearResponse<double> response;
  Modes modes;  ///< of use if the poles are well apart

  explicit LegShip(const LinearResponse<double>& ship) : response(ship), modes(ship.m, ship.p.slow, ship.p.fast) {}
};

/// psi and its derivatives along a leg.
///
/// The rudder moves in a straight line, so that from the order `free` on (2 under a resting rudder, else 3) the
/// derivatives f_free, f_free+1, … obey y'' = tr y' − det y with no force. With v = (beta, omega) differentiated free −
/// 1 times at the start,
///
///     f_free(s) = (exp(A s) v)_omega,   f_free−k(s) = Taylor polynomial of degree k − 1 at the start + k-fold integral
///     of f_free.
///
/// Within the horizon f_free passes zero at most once. A function whose derivative does so has one top at most, and the
/// signs at both ends tell whether that top matters; so the zeros are isolated one order at a time and none is missed.
class LegFunctions {
 public:
  LegFunctions(const LegShip& ship, const LinearState<double>& start, const RudderLine<double>& rudder)
      : ship_(ship.response), modes_(ship.modes), start_(start), ramp_(rudder.rate != 0.0), free_(ramp_ ? 3 : 2) {
    const auto& m = ship_.m;
    first_ = rates(m, start, rudder.value);
    v_ = ramp_ ? rates(m, {first_.beta, first_.omega, 0.0}, rudder.rate) : first_;
    const auto [yaw1, yaw2] = split(modes_.yaw_beta * start.beta + modes_.yaw_omega * start.omega, first_.omega,
                                    modes_.yaw_gain, m.c2, rudder);
    const auto [drift1, drift2] = split(modes_.drift_beta * start.beta + modes_.drift_omega * start.omega, first_.beta,
                                        modes_.drift_gain, m.c1, rudder);
    yaw_ = {yaw1, yaw2, v_.omega, m.a2 * v_.beta - m.a1 * v_.omega};
    drift_ = {drift1, drift2, v_.beta, m.b1 * v_.omega - m.b2 * v_.beta};
  }

  Knot at(double s) const {
    if (!ship_.p.apart) return of_near_poles(s);
    return knot(s, ModeMoments{moments(modes_.l1, modes_.over_l1, s), moments(modes_.l2, modes_.over_l2, s)});
  }

  LinearState<double> state_at(double s) const { return state(at(s)); }
  static LinearState<double> state(const Knot& k) { return {k.beta, k.f[1], k.f[0]}; }

  /// The first s in (0, end] at which the derivative of that order equals `target` (0 from the second on), or the end,
  /// which is at most the horizon.
  struct Sailed {
    bool found;
    Knot end;
  };

  Sailed sail(int level, double target, double end) const {
    Knot a = knot(0.0, {ship_.p.tr * yaw_.y0 + yaw_.turn, yaw_.y0, 0.0, 0.0, 0.0}, {});
    for (;;) {
      const double guess = a.s + 1.25 * step_to(a, level, target);
      const Knot b = at(guess > a.s && guess < end ? guess : end);
      if (const auto found = descend(a, b, free_, level, target)) return {true, at(*found)};
      if (b.s == end) return {false, b};
      a = b;
    }
  }

  /// Length of time within which f_free has one zero at most, and exponentials stay in range. A fast mode that dies out
  /// does not shorten it: two real exponentials have one common zero at most, however far one looks.
  double horizon() const {
    const auto& p = ship_.p;
    if (p.apart && p.fast < 0.0) return 30.0 / std::abs(p.slow);
    const double range = 30.0 / p.size;
    return p.q < 0.0 ? std::min(range, 0.99 * pi / std::sqrt(-p.q)) : range;
  }

 private:
  /// A function that obeys y'' = tr y' − det y: its derivative, itself, its integrals.
  struct Free {
    double rise, y, i1, i2, i3;
  };

  /// Such a function from its start, by modes and by Cayley–Hamilton, y = h_{−1} y0 + h_0 turn.
  struct FreeStart {
    double mode1, mode2, y0, turn;
  };

  struct Parts {
    double slow, fast;
  };

  /// Modes of a derivative of beta or omega at the start, y' = y1' + y2' and y_i' = l_i y_i + g_i delta, under a moving
  /// rudder one derivative more. The slow part never as a difference of large rates, which would lose digits where T2
  /// is very small.
  Parts split(double slow, double rate, double gain, double whole_gain, const RudderLine<double>& rudder) const {
    const double slow_rate = modes_.l1 * slow + gain * rudder.value, fast_rate = rate - slow_rate;
    if (!ramp_) return {slow_rate, fast_rate};
    return {modes_.l1 * slow_rate + gain * rudder.rate, modes_.l2 * fast_rate + (whole_gain - gain) * rudder.rate};
  }

  /// What all functions of the leg are made of, if the poles are well apart.
  struct ModeMoments {
    ExponentialMoments slow, fast;
  };

  static double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

  /// Sign just behind the start of an interval.
  static double sign_behind(const Knot& k, int level, double target) {
    if (const double y = k.f[static_cast<std::size_t>(level)] - target; y != 0.0) return sign(y);
    for (auto i = static_cast<std::size_t>(level) + 1; i < k.f.size(); ++i)
      if (k.f[i] != 0.0) return sign(k.f[i]);
    return 0.0;
  }

  /// Whether the function of that order passes zero in (a, b], if it does so at most once.
  static bool passes(const Knot& a, const Knot& b, int level, double target) {
    const double before = sign_behind(a, level, target), after = sign(b.f[static_cast<std::size_t>(level)] - target);
    return before != 0.0 && after != before;
  }

  /// First zero of f_level in (a, b], where f_order+1 passes zero at most once.
  std::optional<double> search(const Knot& a, const Knot& b, int order, int level, double target) const {
    const double value = order == level ? target : 0.0;
    if (!needs_top(a, b, order, value)) return descend(a, b, order, level, target);
    const Knot top = at(root(a, b, order + 1, 0.0));
    if (const auto found = descend(a, top, order, level, target)) return found;
    return descend(top, b, order, level, target);
  }

  /// The same where f_order passes zero at most once.
  std::optional<double> descend(const Knot& a, const Knot& b, int order, int level, double target) const {
    if (order > level) return search(a, b, order - 1, level, target);
    return passes(a, b, level, target) ? std::optional(root(a, b, level, target)) : std::nullopt;
  }

  /// Whether between a and b the function turns back on its way to zero, so that it may have two zeros or none.
  static bool needs_top(const Knot& a, const Knot& b, int level, double target) {
    return passes(a, b, level + 1, 0.0) && !passes(a, b, level, target) &&
           sign_behind(a, level, target) != sign_behind(a, level + 1, 0.0);
  }

  /// Apart from the others, for which inlining it costs a zigzag 1 to 3 %.
  [[gnu::noinline]] Knot of_near_poles(double s) const { return knot(s, response_basis(ship_.p, s)); }

  Free combined(const ModeMoments& modes, const FreeStart& f) const {
    const auto& [slow, fast] = modes;
    const double c1 = f.mode1, c2 = f.mode2;
    return {modes_.l1 * c1 * slow.e + modes_.l2 * c2 * fast.e, c1 * slow.e + c2 * fast.e, c1 * slow.p1 + c2 * fast.p1,
            c1 * slow.p2 + c2 * fast.p2, c1 * slow.p3 + c2 * fast.p3};
  }

  Free combined(const ResponseBasis<double>& h, const FreeStart& f) const {
    const double y0 = f.y0, turn = f.turn;
    return {(ship_.p.tr * h.h_1 - ship_.p.det * h.h0) * y0 + h.h_1 * turn, h.h_1 * y0 + h.h0 * turn,
            h.h0 * y0 + h.h1 * turn, h.h1 * y0 + h.h2 * turn, h.h2 * y0 + h.h3 * turn};
  }

  template <class Basis>
  Knot knot(double s, const Basis& basis) const {
    return knot(s, combined(basis, yaw_), combined(basis, drift_));
  }

  Knot knot(double s, const Free& yaw, const Free& drift) const {
    const double psi = start_.psi + start_.omega * s;
    const double curve = ship_.p.tr * yaw.rise - ship_.p.det * yaw.y;
    if (!ramp_) return {s, {psi + yaw.i2, start_.omega + yaw.i1, yaw.y, yaw.rise, curve}, start_.beta + drift.i1};
    return {s,
            {psi + 0.5 * first_.omega * s * s + yaw.i3, start_.omega + first_.omega * s + yaw.i2, first_.omega + yaw.i1,
             yaw.y, yaw.rise},
            start_.beta + first_.beta * s + drift.i2};
  }

  /// How far from a the target is reached by the parabola that touches the function there.
  ///
  ///     y + f t + ½ g t² = 0, without cancellation; the first t > 0, if there is one
  static double step_to(const Knot& a, int level, double target) {
    const auto i = static_cast<std::size_t>(level);
    const double y = a.f[i] - target, f = a.f[i + 1], g = a.f[i + 2];
    const double root = std::sqrt(std::max(f * f - 2.0 * y * g, 0.0));
    return -2.0 * y / (f - std::copysign(root, y));
  }

  /// Householder's method of third order from b, never leaving the bracket (a, b] with one zero.
  double root(const Knot& a, const Knot& b, int level, double target) const {
    const auto i = static_cast<std::size_t>(level);
    double low = a.s, high = b.s;
    const double before = sign_behind(a, level, target);
    Knot k = b;
    for (int step = 0; step < 100; ++step) {
      const double y = k.f[i] - target;
      const double newton = -y / k.f[i + 1];
      const double bend = i + 2 < k.f.size() ? newton * k.f[i + 2] / k.f[i + 1] : 0.0;
      const double twist = i + 3 < k.f.size() ? newton * newton * k.f[i + 3] / k.f[i + 1] : 0.0;
      const double by = newton * (1.0 + 0.5 * bend) / (1.0 + bend + twist / 6.0);
      // the error left is of the fourth order in the step; upon the zero itself rounding may lead out of the bracket
      const double error = std::abs(by) * ship_.p.size + std::abs(bend);
      double next = k.s + by;
      const bool inside = next > low && next < high;
      if (y == 0.0 || next == k.s || error < 1e-13) return inside ? next : k.s;
      if (inside && error < 1e-4) return next;
      if (!inside) next = 0.5 * (low + high);
      if (next == low || next == high) return next;
      k = at(next);
      (sign(k.f[i] - target) == before ? low : high) = next;
    }
    return k.s;
  }

  const LinearResponse<double>& ship_;
  const Modes& modes_;
  LinearState<double> start_;
  bool ramp_;
  int free_;
  LinearState<double> first_{};  ///< beta' and omega' at the start
  LinearState<double> v_{};      ///< beta and omega differentiated free − 1 times, at the start
  FreeStart yaw_{}, drift_{};
};

/// Legs between two orders, or parts of a leg. One ends where the exponentials of the ship leave the range of numbers:
/// published ships need a few, one whose motion grows or dies 10⁵⁶ times in a ship length would need them without end.
constexpr std::size_t most_legs = 5'000;

inline void require_sailable(std::size_t legs) {
  if (legs == most_legs)
    throw Refusal(
        "the motion of this linear ship changes too fast to be sailed: look at her length over beam, "
        "added masses and derivatives");
}

/// Calls visit(state, s) at all s in (0, length] at which the derivative of psi of that order passes zero.
template <class Visit>
void for_each_zero(const LegShip& ship, LinearState<double> start, RudderLine<double> rudder, double length, int level,
                   const Visit& visit) {
  double from = 0.0;
  for (std::size_t legs = 0; from < length; ++legs) {
    require_sailable(legs);
    const LegFunctions functions(ship, start, rudder);
    const auto [found, last] = functions.sail(level, 0.0, std::min(length - from, functions.horizon()));
    if (found) visit(LegFunctions::state(last), from + last.s);
    // go on just behind the zero, where the function is no longer zero
    const double on = found ? last.s * (1.0 + 1e-9) + 1e-12 : last.s;
    start = functions.state_at(on);
    rudder.value += rudder.rate * on;
    from += on;
  }
}

}  // namespace swayaw::linear::detail
