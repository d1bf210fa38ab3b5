#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_manoeuvres.hpp"
#include "swayaw/nonlinear/equilibria.hpp"

namespace swayaw {
namespace {

using test::RandomShips;
using test::with_model;

PullOut patient_pull_out(const MmgShip<double>& model) {
  return pull_out(with_model(model), {.rudder = 0.6 * model.steering_gear.max_angle, .settling = test::patient},
                  test::precise);
}

std::vector<SteadyMotion> turns_amidships(const MmgShip<double>& model) {
  return steady_turns(with_model(model), self_propulsion(model, model.particulars.U_0));
}

TEST_CASE("what a pull-out leaves are the outermost steady motions with the rudder amidships",
          "[nonlinear][second-route]") {
  RandomShips random(61);
  int compared = 0;
  for (int i = 0; i < 20; ++i) {
    const auto model = random.ship();
    const auto result = patient_pull_out(model);
    const auto turns = turns_amidships(model);
    const auto agrees = [&](const PullOutSide& side, const SteadyMotion& outermost) {
      if (!side.settled) return;
      ++compared;
      CHECK_THAT(side.residual, WithinAbs(outermost.motion.r, 1e-6 * test::yaw_unit(model)));
    };
    agrees(result.sides.port, turns.front());
    agrees(result.sides.starboard, turns.back());
  }
  CHECK(compared > 35);
}

TEST_CASE("a stable ship comes back to a straight course from both sides, after a gentle turn as fast as her T1 tells",
          "[nonlinear][second-route]") {
  RandomShips random(62);
  int stable = 0;
  for (int i = 0; i < 30; ++i) {
    const auto model = random.ship();
    const PullOutOrder gentle{.rudder = 0.03 * model.steering_gear.max_angle,
                              .settling = {.tolerance = 1e-10, .longest = 2000.0}};
    const auto result = pull_out(with_model(model), gentle, {.tolerance = 1e-13, .sampled = false});
    for (const auto* side : {&result.sides.port, &result.sides.starboard}) {
      if (!side->T1 || *side->T1 < 0.0 || *side->T1 > 20.0 / test::yaw_unit(model) || !side->settled) continue;
      ++stable;
      CHECK(std::abs(side->residual) < 1e-6 * test::yaw_unit(model));
      REQUIRE(side->decay_time);
      CHECK_THAT(*side->decay_time, WithinRel(*side->T1, 0.02));
    }
  }
  CHECK(stable > 10);
}

TEST_CASE("residual yaw rates of an unstable ship differ by the height of her loop", "[nonlinear][second-route]") {
  const auto model = test::symmetric_as_negative(test::mmg(test::kvlcc2_l7()));
  const auto result = patient_pull_out(model);
  const auto loop = instability_loop(steady_turn_curve(with_model(model), result.propulsion, 0.6, 0.002));
  REQUIRE(loop);
  CHECK_THAT(result.sides.starboard.residual - result.sides.port.residual, WithinRel(loop->height, 1e-3));
  CHECK(result.sides.starboard.T1.value() < 0.0);
}

TEST_CASE("a mirrored ship pulls out of the mirrored turn", "[nonlinear][symmetry]") {
  RandomShips random(63);
  for (int i = 0; i < 10; ++i) {
    const auto model = random.ship();
    const auto ship = patient_pull_out(model), mirror = patient_pull_out(test::mirrored(model));
    const auto same = [&](const PullOutSide& a, const PullOutSide& b) {
      CHECK_THAT(a.turning, WithinAbs(-b.turning, 1e-8 * test::yaw_unit(model)));
      CHECK_THAT(a.residual, WithinAbs(-b.residual, 1e-7 * test::yaw_unit(model)));
      CHECK(a.fall_time.value() == Approx(b.fall_time.value()).epsilon(1e-6));
    };
    same(ship.sides.port, mirror.sides.starboard);
    same(ship.sides.starboard, mirror.sides.port);
  }
}

TEST_CASE("the fall time is where 1/e of the turn is left in the time series", "[nonlinear][second-route]") {
  const auto result = pull_out(test::kvlcc2_l7(), {.rudder = radians(20)}, {.step = 0.01});
  for (const auto* side : {&result.sides.port, &result.sides.starboard}) {
    const auto r = side->run[Channel::r];
    const auto at = static_cast<std::size_t>(std::lround((side->execute + side->fall_time.value()) / 0.01));
    const double left = (r[at] - side->residual) / (side->turning - side->residual);
    CHECK_THAT(left, WithinAbs(std::exp(-1.0), 2e-3));
    CHECK(side->run.time.back() > side->execute + *side->fall_time);
  }
  CHECK(result.sides.port.run.facts.manoeuvre == "pullout 20 from port");
}

TEST_CASE("the Mariner, not the same to both sides, comes from both turns to the one she makes by herself",
          "[nonlinear][second-route]") {
  const Ship ship = read_ship(test::ships / "mariner.toml");
  const auto result = pull_out(ship, {.rudder = radians(20), .settling = test::patient}, test::precise);
  const auto turns = steady_turns(ship, result.propulsion);
  REQUIRE(turns.size() == 1);
  const double unit = service_speed(ship) / length(ship);
  for (const auto* side : {&result.sides.port, &result.sides.starboard})
    CHECK_THAT(side->residual, WithinAbs(turns[0].motion.r, 1e-6 * unit));
}

TEST_CASE("pull-outs of no sense are refused in words", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_WITH(pull_out(ship, {.rudder = radians(40)}),
                    "rudder angle 40 deg is beyond the ship's largest, 35 deg");
  Ship windy = ship;
  windy.surroundings.windy = true;
  CHECK_THROWS_WITH(pull_out(windy, {.rudder = radians(10)}), ContainsSubstring("no turn is steady in wind"));
  CHECK_THROWS_WITH(pull_out(ship, {.rudder = radians(10)}, {.speed = 0.0}),
                    "approach speed [m/s] must be positive, got 0");
}

}  // namespace
}  // namespace swayaw
