#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "../simulation/step_replay.hpp"
#include "../steady/small_matrices.hpp"
#include "../steady/steady_balance.hpp"
#include "settle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

constexpr int lanes = static_cast<int>(slopes_at_once) + 1;  // and one for the time
using D = Dual<lanes>;

template <template <class> class Indices>
Indices<D> none_of() {
  Indices<D> indices;
  for (const auto& p : Indices<D>::parameters()) indices.*p.member = D(missing);
  return indices;
}

// ---------------------------------------------------------------- start

/// The ship in duals at her approach speed, and what propels her.
template <template <class> class Model>
struct Approach {
  Model<D> ship;
  D speed;
  Controls<D> propulsion;
};

/// du/dt straight ahead.
template <class Ship, class S>
S straight_acceleration(const Ship& ship, const S& speed, const Controls<S>& controls) {
  const PlanarMotion<S> m{speed, S(0.0), S(0.0)};
  return acceleration(ship, m, forces(ship, m, controls).total()).u;
}

/// Shaft speed, or thrust of both propellers, moved by a factor.
template <class S>
Controls<S> driven(const Controls<double>& c, const S& factor) {
  return {S(c.delta), S(c.rev * factor), {S(c.thrust.port * factor), S(c.thrust.starboard * factor)}, c.by_thrust};
}

/// What keeps the ship at that speed whatever her numbers are: with du/dt = a(theta, factor) = 0 the factor has
/// −(∂a/∂theta)/(∂a/∂factor).
template <template <class> class Model>
Controls<D> self_propelled(const Model<double>& model, const Model<D>& ship, const D& speed,
                           const Controls<double>& controls) {
  const double by_factor = straight_acceleration(cast<D>(model), D(speed.a), driven(controls, D(1.0, 0))).v[0];
  D factor(1.0);
  if (by_factor != 0.0) factor.v = -straight_acceleration(ship, speed, cast<D>(controls)).v / by_factor;
  return driven(controls, factor);
}

template <template <class> class Model>
Approach<Model> approach_of(const Model<double>& model, std::span<const Parameter> numbers,
                            const ManoeuvreOptions& options, const Controls<double>& propulsion) {
  Approach<Model> a{seeded<lanes>(model, numbers), {}, {}};
  a.speed = options.speed ? D(*options.speed) : a.ship.particulars.U_0;
  const bool given = options.rev || options.thrust;
  a.propulsion = given ? cast<D>(propulsion) : self_propelled(model, a.ship, a.speed, propulsion);
  return a;
}

template <template <class> class Model>
StepReplay<Model, lanes> replay_of(const Approach<Model>& a, const Ship& ship, std::span<const ManoeuvreStep> steps) {
  return {a.ship, surroundings_at(ship, 0.0).current, a.speed, a.propulsion, steps};
}

// ---------------------------------------------------------------- steady turn

/// The steady motion in duals.
template <template <class> class Model>
PlanarMotion<D> steady_in_duals(const Ship& bare, const Model<D>& ship, const PlanarMotion<double>& m,
                                const Controls<D>& controls) {
  const PlanarMotion<D> fixed{D(m.u), D(m.v), D(m.r)};
  const auto by_theta = acceleration(ship, fixed, forces(ship, fixed, controls).total());
  const Controls<double> held{
      controls.delta.a, controls.rev.a, {controls.thrust.port.a, controls.thrust.starboard.a}, controls.by_thrust};
  const Eigen::Matrix3d J = SteadyEquations(bare, held).at(m, held.delta).jacobian.leftCols<3>();
  Eigen::Matrix<double, 3, lanes> slopes;
  for (int k = 0; k < lanes; ++k)
    slopes.col(k) = -solve(J, Eigen::Vector3d(by_theta.u.v[k], by_theta.v.v[k], by_theta.r.v[k]));
  return {D(m.u, slopes.row(0).transpose()), D(m.v, slopes.row(1).transpose()), D(m.r, slopes.row(2).transpose())};
}

template <class S>
void put_steady(CircleIndices<S>& i, const PlanarMotion<S>& steady, double turn) {
  i.u = steady.u;
  i.v = turn * steady.v;
  i.r = turn * steady.r;
  i.U = speed(steady);
  i.beta = turn * drift_angle(steady);
  i.D = 2.0 * i.U / i.r;
}

// ---------------------------------------------------------------- the manoeuvres once more

template <template <class> class Model>
CircleIndices<D> circle_in_duals(const Ship& ship, const Model<double>& model, const TurnOrder& order,
                                 const ManoeuvreOptions& options, const TurningCircle& circle,
                                 std::span<const Parameter> numbers) {
  const auto start = approach_of(model, numbers, options, circle.propulsion);
  auto stepper = replay_of(start, ship, circle.steps);
  auto i = none_of<CircleIndices>();
  const double turn = yaw_sign(order.side);
  const auto round = [&](double angle) { return stepper.advance([&](const auto& s) { return turn * s.psi - angle; }); };
  stepper.order(rudder_sign(order.side) * order.rudder);
  if (round(radians(10.0)) && circle.initial_turning) i.initial_turning = stepper.way();
  if (circle.time_90 && round(radians(90.0))) {
    i.time_90 = stepper.time();
    i.advance = stepper.state().x;
    i.transfer = turn * stepper.state().y;
  }
  if (circle.time_180 && round(radians(180.0))) {
    i.time_180 = stepper.time();
    i.tactical_diameter = turn * stepper.state().y;
  }
  if (circle.steady)
    put_steady(i, steady_in_duals(ship, start.ship, *circle.steady, stepper.controls_at(D(circle.steps.back().to))),
               turn);
  return i;
}

