#include <Eigen/Eigenvalues>

#include "small_matrices.hpp"

namespace swayaw::inline nonlinear::detail {

std::array<std::complex<double>, 3> eigenvalues(const Eigen::Matrix3d& J) {
  const Eigen::Vector3cd values = J.eigenvalues();
  return {values[0], values[1], values[2]};
}

bool is_stable(const Eigen::Matrix3d& J) {
  for (const auto& value : eigenvalues(J))
    if (!(value.real() < 0.0)) return false;
  return true;
}

}  // namespace swayaw::nonlinear::detail
