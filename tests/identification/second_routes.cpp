#include "second_routes.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace swayaw::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd by_reflections(const MatrixXd& X, const VectorXd& y) { return X.householderQr().solve(y); }

MatrixXd inverse_gram(const MatrixXd& X) {
  const MatrixXd pseudo = X.completeOrthogonalDecomposition().pseudoInverse();
  return pseudo * pseudo.transpose();
}

MatrixXd orthonormal(const MatrixXd& X) { return MatrixXd(X.householderQr().householderQ()).leftCols(X.cols()); }

double condition_number(const MatrixXd& X) {
  const VectorXd singular = X.jacobiSvd().singularValues();
  return singular[0] / singular[singular.size() - 1];
}

VectorXd least_told(const MatrixXd& X) { return X.jacobiSvd(Eigen::ComputeFullV).matrixV().col(X.cols() - 1); }

}  // namespace swayaw::test
