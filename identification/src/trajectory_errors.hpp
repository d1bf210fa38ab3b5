#pragma once

#include "trajectory_shooting.hpp"

/// What legs tell about the numbers at the end of a fit. Not installed.
namespace swayaw::trajectory {

struct NumberErrors {
  Eigen::MatrixXd covariance;   ///< infinite on the diagonal for a number that is not told
  Eigen::MatrixXd information;  ///< of the numbers, the starts being unknown
  bool full_rank;
};

/// Inverse information, with standard errors enlarged where residuals are correlated over a part of a ship length.
NumberErrors number_errors(const TrajectoryProblem& problem, const Linearization& at, const Eigen::VectorXd& prior);

/// Which combinations of the numbers are known, and which are not.
struct Combinations {
  double condition_number;
  std::string best;
  std::vector<std::string> undetermined;
};

Combinations combinations_of(const NumberList& numbers, std::span<const double> values, const NumberErrors& errors);

}  // namespace swayaw::trajectory
