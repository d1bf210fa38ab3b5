#include "swayaw/nonlinear/models/validity.hpp"

#include <catch.hpp>
#include <cmath>
#include <limits>

#include "model_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/replay.hpp"

#define EVERY_MODEL MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>

namespace swayaw {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEMPLATE_TEST_CASE("what no force model holds for is refused in words", "[nonlinear][refusal]", EVERY_MODEL) {
  test::RandomModels random(31);
  const auto model = random.ship<TestType>();
  const auto ship = test::ship_of(model);
  const double U = model.particulars.U_0, L = model.particulars.L;
  const auto forces_of = [&](const PlanarMotion<double>& m, const Controls<double>& c) {
    return force_breakdown(ship, {0.0, 0.0, 0.0, m}, c);
  };
  const auto controls = random.controls(model);
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(forces_of({0.0, 0.0, 0.0}, controls), "forces are known for way ahead, not for u = 0 m/s");
  CHECK_THROWS_WITH(forces_of({-1.0, 0.0, 0.0}, controls), "forces are known for way ahead, not for u = -1 m/s");
  CHECK_THROWS_WITH(forces_of({1e-6 * U, 0.0, 0.1 * U / L}, controls), Contains("turns on the spot"));
  for (const PlanarMotion<double>& m : {PlanarMotion<double>{nan, 0, 0}, {U, nan, 0}, {U, 0, nan}, {INFINITY, 0, 0}})
    CHECK_THROWS_WITH(forces_of(m, controls), "motion and controls must be finite numbers");
  CHECK_THROWS_WITH(forces_of({U, 0.0, 0.0}, with_rudder(controls, nan)), "motion and controls must be finite numbers");
  Controls<double> astern{.delta = 0.0, .rev = -0.5};
  CHECK_THROWS_WITH(forces_of({U, 0.0, 0.0}, astern),
                    "the thrust is known for a shaft that turns ahead, not at -0.5 1/s");
  CHECK_THROWS_AS(linearize(ship, {{U, 0.0, 0.0}, astern}), Refusal);
  CHECK_THROWS_AS(linearize(ship, {{0.0, 0.0, 0.0}, controls}), Refusal);
  CHECK_THROWS_AS(linearize(ship, {{nan, 0.0, 0.0}, controls}), Refusal);
}

TEMPLATE_TEST_CASE("forces are finite wherever they are given", "[nonlinear][limit]", EVERY_MODEL) {
  test::RandomModels random(32);
  for (int i = 0; i < 300; ++i) {
    const auto model = random.ship<TestType>();
    const double U = model.particulars.U_0, L = model.particulars.L;
    const double u = U * std::pow(10.0, random.uniform(-6.0, 0.3)), v = u * random.uniform(-30.0, 30.0);
    const PlanarMotion<double> m{u, v, random.uniform(-9.9, 9.9) * std::hypot(u, v) / L};
    auto controls = random.controls(model);
    controls.rev *= random.uniform(0.0, 1.0) < 0.3 ? 0.0 : 1.0;
    const auto split = force_breakdown(test::ship_of(model), {0.0, 0.0, 0.0, m}, controls);
    CHECK(std::isfinite(split.total.X + split.total.Y + split.total.N));
  }
}

TEST_CASE("a replay refuses a shaft that turns astern, with the time", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 30.0, .step = 0.5}).run;
  run.fill(Channel::rev);
  for (std::size_t i = 0; i < run.samples(); ++i) run.channels[index_of(Channel::rev)][i] = i < 20 ? 10.0 : -2.0;
  CHECK_THROWS_WITH(replay(ship, run),
                    "the thrust is known for a shaft that turns ahead: the recorded shaft turns astern at 10 s");
}

TEST_CASE("a manoeuvre refuses propulsion that is no number", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_AS(turning_circle(ship, {.rudder = radians(20)}, {.thrust = nan}), Refusal);
  CHECK_THROWS(turning_circle(ship, {.rudder = radians(20)}, {.rev = -1.0}));
  CHECK_THROWS(turning_circle(ship, {.rudder = radians(20)}, {.speed = 0.0}));
}

}  // namespace
}  // namespace swayaw
