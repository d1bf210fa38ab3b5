#include "swayaw/linear/indices.hpp"

#include <Eigen/Core>
#include <Eigen/SVD>
#include <catch.hpp>
#include <nlohmann/json.hpp>

#include "random_linear_ships.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/dimensional.hpp"
#include "swayaw/linear/ship_parts.hpp"
#include "swayaw/linear/sname.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using nlohmann::json;
using test::coefficients_of;
using test::printed_indices;
using test::RandomLinearShips;
using test::reference;
using Coefficients = SwayYawCoefficients<double>;
using Indices = SteeringIndices<double>;

constexpr double eps = 2.3e-16;

std::array<double, 6> list(const Coefficients& m) { return {m.a1, m.b1, m.c1, m.a2, m.b2, m.c2}; }
std::array<double, 6> list(const Indices& i) { return {i.T1T2, i.T1_plus_T2, i.T3b, i.T3w, i.Kb, i.Kw}; }

template <class Numbers>
void check_close(const Numbers& found, const Numbers& wanted, double relative) {
  const auto a = list(found), b = list(wanted);
  for (std::size_t i = 0; i < a.size(); ++i) {
    INFO("number " << i);
    CHECK_THAT(a[i], WithinRel(b[i], relative));
  }
}

double largest_relative_difference(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]) / std::abs(b[i]));
  return largest;
}

// ---------------------------------------------------------------- laws

TEST_CASE("indices and coefficients are each other's inverse, within what the conversion loses",
          "[linear][round-trip]") {
  RandomLinearShips random(21);
  int unstable = 0, complex = 0;
  for (int k = 0; k < 10'000; ++k) {
    const auto m = random.ship();
    unstable += !is_stable(m);
    complex += has_complex_poles(m);
    // rounding errors times what the conversion loses; the matrices lose a digit more
    const double loss = eps * condition_number(m), printed = std::min(1e-9, 10.0 * loss),
                 by_matrices = std::min(1e-9, 100.0 * loss);
    const auto i = steering_indices(m);
    REQUIRE(largest_relative_difference(list(coefficients_from(i)), list(m)) < printed);
    REQUIRE(largest_relative_difference(list(coefficients_by_controllability(i)), list(m)) < by_matrices);
    REQUIRE(largest_relative_difference(list(steering_indices(coefficients_from(i))), list(i)) < printed);
  }
  CHECK(unstable > 1000);
  CHECK(complex > 1000);
}

TEST_CASE("transfer functions and coefficients are each other's inverse", "[linear][round-trip]") {
  RandomLinearShips random(22);
  for (int k = 0; k < 10'000; ++k) {
    const auto m = random.ship();
    const auto h = transfer_functions(m);
    const double loss = std::max(1.0, 10.0 / std::abs(controllability(h)));
    const auto back = coefficients_from(h);
    const auto a = list(m), b = list(back);
    for (std::size_t i = 0; i < 6; ++i) REQUIRE_THAT(b[i], WithinAbs(a[i], 1e4 * eps * loss));
  }
}

TEST_CASE("a neutral ship and one with Kb = 0 have transfer functions and come back from them", "[linear][limit]") {
  const Coefficients neutral{-0.5, 0.4, -0.17, 0.5 * 2.0 / 0.4, -2.0, -1.4};  // a1 b2 = a2 b1
  REQUIRE_THAT(determinant(neutral), WithinAbs(0.0, eps));
  const auto kb_zero = coefficients_of(reference().at("degenerate_examples").at("Kb_zero").at("abc"));
  REQUIRE_THAT(transfer_functions(kb_zero).nb0, WithinAbs(0.0, 1e-15));
  for (const auto& m : {neutral, kb_zero}) check_close(coefficients_from(transfer_functions(m)), m, 1e-13);
}

TEST_CASE("when T3b = T3w there is no inverse, and the distance to it says so", "[linear][limit]") {
  RandomLinearShips random(23);
  auto i = steering_indices(RandomLinearShips::tanker());
  CHECK(inverse_distance(i) > 0.5);
  i.T3w = i.T3b;
  CHECK(inverse_distance(i) == 0.0);
  CHECK_FALSE(std::isfinite(coefficients_from(i).a1));
}

TEST_CASE("time constants give back product and sum, and lose no digits", "[linear][round-trip]") {
  RandomLinearShips random(24);
  for (int k = 0; k < 10'000; ++k) {
    const auto h = transfer_functions(random.ship());
    const auto T = time_constants(h);
    REQUIRE(T.has_value() == !has_complex_poles(coefficients_from(h)));
    if (!T) continue;
    REQUIRE_THAT(T->T1 * T->T2, WithinRel(1.0 / h.e0, 1e-12));
    REQUIRE_THAT(T->T1 + T->T2, WithinAbs(h.e1 / h.e0, 1e-12 * (std::abs(T->T1) + std::abs(T->T2))));
    REQUIRE(std::abs(T->T1) >= std::abs(T->T2));
  }
}

