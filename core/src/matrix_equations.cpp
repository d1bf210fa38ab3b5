#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline core::detail {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd inverse(const MatrixXd& A) { return A.inverse(); }

VectorXd solve(const MatrixXd& A, const VectorXd& b) { return A.partialPivLu().solve(b); }

VectorXd solve_symmetric(const MatrixXd& A, const VectorXd& b) { return A.ldlt().solve(b); }

double log_determinant(const MatrixXd& A) { return A.ldlt().vectorD().array().abs().log().sum(); }

}  // namespace swayaw::core::detail
