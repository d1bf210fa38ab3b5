#include "small_matrices.hpp"

#include <Eigen/LU>

namespace swayaw::inline nonlinear::detail {

Eigen::Vector3d solve(const Eigen::Matrix3d& A, const Eigen::Vector3d& b) { return A.partialPivLu().solve(b); }

Eigen::Vector4d solve(const Eigen::Matrix4d& A, const Eigen::Vector4d& b) { return A.partialPivLu().solve(b); }

Eigen::Vector4d kernel(const Eigen::Matrix<double, 3, 4>& A) { return A.fullPivLu().kernel().col(0).normalized(); }

}  // namespace swayaw::nonlinear::detail
