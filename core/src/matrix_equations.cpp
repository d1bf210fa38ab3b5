#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline core::detail {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Eigen sums products of large matrices in blocks that suit the caches of the machine, so another machine rounds
/// otherwise, and a diagnosis between two valleys ended in the one here and in the other there: a compass that was 4.24
/// deg off came to 3.69 deg beside first caches of 48 KiB and to 4.06 deg beside 32. So the blocks are those of one
/// machine, for all products of the process. AᵀA of 3,259 rows and 88 columns takes 0.97 to 1.1 times as long so beside
/// 48 KiB.
[[maybe_unused]] const bool one_order_of_sums = [] {
  constexpr std::ptrdiff_t KiB = 1024;
  Eigen::setCpuCacheSizes(32 * KiB, 1024 * KiB, 32 * 1024 * KiB);
  return true;
}();

}  // namespace

MatrixXd inverse(const MatrixXd& A) { return A.inverse(); }

VectorXd solve(const MatrixXd& A, const VectorXd& b) { return A.partialPivLu().solve(b); }

// Eigen's LLᵀ works in blocks, its LDLᵀ does not: of a hundred unknowns it took 10 % of a diagnosis.

VectorXd solve_symmetric(const MatrixXd& A, const VectorXd& b) {
  const Eigen::LLT<MatrixXd> factors(A);
  if (factors.info() == Eigen::Success) return factors.solve(b);
  return A.ldlt().solve(b);
}

double log_determinant(const MatrixXd& A) {
  const Eigen::LLT<MatrixXd> factors(A);
  if (factors.info() == Eigen::Success) return 2.0 * factors.matrixLLT().diagonal().array().log().sum();
  return A.ldlt().vectorD().array().abs().log().sum();
}

MatrixXd gram(const MatrixXd& A) {
  if (A.size() == 0) return MatrixXd::Zero(A.cols(), A.cols());  // Eigen divides by the number of rows
  MatrixXd product = MatrixXd::Zero(A.cols(), A.cols());
  product.selfadjointView<Eigen::Lower>().rankUpdate(A.transpose());
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

std::vector<std::vector<double>> rows_of(const MatrixXd& A) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : A.rowwise()) rows.emplace_back(row.begin(), row.end());
  return rows;
}

}  // namespace swayaw::core::detail
