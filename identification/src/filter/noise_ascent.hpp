#pragma once

#include <Eigen/Core>
#include <functional>

/// Likelihood climbed by the method of Broyden, Fletcher, Goldfarb and Shanno. Not installed.
namespace swayaw::inline identification::detail {

/// Log likelihood and its slope by the parameters.
struct Slope {
  double value;
  Eigen::VectorXd by_p;
};

struct NoiseAscent {
  Eigen::VectorXd p;
  double value;
  int iterations;
  bool converged;
};

/// Climbs from a start, first in the direction of the slope over `curvature`, later with the curvature that the slopes
/// show. It ends where a step predicts less than 5e-3 of log likelihood, that is 0.1 standard errors; or less than
/// 0.1, and no iterate on the way is better, for the slope of a linearized likelihood is not exactly its own.
NoiseAscent climb(const std::function<Slope(const Eigen::VectorXd&)>& at, const Eigen::VectorXd& start,
                  const Eigen::VectorXd& curvature, int most_iterations);

}  // namespace swayaw::identification::detail
