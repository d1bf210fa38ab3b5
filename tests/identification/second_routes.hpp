#pragma once

#include <Eigen/Core>

/// Least squares by orthogonal factors, beside which regressions are held; compiled once.
namespace swayaw::test {

/// x of least ‖X x − y‖.
Eigen::VectorXd by_reflections(const Eigen::MatrixXd& X, const Eigen::VectorXd& y);

/// (XᵀX)⁻¹
Eigen::MatrixXd inverse_gram(const Eigen::MatrixXd& X);

/// Columns of length 1, at right angles, that span those of X.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& X);

/// Largest singular value over the least.
double condition_number(const Eigen::MatrixXd& X);

/// The unit vector x of least ‖X x‖.
Eigen::VectorXd least_told(const Eigen::MatrixXd& X);

}  // namespace swayaw::test
