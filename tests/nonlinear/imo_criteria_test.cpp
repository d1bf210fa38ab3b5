#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"

#include <algorithm>
#include <catch.hpp>

#include "random_manoeuvres.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw {
namespace {

using test::RandomShips;
using test::with_model;

const Criterion& named(const std::vector<Criterion>& all, std::string_view name, Side side) {
  const auto found = std::ranges::find_if(all, [&](const Criterion& c) { return c.name == name && c.side == side; });
  REQUIRE(found != all.end());
  return *found;
}

TEST_CASE("overshoot limits are those of MSC.137(76)", "[nonlinear][published]") {
  struct Row {
    double L_over_V, first, second;  // s, deg, deg
  };
  for (const auto& [L_over_V, first, second] :
       {Row{5, 10, 25}, Row{9.99, 10, 25}, Row{10, 10, 25}, Row{20, 15, 32.5}, Row{30, 20, 40}, Row{45, 20, 40}}) {
    CHECK_THAT(degrees(first_overshoot_limit(L_over_V)), WithinAbs(first, 1e-9));
    CHECK_THAT(degrees(second_overshoot_limit(L_over_V)), WithinAbs(second, 1e-9));
  }
}

TEST_CASE("the criteria hold what turning circle and zigzags tell", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2();
  const double L = length(ship), V = service_speed(ship);
  const auto all = imo_criteria(ship);
  CHECK(all.criteria.size() == 12);
  for (const Side side : {Side::starboard, Side::port}) {
    const auto circle = turning_circle(ship, {radians(35), side});
    const auto ten = zigzag(ship, {radians(10), radians(10), side}),
               twenty = zigzag(ship, {radians(20), radians(20), side});
    CHECK_THAT(named(all.criteria, "advance", side).value.value(), WithinRel(*circle.advance / L, 1e-12));
    CHECK_THAT(named(all.criteria, "tactical_diameter", side).value.value(),
               WithinRel(*circle.tactical_diameter / L, 1e-12));
    CHECK_THAT(named(all.criteria, "initial_turning", side).value.value(), WithinRel(*ten.initial_turning / L, 1e-12));
    CHECK_THAT(named(all.criteria, "first_overshoot_10_10", side).value.value(),
               WithinRel(degrees(*ten.reversals[0].overshoot), 1e-12));
    CHECK_THAT(named(all.criteria, "second_overshoot_10_10", side).value.value(),
               WithinRel(degrees(*ten.reversals[1].overshoot), 1e-12));
    CHECK_THAT(named(all.criteria, "first_overshoot_20_20", side).value.value(),
               WithinRel(degrees(*twenty.reversals[0].overshoot), 1e-12));
    CHECK_THAT(named(all.criteria, "second_overshoot_10_10", side).limit,
               WithinRel(degrees(second_overshoot_limit(L / V)), 1e-12));
  }
  for (const auto& c : all.criteria) CHECK(c.pass == (*c.value <= c.limit));
}

TEST_CASE("initial turning is the same in a turn at 10 deg as in a 10/10 zigzag", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const TurnOrder turn{radians(10), Side::port};
  const ZigzagOrder order{radians(10), radians(10), Side::port};
  const auto of_turn = criteria_of(turning_circle(ship, turn), turn, length(ship), turning_rudder(ship));
  const auto of_zigzag = criteria_of(zigzag(ship, order), order, length(ship));
  REQUIRE(of_turn.size() == 1);
  CHECK_THAT(of_turn[0].value.value(), WithinRel(named(of_zigzag, "initial_turning", Side::port).value.value(), 1e-6));
}

TEST_CASE("a mirrored ship meets the criteria of the other side", "[nonlinear][symmetry]") {
  RandomShips random(81);
  for (int i = 0; i < 6; ++i) {
    auto model = random.ship();
    model.steering_gear.max_angle = radians(35);
    const auto ship = imo_criteria(with_model(model)), mirror = imo_criteria(with_model(test::mirrored(model)));
    for (const auto& c : ship.criteria) {
      const auto& other = named(mirror.criteria, c.name, c.side == Side::port ? Side::starboard : Side::port);
      REQUIRE(c.value.has_value() == other.value.has_value());
      if (c.value) CHECK_THAT(*other.value, WithinAbs(*c.value, 1e-5));
      CHECK(c.limit == other.limit);
    }
  }
}

TEST_CASE("a ship with a tenth of her rudder fails", "[nonlinear][limit]") {
  auto model = test::mmg(test::kvlcc2());
  model.rudder.A_R *= 0.1;
  const auto all = imo_criteria(with_model(model));
  CHECK_FALSE(named(all.criteria, "initial_turning", Side::starboard).pass.value());
  CHECK_FALSE(named(all.criteria, "first_overshoot_10_10", Side::port).pass.value());
}

TEST_CASE("a manoeuvre cut short is not judged, and others than those of the standards tell nothing",
          "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const double L = length(ship);
  const TurnOrder turn{radians(35), Side::starboard};
  const auto cut = criteria_of(turning_circle(ship, turn, {.duration = 30.0}), turn, L, turning_rudder(ship));
  CHECK(named(cut, "advance", Side::starboard).pass == true);
  CHECK_FALSE(named(cut, "tactical_diameter", Side::starboard).value);
  CHECK_FALSE(named(cut, "tactical_diameter", Side::starboard).pass);
  const ZigzagOrder other{radians(15), radians(10), Side::starboard};
  CHECK(criteria_of(zigzag(ship, other), other, L).empty());
  const TurnOrder gentle{radians(20), Side::starboard};
  CHECK(criteria_of(turning_circle(ship, gentle), gentle, L, turning_rudder(ship)).empty());
}

TEST_CASE("a ship whose rudder does not go to 20 deg is refused", "[nonlinear][refusal]") {
  auto model = test::mmg(test::kvlcc2());
  model.steering_gear.max_angle = radians(15);
  CHECK_THROWS_WITH(imo_criteria(with_model(model)), "rudder angle 20 deg is beyond the ship's largest, 15 deg");
}

}  // namespace
}  // namespace swayaw
