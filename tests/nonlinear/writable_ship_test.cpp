#include "swayaw/nonlinear/writable_ship.hpp"

#include <catch.hpp>

#include "random_ships.hpp"
#include "swayaw/nonlinear/coefficients.hpp"

/// What a fit found and no file can hold gives way, the rest stays.
namespace swayaw {
namespace {

using namespace std::string_literals;

Ship with(const Ship& ship, const std::string& name, double value) {
  return with_values(ship, parameters_of(ship, std::array{name}), std::array{value});
}

TEST_CASE("a ship whose numbers lie in their ranges is written as she is", "[nonlinear][limit]") {
  const auto ship = test::kvlcc2();
  const auto kept = writable(ship, ship);
  CHECK(kept.changed.empty());
  CHECK(ship_text(kept.ship) == ship_text(ship));
}

TEST_CASE("a number outside its range gives way to that of the beginning, and no other does", "[nonlinear][limit]") {
  const auto beginning = test::kvlcc2();
  auto found = with(with(beginning, "m_y", -0.208), "N_v", -0.2);
  CHECK_THROWS_AS(ship_text(found), std::domain_error);
  const auto kept = writable(found, beginning);
  REQUIRE(kept.changed.size() == 1);
  CHECK(kept.changed[0] == "m_y = -0.208 was found, which no ship file holds; 0.223 stands there");
  CHECK(ship_text(kept.ship) == ship_text(with(beginning, "N_v", -0.2)));
  CHECK(writable(with(beginning, "N_r", std::nan("")), beginning).changed.size() == 1);
}

TEST_CASE("a number of an effect outside its range gives way to the nearest one", "[nonlinear][limit]") {
  const auto beginning = test::kvlcc2();
  auto found = beginning;
  found.effects.push_back(SteadyWind<>{-3.0, 1.0});
  CHECK_THROWS_AS(ship_text(found), std::domain_error);
  const auto kept = writable(found, beginning);
  REQUIRE(kept.changed.size() == 1);
  CHECK_THAT(kept.changed[0], ContainsSubstring("wind_speed_m_s of steady_wind = -3"));
  CHECK(parse_ship(ship_text(kept.ship), "kept.toml").effects.size() == 1);
}

TEST_CASE("a trust that is no number is left out", "[nonlinear][limit]") {
  auto found = test::kvlcc2();
  found.confidence.named = {{"N_v", std::nan("")}, {"N_r", 0.05}};
  CHECK(writable(found, found).ship.confidence.named == std::vector{std::pair{"N_r"s, 0.05}});
}

}  // namespace
}  // namespace swayaw
