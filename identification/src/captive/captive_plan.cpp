#include <algorithm>
#include <cmath>

#include "../forces/force_component.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/coefficients.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Names = std::vector<std::string>;

/// A step as the table below has it: coefficients of a linear hull, and those that a cubic one has besides.
struct StandardStep {
  Names tests;
  ForceComponent component;
  Names linear, cubic;
  bool of_rudder = false;
};

/// [Alexandersson2024] table 3, with the sway force of yawing, cubic terms and oscillating tests beside circles. Added
/// mass comes first, for it stands in the forces of a turn; in an oscillation it is apart from all that depends on
/// velocity.
const std::vector<StandardStep>& standard_steps() {
  using enum ForceComponent;
  static const Names resistance{"resistance", "self_propulsion"}, rudder{"static_rudder"}, drift{"static_drift"},
      circle{"circle", "pure_yaw:velocity"}, circle_drift{"circle_drift", "yaw_drift:velocity", "yaw_drift:second"},
      sway{"pure_sway:acceleration"}, yaw{"pure_yaw:acceleration"};
  static const std::vector<StandardStep> steps{
      {sway, Y, {"Y_vdot", "m_y"}, {}},
      {sway, N, {"N_vdot"}, {}},
      {yaw, Y, {"Y_rdot"}, {}},
      {yaw, N, {"N_rdot", "J_z"}, {}},
      {rudder, Y, {"a_H"}, {}, true},
      {rudder, N, {"x_H", "x_H_prime"}, {}, true},
      {resistance, X, {"X_0", "X_u", "R_0"}, {}},
      {drift, X, {"X_vv"}, {"X_vvvv"}},
      {drift, Y, {"Y_v"}, {"Y_vvv"}},
      {drift, N, {"N_v"}, {"N_vvv"}},
      {circle, X, {"X_rr"}, {}},
      {circle, Y, {"Y_r"}, {"Y_rrr"}},
      {circle, N, {"N_r"}, {"N_rrr"}},
      {circle_drift, X, {"X_vr"}, {}},
      {circle_drift, Y, {}, {"Y_vvr", "Y_vrr"}},
      {circle_drift, N, {}, {"N_vvr", "N_vrr"}},
  };
  return steps;
}

/// Those that the model has and that may be fitted.
Names known(const Ship& ship, const Names& names) {
  Names result;
  const auto parameters = parameters_of(ship);
  for (const auto& name : names)
    if (std::ranges::any_of(parameters,
                            [&](const Parameter& n) { return n.name == name && n.role == Role::coefficient; }))
      result.push_back(name);
  return result;
}

bool measured(const CaptivePoint& point, ForceComponent component) {
  return !std::isnan(component_of(point.measured, component));
}

/// Least speed of the drift tests: rudder tests at lower speeds have a propeller that is loaded more.
double speed_of_drift_tests(std::span<const CaptivePoint> points) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& point : selected(points, {.tests = {"static_drift"}}))
    least = std::min(least, speed(point.moments.front().motion));
  return std::isfinite(least) ? least : 0.0;
}

}  // namespace

CaptivePlan captive_plan(const Ship& ship, std::span<const CaptivePoint> points, HullTerms terms, double max_drift) {
  CaptivePlan plan{
      .steps = {},
      .validation = {.tests = {"static_drift_rudder"}, .max_drift = max_drift, .min_rudder = radians(0.5)}};
  for (const auto& s : standard_steps()) {
    auto names = known(ship, s.linear);
    if (terms == HullTerms::cubic) std::ranges::copy(known(ship, s.cubic), std::back_inserter(names));
    CaptiveSelection selection{.tests = s.tests, .max_drift = max_drift};
    if (s.of_rudder) selection.min_speed = speed_of_drift_tests(points);
    const auto mine = selected(points, selection);
    const auto tell =
        std::ranges::count_if(mine, [&](const CaptivePoint& point) { return measured(point, s.component); });
    if (!names.empty() && tell > static_cast<std::ptrdiff_t>(names.size()))
      plan.steps.push_back({selection, s.component, names});
  }
  return plan;
}

}  // namespace swayaw::identification
