#include "swayaw/nonlinear/manoeuvres/williamson_turn.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "manoeuvre_run.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

TrackPlace place_of(const ShipStepper& stepper, double turn) {
  return {.time = stepper.time(), .along = stepper.state().x, .offset = turn * stepper.state().y};
}

/// The three rudder orders, as far as the ship comes. @param turn  sign of a heading change to the first side
void give_orders(ShipStepper& stepper, WilliamsonTurn& result, const WilliamsonOrder& order, double turn, double end) {
  stepper.order(-turn * order.rudder);
  if (!stepper.advance(end, [&](const auto& s) { return turn * s.psi - order.heading; })) return;
  result.shifted = place_of(stepper, turn);
  stepper.order(turn * order.rudder);
  if (!stepper.advance(end, [&](const auto& s) { return turn * s.psi + pi - order.before; })) return;
  result.amidships = place_of(stepper, turn);
  stepper.order(0.0);
  // the ship arrives where the heading left passes zero, or rests where the yaw rate does
  const auto left = [turn](const auto& s) { return turn * s.psi + pi; };
  stepper.advance(end, [&](const auto& s) { return std::min(left(s), -turn * s.motion.r); });
  if (std::abs(left(stepper.state())) < 1e-9) result.reciprocal = place_of(stepper, turn);
}

template <class Model>
WilliamsonTurn run_williamson(const ActingShip<Model>& acting, const WilliamsonOrder& order,
                              const ManoeuvreOptions& options) {
  const Plan planned = plan(acting, options, 100.0);
  const auto made = approaching(acting, planned, options);
  ShipStepper& stepper = *made;
  WilliamsonTurn result{.shifted = {},
                        .amidships = {},
                        .reciprocal = {},
                        .way = {},
                        .heading = 0.0,
                        .yaw_rate = 0.0,
                        .approach_speed = planned.speed,
                        .propulsion = planned.propulsion,
                        .run = {}};
  const double turn = yaw_sign(order.first);
  give_orders(stepper, result, order, turn, planned.end);
  if (result.reciprocal) result.way = way_made(stepper.samples(), now(stepper), result.reciprocal->time);
  if (options.duration) stepper.advance(planned.end);
  result.heading = turn * stepper.state().psi;
  result.yaw_rate = stepper.state().motion.r;
  if (options.sampled) result.run = recording_of(stepper.samples(), acting);
  return result;
}

}  // namespace

WilliamsonTurn williamson_turn(const Ship& ship, const WilliamsonOrder& order, const ManoeuvreOptions& options) {
  require_rudder(order.rudder, steering_gear(ship));
  require_positive(order.heading, "heading angle [rad]");
  require_positive(order.before, "angle before the reciprocal heading [rad]");
  if (!(order.before < pi))
    throw std::domain_error(fmt::format("{:.6g} deg before the reciprocal heading is the approach heading or beyond",
                                        degrees(order.before)));
  auto result = visit_acting(ship, [&](const auto& acting) { return run_williamson(acting, order, options); });
  if (options.step && options.sampled && result.reciprocal)
    result.way = williamson_turn(ship, order, measuring(options, just_after(result.reciprocal->time))).way;
  result.run.name = ship.name;
  result.run.facts.execute = 0.0;
  result.run.facts.manoeuvre =
      fmt::format("williamson turn {:.6g} first {}", degrees(order.rudder), name_of(order.first));
  return result;
}

}  // namespace swayaw::nonlinear
