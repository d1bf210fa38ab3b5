#include "manoeuvre_run.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

/// Adds a reversal and its overshoot to the zigzag. @return whether the run went on to the heading peak
bool reverse(ShipStepper& stepper, Zigzag& zigzag, const ZigzagOrder& order, double turn, double end) {
  if (!stepper.advance(end, [&](const auto& s) { return turn * s.psi - order.heading; })) return false;
  zigzag.reversals.push_back({.time = stepper.time(), .peak_time = {}, .overshoot = {}});
  stepper.order(turn * order.rudder);
  if (!stepper.advance(end, [](const auto& s) { return s.motion.r; })) return false;
  zigzag.reversals.back().peak_time = stepper.time();
  zigzag.reversals.back().overshoot = turn * stepper.state().psi - order.heading;
  return true;
}

template <class Model>
Zigzag run_zigzag(const ActingShip<Model>& acting, const ZigzagOrder& order, const ManoeuvreOptions& options) {
  const Plan planned = plan(acting, options, 200.0);
  const auto made = approaching(acting, planned, options);
  ShipStepper& stepper = *made;
  stepper.order(rudder_sign(order.first) * order.rudder);
  Zigzag result{.reversals = {},
                .period = {},
                .initial_turning = {},
                .approach_speed = planned.speed,
                .propulsion = planned.propulsion,
                .run = {},
                .steps = {}};
  constexpr std::size_t enough = 4;
  double turn = yaw_sign(order.first);
  while (reverse(stepper, result, order, turn, planned.end)) {
    turn = -turn;
    if (!options.duration && result.reversals.size() == enough) break;
  }
  const auto& reversals = result.reversals;
  if (reversals.size() >= 3) result.period = reversals.back().time - reversals[reversals.size() - 3].time;
  if (!reversals.empty()) result.initial_turning = way_made(stepper.samples(), now(stepper), reversals.front().time);
  if (options.sampled) result.run = recording_of(stepper.samples(), acting);
  result.steps = std::move(stepper.steps());
  return result;
}

}  // namespace

Zigzag zigzag(const Ship& ship, const ZigzagOrder& order, const ManoeuvreOptions& options) {
  require_rudder(order.rudder, steering_gear(ship));
  require_positive(order.heading, "heading angle [rad]");
  auto result = visit_acting(ship, [&](const auto& acting) { return run_zigzag(acting, order, options); });
  if (options.step && options.sampled && !result.reversals.empty())
    result.initial_turning =
        zigzag(ship, order, measuring(options, just_after(result.reversals.front().time))).initial_turning;
  result.run.name = ship.name;
  result.run.facts.execute = 0.0;
  result.run.facts.manoeuvre =
      fmt::format("zigzag {:.6g}/{:.6g} first {}", degrees(order.rudder), degrees(order.heading), name_of(order.first));
  return result;
}

}  // namespace swayaw::nonlinear
