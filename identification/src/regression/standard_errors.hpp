#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

/// Standard errors of a fit whose residuals are correlated over a part of a ship length, and its best and worst known
/// combinations in words. Not installed.
namespace swayaw::inline identification::detail {

/// Slopes of the log likelihood by the unknowns, sample by sample, of a run that is so many ship lengths long.
struct RunScores {
  std::vector<Eigen::VectorXd> by_sample;
  double lengths;
};

/// Enlarges a covariance C, inverse information, to the standard errors of
///
///     C (B + Λ) C
///
/// where these are larger: B is the covariance of the sum of the scores, which count as correlated over one ship
/// length, enlarged for the degrees of freedom that the unknowns took from the independent pieces; Λ the precision of a
/// prior.
void enlarge_for_correlation(Eigen::MatrixXd& C, std::span<const RunScores> runs, const Eigen::VectorXd& prior,
                             double unknowns);

/// The point of Student's distribution below which the share lies.
double student_quantile(double share, double degrees_of_freedom);

/// "|Y_v|^0.71 |N_v|^-0.70 to 0.4 %", factors with small powers left out; "not at all" where the error is infinite.
std::string combination_words(std::span<const std::string> names, const Eigen::VectorXd& powers, double relative_error);

}  // namespace swayaw::identification::detail
