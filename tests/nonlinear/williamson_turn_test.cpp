#include "swayaw/nonlinear/manoeuvres/williamson_turn.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_manoeuvres.hpp"

namespace swayaw {
namespace {

using test::RandomShips;
using test::with_model;

TEST_CASE("the orders of a Williamson turn are given at 60 deg and at 20 deg before the reciprocal heading",
          "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  for (const Side first : {Side::starboard, Side::port}) {
    const double turn = yaw_sign(first);
    const auto whole = williamson_turn(ship, {.first = first}, {.sampled = false});
    const auto heading_at = [&](const TrackPlace& place) {
      const auto part = williamson_turn(ship, {.first = first}, {.duration = place.time, .step = place.time / 4});
      CHECK_THAT(part.run[Channel::x].back(), WithinAbs(place.along, 1e-7));
      CHECK_THAT(turn * part.run[Channel::y].back(), WithinAbs(place.offset, 1e-7));
      return turn * degrees(part.run[Channel::psi].back());
    };
    CHECK_THAT(heading_at(whole.shifted.value()), WithinAbs(60.0, 1e-7));
    CHECK_THAT(heading_at(whole.amidships.value()), WithinAbs(-160.0, 1e-7));
    CHECK_THAT(heading_at(whole.reciprocal.value()), WithinAbs(-180.0, 1e-7));
    CHECK_THAT(degrees(whole.heading), WithinAbs(-180.0, 1e-7));
    CHECK_FALSE(whole.way);
  }
}

TEST_CASE("the rudder of a Williamson turn goes hard over, to the other side, and amidships", "[nonlinear][limit]") {
  const auto turn = williamson_turn(test::kvlcc2_l7(), {}, {.step = 0.5});
  const auto delta_at = [&](double time) {
    return degrees(turn.run[Channel::delta][static_cast<std::size_t>(time / 0.5)]);
  };
  CHECK_THAT(delta_at(turn.shifted->time), WithinAbs(-35.0, 1e-9));
  CHECK_THAT(delta_at(turn.amidships->time), WithinAbs(35.0, 1e-9));
  CHECK_THAT(degrees(turn.run[Channel::delta].back()), WithinAbs(0.0, 1e-9));
  CHECK(turn.run.facts.manoeuvre == "williamson turn 35 first starboard");
}

TEST_CASE("a mirrored ship makes the mirrored Williamson turn", "[nonlinear][symmetry]") {
  RandomShips random(71);
  for (int i = 0; i < 15; ++i) {
    const auto model = random.ship();
    const double rudder = model.steering_gear.max_angle;
    const auto ship = williamson_turn(with_model(model), {.rudder = rudder, .first = Side::starboard});
    const auto mirror = williamson_turn(with_model(test::mirrored(model)), {.rudder = rudder, .first = Side::port});
    REQUIRE(ship.reciprocal.has_value() == mirror.reciprocal.has_value());
    CHECK(ship.heading == Approx(mirror.heading).margin(1e-7));
    if (!ship.reciprocal) continue;
    CHECK_THAT(mirror.reciprocal->time, WithinRel(ship.reciprocal->time, 1e-7));
    CHECK_THAT(mirror.reciprocal->offset, WithinAbs(ship.reciprocal->offset, 1e-6));
    CHECK_THAT(mirror.reciprocal->along, WithinAbs(ship.reciprocal->along, 1e-6));
  }
}

TEST_CASE("the way made in a Williamson turn is the length of the track", "[nonlinear][second-route]") {
  const auto turn = williamson_turn(test::kvlcc2_l7(), {}, {.step = 0.01});
  const auto x = turn.run[Channel::x], y = turn.run[Channel::y];
  double way = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) way += std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
  CHECK_THAT(turn.way.value(), WithinAbs(way, 0.02));
}

TEST_CASE("a swing that dies out before the reciprocal heading is told", "[nonlinear][limit]") {
  auto model = test::mmg(test::kvlcc2_l7());
  model.hull.N_r *= 3.0;  // a ship that stops turning at once
  const auto turn = williamson_turn(with_model(model), {.before = radians(120.0)});
  CHECK(turn.amidships);
  CHECK_FALSE(turn.reciprocal);
  CHECK_FALSE(turn.way);
  CHECK(turn.heading < -radians(60.0));
  CHECK(turn.heading > -radians(180.0));
}

TEST_CASE("Williamson turns of no sense are refused in words", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_WITH(williamson_turn(ship, {.rudder = radians(36)}),
                    "rudder angle 36 deg is beyond the ship's largest, 35 deg");
  CHECK_THROWS_WITH(williamson_turn(ship, {.heading = 0.0}), "heading angle [rad] must be positive, got 0");
  CHECK_THROWS_WITH(williamson_turn(ship, {.before = radians(200)}),
                    "200 deg before the reciprocal heading is the approach heading or beyond");
}

}  // namespace
}  // namespace swayaw
