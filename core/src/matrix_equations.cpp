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

std::vector<std::vector<double>> rows_of(const MatrixXd& A) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : A.rowwise()) rows.emplace_back(row.begin(), row.end());
  return rows;
}

}  // namespace swayaw::core::detail
