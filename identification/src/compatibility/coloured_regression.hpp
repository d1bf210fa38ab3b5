#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

/// Linear regression on a series in time whose errors remember.
namespace swayaw::inline identification::detail {

/// Errors of a series on one or two axes i, e.g. x and y:
///
///     e_i(t) = white_i + m_i(t) + w_i(t) + V_i(t) (c(t) + jitter)
///
/// m is a first-order Markov process, whose correlation falls to 1/e in `memory`; w a random walk from zero,
/// Var w(t) = walk² t; c, common to the axes, the error of their clock, a random walk, too, and with it the jitter of
/// each sample: a clock that drifts and jumps moves a ship along her track and not across it. The walk may have a part
/// of its own across the ship: sway that was not measured.
struct ErrorModel {
  double white;         ///< standard deviation
  double markov;        ///< standard deviation
  double memory;        ///< [s]
  double walk;          ///< standard deviation after one second
  double clock = 0.0;   ///< standard deviation after one second [s]
  double jitter = 0.0;  ///< standard deviation [s]
};

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows of a regression in time, y = X beta + e.
struct TimeSeries {
  std::vector<double> time;    ///< [s], not decreasing
  std::vector<int> axis;       ///< 0 or 1
  std::vector<double> speed;   ///< V of the row's axis; 0 without clock
  std::vector<double> bridge;  ///< standard deviation that the walk gains before the row, beyond its own: a gap
  RowMatrix Xy;                ///< X, and y in the last column

  /// Room for rows; time, axis and the rest to be filled.
  TimeSeries(std::size_t rows, Eigen::Index columns)
      : time(rows),
        axis(rows),
        speed(rows),
        bridge(rows),
        Xy(RowMatrix::Zero(static_cast<Eigen::Index>(rows), columns)) {}
};

struct ColouredFit {
  Eigen::VectorXd beta;
  Eigen::MatrixXd covariance;
  ErrorModel errors;
  double deviance;  ///< −2 ln of the likelihood of the errors, but for a constant
};

/// beta with the prior N(0, diag(prior²)) by generalised least squares, and the size and memory of the errors by their
/// likelihood with beta integrated out. Whitened: each column of [X y] goes through the Kalman filter of the errors.
/// What an error model has at 0 when the search begins stays there.
///
/// The covariance counts what memory the whitened residuals still have: with g_k = x_k e_k, Bartlett's weights and
/// information A, the variances of   A⁻¹ (Σ g gᵀ) A⁻¹   take the place of those of   A⁻¹   where they are larger.
///
/// @param starts  where the search of the errors begins; the likeliest end counts
ColouredFit coloured_regression(const TimeSeries& series, const Eigen::VectorXd& prior,
                                std::span<const ErrorModel> starts);

/// Every n-th row of each axis, so that few are left: the search of the errors needs no more.
TimeSeries thinned(const TimeSeries& series);

/// By how much the deviance would fall with one more column, for each of several columns Z beside X: with whitened
/// columns and M = I − X A⁻¹ Xᵀ
///
///     (zᵀ M y)² / (zᵀ M z)
Eigen::VectorXd gains_of(const TimeSeries& series, const Eigen::VectorXd& prior, const ErrorModel& errors,
                         const RowMatrix& Z);

}  // namespace swayaw::identification::detail
