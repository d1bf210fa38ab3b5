#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>

/// Least squares with a normal prior between bounds, by Levenberg and Marquardt. Not installed.
namespace swayaw {

/// A x = b, to which the step of Gauss and Newton leads.
struct NormalEquations {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
};

struct DescentOptions {
  int iterations;
  int attempts;           ///< with growing damping, until a step descends
  double worth;           ///< least gain in the cost for which it goes on
  double harder, easier;  ///< factor on the damping after a step that failed, and over it after one that did not
};

/// Where the descent is.
struct Descent {
  Eigen::VectorXd point, residuals;
  double cost;
};

/// Descends from a point.
///
/// @param renew(descent, iteration)  works out slopes there and gives the normal equations
/// @param at(point)                  residuals, huge where there are none
/// @param cost(point, residuals)     what is to be least
/// @param kept(point)                the point within its bounds
template <class Renew, class At, class Cost, class Kept>
void descend(Descent& here, const DescentOptions& options, Renew&& renew, At&& at, Cost&& cost, Kept&& kept) {
  constexpr double least_damping = 1e-3;  // of the diagonal of A
  double damping = least_damping;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const NormalEquations normal = renew(here, iteration);
    double gain = 0.0;
    for (int attempt = 0; attempt < options.attempts && gain == 0.0; ++attempt) {
      Eigen::MatrixXd damped = normal.A;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd step = damped.ldlt().solve(normal.b);
      const double tried = damping;
      damping *= options.harder;
      if (!step.allFinite()) continue;
      const Eigen::VectorXd moved = kept(here.point + step);
      Eigen::VectorXd there = at(moved);
      const double cost_there = cost(moved, there);
      if (!(cost_there < here.cost)) continue;
      gain = here.cost - cost_there;
      here = {moved, std::move(there), cost_there};
      damping = std::max(tried / options.easier, least_damping);
    }
    if (gain < options.worth) return;
  }
}

}  // namespace swayaw
