#include "linear_estimates.hpp"

#include <cmath>

#include "../regression/spectrum.hpp"
#include "../regression/standard_errors.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/dual.hpp"

namespace swayaw::inline identification::detail {
namespace {

using D = Dual<6>;

/// sqrt(gᵀ C g): the error of a function of the constants with gradient g.
Estimate estimate(const D& x, const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd g = x.v.head(covariance.rows());
  return {x.a, std::sqrt(g.dot(covariance * g))};
}

SwayYawTransfer<D> transfer_of(const FittedConstants& constants) {
  const auto& x = constants.value;
  if (constants.with_drift())
    return transfer_functions(
        SwayYawCoefficients<D>{D(x[0], 0), D(x[1], 1), D(x[2], 2), D(x[3], 3), D(x[4], 4), D(x[5], 5)});
  return {
      .e0 = D(x[0], 0), .e1 = D(x[1], 1), .nb0 = D(missing), .nb1 = D(missing), .nw0 = D(x[2], 2), .nw1 = D(x[3], 3)};
}

double normal_probability(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

/// P(e0 > 0 and e1 > 0) ≥ P(e0 > 0) + P(e1 > 0) − 1, equal where one of them is certain.
double probability_of_stability(const SwayYawTransfer<Estimate>& h) {
  const double p = normal_probability(h.e0.value / h.e0.standard_error),
               q = normal_probability(h.e1.value / h.e1.standard_error);
  return std::max(0.0, p + q - 1.0);
}

/// Principal axes of the covariance of the logarithms, C_ij/(x_i x_j). A constant that may be zero counts as its
/// standard error.
void tell_combinations(const FittedConstants& constants, LinearFit& fit) {
  using Names = std::vector<std::string>;
  const auto names =
      constants.with_drift() ? Names{"a1", "b1", "c1", "a2", "b2", "c2"} : Names{"e0", "e1", "nw0", "nw1"};
  const Eigen::VectorXd size = constants.value.cwiseAbs().cwiseMax(constants.covariance.diagonal().cwiseSqrt());
  const Eigen::VectorXd over = constants.value.array().sign() / size.array();
  const auto axes = core::detail::principal_axes(over.asDiagonal() * constants.covariance * over.asDiagonal());
  const Eigen::VectorXd errors = axes.size.cwiseMax(0.0).cwiseSqrt();
  const auto last = errors.size() - 1;
  fit.condition_number = errors[0] / errors[last];
  fit.best_combination = combination_words(names, axes.axis.col(last), errors[last]);
  fit.worst_combination = combination_words(names, axes.axis.col(0), errors[0]);
}

void tell_coefficients(const FittedConstants& constants, LinearFit& fit) {
  for (auto& row : fit.covariance) row.fill(missing);
  fit.coefficients = {};
  if (!constants.with_drift()) return;
  const auto& x = constants.value;
  const auto& C = constants.covariance;
  const auto at = [&](Eigen::Index i) { return Estimate{x[i], std::sqrt(C(i, i))}; };
  fit.coefficients = {at(0), at(1), at(2), at(3), at(4), at(5)};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      fit.covariance[i][j] = C(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
}

}  // namespace

void tell_constants(const FittedConstants& constants, LinearFit& fit) {
  tell_coefficients(constants, fit);
  tell_combinations(constants, fit);
  const auto h = transfer_of(constants);
  const auto i = steering_indices(h);
  const bool drift = constants.with_drift();
  const auto told = [&](const D& x, bool known = true) {
    return known ? estimate(x, constants.covariance) : Estimate{};
  };
  fit.transfer = {.e0 = told(h.e0),
                  .e1 = told(h.e1),
                  .nb0 = told(h.nb0, drift),
                  .nb1 = told(h.nb1, drift),
                  .nw0 = told(h.nw0),
                  .nw1 = told(h.nw1)};
  fit.indices = {.T1T2 = told(i.T1T2),
                 .T1_plus_T2 = told(i.T1_plus_T2),
                 .T3b = told(i.T3b, drift),
                 .T3w = told(i.T3w),
                 .Kb = told(i.Kb, drift),
                 .Kw = told(i.Kw)};
  fit.time_constants.reset();
  if (const auto t = time_constants(h)) fit.time_constants = TimeConstants<Estimate>{told(t->T1), told(t->T2)};
  fit.stable = h.e0 > D(0.0) && h.e1 > D(0.0);
  fit.probability_stable = probability_of_stability(fit.transfer);
}

}  // namespace swayaw::identification::detail
