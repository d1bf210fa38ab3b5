#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <limits>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline core::detail {

using Eigen::MatrixXd;
using Eigen::VectorXd;

PrincipalAxes principal_axes(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(A);
  return {axes.eigenvalues().reverse(), axes.eigenvectors().rowwise().reverse()};
}

double largest_eigenvalue(const MatrixXd& A, const MatrixXd& B) {
  const Eigen::LLT<MatrixXd> L(B);
  if (L.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  // those of L⁻¹ A L⁻ᵀ
  const MatrixXd half = L.matrixL().solve(A);
  const MatrixXd whole = L.matrixL().solve(half.transpose());
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(whole, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

Eigen::Index SingularValues::rank(double nothing) const {
  return size.size() == 0 ? 0 : (size.array() > nothing * size[0]).count();
}

VectorXd SingularValues::least_norm(const VectorXd& b, double nothing) const {
  const auto r = rank(nothing);
  const VectorXd along = U.leftCols(r).transpose() * b;
  return V.leftCols(r) * along.cwiseQuotient(size.head(r));
}

SingularValues singular_values(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

}  // namespace swayaw::core::detail
