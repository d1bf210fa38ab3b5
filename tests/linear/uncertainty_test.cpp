#include "swayaw/linear/uncertainty.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_linear_ships.hpp"

namespace swayaw {
namespace {

using test::RandomLinearShips;

SteeringIndices<double> tanker() { return steering_indices(RandomLinearShips::tanker()); }

IndexCovariance relative(double deviation) {
  return independent(tanker(), {deviation, deviation, deviation, deviation, deviation, deviation});
}

TEST_CASE("the first-order covariance is that of difference quotients", "[linear][second-route]") {
  RandomLinearShips random(61);
  for (int k = 0; k < 200; ++k) {
    const auto m = random.ship();
    const auto i = steering_indices(m);
    if (inverse_distance(i) < 0.1) continue;
    const auto covariance = independent(i, {0.01, 0.02, 0.03, 0.01, 0.02, 0.03});
    const auto C = coefficient_covariance(i, covariance);
    // variance of a1, parameter by parameter
    double variance = 0.0;
    const double values[] = {i.T1T2, i.T1_plus_T2, i.T3b, i.T3w, i.Kb, i.Kw};
    for (int j = 0; j < 6; ++j) {
      const double h = 1e-6 * std::abs(values[j]);
      double up[6], down[6];
      std::copy(values, values + 6, up);
      std::copy(values, values + 6, down);
      up[j] += h;
      down[j] -= h;
      const double slope =
          (coefficients_from(SteeringIndices<double>{up[0], up[1], up[2], up[3], up[4], up[5]}).a1 -
           coefficients_from(SteeringIndices<double>{down[0], down[1], down[2], down[3], down[4], down[5]}).a1) /
          (2 * h);
      variance += slope * slope * covariance(j, j);
    }
    REQUIRE_THAT(C(0, 0), WithinRel(variance, 1e-5));
    REQUIRE((C - C.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * C.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("sampling and the first-order covariance agree for small errors", "[linear][second-route]") {
  const auto covariance = relative(0.01);
  const auto first_order = coefficient_covariance(tanker(), covariance);
  const auto sampled = sample_coefficients(tanker(), covariance);
  CHECK(sampled.crossed == 0.0);
  for (int j = 0; j < 6; ++j) {
    const double deviation = std::sqrt(first_order(j, j));
    CHECK_THAT(std::sqrt(sampled.covariance(j, j)), WithinRel(deviation, 0.05));
    CHECK_THAT(0.5 * (sampled.high[j] - sampled.low[j]), WithinRel(1.96 * deviation, 0.05));
  }
}

TEST_CASE("5 % noise on both T3 gives 4 to 5 % median error in a1 and b1 and 1 % in a2 and b2", "[linear][published]") {
  // the median of |x| of a normal x is 0.6745 deviations
  const auto C = coefficient_covariance(tanker(), independent(tanker(), {0.0, 0.0, 0.05, 0.05, 0.0, 0.0}));
  const auto m = RandomLinearShips::tanker();
  const auto median = [&](int j, double value) { return 0.6745 * std::sqrt(C(j, j)) / std::abs(value); };
  CHECK_THAT(median(0, m.a1), WithinAbs(0.045, 0.01));
  CHECK_THAT(median(1, m.b1), WithinAbs(0.045, 0.01));
  CHECK_THAT(median(3, m.a2), WithinAbs(0.01, 0.005));
  CHECK_THAT(median(4, m.b2), WithinAbs(0.01, 0.005));
}

TEST_CASE("the seven numbers take over the errors of the indices, the known one none", "[linear][limit]") {
  const LinearParts<double> ship{.hull = {5.867, 0.761, 0.056, 1.004, 0.247, 0.225, 0.0043, 0.026, 0.0024, -0.063},
                                 .rudder = {0.0177, 0.326, 2.127, 0.0385, 0.6, 1.0, -0.5}};
  const auto i = steering_indices(coefficients(ship).total());
  const auto covariance = independent(i, {0.02, 0.02, 0.02, 0.02, 0.02, 0.02});
  const int place[] = {3, 4, 5, 6, 1};
  const KnownPart known[] = {KnownPart::Y_b, KnownPart::Y_w, KnownPart::N_b, KnownPart::N_w, KnownPart::c_Ry};
  for (int k = 0; k < 5; ++k) {
    const auto C = part_covariance(i, covariance, ship, known[k]);
    for (int j = 0; j < 7; ++j) {
      if (j == place[k]) CHECK_THAT(C(j, j), WithinAbs(0.0, 1e-20));
      else CHECK(C(j, j) > 0.0);
    }
  }
  // a_H and x'_Reff follow from c1 and c2 alone
  CHECK_THAT(part_covariance(i, covariance, ship, KnownPart::Y_b)(0, 0),
             WithinRel(part_covariance(i, covariance, ship, KnownPart::c_Ry)(0, 0), 1e-9));
}

TEST_CASE("the seven numbers spread as their first-order covariance says, for small errors", "[linear][second-route]") {
  const LinearParts<double> ship{.hull = {5.867, 0.761, 0.056, 1.004, 0.247, 0.225, 0.0043, 0.026, 0.0024, -0.063},
                                 .rudder = {0.0177, 0.326, 2.127, 0.0385, 0.6, 1.0, -0.5}};
  const auto i = steering_indices(coefficients(ship).total());
  const auto covariance = independent(i, {0.005, 0.005, 0.005, 0.005, 0.005, 0.005});
  const auto first_order = part_covariance(i, covariance, ship, KnownPart::N_b);
  const auto sampled = sample_parts(i, covariance, ship, KnownPart::N_b);
  for (int j = 0; j < 7; ++j)
    CHECK_THAT(std::sqrt(sampled.covariance(j, j)),
               WithinAbs(std::sqrt(first_order(j, j)), 0.05 * std::sqrt(first_order(j, j)) + 1e-9));
}

TEST_CASE("a separation of T3b and T3w within its standard error is said", "[linear][refusal]") {
  auto i = tanker();
  CHECK_FALSE(separation_warning(i, relative(0.01)).has_value());
  i.T3w = i.T3b * 1.02;
  const auto covariance = independent(i, {0.01, 0.01, 0.05, 0.05, 0.01, 0.01});
  CHECK(separation(i, covariance) < 1.0);
  CHECK_THAT(separation_warning(i, covariance).value(), ContainsSubstring("cannot be told apart"));
  CHECK(sample_coefficients(i, covariance, 2000).crossed > 0.2);
  i.T3w = i.T3b * 1.15;
  CHECK_THAT(separation_warning(i, independent(i, {0.01, 0.01, 0.05, 0.05, 0.01, 0.01})).value(),
             ContainsSubstring("standard errors apart"));
}

TEST_CASE("trust in T1 and T2 becomes a covariance of their product and sum", "[linear][second-route]") {
  const auto i = tanker();
  const auto T = time_constants(transfer_functions(i)).value();
  const Confidence confidence{.coefficients = 0.02, .named = {{"T1", 0.05}, {"T2", 0.1}}};
  const auto C = covariance_of(i, confidence);
  CHECK_THAT(std::sqrt(C(0, 0)) / i.T1T2, WithinRel(std::hypot(0.05, 0.1), 1e-12));
  CHECK_THAT(std::sqrt(C(1, 1)), WithinRel(std::hypot(0.05 * T.T1, 0.1 * T.T2), 1e-12));
  CHECK_THAT(C(0, 1), WithinRel(0.0025 * T.T1 * T.T1 * T.T2 + 0.01 * T.T2 * T.T2 * T.T1, 1e-12));
  CHECK_THAT(std::sqrt(C(5, 5)), WithinRel(0.02 * std::abs(i.Kw), 1e-12));
}

TEST_CASE("the same seed gives the same samples", "[linear][limit]") {
  CHECK(sample_coefficients(tanker(), relative(0.02), 500, 7).mean ==
        sample_coefficients(tanker(), relative(0.02), 500, 7).mean);
  CHECK(sample_coefficients(tanker(), relative(0.02), 500, 7).mean !=
        sample_coefficients(tanker(), relative(0.02), 500, 8).mean);
}

}  // namespace
}  // namespace swayaw
