#include "swayaw/linear/inversion.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_linear_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using test::printed_table_1;
using test::RandomLinearShips;
using test::reference;

Inversion inversion_of(const SwayYawCoefficients<double>& m, KnownPart known) {
  return inverted(m, steering_indices(m), printed_table_1(), known);
}

TEST_CASE("hull and rudder from the printed coefficients agree with the reference for every known number",
          "[linear][published]") {
  const auto& cases = reference().at("section7").at("from_printed_abc");
  for (const auto& [name, known] : test::known_parts) {
    const auto& wanted = cases.at(name);
    const auto result = inversion_of(RandomLinearShips::tanker(), known).parts;
    const char* keys[] = {"aH", "cRy", "xR", "Yb", "Yw", "Nb", "Nw"};
    for (std::size_t k = 0; k < result.size(); ++k)
      CHECK_THAT(result[k].value, WithinRel(wanted.at(keys[k]).get<double>(), 1e-10));
  }
}

TEST_CASE("elasticities of the coefficients are the reference's Jacobian", "[linear][published]") {
  // columns of the reference: T1, T2, T3b, T3w, Kb, Kw; its differences hold seven digits
  const auto jacobian = reference().at("jacobian_REF").at("d_abc_d_TK");
  const auto m = RandomLinearShips::tanker();
  const auto i = steering_indices(m);
  const auto T = time_constants(transfer_functions(m)).value();
  const double input[] = {T.T1, T.T2, i.T3b, i.T3w, i.Kb, i.Kw};
  const std::size_t place[] = {0, 1, 4, 5, 6, 7};
  const auto result = inverted_coefficients(m, i);
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t k = 0; k < 6; ++k)
      CHECK_THAT(result[row].elasticity[place[k]] * result[row].value / input[k],
                 WithinAbs(jacobian[row][k].get<double>(), 1e-6));
}

TEST_CASE("elasticities are differences of the inversion", "[linear][second-route]") {
  const auto m = RandomLinearShips::tanker();
  const auto i = steering_indices(m);
  const double h = 1e-6;
  for (const auto& [name, known] : test::known_parts) {
    const auto result = inverted(m, i, printed_table_1(), known).parts;
    const auto value = [&, &known = known](double factor) {
      auto varied = i;
      varied.T3w *= factor;
      return inverted(coefficients_from(varied), varied, printed_table_1(), known).parts;
    };
    const auto up = value(1.0 + h), down = value(1.0 - h);
    for (std::size_t k = 0; k < result.size(); ++k) {
      INFO(name << ", " << result[k].name);
      CHECK_THAT(result[k].elasticity[5], WithinAbs((up[k].value - down[k].value) / (2.0 * h * result[k].value), 1e-6));
    }
  }
}

TEST_CASE("a number that is known follows itself and no index", "[linear]") {
  const auto result = inversion_of(RandomLinearShips::tanker(), KnownPart::Y_w).parts[4];
  CHECK(result.name == "Y_w");
  CHECK_THAT(result.value, WithinRel(0.026, 1e-13));
  CHECK_THAT(result.elasticity[8], WithinRel(1.0, 1e-12));
  for (std::size_t k = 0; k < 8; ++k) CHECK_THAT(result.elasticity[k], WithinAbs(0.0, 1e-12));
}

TEST_CASE("hull and rudder come back from their coefficients whatever is known", "[linear][round-trip]") {
  RandomLinearShips random(11);
  for (int n = 0; n < 200; ++n) {
    const auto ship = random.parts();
    const auto m = coefficients(ship).total();
    for (const auto& [name, known] : test::known_parts) {
      const auto again = inverted(m, steering_indices(m), ship, known).ship;
      CHECK_THAT(again.rudder.c_Ry, WithinRel(ship.rudder.c_Ry, 1e-9));
      CHECK_THAT(again.rudder.a_H, WithinRel(ship.rudder.a_H, 1e-9));
      CHECK_THAT(again.hull.N_w, WithinRel(ship.hull.N_w, 1e-9));
      CHECK_THAT(again.hull.Y_b, WithinRel(ship.hull.Y_b, 1e-9));
    }
  }
}

TEST_CASE("1 % in the known number does to the tanker what the reference says", "[linear][published]") {
  // from table 1: Y_b gives -3.3 % in c_Ry and 4.7 % in Y_w, N_b 3.7 % and -5.3 %
  const auto m = coefficients(printed_table_1()).total();
  const auto by_Y_b = inversion_of(m, KnownPart::Y_b).parts, by_N_b = inversion_of(m, KnownPart::N_b).parts;
  CHECK_THAT(by_Y_b[1].elasticity[8], WithinAbs(-3.3, 0.05));
  CHECK_THAT(by_Y_b[4].elasticity[8], WithinAbs(4.7, 0.1));
  CHECK_THAT(by_N_b[1].elasticity[8], WithinAbs(3.7, 0.05));
  CHECK_THAT(by_N_b[4].elasticity[8], WithinAbs(-5.3, 0.1));
}

TEST_CASE("of the tanker Y_w is best known, then c_Ry", "[linear]") {
  const auto conditions = known_conditions(RandomLinearShips::tanker(), printed_table_1());
  CHECK(best_known(conditions) == KnownPart::Y_w);
  for (const auto& c : conditions) {
    CHECK(c.by_known >= 1.0 - 1e-12);
    CHECK(c.worst >= c.by_known);
    if (c.known != KnownPart::Y_w && c.known != KnownPart::c_Ry) CHECK(c.worst > conditions[4].worst);
  }
}

TEST_CASE("a ship without Kb is inverted, her elasticities to the indices are not numbers", "[linear][limit]") {
  auto m = RandomLinearShips::tanker();
  m.c1 = m.b1 * m.c2 / m.b2;
  const auto result = inverted(m, {.T1T2 = 3, .T1_plus_T2 = 10, .T3b = INFINITY, .T3w = 1, .Kb = 0, .Kw = -4},
                               printed_table_1(), KnownPart::c_Ry);
  CHECK(result.coefficients[2].value == m.c1);
  CHECK(std::isfinite(result.parts[4].value));
  CHECK(std::isfinite(result.parts[4].elasticity[8]));
  CHECK_FALSE(std::isfinite(result.coefficients[0].elasticity[4]));
}

TEST_CASE("a rudder that tells nothing is refused in words", "[linear][refusal]") {
  auto m = RandomLinearShips::tanker();
  m.c1 = 0.0;
  CHECK_THROWS_WITH(inversion_of(m, KnownPart::c_Ry),
                    "c1 is 0: a rudder without sway force tells neither a_H nor x_R_eff_prime");
  m = RandomLinearShips::tanker();
  m.c2 = 0.0;  // the rudder acts midship: no moment
  CHECK_THROWS_AS(inversion_of(m, KnownPart::N_w), Refusal);
  CHECK(std::isinf(known_conditions(m, printed_table_1())[3].worst));
}

}  // namespace
}  // namespace swayaw
