#include "swayaw/nonlinear/manoeuvres/spiral.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>

#include "random_manoeuvres.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"

namespace swayaw {
namespace {

using test::RandomShips;
using test::with_model;

SpiralOrder order_of(const MmgShip<double>& model, Side first = Side::starboard) {
  return {.largest = 0.7 * model.steering_gear.max_angle, .first = first, .settling = test::patient};
}

/// Largest difference of two motions, speeds over U and yaw rates over U/L.
double difference(const MmgShip<double>& ship, const PlanarMotion<double>& a, const PlanarMotion<double>& b) {
  const double U = ship.particulars.U_0, L = ship.particulars.L;
  return std::max({std::abs(a.u - b.u) / U, std::abs(a.v - b.v) / U, std::abs(a.r - b.r) * L / U});
}

/// Whether no steady turn on the curve is unstable.
bool stable_everywhere(const std::vector<SteadyTurn>& curve) { return std::ranges::all_of(curve, &SteadyTurn::stable); }

// ---------------------------------------------------------------- direct spiral

TEST_CASE("where a spiral settles there is a stable steady turn", "[nonlinear][second-route]") {
  RandomShips random(51);
  int settled = 0, all = 0;
  for (int i = 0; i < 12; ++i) {
    const auto model = random.ship();
    const auto result = spiral(with_model(model), order_of(model), test::precise);
    for (const auto* way : {&result.down, &result.up})
      for (const auto& point : *way) {
        ++all;
        if (!point.settled) continue;
        ++settled;
        const auto turns = steady_turns(with_model(model), with_rudder(result.propulsion, point.delta));
        const auto here = [&](const SteadyMotion& s) { return difference(model, s.motion, point.motion) < 1e-6; };
        CHECK(std::ranges::any_of(turns, here));
      }
  }
  CHECK(settled > 0.95 * all);
}

TEST_CASE("the spiral of a stable ship has no loop", "[nonlinear][limit]") {
  RandomShips random(52);
  int stable = 0, compared = 0, all = 0;
  for (int i = 0; i < 30; ++i) {
    const auto model = random.ship();
    const auto result = spiral(with_model(model), order_of(model), test::precise);
    if (!stable_everywhere(result.curve)) continue;
    ++stable;
    CHECK_FALSE(result.loop);
    CHECK_FALSE(result.exact);
    for (std::size_t k = 0; k < result.down.size(); ++k) {
      const auto &down = result.down[k], &up = result.up[result.up.size() - 1 - k];
      ++all;
      if (!down.settled || !up.settled) continue;  // a ship that is hardly stable takes more than the time given
      ++compared;
      CHECK(difference(model, down.motion, up.motion) < 1e-6);
    }
  }
  CHECK(stable > 3);
  CHECK(compared > 0.97 * all);
}

TEST_CASE("the loop of an unstable ship's spiral is that of her steady turns, seen in steps",
          "[nonlinear][second-route]") {
  const auto model = test::symmetric_as_negative(test::mmg(test::kvlcc2_l7()));
  const double step = radians(0.1);
  const auto result =
      spiral(with_model(model), {.largest = radians(3.0), .step = step, .settling = test::patient}, test::precise);
  REQUIRE(result.loop);
  REQUIRE(result.exact);
  CHECK(result.loop->width <= result.exact->width);
  CHECK(result.exact->width < result.loop->width + 2.0 * step);
  // the largest gap between the two ways is at least that in the middle
  CHECK(result.loop->height >= result.exact->height * (1.0 - 1e-3));
  const auto middle = result.down.size() / 2;
  CHECK(result.down[middle].delta == 0.0);
  CHECK_THAT(result.down[middle].motion.r - result.up[middle].motion.r, WithinRel(result.exact->height, 2e-3));
}

TEST_CASE("a mirrored ship sails the mirrored spiral", "[nonlinear][symmetry]") {
  RandomShips random(53);
  for (int i = 0; i < 8; ++i) {
    const auto model = random.ship();
    const auto starboard = spiral(with_model(model), order_of(model), test::precise);
    const auto port = spiral(with_model(test::mirrored(model)), order_of(model, Side::port), test::precise);
    for (std::size_t k = 0; k < starboard.down.size(); ++k) {
      CHECK_THAT(port.down[k].delta, WithinAbs(-starboard.down[k].delta, 1e-12));
      CHECK(difference(model, port.down[k].motion, mirrored(starboard.down[k].motion)) < 1e-7);
      CHECK(difference(model, port.up[k].motion, mirrored(starboard.up[k].motion)) < 1e-7);
    }
  }
}

TEST_CASE("a spiral begins at the largest angle on the first side and comes back to it", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto result =
      spiral(ship, {.largest = radians(12.0), .step = radians(5.0), .first = Side::port}, {.step = 1.0});
  const std::vector<double> degrees_down{12.0, 10.0, 5.0, 0.0, -5.0, -10.0, -12.0};
  REQUIRE(result.down.size() == degrees_down.size());
  for (std::size_t k = 0; k < degrees_down.size(); ++k) {
    CHECK_THAT(degrees(result.down[k].delta), WithinAbs(degrees_down[k], 1e-9));
    CHECK_THAT(degrees(result.up[k].delta), WithinAbs(degrees_down[degrees_down.size() - 1 - k], 1e-9));
  }
  CHECK(result.down.front().motion.r < 0.0);
  double held = 0.0;
  for (const auto& point : result.down) held += point.held;
  for (std::size_t k = 1; k < result.up.size(); ++k) held += result.up[k].held;
  CHECK_THAT(result.run.time.back(), WithinAbs(held, 1.0));
  CHECK(result.run.facts.manoeuvre == "spiral 12 first port");
}

TEST_CASE("a ship of another model sails spirals too: the Mariner is stable and turns to starboard by herself",
          "[nonlinear][second-route]") {
  const Ship ship = read_ship(test::ships / "mariner.toml");
  const auto result = spiral(ship, {.settling = test::patient}, test::precise);
  CHECK_FALSE(result.loop);
  CHECK_FALSE(result.exact);
  const double U = service_speed(ship);
  for (const auto& point : result.down) {
    REQUIRE(point.settled);
    const auto steady = steady_motion(ship, with_rudder(result.propulsion, point.delta), point.motion);
    REQUIRE(steady);
    CHECK(steady->stable);
    CHECK_THAT(point.motion.r, WithinAbs(steady->motion.r, 1e-6 * U / length(ship)));
  }
  const auto& amidships = result.down[5];
  CHECK(amidships.delta == 0.0);
  CHECK(amidships.motion.r > 0.0);
  const auto held = held_yaw_rates(ship, result.propulsion, std::vector{0.0, amidships.motion.r}, radians(25.0));
  CHECK_THAT(held[1].turn.value().delta, WithinAbs(0.0, 1e-6));
  CHECK(held[0].turn.value().delta > 0.0);
}

TEST_CASE("a wait that is too short is told", "[nonlinear][limit]") {
  const auto result = spiral(test::kvlcc2_l7(), {.settling = {.tolerance = 1e-7, .longest = 3.0}}, {.sampled = false});
  CHECK(std::ranges::none_of(result.down, &SpiralPoint::settled));
  const double unit = 7.0 / 1.179;
  for (const auto& point : result.down) CHECK_THAT(point.held, WithinAbs(3.0 * unit, 1e-6));
}

// ---------------------------------------------------------------- reverse spiral

TEST_CASE("a reverse spiral holds each yaw rate on the curve of steady turns", "[nonlinear][second-route]") {
  RandomShips random(54);
  for (int i = 0; i < 12; ++i) {
    const auto model = random.ship();
    const auto result = reverse_spiral(with_model(model), {.largest = 0.7 * model.steering_gear.max_angle});
    REQUIRE(result.points.size() == 21);
    for (const auto& [r, turn] : result.points) {
      REQUIRE(turn);
      CHECK(turn->motion.r == Approx(r).margin(1e-12 * test::yaw_unit(model)));
      const auto controls = with_rudder(result.propulsion, turn->delta);
      const auto a = acceleration(model, turn->motion, forces(model, turn->motion, controls).total());
      const double L = model.particulars.L, unit = model.particulars.U_0 * test::yaw_unit(model);
      CHECK(std::max({std::abs(a.u), std::abs(a.v), std::abs(a.r) * L}) < 1e-10 * unit);
      const double U = model.particulars.U_0;
      const auto again = steady_motion(with_model(model), controls,
                                       {turn->motion.u + 1e-5 * U, turn->motion.v - 1e-5 * U, turn->motion.r});
      REQUIRE(again);
      CHECK(difference(model, again->motion, turn->motion) < 1e-7);
      if (r != 0.0) CHECK(again->stable == turn->stable);  // straight ahead the force has a kink
    }
  }
}

/// The rudder angle of a helmsman who keeps a yaw rate: proportional and integral, no steering gear between, RK4.
double simulated_helm(const MmgShip<double>& ship, const Controls<double>& propulsion, double yaw_rate, double end) {
  using State = std::array<double, 4>;  // u, v, r, integral
  const double unit = ship.particulars.L / ship.particulars.U_0;
  const auto helm = [&](const State& s) { return 3.0 * unit * (s[2] - yaw_rate) + s[3]; };
  const auto rate = [&](const State& s) {
    const PlanarMotion<double> m{s[0], s[1], s[2]};
    const auto a = acceleration(ship, m, forces(ship, m, with_rudder(propulsion, helm(s))).total());
    return State{a.u, a.v, a.r, 1.0 * (s[2] - yaw_rate)};
  };
  const auto plus = [](State a, const State& k, double f) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += f * k[i];
    return a;
  };
  const double h = 0.02 * unit;
  State s{ship.particulars.U_0, 0.0, 0.0, 0.0};
  for (double t = 0.0; t < end * unit; t += h) {
    const State k1 = rate(s), k2 = rate(plus(s, k1, h / 2)), k3 = rate(plus(s, k2, h / 2)), k4 = rate(plus(s, k3, h));
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return helm(s);
}

TEST_CASE("a helmsman who keeps the yaw rates of an unstable ship comes to the angles of the reverse spiral",
          "[nonlinear][second-route]") {
  const auto model = test::symmetric_as_negative(test::mmg(test::kvlcc2_l7()));
  const auto result = reverse_spiral(with_model(model), {.largest = radians(10.0), .steps = 8});
  int unstable = 0;
  for (const auto& [r, turn] : result.points) {
    REQUIRE(turn);
    unstable += !turn->stable;
    CHECK_THAT(simulated_helm(model, result.propulsion, r, 300.0), WithinAbs(turn->delta, 1e-6));
  }
  CHECK(unstable >= 3);
}

TEST_CASE("a yaw rate beyond the largest rudder angle is not held", "[nonlinear][limit]") {
  const auto model = test::mmg(test::kvlcc2_l7());
  const auto propulsion = self_propulsion(model, model.particulars.U_0);
  const std::vector<double> rates{0.1 * test::yaw_unit(model), 3.0 * test::yaw_unit(model)};
  const auto held = held_yaw_rates(with_model(model), propulsion, rates, radians(20.0));
  CHECK(held[0].turn);
  CHECK_FALSE(held[1].turn);
}

TEST_CASE("spirals of no sense are refused in words", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_WITH(spiral(ship, {.largest = radians(36)}), "rudder angle 36 deg is beyond the ship's largest, 35 deg");
  CHECK_THROWS_WITH(spiral(ship, {.step = radians(30)}),
                    "steps of 30 deg are larger than the largest rudder angle, 25 deg");
  CHECK_THROWS_WITH(spiral(ship, {.step = 0.0}), "step of the rudder angle [rad] must be positive, got 0");
  CHECK_THROWS_WITH(reverse_spiral(ship, {.largest = -0.1}), ContainsSubstring("rudder angle [rad] must be positive"));
  Ship windy = ship;
  windy.surroundings.windy = true;
  CHECK_THROWS_WITH(spiral(windy),
                    "no turn is steady in wind, which the spiral waits for; take the wind out of the ship file");
  CHECK_THROWS_AS(reverse_spiral(windy), Refusal);
  CHECK_THROWS_WITH(reverse_spiral(ship, {.steps = 0}),
                    "a reverse spiral needs at least one yaw rate on each side, got 0");
}

}  // namespace
}  // namespace swayaw
