#include "swayaw/nonlinear/manoeuvres/spiral.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "manoeuvre_run.hpp"
#include "settle.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

constexpr double differing = 1e-3;    // of yaw rates over U/L
constexpr double curve_step = 0.005;  // of the exact curve

std::optional<SpiralLoop> loop_of(const Spiral& s, double L) {
  double lowest = 0.0, highest = 0.0, height = 0.0;
  for (std::size_t i = 0; i < s.down.size(); ++i) {
    const auto &out = s.down[i], &back = s.up[s.up.size() - 1 - i];
    const double gap = std::abs(out.motion.r - back.motion.r);
    if (gap <= differing * s.approach_speed / L) continue;
    const auto [low, high] = std::minmax(out.delta, back.delta);
    lowest = height == 0.0 ? low : std::min(lowest, low);
    highest = height == 0.0 ? high : std::max(highest, high);
    height = std::max(height, gap);
  }
  if (height == 0.0) return std::nullopt;
  return SpiralLoop{.width = highest - lowest, .height = height};
}

SpiralPoint hold(ShipStepper& stepper, double delta, const Settling& settling, double L, double U) {
  const double start = stepper.time();
  stepper.order(delta + 0.0);  // 0 rather than -0
  const bool settled = settle(stepper, settling, L, U);
  return {
      .delta = stepper.shown(), .motion = stepper.state().motion, .held = stepper.time() - start, .settled = settled};
}

template <class Model>
Spiral run_spiral(const ActingShip<Model>& acting, const SpiralOrder& order, const ManoeuvreOptions& options) {
  const auto& model = acting.model;
  const auto angles = spiral_angles(order.largest, order.step);
  ManoeuvreOptions whole = options;
  whole.duration.reset();
  if (!whole.step) whole.step = round_down(0.2 * model.particulars.L / options.speed.value_or(model.particulars.U_0));
  const Plan planned = plan(acting, whole, order.settling.longest * 2.0 * static_cast<double>(angles.size()));
  const double U = planned.speed;
  const auto& propulsion = planned.propulsion;
  const auto& times = planned.times;
  const double L = model.particulars.L, sign = rudder_sign(order.first);
  const auto made = make_stepper(acting, approach(U, propulsion), options.tolerance);
  ShipStepper& stepper = *made;
  stepper.sample_at(times);
  Spiral result{.down = {},
                .up = {},
                .loop = {},
                .curve = {},
                .exact = {},
                .approach_speed = U,
                .propulsion = propulsion,
                .run = {}};
  for (const double angle : angles) result.down.push_back(hold(stepper, sign * angle, order.settling, L, U));
  result.up.push_back(result.down.back());
  for (std::size_t i = angles.size() - 1; i-- > 0;)
    result.up.push_back(hold(stepper, sign * angles[i], order.settling, L, U));
  if (options.sampled) result.run = recording_of(stepper.samples(), acting);
  return result;
}

/// Size of the yaw rate at the end of a curve, or at the largest rudder angle where the curve goes a little beyond.
double end_rate(const Ship& ship, const Controls<double>& propulsion, const SteadyTurn& end, double largest) {
  if (std::abs(end.delta) <= largest) return std::abs(end.motion.r);
  const auto steady = steady_motion(ship, with_rudder(propulsion, std::copysign(largest, end.delta)), end.motion);
  return std::abs(steady ? steady->motion.r : end.motion.r);
}

/// Evenly spaced yaw rates to both sides, 0 among them, up to the largest.
std::vector<double> even_yaw_rates(double largest, int steps) {
  std::vector<double> rates;
  for (int k = -steps; k <= steps; ++k) rates.push_back(largest * k / steps);
  return rates;
}

}  // namespace

std::vector<double> spiral_angles(double largest, double step) {
  require_positive(step, "step of the rudder angle [rad]");
  if (step > largest)
    throw std::domain_error(fmt::format("steps of {:.6g} deg are larger than the largest rudder angle, {:.6g} deg",
                                        degrees(step), degrees(largest)));
  std::vector<double> angles{largest};
  const auto inner = static_cast<int>(std::ceil(largest / step - 1e-9)) - 1;
  for (int k = inner; k >= -inner; --k) angles.push_back(k * step);
  angles.push_back(-largest);
  return angles;
}

Spiral spiral(const Ship& ship, const SpiralOrder& order, const ManoeuvreOptions& options) {
  require_calm(ship, "spiral");
  require_rudder(order.largest, steering_gear(ship));
  auto result = visit_acting(ship, [&](const auto& acting) { return run_spiral(acting, order, options); });
  result.loop = loop_of(result, length(ship));
  result.curve = steady_turn_curve(ship, result.propulsion, order.largest, curve_step);
  result.exact = instability_loop(result.curve);
  result.run.name = ship.name;
  result.run.facts.execute = 0.0;
  result.run.facts.manoeuvre = fmt::format("spiral {:.6g} first {}", degrees(order.largest), name_of(order.first));
  return result;
}

ReverseSpiral reverse_spiral(const Ship& ship, const ReverseSpiralOrder& order, const ManoeuvreOptions& options) {
  require_calm(ship, "reverse spiral");
  require_rudder(order.largest, steering_gear(ship));
  if (order.steps < 1)
    throw std::domain_error(
        fmt::format("a reverse spiral needs at least one yaw rate on each side, got {}", order.steps));
  const double speed = require_positive(options.speed.value_or(service_speed(ship)), "approach speed [m/s]");
  const auto propulsion = swayaw::propulsion(ship, speed, options.rev, options.thrust);
  const auto curve = steady_turn_curve(ship, propulsion, order.largest);
  const double largest = std::min(end_rate(ship, propulsion, curve.front(), order.largest),
                                  end_rate(ship, propulsion, curve.back(), order.largest));
  const auto rates = even_yaw_rates(largest, order.steps);
  return {.points = held_yaw_rates(ship, propulsion, rates, order.largest),
          .approach_speed = speed,
          .propulsion = propulsion};
}

std::vector<HeldYawRate> held_yaw_rates(const Ship& ship, const Controls<double>& propulsion,
                                        std::span<const double> yaw_rates, double largest) {
  const auto curve = steady_turn_curve(ship, propulsion, largest);
  std::vector<HeldYawRate> points;
  for (const double r : yaw_rates) points.push_back({r, turn_at_yaw_rate(ship, propulsion, curve, r, largest)});
  return points;
}

}  // namespace swayaw::nonlinear
