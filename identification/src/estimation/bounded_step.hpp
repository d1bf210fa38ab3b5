#pragma once

#include <Eigen/Core>

/// Steps of a least-squares fit between bounds. Not installed.
namespace swayaw::inline identification::detail {

/// The step d that makes ½ dᵀH d + gᵀd least for low ≤ d ≤ high and |d| ≤ radius; low ≤ 0 ≤ high.
///
/// H is positive semidefinite. Where the radius binds, d solves the problem of H + mu I with the least mu that keeps
/// it.
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& H, const Eigen::VectorXd& g, const Eigen::VectorXd& low,
                             const Eigen::VectorXd& high, double radius);

}  // namespace swayaw::identification::detail
