#pragma once

#include <Eigen/Core>
#include <vector>

/// How the residuals of a regression hang together in time. Not installed.
namespace swayaw::inline identification::detail {

/// Rows [first, first + count) of a run.
struct RowRange {
  Eigen::Index first, count;
};

/// e_t = Σ phi_k e_{t−k} + white noise, as the predictors of every lower order and the variances that they leave.
struct Autoregression {
  std::vector<Eigen::VectorXd> phi;  ///< of order 0, 1, … p
  Eigen::VectorXd variance;          ///< that each leaves; [0] is that of e itself

  const Eigen::VectorXd& of_full_order() const { return phi.back(); }

  /// Rows that say as much of the mean as one independent row: var(mean of many) over var(e)/n.
  double rows_for_one() const;
};

/// Yule–Walker equations of the residuals of all runs, solved by Levinson and Durbin.
Autoregression autoregression_of(const Eigen::VectorXd& e, const std::vector<RowRange>& runs, Eigen::Index order);

/// Rows whose residuals are white and of the variance that the full order leaves; the first ones of a run are predicted
/// from as many as there are. Source: [Prais1954]
Eigen::MatrixXd whitened(const Autoregression& noise, const Eigen::MatrixXd& rows, const std::vector<RowRange>& runs);

/// Covariance of the sum of all rows, rows of a run being correlated; Bartlett weights and an automatic bandwidth, the
/// columns whitened beforehand. Source: [Newey1994], [Andrews1992]
Eigen::MatrixXd covariance_of_sum(const Eigen::MatrixXd& scores, const std::vector<RowRange>& runs);

/// Effective number of independent residuals.
double effective_samples(const Eigen::VectorXd& e, const std::vector<RowRange>& runs);

}  // namespace swayaw::identification::detail
