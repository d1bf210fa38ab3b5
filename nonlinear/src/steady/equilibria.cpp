#include "swayaw/nonlinear/equilibria.hpp"

#include <algorithm>
#include <cmath>

#include "small_matrices.hpp"
#include "steady_balance.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

using Point = Eigen::Vector4d;  ///< u/U, v/U, rL/U, delta

/// Accelerations over U²/L and their derivatives by a point.
struct Balance {
  Eigen::Vector3d residual;
  Eigen::Matrix<double, 3, 4> jacobian;
};

class TurnEquations {
 public:
  TurnEquations(const Ship& ship, const Controls<double>& propulsion, double U)
      : equations_(ship, propulsion), U_(U), L_(equations_.L()) {}

  Balance at(const Point& p) const {
    const auto b = equations_.at(motion_at(p), p[3]);
    const Eigen::Vector3d accelerations(L_ / (U_ * U_), L_ / (U_ * U_), L_ * L_ / (U_ * U_));
    const Eigen::Vector4d units(U_, U_, U_ / L_, 1.0);
    return {b.acceleration.cwiseProduct(accelerations), accelerations.asDiagonal() * b.jacobian * units.asDiagonal()};
  }

  SteadyTurn turn_at(const Point& p) const {
    const Eigen::Matrix3d J = at(p).jacobian.leftCols<3>();
    return {p[3], motion_at(p), is_stable(J)};
  }

 private:
  PlanarMotion<double> motion_at(const Point& p) const { return {U_ * p[0], U_ * p[1], U_ / L_ * p[2]}; }

  SteadyEquations equations_;
  double U_, L_;
};

/// Unit vector along the curve, on the side of `before`.
Point tangent(const Balance& b, const Point& before) {
  const Point t = kernel(b.jacobian);
  return t.dot(before) < 0.0 ? Point(-t) : t;
}

/// Newton's method on the plane through `p` across `t`. @return whether it came to a point of the curve
bool correct(const TurnEquations& equations, Point& p, const Point& t) {
  const Point plane = p;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Balance b = equations.at(p);
    Eigen::Matrix4d J;
    J << b.jacobian, t.transpose();
    Eigen::Vector4d residual;
    residual << b.residual, t.dot(p - plane);
    const Point change = solve(J, Point(-residual));
    p += change;
    const double size = change.cwiseAbs().maxCoeff();
    if (!(size < 1.0)) return false;
    if (size < 1e-12) return true;
  }
  return equations.at(p).residual.cwiseAbs().maxCoeff() <
         1e-11;  // where the force has a kink the last steps may alternate
}

constexpr double slowest = 0.05;  // u/U at which a curve is left

/// The curve from `start` on, in the direction of `along`, without its first point.
std::vector<Point> follow(const TurnEquations& equations, const Point& start, const Point& along, double largest,
                          double longest) {
  constexpr std::size_t most = 20000;
  std::vector<Point> curve;
  Point p = start, t = tangent(equations.at(start), along);
  double step = longest;
  while (curve.size() < most && std::abs(p[3]) <= largest && p[0] > slowest) {
    Point next = p + step * t;
    if (!correct(equations, next, t)) {
      step *= 0.5;
      if (step < 1e-7) break;
      continue;
    }
    t = tangent(equations.at(next), next - p);
    p = next;
    curve.push_back(p);
    step = std::min(longest, 1.5 * step);
  }
  return curve;
}

std::vector<Point> curve_points(const TurnEquations& equations, double largest, double step) {
  Point straight(1.0, 0.0, 0.0, 0.0);
  const Point across = Point::Unit(3);  // at amidships rudder
  if (!correct(equations, straight, across)) return {};
  const Point along = tangent(equations.at(straight), across);
  auto curve = follow(equations, straight, Point(-along), largest, step);
  std::ranges::reverse(curve);
  curve.push_back(straight);
  const auto rest = follow(equations, straight, along, largest, step);
  curve.insert(curve.end(), rest.begin(), rest.end());
  return curve;
}

/// Newton's method at the yaw rate that lies between two turns of a curve, from the place of a straight line between
/// them.
std::optional<SteadyTurn> turn_between(const TurnEquations& equations, const SteadyTurn& a, const SteadyTurn& b,
                                       double yaw_rate, double U, double L) {
  const auto point = [&](const SteadyTurn& s) {
    return Point(s.motion.u / U, s.motion.v / U, s.motion.r * L / U, s.delta);
  };
  const double share = a.motion.r == b.motion.r ? 0.0 : (yaw_rate - a.motion.r) / (b.motion.r - a.motion.r);
  Point p = point(a) + share * (point(b) - point(a));
  p[2] = yaw_rate * L / U;
  if (!correct(equations, p, Point(Point::Unit(2)))) return std::nullopt;
  return equations.turn_at(p);
}

