#include "swayaw/linear/euler_zigzag.hpp"

#include <algorithm>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline linear {
namespace {

EulerStep advanced(const SwayYawCoefficients<double>& ship, const EulerStep& now, double ordered, double reach,
                   double next_s, double h) {
  const auto& x = now.state;
  const auto d = rates(ship, x, now.delta);
  return {
      .s = next_s,
      .state = {x.beta + h * d.beta, x.omega + h * d.omega, x.psi + h * d.psi},
      .delta = now.delta + std::clamp(ordered - now.delta, -reach, reach),
  };
}

}  // namespace

EulerZigzag euler_zigzag(const SwayYawCoefficients<double>& ship, const LinearZigzagOrder& order, double step) {
  require_positive(order.rudder, "rudder angle [rad]");
  require_positive(order.heading, "heading angle [rad]");
  require_positive(order.rate, "rudder rate [rad per ship length]");
  require_positive(step, "step [ship lengths]");
  EulerZigzag result;
  EulerStep now{0.0, {0.0, 0.0, 0.0}, 0.0};
  double turn = yaw_sign(order.first);  // side to which the heading is awaited
  auto& reversals = result.reversals;
  bool swinging_out = false;  // the heading still goes on after the last reversal
  for (std::size_t i = 0; now.s <= order.longest; ++i) {
    result.steps.push_back(now);
    if (swinging_out) {
      auto& last = reversals.back();
      const double beyond = -turn * now.state.psi - order.heading;
      swinging_out = beyond >= last.overshoot;
      if (swinging_out) last = {last.execute, now.s, beyond, last.leg};
      if (!swinging_out && reversals.size() == order.reversals) return result;
    }
    if (turn * now.state.psi >= order.heading) {
      reversals.push_back({now.s, now.s, turn * now.state.psi - order.heading, i});
      swinging_out = true;
      turn = -turn;
    }
    now = advanced(ship, now, -turn * order.rudder, order.rate * step, static_cast<double>(i + 1) * step, step);
  }
  if (swinging_out) reversals.pop_back();  // its peak is to come
  return result;
}

}  // namespace swayaw::linear
