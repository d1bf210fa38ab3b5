#include "spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace swayaw::inline identification::detail {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double Spectrum::condition_number() const {
  return full() ? std::sqrt(lambda[lambda.size() - 1] / lambda[0]) : std::numeric_limits<double>::infinity();
}

MatrixXd Spectrum::inverse() const {
  const VectorXd over = (lambda.array() > least).select(1.0 / lambda.array(), 0.0);
  const MatrixXd W = size.cwiseInverse().asDiagonal() * V;
  return W * over.asDiagonal() * W.transpose();
}

VectorXd column_sizes(const VectorXd& squares) {
  return (squares.array() > 0.0).select(squares.cwiseAbs().cwiseSqrt(), 1.0);
}

namespace {

Spectrum spectrum(const VectorXd& size, const VectorXd& lambda, const MatrixXd& V, double nothing) {
  return {size, lambda, V, lambda.size() == 0 ? 0.0 : nothing * lambda[lambda.size() - 1]};
}

}  // namespace

PrincipalAxes principal_axes(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(A);
  return {axes.eigenvalues().reverse(), axes.eigenvectors().rowwise().reverse()};
}

Spectrum spectrum_of(const MatrixXd& A, double nothing) {
  const VectorXd size = column_sizes(A.diagonal()), over = size.cwiseInverse();
  const auto axes = principal_axes(over.asDiagonal() * A * over.asDiagonal());
  return spectrum(size, axes.size.reverse(), axes.axis.rowwise().reverse(), nothing);
}

Spectrum spectrum_of_rows(const MatrixXd& R, double nothing) {
  const VectorXd size = column_sizes(R.colwise().squaredNorm().transpose());
  const Eigen::JacobiSVD<MatrixXd> svd(R * size.cwiseInverse().asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  VectorXd lambda = VectorXd::Zero(R.cols());
  lambda.head(svd.singularValues().size()) = svd.singularValues().cwiseAbs2();
  return spectrum(size, lambda.reverse(), svd.matrixV().rowwise().reverse(), nothing);
}

}  // namespace swayaw::identification::detail
