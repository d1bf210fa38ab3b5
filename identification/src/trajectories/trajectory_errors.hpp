#pragma once

#include "trajectory_shooting.hpp"

/// What segments tell about the parameters at the end of a fit. Not installed.
namespace swayaw::inline identification::detail {

struct ParameterErrors {
  Eigen::MatrixXd covariance;   ///< infinite on the diagonal for a number that is not told
  Eigen::MatrixXd information;  ///< of the parameters, the starts being unknown
  bool full_rank;
};

/// Inverse information, with standard errors enlarged where residuals are correlated over a part of a ship length.
ParameterErrors parameter_errors(const TrajectoryProblem& problem, const Linearization& at,
                                 const Eigen::VectorXd& prior);

/// Which combinations of the parameters are known, and which are not.
struct Combinations {
  double condition_number;
  std::string best;
  std::vector<std::string> undetermined;
};

Combinations combinations_of(const std::vector<Parameter>& parameters, std::span<const double> values,
                             const ParameterErrors& errors);

}  // namespace swayaw::identification::detail
