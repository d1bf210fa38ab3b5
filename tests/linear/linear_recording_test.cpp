#include "swayaw/linear/linear_recording.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw {
namespace {

constexpr PrimeScale prime_scale{.L = 100.0, .U = 8.0};

LinearZigzagOrder order(double longest = 1000.0) {
  return {.rudder = radians(10), .heading = radians(10), .rate = 0.5, .longest = longest};
}

TEST_CASE("a zigzag as a recording has its overshoots, its speed and its rudder", "[linear]") {
  const auto ship = test::RandomLinearShips::tanker();
  const auto zigzag = linear_zigzag(ship, order());
  const auto run = recording_of(ship, zigzag.legs, prime_scale, 0.1);
  double largest = 0.0;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    CHECK_THAT(std::hypot(run[Channel::u][i], run[Channel::v][i]), WithinRel(8.0, 1e-12));
    CHECK(std::abs(run[Channel::delta][i]) <= radians(10) + 1e-12);
    largest = std::max(largest, std::abs(run[Channel::psi][i]));
  }
  double highest = 0.0;
  for (const auto& r : zigzag.reversals) highest = std::max(highest, r.overshoot + radians(10));
  CHECK_THAT(largest, WithinAbs(highest, 1e-4));
  CHECK_THAT(run.time.back(), WithinAbs(zigzag.reversals.back().peak * 12.5, 0.1));
}

TEST_CASE("heading and track of a recording are integrals of its yaw rate and velocity", "[linear][second-route]") {
  const auto ship = test::RandomLinearShips::tanker();
  const auto run = recording_of(ship, linear_zigzag(ship, order()).legs, prime_scale, 0.05);
  double psi = 0.0, x = 0.0, y = 0.0;
  const auto north = [&](std::size_t i) {
    return run[Channel::u][i] * std::cos(run[Channel::psi][i]) - run[Channel::v][i] * std::sin(run[Channel::psi][i]);
  };
  const auto east = [&](std::size_t i) {
    return run[Channel::u][i] * std::sin(run[Channel::psi][i]) + run[Channel::v][i] * std::cos(run[Channel::psi][i]);
  };
  for (std::size_t i = 1; i < run.samples(); ++i) {
    psi += 0.025 * (run[Channel::r][i] + run[Channel::r][i - 1]);
    x += 0.025 * (north(i) + north(i - 1));
    y += 0.025 * (east(i) + east(i - 1));
  }
  CHECK_THAT(run[Channel::psi].back(), WithinAbs(psi, 1e-5));
  CHECK_THAT(run[Channel::x].back(), WithinAbs(x, 1e-2));
  CHECK_THAT(run[Channel::y].back(), WithinAbs(y, 1e-2));
}

TEST_CASE("the recording of a ship that runs away ends in finite numbers", "[linear][limit]") {
  const SwayYawCoefficients<double> wild{2.0, 50.0, -0.17, 40.0, -2.0, -1.4};
  const auto zigzag = linear_zigzag(wild, order(1e5));
  CHECK(zigzag.reversals.size() < 2);
  const auto run = recording_of(wild, zigzag.legs, prime_scale, 0.05);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    CHECK(std::isfinite(run[Channel::psi][i]));
    CHECK(std::isfinite(run[Channel::x][i]));
    CHECK(std::abs(run[Channel::r][i]) <= 100.0 * 8.0 / 100.0);
  }
}

TEST_CASE("a motion that cannot be sampled is refused", "[linear][refusal]") {
  CHECK_THROWS_AS(recording_of(test::RandomLinearShips::tanker(), {}, prime_scale, 0.1), std::domain_error);
  CHECK_THROWS_AS(recording_of(test::RandomLinearShips::tanker(),
                               linear_zigzag(test::RandomLinearShips::tanker(), order()).legs, prime_scale, 0.0),
                  std::domain_error);
}

}  // namespace
}  // namespace swayaw
