#pragma once

#include <Eigen/Core>

#include "bounded_step.hpp"

/// Least squares with a normal prior between bounds, in a trust region. Not installed.
namespace swayaw::inline identification::detail {

/// A x = b, to which the step of Gauss and Newton leads.
struct NormalEquations {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  bool from_here = true;  ///< of slopes worked out here, none kept from an earlier point
};

struct DescentOptions {
  int iterations;
  int attempts;              ///< in a shrinking region, until a step descends
  double worth;              ///< least gain in the cost that a step must predict
  double worth_share = 0.0;  ///< the same as a share of the cost, which comes to it
  double radius;             ///< of the first region
};

/// Where the descent is, and between which bounds it stays.
struct Descent {
  Eigen::VectorXd point, residuals;
  double cost;
  Eigen::VectorXd low, high;
  double kept = 1.0;  ///< of the gain that the last step predicted
};

/// Descends from a point. The region shrinks after a step that gained less than a quarter of what was predicted, and
/// doubles after one that gained three quarters and ended at its edge. Source: [More1983] Where slopes were kept from
/// an earlier point it is they that were wrong: the region stays, and the step is sought once more with slopes from
/// here.
///
/// @param renew(descent, iteration)  works out slopes there and gives the normal equations; empty ones end the descent.
///                                   Where the last step kept less than a quarter, from there
/// @param at(point)                  residuals, huge where there are none
/// @param cost(point, residuals)     what is to be least
template <class Renew, class At, class Cost>
void descend(Descent& here, const DescentOptions& options, Renew&& renew, At&& at, Cost&& cost) {
  constexpr double poor = 0.25, good = 0.75, enough = 1e-3;  // of the gain that was predicted
  double radius = options.radius;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const NormalEquations normal = renew(here, iteration);
    if (normal.b.size() == 0) return;
    bool goes_on = false;
    for (int attempt = 0; attempt < options.attempts && !goes_on; ++attempt) {
      const Eigen::VectorXd step =
          bounded_step(normal.A, -normal.b, here.low - here.point, here.high - here.point, radius);
      const double predicted = step.dot(2.0 * normal.b - normal.A * step);
      if (!(predicted > options.worth + options.worth_share * here.cost)) return;
      const Eigen::VectorXd there = here.point + step;
      Eigen::VectorXd residuals = at(there);
      const double cost_there = cost(there, residuals), share = (here.cost - cost_there) / predicted;
      here.kept = share;
      const bool is_poor = !(share > poor);
      if (is_poor && normal.from_here) radius = 0.25 * step.norm();
      else if (share > good && step.norm() > 0.9 * radius) radius *= 2.0;
      if (share > enough) here.point = there, here.residuals = std::move(residuals), here.cost = cost_there;
      goes_on = share > enough || !normal.from_here;
    }
    if (!goes_on) return;
  }
}

}  // namespace swayaw::identification::detail
