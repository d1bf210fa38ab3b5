#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

/// Decompositions of small matrices, each compiled once: what Eigen makes of one takes the compiler seconds. Not
/// installed.
namespace swayaw::inline nonlinear::detail {

std::array<std::complex<double>, 3> eigenvalues(const Eigen::Matrix3d& J);

/// Whether every motion dx/dt = J x dies out.
bool is_stable(const Eigen::Matrix3d& J);

/// x with A x = b.
Eigen::Vector3d solve(const Eigen::Matrix3d& A, const Eigen::Vector3d& b);
Eigen::Vector4d solve(const Eigen::Matrix4d& A, const Eigen::Vector4d& b);

/// Unit vector x with A x = 0.
Eigen::Vector4d kernel(const Eigen::Matrix<double, 3, 4>& A);

}  // namespace swayaw::nonlinear::detail
