#include "manoeuvre_run.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

/// Goes on until the heading has changed by `angle` towards the side.
bool turn_through(ShipStepper& stepper, double turn, double angle, double end) {
  return stepper.advance(end, [&](const auto& s) { return turn * s.psi - angle; });
}

void measure_first_half(ShipStepper& stepper, TurningCircle& circle, double turn, double end) {
  if (!turn_through(stepper, turn, radians(10.0), end)) return;
  circle.initial_turning = way_made(stepper.samples(), now(stepper), stepper.time());
  if (!turn_through(stepper, turn, radians(90.0), end)) return;
  circle.time_90 = stepper.time();
  circle.advance = stepper.state().x;
  circle.transfer = turn * stepper.state().y;
  if (!turn_through(stepper, turn, radians(180.0), end)) return;
  circle.time_180 = stepper.time();
  circle.tactical_diameter = turn * stepper.state().y;
}

/// Goes on until the heading has changed by 540 deg, or the ship no longer moves ahead.
void turn_until_steady(ShipStepper& stepper, TurningCircle& circle, double turn, double end) {
  const auto watch = [&](const auto& s) {
    return std::min(radians(540.0) - turn * s.psi, s.motion.u / circle.approach_speed);
  };
  if (stepper.advance(end, watch) && turn * stepper.state().psi < radians(539.0)) circle.way_lost = stepper.time();
}

/// The stable steady turn that the ship is about to settle in.
void measure_steady_turn(const Ship& ship, TurningCircle& circle, const Sample& last) {
  const auto& m = last.state.motion;
  const auto steady = steady_motion(ship, last.controls, m);
  if (!steady || !steady->stable) return;
  const bool near = std::abs(speed(steady->motion) - speed(m)) < 0.2 * speed(m) &&
                    std::abs(steady->motion.r - m.r) < 0.2 * std::abs(m.r);
  if (!near) return;
  circle.steady = steady->motion;
  circle.final_diameter = 2.0 * speed(steady->motion) / std::abs(steady->motion.r);
}

template <class Model>
TurningCircle run_circle(const Ship& ship, const ActingShip<Model>& acting, const TurnOrder& order,
                         const ManoeuvreOptions& options) {
  const Plan planned = plan(acting, options, 100.0);
  const auto made = approaching(acting, planned, options);
  ShipStepper& stepper = *made;
  stepper.order(rudder_sign(order.side) * order.rudder);
  TurningCircle circle{.approach_speed = planned.speed, .propulsion = planned.propulsion, .run = {}, .steps = {}};
  const double turn = yaw_sign(order.side);
  measure_first_half(stepper, circle, turn, planned.end);
  if (options.duration) stepper.advance(planned.end);
  else turn_until_steady(stepper, circle, turn, planned.end);
  if (!circle.way_lost) measure_steady_turn(ship, circle, now(stepper));
  if (options.sampled) circle.run = recording_of(stepper.samples(), acting);
  circle.steps = std::move(stepper.steps());
  return circle;
}

}  // namespace

TurningCircle turning_circle(const Ship& ship, const TurnOrder& order, const ManoeuvreOptions& options) {
  require_rudder(order.rudder, steering_gear(ship));
  auto circle = visit_acting(ship, [&](const auto& acting) { return run_circle(ship, acting, order, options); });
  if (options.step && options.sampled) {
    const auto duration = circle.time_90 ? std::optional(just_after(*circle.time_90)) : options.duration;
    circle.initial_turning = turning_circle(ship, order, measuring(options, duration)).initial_turning;
  }
  circle.run.name = ship.name;
  circle.run.facts.execute = 0.0;
  circle.run.facts.manoeuvre = fmt::format("turn {:.6g} to {}", degrees(order.rudder), name_of(order.side));
  return circle;
}

}  // namespace swayaw::nonlinear
