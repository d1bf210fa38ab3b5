#pragma once

#include <Eigen/Core>

#include "swayaw/identification/regression.hpp"

/// The linear algebra of a regression. Not installed.
namespace swayaw::inline identification::detail {

/// b = b_0 + Z c for every c: what linear constraints leave free.
struct Freedom {
  Eigen::VectorXd b_0;
  Eigen::MatrixXd Z;
};

/// Coefficients with C b = d.
/// @throws Refusal  if the constraints contradict each other or leave nothing free
Freedom freedom(const Eigen::MatrixXd& C, const Eigen::VectorXd& d, Eigen::Index count);

/// Σ weight (b − centre)², added to the sum of squares.
struct Penalty {
  Eigen::VectorXd weight, centre;

  bool none() const { return weight.maxCoeff() == 0.0; }
};

/// Sums over the samples.
struct Moments {
  Eigen::MatrixXd rows;    ///< [X y]ᵀ [X y]
  Eigen::MatrixXd errors;  ///< sum of the covariances of (x, y), to be taken off; empty where features are exact
};

struct Solution {
  Eigen::VectorXd b;
  Eigen::MatrixXd inverse;       ///< of what multiplies b, along all that is determined
  Eigen::MatrixXd by_data;       ///< the same without the penalty
  Eigen::MatrixXd null;          ///< changes of b that change nothing, in columns
  Eigen::MatrixXd null_of_data;  ///< the same without the penalty
  Eigen::VectorXd variance_inflation;
  double condition_number;
  double used;  ///< coefficients that the data determine, as a number
  Solver solver;
};

/// Least squares with moments known; the rows themselves are looked at where the columns are nearly collinear.
Solution solve(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const Moments& moments, const Freedom& free,
               const Penalty& penalty);

/// The largest multiple of the errors that leaves the moments positive, on what the constraints leave free.
double largest_errors(const Moments& moments, const Freedom& free);

}  // namespace swayaw::identification::detail
