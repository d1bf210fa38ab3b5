#include "manoeuvre_run.hpp"

namespace swayaw {
namespace {

/// Sails on until the heading has changed by `angle` towards the side.
template <class Sailing>
bool sail_round(Sailing& voyage, double turn, double angle, double end) {
  return voyage.sail(end, [&](const auto& s) { return turn * s.psi - angle; });
}

template <class Sailing>
void measure_first_half(Sailing& voyage, TurningCircle& circle, double turn, double end) {
  if (!sail_round(voyage, turn, radians(10.0), end)) return;
  circle.initial_turning = way_made(voyage.samples(), now(voyage), voyage.time());
  if (!sail_round(voyage, turn, radians(90.0), end)) return;
  circle.time_90 = voyage.time();
  circle.advance = voyage.state().x;
  circle.transfer = turn * voyage.state().y;
  if (!sail_round(voyage, turn, radians(180.0), end)) return;
  circle.time_180 = voyage.time();
  circle.tactical_diameter = turn * voyage.state().y;
}

/// Sails on until the heading has changed by 540 deg, or the ship no longer moves ahead.
template <class Sailing>
void sail_towards_steady(Sailing& voyage, TurningCircle& circle, double turn, double end) {
  const auto watch = [&](const auto& s) {
    return std::min(radians(540.0) - turn * s.psi, s.motion.u / circle.approach_speed);
  };
  if (voyage.sail(end, watch) && turn * voyage.state().psi < radians(539.0)) circle.way_lost = voyage.time();
}

/// The stable steady turn that the ship is about to settle in.
void measure_steady_turn(const Ship& ship, TurningCircle& circle, const Moment& last) {
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
TurningCircle sail_circle(const Ship& ship, const ActingShip<Model>& acting, const TurnOrder& order,
                          const ManoeuvreOptions& options) {
  const auto& model = acting.model;
  const Plan planned = plan(model, options, 100.0);
  const double speed = planned.speed, end = planned.end;
  const auto& propulsion = planned.propulsion;
  const auto& times = planned.times;
  return with_voyage(acting, approach(speed, propulsion), options.tolerance, [&](auto& voyage) {
    voyage.sample_at(times);
    voyage.trace(options.traced);
    voyage.order(rudder_sign(order.side) * order.rudder);
    TurningCircle circle{.approach_speed = speed, .propulsion = propulsion, .run = {}, .steps = {}};
    const double turn = yaw_sign(order.side);
    measure_first_half(voyage, circle, turn, end);
    if (options.duration) voyage.sail(end);
    else sail_towards_steady(voyage, circle, turn, end);
    if (!circle.way_lost) measure_steady_turn(ship, circle, now(voyage));
    if (options.sampled) circle.run = recording_of(voyage.samples(), acting);
    circle.steps = std::move(voyage.steps());
    return circle;
  });
}

}  // namespace

TurningCircle turning_circle(const Ship& ship, const TurnOrder& order, const ManoeuvreOptions& options) {
  require_rudder(order.rudder, steering_gear(ship));
  auto circle = visit_acting(ship, [&](const auto& acting) { return sail_circle(ship, acting, order, options); });
  circle.run.name = ship.name;
  circle.run.facts.execute = 0.0;
  circle.run.facts.manoeuvre = fmt::format("turn {:.6g} to {}", degrees(order.rudder), name_of(order.side));
  return circle;
}

}  // namespace swayaw
