#include "swayaw/nonlinear/equilibria.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "random_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

namespace swayaw {
namespace {

Ship ship_of(const MmgShip<double>& model) {
  return {.name = "random", .model = model, .confidence = {}, .surroundings = {}};
}

/// Largest acceleration of u, v and r in units of U²/L.
double acceleration_of(const MmgShip<double>& ship, const PlanarMotion<double>& m, const Controls<double>& c) {
  const auto a = acceleration(ship, m, forces(ship, m, c).total());
  const double L = ship.particulars.L, unit = speed(m) * speed(m) / L;
  return std::max({std::abs(a.u), std::abs(a.v), std::abs(a.r) * L}) / unit;
}

TEST_CASE("nothing accelerates anywhere on the r-delta curve", "[nonlinear][second-route]") {
  test::RandomShips random(41);
  for (int i = 0; i < 20; ++i) {
    const auto model = random.ship();
    const auto propulsion = self_propulsion(model, model.particulars.U_0);
    const auto curve = steady_turn_curve(ship_of(model), propulsion, 0.6);
    REQUIRE(curve.size() > 10);
    for (const auto& turn : curve)
      CHECK(acceleration_of(model, turn.motion, with_rudder(propulsion, turn.delta)) < 1e-9);
  }
}

TEST_CASE("an unstable ship has three steady motions with the rudder amidships, the straight one unstable",
          "[nonlinear][limit]") {
  auto model = test::mmg(test::kvlcc2_l7());
  model.rudder.gamma_R_positive = model.rudder.gamma_R_negative;
  model.propeller.C_2_positive = model.propeller.C_2_negative;
  const Ship ship = ship_of(model);
  const auto propulsion = self_propulsion(ship, service_speed(ship));
  const auto turns = steady_turns(ship, propulsion);
  REQUIRE(turns.size() == 3);
  CHECK(turns[0].stable);
  CHECK_FALSE(turns[1].stable);
  CHECK(std::abs(turns[1].motion.r) < 1e-12);
  CHECK(turns[2].stable);
  const auto loop = instability_loop(steady_turn_curve(ship, propulsion, 0.6, 0.002));
  REQUIRE(loop);
  CHECK(loop->height == Approx(turns[2].motion.r - turns[0].motion.r).epsilon(1e-3));
}

TEST_CASE("KVLCC2 is unstable towards port turns only, where the rudder feels less of the drift",
          "[nonlinear][published]") {
  const Ship ship = test::kvlcc2_l7();
  const auto turns = steady_turns(ship, self_propulsion(ship, service_speed(ship)));
  REQUIRE(turns.size() == 2);
  CHECK(turns[0].stable);
  CHECK(turns[0].motion.r < 0.0);
  CHECK(std::abs(turns[1].motion.r) < 1e-12);
}

TEST_CASE("the curve passes through the end of a turning circle", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto circle = turning_circle(ship, {.rudder = radians(20), .side = Side::starboard}, {.sampled = false});
  REQUIRE(circle.steady);
  const auto turns = steady_turns(ship, with_rudder(circle.propulsion, -radians(20)));
  const auto same = [&](const SteadyMotion& s) { return std::abs(s.motion.r - circle.steady->r) < 1e-10; };
  CHECK(std::ranges::any_of(turns, same));
}

TEST_CASE("the r-delta curve of a mirrored ship is mirrored", "[nonlinear][symmetry]") {
  test::RandomShips random(42);
  for (int i = 0; i < 20; ++i) {
    const auto model = random.ship();
    const auto controls = with_rudder(self_propulsion(model, model.particulars.U_0), random.uniform(-0.5, 0.5));
    const auto turns = steady_turns(ship_of(model), controls);
    const auto mirror = steady_turns(ship_of(test::mirrored(model)), with_rudder(controls, -controls.delta));
    REQUIRE(turns.size() == mirror.size());
    for (std::size_t k = 0; k < turns.size(); ++k)
      CHECK(turns[k].motion.r == Approx(-mirror[turns.size() - 1 - k].motion.r)
                                     .margin(1e-9 * service_speed(ship_of(model)) / model.particulars.L));
  }
}

TEST_CASE("a stable ship has no instability loop", "[nonlinear][limit]") {
  test::RandomShips random(43);
  int stable = 0;
  for (int i = 0; i < 30; ++i) {
    const Ship ship = ship_of(random.ship());
    const auto straight = steady_motion(ship, self_propulsion(ship, service_speed(ship)), {service_speed(ship), 0, 0});
    if (!straight || !straight->stable) continue;
    ++stable;
    CHECK_FALSE(instability_loop(steady_turn_curve(ship, self_propulsion(ship, service_speed(ship)), 0.1)));
  }
  CHECK(stable > 3);
}

}  // namespace
}  // namespace swayaw
