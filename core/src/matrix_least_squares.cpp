#include <Eigen/QR>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline core::detail {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd least_squares(const MatrixXd& A, const VectorXd& b) { return A.colPivHouseholderQr().solve(b); }

VectorXd least_norm(const MatrixXd& A, const VectorXd& b) { return A.completeOrthogonalDecomposition().solve(b); }

Triangle triangle(const MatrixXd& A, const VectorXd& b) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  VectorXd right = b;
  right.applyOnTheLeft(qr.householderQ().adjoint());
  const MatrixXd upper = qr.matrixR().topRows(A.cols()).triangularView<Eigen::Upper>();
  return {upper * qr.colsPermutation().transpose(), right.head(A.cols())};
}

}  // namespace swayaw::core::detail
