#include <catch.hpp>

#include "random_designs.hpp"
#include "second_routes.hpp"
#include "swayaw/identification/regression.hpp"

/// What regressions say of their errors, over many noises.
namespace swayaw {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Coverage;
using test::difference;
using test::RandomDesigns;
using test::values;

TEST_CASE("with white noise 95 % intervals hold the truth for 92 to 98 %", "[identification][second-route]") {
  RandomDesigns random(21);
  Coverage few, many, weighted;
  for (int i = 0; i < 400; ++i) {
    auto [design, truth] = random.design(9, 4);  // five degrees of freedom
    design.y += 0.3 * random.normals(9);
    few.add(regress(design), truth);
    auto [large, of_large] = random.design(150, 4);
    large.y += 2.0 * random.normals(150);
    many.add(regress(large), of_large);
    auto [uneven, of_uneven] = random.design(60, 3);
    uneven.variance = VectorXd::NullaryExpr(60, [&] { return random.uniform(0.01, 4.0); });
    uneven.y += uneven.variance.cwiseSqrt().cwiseProduct(random.normals(60));
    weighted.add(regress(uneven), of_uneven);
  }
  for (const auto* coverage : {&few, &many, &weighted}) {
    CHECK(coverage->share() > 0.92);
    CHECK(coverage->share() < 0.98);
  }
}

TEST_CASE("with AR(1) noise least squares claims too much; generalised and Newey-West errors hold for 90 to 98 %",
          "[identification][second-route]") {
  RandomDesigns random(22);
  for (const double phi : {0.5, 0.8}) {
    INFO("phi " << phi);
    Coverage plain, generalised, robust;
    for (int i = 0; i < 400; ++i) {
      auto [design, truth] = random.design(400, 3);
      design.runs = {0, 150};
      design.y.head(150) += random.correlated(150, phi);
      design.y.tail(250) += random.correlated(250, phi);
      plain.add(regress(design), truth);
      generalised.add(regress(design, {.residuals = Residuals::autoregressive}), truth);
      robust.add(regress(design, {.standard_errors = StandardErrors::newey_west}), truth);
    }
    CHECK(plain.share() < 0.87);
    CHECK(generalised.share() > 0.92);
    CHECK(generalised.share() < 0.98);
    CHECK(robust.share() > 0.90);
    CHECK(robust.share() < 0.98);
  }
}

TEST_CASE("generalised least squares is closer to the truth than least squares when noise is correlated",
          "[identification][limit]") {
  RandomDesigns random(23);
  double plain = 0.0, generalised = 0.0;
  for (int i = 0; i < 200; ++i) {
    auto [design, truth] = random.design(300, 3);
    design.y += random.correlated(300, 0.95);
    plain += ((values(regress(design)) - truth).array() / truth.array()).square().sum();
    generalised += ((values(regress(design, {.residuals = Residuals::autoregressive})) - truth).array() / truth.array())
                       .square()
                       .sum();
  }
  CHECK(generalised < 0.5 * plain);
}

TEST_CASE("the autoregression of the residuals is found, of second order too", "[identification][round-trip]") {
  RandomDesigns random(24);
  auto [design, truth] = random.design(20000, 3);
  VectorXd e = random.normals(20000);
  for (Index t = 2; t < e.size(); ++t) e[t] += 1.2 * e[t - 1] - 0.5 * e[t - 2];
  design.y += e;
  const auto fit = regress(design, {.residuals = Residuals::autoregressive, .order = 2});
  CHECK(fit.status == FitStatus::converged);
  CHECK_THAT(fit.autoregression[0], WithinAbs(1.2, 0.03));
  CHECK_THAT(fit.autoregression[1], WithinAbs(-0.5, 0.03));
  // n (1 − phi)/(1 + phi) of a first order
  auto first = test::RandomDesigns(25).design(20000, 2).design;
  first.y += random.correlated(20000, 0.6);
  CHECK_THAT(regress(first, {.residuals = Residuals::autoregressive}).samples, WithinRel(20000 * 0.4 / 1.6, 0.1));
  CHECK_THAT(regress(first).samples, WithinRel(20000 * 0.4 / 1.6, 0.2));
}

/// Features measured with errors; truth and covariance of the errors of (x, y).
struct Noisy {
  Design design;
  VectorXd truth;
  MatrixXd covariance;
};

Noisy with_feature_errors(RandomDesigns& random, Index n) {
  Noisy noisy;
  MatrixXd X(n, 3);
  for (Index j = 0; j < 3; ++j) X.col(j) = random.correlated(n, 0.6);
  X.col(1) += 0.5 * X.col(0);
  noisy.truth = VectorXd::Constant(3, 1.0) + 0.2 * random.normals(3);
  // errors of x_0, x_1 and y are correlated, x_2 is exact
  MatrixXd root = MatrixXd::Zero(4, 4);
  root << 0.6, 0, 0, 0, 0.2, 0.5, 0, 0, 0, 0, 0, 0, 0.3, 0.1, 0, 0.4;
  noisy.covariance = root * root.transpose();
  MatrixXd both(n, 4);
  both << X, X * noisy.truth;
  for (Index i = 0; i < n; ++i) both.row(i) += (root * random.normals(4)).transpose();
  noisy.design = {{"a", "b", "c"}, both.leftCols(3), both.col(3)};
  return noisy;
}

TEST_CASE("known errors of features are taken off: no attenuation, intervals hold for 92 to 98 %",
          "[identification][second-route]") {
  RandomDesigns random(26);
  Coverage plain, corrected;
  VectorXd plain_bias = VectorXd::Zero(3), bias = VectorXd::Zero(3), told = VectorXd::Zero(3);
  constexpr int runs = 300;
  for (int i = 0; i < runs; ++i) {
    const auto [design, truth, covariance] = with_feature_errors(random, 400);
    const auto naive = regress(design), fit = regress(design, {.feature_errors = {{covariance}}});
    plain.add(naive, truth);
    corrected.add(fit, truth);
    plain_bias += (values(naive) - truth) / runs;
    bias += (values(fit) - truth) / runs;
    for (Index j = 0; j < 3; ++j) told[j] += fit.coefficients[static_cast<std::size_t>(j)].attenuation / runs;
  }
  CHECK(plain_bias.cwiseAbs().maxCoeff() > 0.08);
  CHECK(bias.cwiseAbs().maxCoeff() < 0.015);
  CHECK((told - plain_bias).cwiseAbs().maxCoeff() < 0.015);
  CHECK(plain.share() < 0.7);
  CHECK(corrected.share() > 0.92);
  CHECK(corrected.share() < 0.98);
}

TEST_CASE("a covariance for each sample does the same as one for all where they are equal",
          "[identification][symmetry]") {
  RandomDesigns random(27);
  const auto [design, truth, covariance] = with_feature_errors(random, 100);
  const auto one = regress(design, {.feature_errors = {{covariance}}});
  const auto each = regress(design, {.feature_errors = {std::vector<MatrixXd>(100, covariance)}});
  CHECK(difference(values(each), values(one)) < 1e-10);
  CHECK((each.covariance - one.covariance).norm() < 1e-10 * one.covariance.norm());
}

TEST_CASE("total least squares is the smallest right singular vector", "[identification][second-route]") {
  RandomDesigns random(28);
  auto [design, truth] = random.design(200, 3);
  MatrixXd both(200, 4);
  both << random.normals(200), random.normals(200), random.normals(200), VectorXd::Zero(200);
  both.col(3) = both.leftCols(3) * VectorXd::LinSpaced(3, 1.0, 2.0);
  both += 0.1 * MatrixXd::NullaryExpr(200, 4, [&] { return random.normal(); });
  const auto fit = regress({{"a", "b", "c"}, both.leftCols(3), both.col(3)},
                           {.feature_errors = {.covariance = {MatrixXd::Identity(4, 4)}, .size_known = false}});
  const VectorXd v = test::least_told(both);
  CHECK(difference(values(fit), -v.head(3) / v[3]) < 1e-9);
  CHECK_THAT(fit.error_size, WithinRel(0.01, 0.2));
}

TEST_CASE("total least squares with noise of the right shape holds the truth for 92 to 98 %",
          "[identification][second-route]") {
  RandomDesigns random(29);
  Coverage coverage;
  for (int i = 0; i < 300; ++i) {
    const auto [design, truth, covariance] = with_feature_errors(random, 400);
    coverage.add(regress(design, {.feature_errors = {.covariance = {5.0 * covariance}, .size_known = false}}), truth);
  }
  CHECK(coverage.share() > 0.92);
  CHECK(coverage.share() < 0.98);
}

TEST_CASE("a coefficient whose force might be half of all is told undetermined, with the combination that is",
          "[identification][limit]") {
  RandomDesigns random(30);
  auto design = random.design(100, 3).design;
  design.X.col(2) = design.X.col(1) + 1e-3 * design.X.col(1).norm() / 10.0 * random.normals(100);
  design.y = design.X.col(0) / design.X.col(0).norm() + 0.02 * random.normals(100);
  const auto fit = regress(design);
  CHECK(fit.status == FitStatus::converged);
  REQUIRE(fit.undetermined.size() == 1);
  CHECK((in_words(fit.undetermined[0]) == "b1 - b2" || in_words(fit.undetermined[0]) == "-b1 + b2"));
  CHECK(!fit["b0"].undetermined);
  CHECK(fit["b1"].undetermined);
  CHECK(fit["b2"].undetermined);
}

}  // namespace
}  // namespace swayaw
