#include <algorithm>
#include <catch.hpp>
#include <cmath>

#include "model_ships.hpp"
#include "random_windage.hpp"
#include "swayaw/core/parts_writer.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw {
namespace {

std::vector<double> values_of(const Ship& ship) {
  std::vector<double> values;
  for (const auto& n : parameters_of(ship)) values.push_back(n.value);
  return values;
}

Ship ship_with(const ShipModel& model) {
  return {.name = "a \"quoted\" \\ ship", .model = model, .confidence = {}, .surroundings = {}};
}

/// To the last bit or the one beside it: not every angle in radians is an angle in degrees times pi/180.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return x == y || std::nextafter(x, y) == y; });
}

/// Shaken numbers may be out of range.
template <class Model>
Model in_range(Model model) {
  model.steering_gear = {.rate = 0.1, .max_angle = 0.6, .lag = 0.0, .dead_band = 0.0};
  if constexpr (requires { model.particulars.A_front; }) model.particulars.A_front = model.particulars.A_lateral = 0.0;
  return model;
}

}  // namespace

TEMPLATE_TEST_CASE("a ship written to a file and read again is the same to the last digit", "[nonlinear][round-trip]",
                   MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>) {
  test::RandomModels random(20261121);
  for (int i = 0; i < 200; ++i) {
    Ship ship = ship_with(in_range(random.ship<TestType>()));
    ship.confidence = {.coefficients = 0.02, .named = {}};
    ship.surroundings.current = {0.3, -1.2};
    const auto back = parse_ship(ship_text(ship, "one line\nand another"), "back.toml");
    CHECK(back.name == ship.name);
    CHECK(back.model.index() == ship.model.index());
    CHECK(same(values_of(back), values_of(ship)));
    CHECK(back.confidence.coefficients == 0.02);
    CHECK(surroundings_at(back, 0.0).current.speed == 0.3);
    CHECK(surroundings_at(back, 0.0).current.to == -1.2);
    CHECK(ship_text(back) == ship_text(ship));
  }
}

TEST_CASE("published ships keep their numbers, choices and trust when they are written", "[nonlinear][round-trip]") {
  for (const auto& [name, text] : published_ships()) {
    if (model_of(text, name) == "linear") continue;
    const auto ship = parse_ship(text, name);
    const auto back = parse_ship(ship_text(ship), name);
    INFO(name);
    CHECK(same(values_of(back), values_of(ship)));
    CHECK(back.confidence.named == ship.confidence.named);
    CHECK(ship_text(back) == ship_text(ship));
  }
}

TEST_CASE("windage and wind of a ship are written with her", "[nonlinear][round-trip]") {
  test::RandomWinds random(7);
  for (int i = 0; i < 50; ++i) {
    const auto forms = random.of_all_forms();
    for (const auto& windage : {forms[0], forms[1]}) {
      Ship ship = published_ship("kvlcc2_l7");
      ship.surroundings = {.windage = windage, .wind = {8.0, 1.5}, .current = {}, .windy = true};
      const auto back = parse_ship(ship_text(ship), "back.toml");
      const auto around = surroundings_at(back, 0.0);
      REQUIRE(around.windy);
      for (const double psi : {0.1, 1.7, -2.5}) {
        const ShipState<double> state{0.0, 0.0, psi, {1.0, 0.1, 0.01}};
        const auto a = wind_load(ship.surroundings, state), b = wind_load(around, state);
        CHECK(b.X == Approx(a.X).epsilon(1e-12));
        CHECK(b.Y == Approx(a.Y).epsilon(1e-12));
        CHECK(b.N == Approx(a.N).epsilon(1e-12));
      }
    }
    Ship fourier = published_ship("kvlcc2_l7");
    fourier.surroundings.windage = forms[2];
    CHECK_THROWS_AS(ship_text(fourier), Refusal);
  }
}

TEST_CASE("a number out of its range is not written", "[nonlinear][refusal]") {
  auto ship = published_ship("kvlcc2_l7");
  std::get<MmgShip<double>>(ship.model).rudder.f_alpha = -1.0;
  CHECK_THROWS_WITH(ship_text(ship), "f_alpha in [rudder] cannot be -1");
  std::get<MmgShip<double>>(ship.model).rudder.f_alpha = std::nan("");
  CHECK_THROWS_AS(ship_text(ship), std::domain_error);
}

