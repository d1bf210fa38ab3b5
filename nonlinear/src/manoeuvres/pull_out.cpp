#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"

#include <cmath>

#include "../steady/acting_propulsion.hpp"
#include "manoeuvre_run.hpp"
#include "settle.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/nonlinear/linearization.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

/// Share of the change of yaw rate that is left.
double left(const PullOutSide& side, const Sample& m) {
  return std::abs((m.state.motion.r - side.residual) / (side.turning - side.residual));
}

/// When the share falls between two samples; its logarithm is a straight line there.
double crossing(const PullOutSide& side, const Sample& a, const Sample& b, double share) {
  return a.time + (b.time - a.time) * std::log(left(side, a) / share) / std::log(left(side, a) / left(side, b));
}

/// First or last fall below a share after the order.
std::optional<double> fall(const std::vector<Sample>& samples, const PullOutSide& side, double share, bool first) {
  std::optional<double> time;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto &a = samples[i - 1], &b = samples[i];
    if (a.time < side.execute || left(side, a) <= share || left(side, b) > share) continue;
    time = left(side, b) > 0.0 ? crossing(side, a, b, share) : b.time;
    if (first) return time;
  }
  return time;
}

/// Last falls, since the yaw rate of a ship that is not the same to both sides may pass its final value before it comes
/// back.
void measure_decay(PullOutSide& side, const std::vector<Sample>& samples) {
  if (const auto e = fall(samples, side, std::exp(-1.0), true)) side.fall_time = *e - side.execute;
  const auto thousandth = fall(samples, side, 1e-3, false), tenth_of_it = fall(samples, side, 1e-4, false);
  if (side.settled && thousandth && tenth_of_it && *tenth_of_it > *thousandth)
    side.decay_time = (*tenth_of_it - *thousandth) / std::log(10.0);
}

/// Slower time constant of sway and yaw on the straight course [s]; nothing without a straight course or real poles.
std::optional<double> linear_T1(const Ship& ship, const Controls<double>& propulsion, Side side) {
  const auto steady = steady_motion(ship, propulsion, {service_speed(ship), 0.0, 0.0});
  if (!steady) return std::nullopt;
  const auto linear = linearize(ship, {steady->motion, propulsion}, side);
  const auto T = time_constants(transfer_functions(sway_yaw(linear.whole, linear.scale)));
  if (!T) return std::nullopt;
  return T->T1 * linear.scale.L / linear.scale.U;
}

template <class Model>
PullOutSide run_pull_out(const Ship& ship, const ActingShip<Model>& acting, const TurnOrder& order,
                         const Settling& settling, const ManoeuvreOptions& options) {
  const auto& model = acting.model;
  ManoeuvreOptions whole = options;
  whole.duration.reset();
  whole.sampled = true;
  const Plan planned = plan(acting, whole, 2.0 * settling.longest);
  const double U = planned.speed;
  const auto& propulsion = planned.propulsion;
  const auto& times = planned.times;
  const double L = model.particulars.L;
  const auto made = make_stepper(acting, approach(U, propulsion), options.tolerance);
  ShipStepper& stepper = *made;
  stepper.sample_at(times);
  stepper.order(rudder_sign(order.side) * order.rudder);
  PullOutSide result{};
  result.turning_settled = settle(stepper, settling, L, U);
  result.execute = stepper.time();
  result.turning = stepper.state().motion.r;
  stepper.order(0.0);
  result.settled = settle(stepper, settling, L, U);
  result.residual = stepper.state().motion.r;
  measure_decay(result, stepper.samples());
  result.T1 = linear_T1(ship, propulsion, order.side);
  if (options.sampled) result.run = recording_of(stepper.samples(), acting);
  result.run.name = ship.name;
  result.run.facts.execute = 0.0;
  result.run.facts.manoeuvre = fmt::format("pullout {:.6g} from {}", degrees(order.rudder), name_of(order.side));
  return result;
}

}  // namespace

PullOut pull_out(const Ship& ship, const PullOutOrder& order, const ManoeuvreOptions& options) {
  require_calm(ship, "pull-out");
  require_rudder(order.rudder, steering_gear(ship));
  const auto both = [&](const auto& acting) {
    const auto& model = acting.model;
    const auto from = [&](Side side) {
      return run_pull_out(ship, acting, {order.rudder, side}, order.settling, options);
    };
    const double speed = options.speed.value_or(model.particulars.U_0);
    return PullOut{.sides = {from(Side::port), from(Side::starboard)},
                   .approach_speed = speed,
                   .propulsion = acting_propulsion(acting, speed, options.rev, options.thrust)};
  };
  auto result = visit_acting(ship, both);
  if (!options.step) return result;
  const auto measured = pull_out(ship, order, measuring(options, options.duration));
  for (const auto side : {&Sides<PullOutSide>::port, &Sides<PullOutSide>::starboard}) {
    (result.sides.*side).fall_time = (measured.sides.*side).fall_time;
    (result.sides.*side).decay_time = (measured.sides.*side).decay_time;
  }
  return result;
}

}  // namespace swayaw::nonlinear
