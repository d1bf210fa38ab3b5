#include "swayaw/identification/regression.hpp"

#include <catch.hpp>

#include "random_designs.hpp"
#include "second_routes.hpp"
#include "swayaw/core/refusal.hpp"

/// Algebra of regressions, over seeded random designs.
namespace swayaw {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::by_reflections;
using test::difference;
using test::inverse_gram;
using test::RandomDesigns;
using test::values;

TEST_CASE("without noise all coefficients come back to 1e-10", "[identification][round-trip]") {
  RandomDesigns random(1);
  for (int i = 0; i < 100; ++i) {
    const auto [design, truth] = random.design(random.whole(40, 400), random.whole(1, 12));
    const auto fit = regress(design);
    REQUIRE(fit.status == FitStatus::converged);
    REQUIRE(difference(values(fit), truth) < 1e-10);
    REQUIRE(fit.R2 > 1.0 - 1e-12);
    REQUIRE(fit.undetermined.empty());
  }
}

TEST_CASE("least squares with standard errors is that of orthogonal factors", "[identification][second-route]") {
  RandomDesigns random(2);
  for (int i = 0; i < 100; ++i) {
    const Index n = random.whole(40, 400), p = random.whole(1, 12);
    auto [design, truth] = random.design(n, p);
    design.y += random.normals(n);
    const auto fit = regress(design);
    const VectorXd b = by_reflections(design.X, design.y);
    const VectorXd e = design.y - design.X * b;
    const double s2 = e.squaredNorm() / static_cast<double>(n - p);
    const MatrixXd C = s2 * inverse_gram(design.X);
    REQUIRE(difference(values(fit), b) < 1e-8);
    REQUIRE(fit.solver == Solver::normal_equations);
    REQUIRE_THAT(fit.residual_rms, WithinRel(std::sqrt(e.squaredNorm() / static_cast<double>(n)), 1e-10));
    REQUIRE_THAT(fit.degrees_of_freedom, WithinAbs(static_cast<double>(n - p), 1e-6));
    for (Index j = 0; j < p; ++j) {
      const auto& c = fit.coefficients[static_cast<std::size_t>(j)];
      REQUIRE_THAT(c.estimate.standard_error, WithinRel(std::sqrt(C(j, j)), 1e-8));
      REQUIRE_THAT(c.variance_inflation, WithinRel(design.X.col(j).squaredNorm() * C(j, j) / s2, 1e-8));
    }
    const MatrixXd even = design.X * design.X.colwise().norm().cwiseInverse().asDiagonal();
    REQUIRE_THAT(fit.condition_number, WithinRel(test::condition_number(even), 1e-8));
  }
}

TEST_CASE("nearly collinear columns go to orthogonal factors and lose no more than the condition number",
          "[identification][round-trip]") {
  RandomDesigns random(3);
  for (const double apart : {1e-3, 1e-5, 1e-7}) {
    auto [design, truth] = random.design(200, 4);
    design.X.col(3) = design.X.col(2) * (1.0 + random.uniform(0.0, 1.0)) +
                      apart * design.X.col(2).norm() / 14.0 * random.normals(200);
    design.y = design.X * truth;
    const auto fit = regress(design);
    CHECK(fit.solver == Solver::qr);
    CHECK(fit.condition_number > 0.1 / apart);
    CHECK(difference(values(fit), truth) < 1e-13 / apart * 100.0);
  }
}

TEST_CASE("columns at right angles have variance inflation 1 and condition number 1", "[identification][limit]") {
  RandomDesigns random(4);
  const MatrixXd Q = test::orthonormal(random.design(100, 6).design.X);
  Design design{
      {"a", "b", "c", "d", "e", "f"}, Q * VectorXd::LinSpaced(6, 1.0, 500.0).asDiagonal(), random.normals(100)};
  const auto fit = regress(design);
  CHECK_THAT(fit.condition_number, WithinAbs(1.0, 1e-10));
  for (const auto& c : fit.coefficients) CHECK_THAT(c.variance_inflation, WithinAbs(1.0, 1e-10));
}

TEST_CASE("another unit of a column changes its coefficient and nothing else", "[identification][symmetry]") {
  RandomDesigns random(5);
  for (int i = 0; i < 30; ++i) {
    auto [design, truth] = random.design(120, 5);
    design.y += random.correlated(120, 0.5);
    for (const auto& options :
         {RegressionOptions{}, RegressionOptions{.residuals = Residuals::autoregressive},
          RegressionOptions{.standard_errors = StandardErrors::newey_west}, RegressionOptions{.ridge = 3.0}}) {
      auto scaled = design;
      scaled.X.col(1) *= 1e4;
      const auto before = regress(design, options), after = regress(scaled, options);
      REQUIRE_THAT(after["b1"].estimate.value * 1e4, WithinRel(before["b1"].estimate.value, 1e-8));
      REQUIRE_THAT(after["b1"].estimate.standard_error * 1e4, WithinRel(before["b1"].estimate.standard_error, 1e-8));
      REQUIRE_THAT(after["b3"].estimate.value, WithinRel(before["b3"].estimate.value, 1e-8));
      REQUIRE_THAT(after.condition_number, WithinRel(before.condition_number, 1e-8));
      REQUIRE_THAT(after.residual_rms, WithinRel(before.residual_rms, 1e-10));
    }
  }
}

TEST_CASE("constraints are kept exactly, and cost nothing where the truth obeys them", "[identification][round-trip]") {
  RandomDesigns random(6);
  for (int i = 0; i < 50; ++i) {
    auto [design, truth] = random.design(150, 5);
    const double sum = 2.0 * truth[0] - 3.0 * truth[4];
    const RegressionOptions kept{.constraints = {{{{"b0", 2.0}, {"b4", -3.0}}, sum}, {{{"b2", 1.0}}, truth[2]}}};
    CHECK(difference(values(regress(design, kept)), truth) < 1e-9);
    design.y += random.normals(150);
    const auto fit = regress(design, kept);
    const double found = 2.0 * fit["b0"].estimate.value - 3.0 * fit["b4"].estimate.value;
    REQUIRE_THAT(found, WithinAbs(sum, 1e-10 * (std::abs(truth[0]) + std::abs(truth[4]))));
    REQUIRE_THAT(fit["b2"].estimate.value, WithinRel(truth[2], 1e-10));
    REQUIRE(fit["b2"].estimate.standard_error <= 1e-6 * regress(design)["b2"].estimate.standard_error);
    REQUIRE_THAT(fit.degrees_of_freedom, WithinAbs(147.0, 1e-6));
  }
}

TEST_CASE("of a column given twice the difference is not determined, and all other coefficients are",
          "[identification][round-trip]") {
  RandomDesigns random(7);
  for (int i = 0; i < 50; ++i) {
    auto [design, truth] = random.design(100, 4);
    const double factor = random.uniform(0.2, 5.0);
    design.X.col(3) = factor * design.X.col(1);
    design.y = design.X * truth + 1e-3 * random.normals(100);
    const auto fit = regress(design);
    REQUIRE(fit.status == FitStatus::rank_deficient);
    REQUIRE(fit.solver == Solver::svd);
    REQUIRE(fit.undetermined.size() == 1);
    const auto& terms = fit.undetermined[0].terms;
    REQUIRE(terms.size() == 2);
    REQUIRE(in_words(fit.undetermined[0]).starts_with(terms[0].second > 0.0 ? "b1 - b3" : "-b1 + b3"));
    REQUIRE(std::isinf(fit.undetermined[0].standard_error));
    for (const auto* name : {"b1", "b3"}) {
      REQUIRE(fit[name].undetermined);
      REQUIRE(std::isnan(fit[name].estimate.value));
      REQUIRE(std::isinf(fit[name].estimate.standard_error));
      REQUIRE(std::isinf(fit[name].variance_inflation));
    }
    REQUIRE(!fit["b0"].undetermined);
    REQUIRE(std::abs(fit["b0"].estimate.value - truth[0]) < 6.0 * fit["b0"].estimate.standard_error);
    REQUIRE(std::abs(fit["b2"].estimate.value - truth[2]) < 6.0 * fit["b2"].estimate.standard_error);
  }
}

TEST_CASE("a constraint or a prior determines what the data do not", "[identification][limit]") {
  RandomDesigns random(8);
  auto [design, truth] = random.design(100, 3);
  design.X.col(2) = design.X.col(1);
  design.y = design.X * truth + 1e-6 * random.normals(100);
  const auto constrained = regress(design, {.constraints = {{{{"b2", 1.0}}, truth[2]}}});
  CHECK(constrained.status == FitStatus::converged);
  CHECK_THAT(constrained["b1"].estimate.value, WithinRel(truth[1], 1e-4));
  const auto informed = regress(design, {.priors = {{"b2", truth[2], 0.1 * std::abs(truth[2])}}});
  CHECK(informed.status == FitStatus::converged);
  CHECK_THAT(informed["b2"].estimate.value, WithinRel(truth[2], 1e-6));
  CHECK_THAT(informed["b2"].estimate.standard_error, WithinRel(0.1 * std::abs(truth[2]), 1e-3));
  CHECK(informed["b2"].undetermined);  // by the data
  CHECK(informed.undetermined.size() == 1);
}

TEST_CASE("weighted least squares is that of rows over their deviations", "[identification][second-route]") {
  RandomDesigns random(9);
  auto [design, truth] = random.design(200, 4);
  design.variance = VectorXd::NullaryExpr(200, [&] { return random.uniform(0.1, 10.0); });
  design.y += design.variance.cwiseSqrt().cwiseProduct(random.normals(200));
  const auto weighted = regress(design);
  auto rows = design;
  rows.variance.resize(0);
  rows.X = design.variance.cwiseSqrt().cwiseInverse().asDiagonal() * design.X;
  rows.y = design.variance.cwiseSqrt().cwiseInverse().cwiseProduct(design.y);
  const auto plain = regress(rows);
  CHECK(difference(values(weighted), values(plain)) < 1e-9);
  CHECK_THAT(weighted["b2"].estimate.standard_error, WithinRel(plain["b2"].estimate.standard_error, 1e-9));
  const auto known = regress(design, {.variance_known = true});
  CHECK_THAT(known["b2"].estimate.standard_error, WithinRel(std::sqrt(inverse_gram(rows.X)(2, 2)), 1e-8));
}

TEST_CASE("a prior is one more measurement", "[identification][second-route]") {
  RandomDesigns random(10);
  for (int i = 0; i < 30; ++i) {
    auto [design, truth] = random.design(60, 3);
    design.y += random.normals(60);
    const double mean = 1.3 * truth[1], deviation = 0.2 * std::abs(truth[1]);
    const auto fit = regress(design, {.priors = {{"b1", mean, deviation}}});
    const double s2 = fit.residuals.squaredNorm() / fit.degrees_of_freedom;
    MatrixXd X(61, 3);
    X << design.X, std::sqrt(s2) / deviation * VectorXd::Unit(3, 1).transpose();
    VectorXd y(61);
    y << design.y, std::sqrt(s2) / deviation * mean;
    REQUIRE(difference(values(fit), by_reflections(X, y)) < 1e-7);
    REQUIRE_THAT(fit["b1"].estimate.standard_error, WithinRel(std::sqrt(s2 * inverse_gram(X)(1, 1)), 1e-7));
  }
}

TEST_CASE("a sharp prior is obeyed, a vague one is not heard", "[identification][limit]") {
  RandomDesigns random(11);
  auto [design, truth] = random.design(80, 3);
  design.y += random.normals(80);
  const auto free = regress(design);
  const double size = free["b0"].estimate.standard_error;
  CHECK_THAT(regress(design, {.priors = {{"b0", 7.0 * size, 1e-6 * size}}})["b0"].estimate.value,
             WithinRel(7.0 * size, 1e-6));
  CHECK(difference(values(regress(design, {.priors = {{"b0", 7.0 * size, 1e6 * size}}})), values(free)) < 1e-6);
}

TEST_CASE("ridge is that many samples that say zero", "[identification][second-route]") {
  RandomDesigns random(12);
  auto [design, truth] = random.design(90, 3);
  design.y += random.normals(90);
  const auto fit = regress(design, {.ridge = 5.0});
  MatrixXd X = MatrixXd::Zero(93, 3);
  X.topRows(90) = design.X;
  for (Index j = 0; j < 3; ++j) X(90 + j, j) = std::sqrt(5.0 / 90.0) * design.X.col(j).norm();
  VectorXd y = VectorXd::Zero(93);
  y.head(90) = design.y;
  CHECK(difference(values(fit), by_reflections(X, y)) < 1e-9);
}

TEST_CASE("the order of runs does not matter, with correlated residuals either", "[identification][symmetry]") {
  RandomDesigns random(13);
  auto [design, truth] = random.design(230, 3);
  design.runs = {0, 90};
  design.y.head(90) += random.correlated(90, 0.8);
  design.y.tail(140) += random.correlated(140, 0.8);
  Design turned = design;
  turned.runs = {0, 140};
  turned.X << design.X.bottomRows(140), design.X.topRows(90);
  turned.y << design.y.tail(140), design.y.head(90);
  for (const auto& options : {RegressionOptions{.residuals = Residuals::autoregressive, .order = 2},
                              RegressionOptions{.standard_errors = StandardErrors::newey_west}}) {
    const auto a = regress(design, options), b = regress(turned, options);
    CHECK(difference(values(a), values(b)) < 1e-9);
    CHECK((a.covariance - b.covariance).norm() < 1e-9 * a.covariance.norm());
    CHECK_THAT(a.samples, WithinRel(b.samples, 1e-9));
  }
}

TEST_CASE("senseless regressions are refused in words", "[identification][refusal]") {
  RandomDesigns random(14);
  auto [design, truth] = random.design(20, 3);
  CHECK_THROWS_AS(regress({design.names, design.X, VectorXd(19)}), std::domain_error);
  CHECK_THROWS_AS(regress({{"a"}, design.X, design.y}), std::domain_error);
  CHECK_THROWS_WITH(regress(design, {.priors = {{"c", 0.0, 1.0}}}), ContainsSubstring("no coefficient c"));
  CHECK_THROWS_WITH(regress({design.names, design.X.topRows(3), design.y.head(3)}),
                    ContainsSubstring("3 samples do not tell 3 coefficients"));
  CHECK_THROWS_WITH(regress(design, {.constraints = {{{{"b0", 1.0}}, 1.0}, {{{"b0", 2.0}}, 1.0}}}),
                    ContainsSubstring("contradict"));
  CHECK_THROWS_WITH(regress({{"b0"}, design.X.leftCols(1), design.y}, {.constraints = {{{{"b0", 1.0}}, 1.0}}}),
                    ContainsSubstring("leave no coefficient"));
  CHECK_THROWS_AS(regress(design, {.priors = {{"b0", 1.0, 0.0}}}), std::domain_error);
  auto bad = design;
  bad.runs = {0, 5, 5};
  CHECK_THROWS_AS(regress(bad), std::domain_error);
  bad = design;
  bad.y[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(regress(bad), ContainsSubstring("not finite"));
  bad = design;
  bad.variance = VectorXd::Zero(20);
  CHECK_THROWS_AS(regress(bad), std::domain_error);
  CHECK_THROWS_AS(
      regress(design, {.residuals = Residuals::autoregressive, .feature_errors = {{MatrixXd::Identity(4, 4)}}}),
      std::domain_error);
}

}  // namespace
}  // namespace swayaw