TEST_CASE("numbers are known by the key of the file, with the table where two have it", "[nonlinear]") {
  const auto ship = published_ship("kvlcc2_l7");
  const std::vector<std::string> names{"N_v", "rudder.x_prime", "hull.Y_r", "kt[1]"};
  const auto numbers = parameters_of(ship, names);
  const auto& model = std::get<MmgShip<double>>(ship.model);
  CHECK(numbers[0].value == model.hull.N_v);
  CHECK(numbers[1].value == model.rudder.x_R);
  CHECK(numbers[2].value == model.hull.Y_r);
  CHECK(numbers[3].value == model.propeller.k_1);
  CHECK(numbers[0].deviation == Approx(std::abs(model.hull.N_v) * ship.confidence.of("N_v")));
  const std::vector<std::string> ambiguous{"x_prime"}, unknown{"N_x"};
  CHECK_THROWS_AS(parameters_of(ship, ambiguous), Refusal);
  CHECK_THROWS_WITH(parameters_of(ship, unknown), ship.name + ": her model has no number N_x");
  CHECK(coefficients_of(ship, "hull").size() == 17);
}

TEST_CASE("coefficients of the resistance are those that resist a straight course", "[nonlinear][second-route]") {
  for (const auto& name : {"kvlcc2_l7", "kvlcc2_pi", "wpcc_pi", "wpcc_pu", "mariner", "kcs"}) {
    const auto ship = published_ship(name);
    const double U = service_speed(ship);
    const auto controls = self_propulsion(ship, U);
    const auto along = [&](const Ship& one) {
      return force_breakdown(one, {0.0, 0.0, 0.0, {0.9 * U, 0.0, 0.0}}, controls).total.X;
    };
    for (const auto& p : coefficients_of(ship, "hull")) {
      INFO(name << ' ' << p.name);
      const auto other = with_values(ship, {&p, 1}, std::vector{1.1 * p.value});
      if (p.value != 0.0) CHECK((along(other) != along(ship)) == is_resistance(p));
    }
  }
}

TEST_CASE("values set by name arrive, and nothing else changes", "[nonlinear]") {
  const auto ship = published_ship("wpcc_pi");
  const std::vector<std::string> names{"N_v", "Y_v"};
  const auto numbers = parameters_of(ship, names);
  const auto changed = with_values(ship, numbers, std::vector{-1.0, -2.0});
  const auto& model = std::get<PiShip<double>>(changed.model);
  CHECK(model.hull.N_v == -1.0);
  CHECK(model.hull.Y_v == -2.0);
  CHECK(
      same(values_of(with_values(changed, numbers, std::vector{numbers[0].value, numbers[1].value})), values_of(ship)));
}

TEMPLATE_TEST_CASE("a seeded ship gives the derivative of her force by each number", "[nonlinear][second-route]",
                   MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>) {
  test::RandomModels random(31);
  for (int i = 0; i < 20; ++i) {
    const Ship ship = ship_with(random.ship<TestType>());
    const auto& model = std::get<TestType>(ship.model);
    const auto motion = random.motion(model);
    const auto controls = random.controls(model);
    for (const auto& n : coefficients_of(ship, "hull")) {
      const auto dual = seeded<1>(model, std::span(&n, 1));
      using D = Dual<1>;
      const auto force =
          forces(dual, PlanarMotion<D>{D(motion.u), D(motion.v), D(motion.r)}, cast<D>(controls)).total();
      const auto at = [&](double value) {
        return forces(std::get<TestType>(with_values(ship, std::span(&n, 1), std::span(&value, 1)).model), motion,
                      controls)
            .total();
      };
      const double h = 1e-3 * (std::abs(n.value) + 1e-3);
      const auto up = at(n.value + h), down = at(n.value - h);
      const auto size = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
      CHECK(force.X.v[0] * 2.0 * h == Approx(up.X - down.X).margin(1e-11 * size(up.X, down.X)));
      CHECK(force.Y.v[0] * 2.0 * h == Approx(up.Y - down.Y).margin(1e-11 * size(up.Y, down.Y)));
      CHECK(force.N.v[0] * 2.0 * h == Approx(up.N - down.N).margin(1e-11 * size(up.N, down.N)));
    }
  }
}

}  // namespace swayaw