TEST_CASE("T3b and T3w do not depend on the straightening of the flow at the rudder", "[linear][published]") {
  RandomLinearShips random(25);
  for (int k = 0; k < 1000; ++k) {
    auto ship = random.parts();
    const auto i = steering_indices(coefficients(ship).total());
    ship.rudder.c_Ry = random.uniform(0.1, 5.0);
    ship.rudder.a_H = random.uniform(0.0, 1.0);
    ship.rudder.area_ratio *= random.uniform(0.5, 2.0);
    const auto j = steering_indices(coefficients(ship).total());
    REQUIRE_THAT(j.T3b, WithinRel(i.T3b, 1e-11));
    REQUIRE_THAT(j.T3w, WithinRel(i.T3w, 1e-11));
  }
}

TEST_CASE("hull and rudder are found again from the coefficients, whichever number is known", "[linear][round-trip]") {
  RandomLinearShips random(26);
  for (int k = 0; k < 1000; ++k) {
    const auto ship = random.parts();
    const auto m = coefficients(ship).total();
    for (const auto known : {KnownPart::Y_b, KnownPart::Y_w, KnownPart::N_b, KnownPart::N_w, KnownPart::c_Ry}) {
      auto blank = ship;
      for (double* x : {&blank.hull.Y_b, &blank.hull.Y_w, &blank.hull.N_b, &blank.hull.N_w, &blank.rudder.c_Ry,
                        &blank.rudder.a_H, &blank.rudder.x_Reff})
        *x = 7.0;
      if (known == KnownPart::Y_b) blank.hull.Y_b = ship.hull.Y_b;
      if (known == KnownPart::Y_w) blank.hull.Y_w = ship.hull.Y_w;
      if (known == KnownPart::N_b) blank.hull.N_b = ship.hull.N_b;
      if (known == KnownPart::N_w) blank.hull.N_w = ship.hull.N_w;
      if (known == KnownPart::c_Ry) blank.rudder.c_Ry = ship.rudder.c_Ry;
      const auto found = parts_from(m, blank, known);
      REQUIRE_THAT(found.hull.Y_b, WithinRel(ship.hull.Y_b, 1e-10));
      REQUIRE_THAT(found.hull.Y_w, WithinRel(ship.hull.Y_w, 1e-10));
      REQUIRE_THAT(found.hull.N_b, WithinRel(ship.hull.N_b, 1e-10));
      REQUIRE_THAT(found.hull.N_w, WithinRel(ship.hull.N_w, 1e-10));
      REQUIRE_THAT(found.rudder.c_Ry, WithinRel(ship.rudder.c_Ry, 1e-10));
      REQUIRE_THAT(found.rudder.a_H, WithinRel(ship.rudder.a_H, 1e-10));
      REQUIRE_THAT(found.rudder.x_Reff, WithinRel(ship.rudder.x_Reff, 1e-10));
    }
  }
}

TEST_CASE("dimensional and primed twins are each other's inverse", "[linear][round-trip]") {
  RandomLinearShips random(27);
  for (int k = 0; k < 1000; ++k) {
    const PrimeScale scale{random.uniform(2.0, 350.0), random.uniform(0.3, 15.0)};
    const auto m = random.ship();
    check_close(to_prime(dimensional(m, scale), scale), m, 1e-14);
    check_close(to_prime(dimensional(steering_indices(m), scale), scale), steering_indices(m), 1e-14);
  }
}

TEST_CASE("SNAME derivatives and coefficients are each other's inverse, for both rudder conventions",
          "[linear][round-trip]") {
  RandomLinearShips random(28);
  for (int k = 0; k < 1000; ++k) {
    const SnameDerivatives<double> inertia{.m = random.uniform(0.1, 0.3),
                                           .x_G = random.uniform(-0.05, 0.05),
                                           .I_z = random.uniform(0.006, 0.02),
                                           .Y_vdot = -random.uniform(0.05, 0.3),
                                           .Y_rdot = random.uniform(-0.01, 0.01),
                                           .N_vdot = random.uniform(-0.01, 0.01),
                                           .N_rdot = -random.uniform(0.005, 0.02)};
    const auto m = random.ship();
    for (const auto rudder : {RudderConvention::positive_to_port, RudderConvention::positive_to_starboard})
      check_close(coefficients(sname_derivatives(m, inertia, rudder), rudder), m, 1e-11);
    const auto to_port = sname_derivatives(m, inertia),
               to_starboard = sname_derivatives(m, inertia, RudderConvention::positive_to_starboard);
    CHECK(to_port.N_delta == -to_starboard.N_delta);
  }
}