template <template <class> class Model>
ZigzagIndices<D> zigzag_in_duals(const Ship& ship, const Model<double>& model, const ZigzagOrder& order,
                                 const ManoeuvreOptions& options, const Zigzag& zigzag,
                                 std::span<const Parameter> numbers) {
  using I = ZigzagIndices<D>;
  constexpr std::array overshoots{&I::overshoot_1, &I::overshoot_2, &I::overshoot_3, &I::overshoot_4};
  auto stepper = replay_of(approach_of(model, numbers, options, zigzag.propulsion), ship, zigzag.steps);
  auto i = none_of<ZigzagIndices>();
  std::vector<D> times;
  double turn = yaw_sign(order.first);
  stepper.order(-turn * order.rudder);
  for (const auto& reversal : zigzag.reversals) {
    stepper.advance([&](const auto& s) { return turn * s.psi - order.heading; });
    if (times.empty() && zigzag.initial_turning) i.initial_turning = stepper.way();
    times.push_back(stepper.time());
    stepper.order(turn * order.rudder);
    if (!reversal.overshoot || !stepper.advance([](const auto& s) { return s.motion.r; })) break;
    if (times.size() <= overshoots.size()) i.*overshoots[times.size() - 1] = turn * stepper.state().psi - order.heading;
    turn = -turn;
  }
  if (times.size() >= 3) i.period = times.back() - times[times.size() - 3];
  return i;
}

/// Appends the derivatives of a chunk of numbers.
template <template <class> class Indices>
void append(Indices<Slopes>& slopes, const Indices<D>& chunk, std::size_t count) {
  constexpr auto from = Indices<D>::parameters();
  constexpr auto to = Indices<Slopes>::parameters();
  for (std::size_t k = 0; k < from.size(); ++k) {
    const D& index = chunk.*from[k].member;
    if (!std::isnan(index.a))
      (slopes.*to[k].member).insert((slopes.*to[k].member).end(), index.v.data(), index.v.data() + count);
  }
}

/// A current acts on the place alone.
/// @throws Refusal  for a ship with effects, which the steps in duals do not have
void require_bare(const Ship& ship) {
  for (const auto& effect : ship.effects)
    if (!is_null(effect) && place_of(effect) != EffectPlace::water)
      throw Refusal(
          fmt::format("exact derivatives of indices are those of a ship without effects; take {} out of the ship file",
                      id_of(effect)));
}

/// A chunk after the other.
template <template <class> class Indices, class InDuals>
Indices<Slopes> in_chunks(const Ship& ship, std::span<const Parameter> numbers, const InDuals& in_duals) {
  require_calm(ship, "exact derivative");
  require_bare(ship);
  Indices<Slopes> slopes;
  for (; !numbers.empty(); numbers = numbers.subspan(std::min(numbers.size(), slopes_at_once))) {
    const auto chunk = numbers.first(std::min(numbers.size(), slopes_at_once));
    append(slopes, std::visit([&](const auto& model) { return in_duals(model, chunk); }, ship.model), chunk.size());
  }
  return slopes;
}

double or_missing(const std::optional<double>& value) { return value.value_or(missing); }

}  // namespace

CircleIndices<> indices_of(const TurningCircle& circle, Side side) {
  CircleIndices<> i{};
  for (const auto& p : i.parameters()) i.*p.member = missing;
  i.advance = or_missing(circle.advance);
  i.transfer = or_missing(circle.transfer);
  i.tactical_diameter = or_missing(circle.tactical_diameter);
  i.time_90 = or_missing(circle.time_90);
  i.time_180 = or_missing(circle.time_180);
  i.initial_turning = or_missing(circle.initial_turning);
  if (circle.steady) put_steady(i, *circle.steady, yaw_sign(side));
  return i;
}

ZigzagIndices<> indices_of(const Zigzag& zigzag) {
  using I = ZigzagIndices<>;
  constexpr std::array overshoots{&I::overshoot_1, &I::overshoot_2, &I::overshoot_3, &I::overshoot_4};
  I i{missing, missing, missing, missing, or_missing(zigzag.period), or_missing(zigzag.initial_turning)};
  for (std::size_t k = 0; k < std::min(overshoots.size(), zigzag.reversals.size()); ++k)
    i.*overshoots[k] = or_missing(zigzag.reversals[k].overshoot);
  return i;
}

CircleIndices<Slopes> index_slopes(const Ship& ship, const TurnOrder& order, const ManoeuvreOptions& options,
                                   const TurningCircle& circle, std::span<const Parameter> numbers) {
  return in_chunks<CircleIndices>(ship, numbers, [&](const auto& model, auto chunk) {
    return circle_in_duals(ship, model, order, options, circle, chunk);
  });
}

ZigzagIndices<Slopes> index_slopes(const Ship& ship, const ZigzagOrder& order, const ManoeuvreOptions& options,
                                   const Zigzag& zigzag, std::span<const Parameter> numbers) {
  return in_chunks<ZigzagIndices>(ship, numbers, [&](const auto& model, auto chunk) {
    return zigzag_in_duals(ship, model, order, options, zigzag, chunk);
  });
}

}  // namespace swayaw::nonlinear
