#include "swayaw/mismatch/linear_view.hpp"

#include <catch.hpp>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

/// Zigzags of a model and of a ship with something hidden, by K, T and the drift–yaw loop.
namespace swayaw {
namespace {

using Catch::Matchers::Contains;

std::vector<Recording> zigzags(const Ship& ship) {
  const ManoeuvreOptions options{.duration = 900.0, .step = 1.0};
  std::vector<Recording> runs;
  for (const double angle : {10.0, 20.0})
    runs.push_back(zigzag(ship, {.rudder = radians(angle), .heading = radians(angle)}, options).run);
  return runs;
}

std::vector<LinearView> views(const Effect& hidden) {
  const auto ship = published_ship("mariner");
  return linear_view(ship, zigzags(with_effect(ship, hidden)));
}

TEST_CASE("a model and its own zigzags agree in K, T and loop", "[mismatch][limit]") {
  const auto ship = published_ship("mariner");
  const auto list = linear_view(ship, zigzags(ship));
  REQUIRE(list.size() == 2);
  for (const auto& v : list) {
    CHECK(std::abs(v.recorded.K / v.model.K - 1.0) < 3e-3);  // corners of the rudder are lost between samples
    CHECK(std::abs(v.recorded.T / v.model.T - 1.0) < 3e-3);  // corners of the rudder are lost between samples
    CHECK(std::abs(v.recorded.loop_area / v.model.loop_area - 1.0) < 0.02);
    CHECK(v.model.K < 0.0);
  }
  CHECK(words_of(list).empty());
}

TEST_CASE("a rudder offset is a constant, of its side", "[mismatch][second-route]") {
  const auto list = views(RudderOffset<double>{radians(1.5)});
  REQUIRE(!list.empty());  // a replay without the offset may turn away and have no peaks
  CHECK_THAT(words_of(list), Contains("a constant acts like a rudder offset to port"));
  CHECK_THAT(words_of(views(RudderOffset<double>{radians(-1.5)})),
             Contains("a constant acts like a rudder offset to starboard"));
}

TEST_CASE("a turning circle has no K and no loop", "[mismatch][refusal]") {
  const auto ship = published_ship("mariner");
  const std::vector runs{turning_circle(ship, {.rudder = radians(20), .side = Side::port}, {.duration = 900.0}).run};
  CHECK(linear_view(ship, runs).empty());
  CHECK(words_of(std::vector<LinearView>{}).empty());
}

}  // namespace
}  // namespace swayaw