// ---------------------------------------------------------------- numbers of the paper

TEST_CASE("coefficients follow from the parts of table 1", "[linear][published]") {
  const auto& r = reference();
  const auto split = coefficients(test::printed_table_1());
  const auto& f = r.at("from_table1");
  CHECK_THAT(split.hull.a1, WithinRel(f.at("a1H").get<double>(), 1e-12));
  CHECK_THAT(split.rudder.a1, WithinRel(f.at("a1R").get<double>(), 1e-12));
  CHECK_THAT(split.hull.b1, WithinRel(f.at("b1H").get<double>(), 1e-12));
  CHECK_THAT(split.rudder.b1, WithinRel(f.at("b1R").get<double>(), 1e-12));
  CHECK_THAT(split.centrifugal.b1, WithinRel(f.at("b1C").get<double>(), 1e-12));
  CHECK_THAT(split.hull.a2, WithinRel(f.at("a2H").get<double>(), 1e-12));
  CHECK_THAT(split.rudder.a2, WithinRel(f.at("a2R").get<double>(), 1e-12));
  CHECK_THAT(split.hull.b2, WithinRel(f.at("b2H").get<double>(), 1e-12));
  CHECK_THAT(split.rudder.b2, WithinRel(f.at("b2R").get<double>(), 1e-12));
  check_close(split.total(), coefficients_of(f), 1e-12);
  const auto i = steering_indices(split.total());
  const auto& record = r.at("from_table1_record");
  const auto T = time_constants(transfer_functions(split.total())).value();
  CHECK_THAT(T.T1, WithinRel(record.at("T1").get<double>(), 1e-9));
  CHECK_THAT(T.T2, WithinRel(record.at("T2").get<double>(), 1e-9));
  CHECK_THAT(i.T3b, WithinRel(record.at("T3b").get<double>(), 1e-9));
  CHECK_THAT(i.T3w, WithinRel(record.at("T3w").get<double>(), 1e-9));
  CHECK_THAT(i.Kb, WithinRel(record.at("Kb").get<double>(), 1e-9));
  CHECK_THAT(i.Kw, WithinRel(record.at("Kw").get<double>(), 1e-9));
}

TEST_CASE("the inverse gives the coefficients of table 3 and of its variations", "[linear][published]") {
  const auto& r = reference();
  check_close(coefficients_from(printed_indices()), coefficients_of(r.at("printed_TK_to_abc")), 1e-11);
  check_close(coefficients_from(printed_indices(0.309)), coefficients_of(r.at("T3b_variation_abc").at("0.309")), 1e-11);
  check_close(coefficients_from(printed_indices(0.154, 0.492)), coefficients_of(r.at("T3w_variation_abc").at("0.492")),
              1e-11);
}

TEST_CASE("the printed coefficients give their indices, in degenerate cases too", "[linear][published]") {
  const auto& r = reference();
  for (const json& record :
       {r.at("printed_abc_record"), r.at("degenerate_examples").at("complex_poles"),
        r.at("degenerate_examples").at("unstable"), r.at("sname_mapping").at("example").at("record")}) {
    const auto m = coefficients_of(record.at("abc"));
    const auto i = steering_indices(m);
    CHECK_THAT(i.T1T2, WithinRel(record.at("P").get<double>(), 1e-9));
    CHECK_THAT(i.T1_plus_T2, WithinRel(record.at("S").get<double>(), 1e-9));
    CHECK_THAT(i.T3b, WithinRel(record.at("T3b").get<double>(), 1e-9));
    CHECK_THAT(i.T3w, WithinRel(record.at("T3w").get<double>(), 1e-9));
    CHECK_THAT(i.Kb, WithinRel(record.at("Kb").get<double>(), 1e-9));
    CHECK_THAT(i.Kw, WithinRel(record.at("Kw").get<double>(), 1e-9));
    CHECK(is_stable(m) == record.at("stable").get<bool>());
    CHECK(has_complex_poles(m) == record.at("complex_poles").get<bool>());
    if (has_complex_poles(m)) continue;
    const auto T = time_constants(transfer_functions(m)).value();
    CHECK_THAT(T.T1, WithinRel(record.at("T1").get<double>(), 1e-9));
    CHECK_THAT(T.T2, WithinRel(record.at("T2").get<double>(), 1e-9));
  }
}

