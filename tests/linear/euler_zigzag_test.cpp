#include "swayaw/linear/euler_zigzag.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using test::RandomLinearShips;

LinearZigzagOrder ten_ten_of(std::size_t reversals = 3, Side first = Side::starboard) {
  auto order = test::ten_ten(2.5, first);
  order.reversals = reversals;
  return order;
}

TEST_CASE("Euler's method at ds' = 0.05 gives the numbers of the reference", "[linear][published]") {
  const auto& wanted = test::reference().at("zigzag_euler_ds0.05_printed_abc");
  const auto found = euler_zigzag(RandomLinearShips::tanker(), ten_ten_of(4)).reversals;
  REQUIRE(found.size() == 4);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK_THAT(found[i].execute, WithinAbs(wanted.at("execute_s")[i].get<double>(), 1e-9));
  for (std::size_t i = 0; i < 3; ++i)
    CHECK_THAT(degrees(found[i].overshoot), WithinAbs(wanted.at("overshoot_deg")[i].get<double>(), 1e-9));
}

TEST_CASE("its overshoots are 12, 10 and 15 % above the exact ones", "[linear][published]") {
  const auto exact = linear_zigzag(RandomLinearShips::tanker(), ten_ten_of()).reversals,
             euler = euler_zigzag(RandomLinearShips::tanker(), ten_ten_of()).reversals;
  const double percent[] = {12, 10, 15};
  for (std::size_t i = 0; i < 3; ++i)
    CHECK_THAT(100.0 * (euler[i].overshoot / exact[i].overshoot - 1.0), WithinAbs(percent[i], 0.5));
}

TEST_CASE("as the step shrinks Euler's zigzag becomes the exact one", "[linear][limit]") {
  RandomLinearShips random(81);
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    const auto m = random.ship();
    auto order = ten_ten_of(2);
    order.longest = 15.0;
    const auto exact = linear_zigzag(m, order);
    if (exact.reversals.size() < 2 || exact.reversals[1].overshoot > radians(60)) continue;
    order.longest = 20.0;
    const auto coarse = euler_zigzag(m, order, 0.01), fine = euler_zigzag(m, order, 1e-4);
    REQUIRE(fine.reversals.size() == 2);
    ++compared;
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK_THAT(fine.reversals[i].execute, WithinAbs(exact.reversals[i].execute, 0.01));
      CHECK_THAT(degrees(fine.reversals[i].overshoot), WithinAbs(degrees(exact.reversals[i].overshoot), 0.2));
    }
    const auto error = [&](const EulerZigzag& z) {
      return std::abs(z.reversals[0].overshoot - exact.reversals[0].overshoot);
    };
    CHECK(error(fine) < 0.1 * error(coarse) + radians(0.005));
  }
  CHECK(compared > 15);
}

TEST_CASE("a mirrored Euler zigzag is the mirrored one", "[linear][symmetry]") {
  const auto a = euler_zigzag(RandomLinearShips::tanker(), ten_ten_of()),
             b = euler_zigzag(RandomLinearShips::tanker(), ten_ten_of(3, Side::port));
  REQUIRE(a.steps.size() == b.steps.size());
  for (std::size_t i = 0; i < a.steps.size(); ++i) CHECK(a.steps[i].state.psi == -b.steps[i].state.psi);
}

TEST_CASE("the rudder never exceeds its rate or its order, and the test of the heading is at the start of a step",
          "[linear][limit]") {
  const auto zigzag = euler_zigzag(RandomLinearShips::tanker(), ten_ten_of());
  const double reach = radians(2.5) * 13.39 * 0.05;
  for (std::size_t i = 1; i < zigzag.steps.size(); ++i) {
    CHECK(std::abs(zigzag.steps[i].delta - zigzag.steps[i - 1].delta) <= reach * (1 + 1e-12));
    CHECK(std::abs(zigzag.steps[i].delta) <= radians(10) * (1 + 1e-12));
  }
  for (const auto& reversal : zigzag.reversals) {
    CHECK(std::abs(zigzag.steps[reversal.leg].state.psi) >= radians(10));
    CHECK(std::abs(zigzag.steps[reversal.leg - 1].state.psi) < radians(10));
  }
}

TEST_CASE("an Euler zigzag that does not come about has no reversals", "[linear][limit]") {
  auto order = ten_ten_of();
  order.longest = 1.0;
  CHECK(euler_zigzag(RandomLinearShips::tanker(), order).reversals.empty());
}

TEST_CASE("senseless Euler zigzags are refused", "[linear][refusal]") {
  CHECK_THROWS_WITH(euler_zigzag(RandomLinearShips::tanker(), ten_ten_of(), 0.0),
                    "step [ship lengths] must be positive, got 0");
  auto order = ten_ten_of();
  order.rate = -1.0;
  CHECK_THROWS_WITH(euler_zigzag(RandomLinearShips::tanker(), order), ContainsSubstring("rudder rate"));
}

}  // namespace
}  // namespace swayaw