/// Speed of the straight course.
double straight_speed(const Ship& ship, const Controls<double>& propulsion) {
  const auto steady = steady_motion(ship, with_rudder(propulsion, 0.0), {service_speed(ship), 0.0, 0.0});
  if (!steady) throw Refusal("the ship has no steady motion ahead near the straight course with this propulsion");
  return speed(steady->motion);
}

void add_if_new(std::vector<SteadyMotion>& found, const std::optional<SteadyMotion>& steady, double U, double L) {
  if (!steady) return;
  const auto same = [&](const SteadyMotion& other) {
    const auto &a = steady->motion, &b = other.motion;
    return std::abs(a.u - b.u) + std::abs(a.v - b.v) + std::abs(a.r - b.r) * L < 1e-6 * U;
  };
  if (std::ranges::none_of(found, same)) found.push_back(*steady);
}

/// A fold of the curve between two points: where delta turns back.
std::vector<std::size_t> folds(const std::vector<SteadyTurn>& curve) {
  std::vector<std::size_t> result;
  for (std::size_t i = 1; i + 1 < curve.size(); ++i)
    if ((curve[i].delta - curve[i - 1].delta) * (curve[i + 1].delta - curve[i].delta) < 0.0) result.push_back(i);
  return result;
}

}  // namespace

std::vector<SteadyTurn> steady_turn_curve(const Ship& ship, const Controls<double>& propulsion, double largest,
                                          double step) {
  const double U = straight_speed(ship, propulsion);
  const TurnEquations equations(ship, propulsion, U);
  std::vector<SteadyTurn> curve;
  for (const auto& p : curve_points(equations, largest, step)) curve.push_back(equations.turn_at(p));
  if (curve.size() > 1 && curve.front().delta > curve.back().delta) std::ranges::reverse(curve);
  return curve;
}

std::vector<SteadyMotion> steady_turns(const Ship& ship, const Controls<double>& controls) {
  const double L = length(ship), delta = controls.delta;
  std::vector<SteadyMotion> found;
  const double U = straight_speed(ship, controls);
  const auto curve = steady_turn_curve(ship, controls, std::abs(delta) + 0.05);
  for (std::size_t i = 1; i < curve.size(); ++i)
    if ((curve[i - 1].delta - delta) * (curve[i].delta - delta) <= 0.0)
      add_if_new(found, steady_motion(ship, controls, curve[i].motion), U, L);
  for (const double u : {0.9, 0.6, 0.3, 0.05})
    for (const double v : {-0.4, -0.15, 0.15, 0.4})
      for (const double r : {-0.9, -0.3, 0.3, 0.9})
        add_if_new(found, steady_motion(ship, controls, {u * U, v * U, r * U / L}), U, L);
  std::ranges::sort(found, {}, [](const SteadyMotion& s) { return s.motion.r; });
  return found;
}

std::optional<SteadyTurn> turn_at_yaw_rate(const Ship& ship, const Controls<double>& propulsion,
                                           const std::vector<SteadyTurn>& curve, double yaw_rate, double largest) {
  const double L = length(ship), U = service_speed(ship);
  std::optional<SteadyTurn> nearest;
  const TurnEquations equations(ship, propulsion, U);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if ((curve[i - 1].motion.r - yaw_rate) * (curve[i].motion.r - yaw_rate) > 0.0) continue;
    const auto turn = turn_between(equations, curve[i - 1], curve[i], yaw_rate, U, L);
    if (turn && std::abs(turn->delta) <= largest * (1.0 + 1e-9) &&
        (!nearest || std::abs(turn->delta) < std::abs(nearest->delta)))
      nearest = turn;
  }
  return nearest;
}

std::optional<InstabilityLoop> instability_loop(const std::vector<SteadyTurn>& curve) {
  const auto turning = folds(curve);
  if (turning.size() < 2) return std::nullopt;
  const auto &first = curve[turning.front()], &last = curve[turning.back()];
  const double neutral = 0.5 * (first.delta + last.delta);
  double lowest = 0.0, highest = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto &a = curve[i - 1], &b = curve[i];
    if ((a.delta - neutral) * (b.delta - neutral) > 0.0 || !b.stable) continue;
    const double r = a.motion.r + (b.motion.r - a.motion.r) * (neutral - a.delta) / (b.delta - a.delta);
    lowest = std::min(lowest, r);
    highest = std::max(highest, r);
  }
  return InstabilityLoop{.width = std::abs(first.delta - last.delta), .height = highest - lowest};
}

}  // namespace swayaw::nonlinear