/// d ln(T1, T2, T3b, T3w, Kb, Kw)/d ln(a1 … c2), for real poles.
Eigen::Matrix<double, 6, 6> logarithmic_jacobian(const Coefficients& m) {
  using D = Dual<6>;
  const auto in = list(m);
  std::array<D, 6> x;
  for (int i = 0; i < 6; ++i) {
    x[static_cast<std::size_t>(i)] = D(in[static_cast<std::size_t>(i)]);
    x[static_cast<std::size_t>(i)].v[i] = in[static_cast<std::size_t>(i)];
  }
  const SwayYawCoefficients<D> dual{x[0], x[1], x[2], x[3], x[4], x[5]};
  const auto i = steering_indices(dual);
  const auto T = time_constants(transfer_functions(dual)).value();
  const std::array out{T.T1, T.T2, i.T3b, i.T3w, i.Kb, i.Kw};
  Eigen::Matrix<double, 6, 6> jacobian;
  for (int row = 0; row < 6; ++row)
    jacobian.row(row) = out[static_cast<std::size_t>(row)].v.transpose() / out[static_cast<std::size_t>(row)].a;
  return jacobian;
}

TEST_CASE("the ill-conditioned direction is forward: d ln T1 = (-5.5, 4.6, 4.6, -4.8) by a1, b1, a2, b2",
          "[linear][published]") {
  const auto J = logarithmic_jacobian(RandomLinearShips::tanker());
  const double wanted[] = {-5.5, 4.6, 0.0, 4.6, -4.8, 0.0};
  for (int i = 0; i < 6; ++i) CHECK_THAT(J(0, i), WithinAbs(wanted[i], 0.06));
  const auto singular = J.jacobiSvd().singularValues();
  CHECK_THAT(singular[0] / singular[5], WithinAbs(65.0, 0.5));
  // with product and sum in place of T1 and T2, as for complex poles
  CHECK_THAT(condition_number(RandomLinearShips::tanker()), WithinAbs(88.5, 0.5));
}

TEST_CASE("the derivatives of the inverse are those of the reference", "[linear][published]") {
  using D = Dual<6>;
  const auto reference_rows = reference().at("jacobian_REF").at("d_TK_d_abc");
  const auto m = RandomLinearShips::tanker();
  const SwayYawCoefficients<D> dual{D(m.a1, 0), D(m.b1, 1), D(m.c1, 2), D(m.a2, 3), D(m.b2, 4), D(m.c2, 5)};
  const auto i = steering_indices(dual);
  const auto T = time_constants(transfer_functions(dual)).value();
  const std::array out{T.T1, T.T2, i.T3b, i.T3w, i.Kb, i.Kw};
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t column = 0; column < 6; ++column)
      CHECK_THAT(out[row].v[static_cast<int>(column)],
                 WithinAbs(reference_rows[row][column].get<double>(), 1e-9 * 100.0));
}

TEST_CASE("the SNAME example gives its coefficients", "[linear][published]") {
  const auto example = reference().at("sname_mapping").at("example");
  const auto M = example.at("M"), F = example.at("F"), G = example.at("G");
  // mass and added mass are told apart by m' alone, taken as 0.2 with x_G = 0
  const double m = 0.2;
  const SnameDerivatives<double> d{.m = m,
                                   .x_G = 0.0,
                                   .I_z = 0.015,
                                   .Y_vdot = m - M[0][0].get<double>(),
                                   .Y_rdot = -M[0][1].get<double>(),
                                   .N_vdot = -M[1][0].get<double>(),
                                   .N_rdot = 0.015 - M[1][1].get<double>(),
                                   .Y_v = F[0][0],
                                   .Y_r = F[0][1].get<double>() + m,
                                   .Y_delta = G[0],
                                   .N_v = F[1][0],
                                   .N_r = F[1][1],
                                   .N_delta = G[1]};
  check_close(coefficients(d), coefficients_of(example.at("record").at("abc")), 1e-12);
  const double K = steering_indices(coefficients(d)).Kw;
  CHECK_THAT(-K, WithinRel(example.at("nomoto_positive_starboard").at("K_prime").get<double>(), 1e-12));
  const auto seconds = dimensional(steering_indices(coefficients(d)), {.L = 100.0, .U = 8.0});
  CHECK_THAT(-seconds.Kr_per_s, WithinRel(example.at("dimensional_L100_V8").at("K_per_s").get<double>(), 1e-12));
}

}  // namespace
}  // namespace swayaw
