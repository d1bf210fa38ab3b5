#include "spectrum.hpp"

#include <cmath>
#include <limits>

#include "swayaw/core/detail/matrices.hpp"

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

Spectrum spectrum_of(const MatrixXd& A, double nothing) {
  const VectorXd size = column_sizes(A.diagonal()), over = size.cwiseInverse();
  const auto axes = core::detail::principal_axes(over.asDiagonal() * A * over.asDiagonal());
  return spectrum(size, axes.size.reverse(), axes.axis.rowwise().reverse(), nothing);
}

Spectrum spectrum_of_rows(const MatrixXd& R, double nothing) {
  const VectorXd size = column_sizes(R.colwise().squaredNorm().transpose());
  const auto svd = core::detail::singular_values(R * size.cwiseInverse().asDiagonal());
  VectorXd lambda = VectorXd::Zero(R.cols());
  lambda.head(svd.size.size()) = svd.size.cwiseAbs2();
  return spectrum(size, lambda.reverse(), svd.V.rowwise().reverse(), nothing);
}

}  // namespace swayaw::identification::detail
