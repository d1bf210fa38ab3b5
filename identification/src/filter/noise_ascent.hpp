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
  Eigen::MatrixXd covariance;  ///< of p, as the slopes on the way showed it
};

struct AscentOptions {
  int iterations;
  double worth = 5e-3;  ///< log likelihood: a step that predicts less ends the ascent, √(2 worth) standard errors from
                        ///< its end
};

/// Climbs from a start, first in the direction of the slope times the covariance of p that is known or expected, later
/// times that which the slopes show. It ends where a step is not worth while; or predicts less than 0.1 of log
/// likelihood, and no iterate on the way is better, for the slope of a linearized likelihood is not exactly its own.
///
/// @param slope     at the start
/// @param expected  covariance of p before anything is known of it
/// @param known     that which a climb nearby has found, if any
NoiseAscent climb(const std::function<Slope(const Eigen::VectorXd&)>& at, const Eigen::VectorXd& start, Slope slope,
                  const Eigen::MatrixXd& expected, const AscentOptions& options,
                  const Eigen::MatrixXd* known = nullptr);

}  // namespace swayaw::identification::detail
