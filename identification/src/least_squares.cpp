#include "least_squares.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>

#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Condition number up to which the normal equations, which square it, keep 1e-10.
constexpr double well_conditioned = 300.0;

/// Relative singular value below which a combination counts as not there: of orthogonal factors, and of moments.
constexpr double nothing_of_rows = 1e-11, nothing_of_moments = 1e-6;

/// A symmetric matrix as D V λ Vᵀ D, D its columns' sizes.
struct Spectrum {
  VectorXd size;    ///< D
  VectorXd lambda;  ///< ascending
  MatrixXd V;
  double least;  ///< λ below which there is nothing

  bool full() const { return lambda.size() == 0 || lambda[0] > least; }
  double condition_number() const { return full() ? std::sqrt(lambda[lambda.size() - 1] / lambda[0]) : infinite; }
  Index empty() const { return (lambda.array() <= least).count(); }

  /// Inverse along all that is there.
  MatrixXd inverse() const {
    const VectorXd over = (lambda.array() > least).select(1.0 / lambda.array(), 0.0);
    const MatrixXd W = size.cwiseInverse().asDiagonal() * V;
    return W * over.asDiagonal() * W.transpose();
  }

  MatrixXd null() const { return size.cwiseInverse().asDiagonal() * V.leftCols(empty()); }
};

/// Sizes of columns; one that is not there counts as 1.
VectorXd sizes(const VectorXd& squares) { return (squares.array() > 0.0).select(squares.cwiseAbs().cwiseSqrt(), 1.0); }

double threshold(const VectorXd& lambda, double nothing) {
  return lambda.size() == 0 ? 0.0 : nothing * nothing * lambda[lambda.size() - 1];
}

Spectrum spectrum_of_moments(const MatrixXd& G) {
  const VectorXd size = sizes(G.diagonal());
  const VectorXd over = size.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(over.asDiagonal() * G * over.asDiagonal());
  return {size, axes.eigenvalues(), axes.eigenvectors(), threshold(axes.eigenvalues(), nothing_of_moments)};
}

/// Rows R with RᵀR = G, whose singular values are those of the features.
Spectrum spectrum_of_rows(const MatrixXd& R) {
  const VectorXd size = sizes(R.colwise().squaredNorm().transpose());
  const Eigen::JacobiSVD<MatrixXd> svd(R * size.cwiseInverse().asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  VectorXd lambda = VectorXd::Zero(R.cols());
  lambda.head(svd.singularValues().size()) = svd.singularValues().cwiseAbs2();
  lambda.reverseInPlace();
  return {size, lambda, svd.matrixV().rowwise().reverse(), threshold(lambda, nothing_of_rows)};
}

/// As many rows as columns that say the same as all rows: ‖X b − y‖² = ‖R b − z‖² + a constant.
struct Triangle {
  MatrixXd R;
  VectorXd z;
};

Triangle triangle_of(const MatrixXd& X, const VectorXd& y) {
  const Index p = X.cols(), n = std::max(X.rows(), p);
  MatrixXd rows = MatrixXd::Zero(n, p);
  rows.topRows(X.rows()) = X;
  VectorXd right = VectorXd::Zero(n);
  right.head(y.size()) = y;
  const VectorXd size = sizes(rows.colwise().squaredNorm().transpose());
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows * size.cwiseInverse().asDiagonal());
  right.applyOnTheLeft(qr.householderQ().adjoint());
  const MatrixXd upper = qr.matrixR().topRows(p).triangularView<Eigen::Upper>();
  return {upper * qr.colsPermutation().transpose() * size.asDiagonal(), right.head(p)};
}

/// The equations for c, constraints and penalty included.
struct Reduced {
  MatrixXd G;  ///< of the data
  VectorXd h;
  MatrixXd P;  ///< of the penalty
  VectorXd g;
};

Reduced reduced(const Moments& moments, const Freedom& free, const Penalty& penalty) {
  const Index p = free.b_0.size();
  const MatrixXd M = moments.errors.size() == 0 ? moments.rows : MatrixXd(moments.rows - moments.errors);
  const MatrixXd weighted = penalty.weight.asDiagonal() * free.Z;
  return {.G = free.Z.transpose() * M.topLeftCorner(p, p) * free.Z,
          .h = free.Z.transpose() * (M.col(p).head(p) - M.topLeftCorner(p, p) * free.b_0),
          .P = free.Z.transpose() * weighted,
          .g = weighted.transpose() * (penalty.centre - free.b_0)};
}

VectorXd by_cholesky(const MatrixXd& A, const VectorXd& right) {
  const VectorXd over = sizes(A.diagonal()).cwiseInverse();
  const MatrixXd scaled = over.asDiagonal() * A * over.asDiagonal();
  return over.asDiagonal() * scaled.llt().solve(over.asDiagonal() * right);
}

/// Least squares of few rows, truncated where something is not determined.
VectorXd by_rows(const MatrixXd& R, const VectorXd& z, bool full) {
  const VectorXd over = sizes(R.colwise().squaredNorm().transpose()).cwiseInverse();
  const MatrixXd scaled = R * over.asDiagonal();
  if (full) return over.asDiagonal() * scaled.colPivHouseholderQr().solve(z);
  Eigen::JacobiSVD<MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(nothing_of_rows);
  return over.asDiagonal() * svd.solve(z);
}

/// Data and penalty as rows.
Triangle with_penalty(const Triangle& data, const Freedom& free, const Penalty& penalty) {
  const Index k = data.R.cols(), p = penalty.weight.size();
  const VectorXd root = penalty.weight.cwiseSqrt();
  Triangle both{MatrixXd(k + p, k), VectorXd(k + p)};
  both.R << data.R, root.asDiagonal() * free.Z;
  both.z << data.z, root.asDiagonal() * (penalty.centre - free.b_0);
  return both;
}

/// x_jᵀx_j times what stands for (XᵀX)⁻¹; infinite where a coefficient is not determined.
VectorXd variance_inflation(const Moments& moments, const MatrixXd& by_data, const MatrixXd& null) {
  VectorXd inflation = moments.rows.diagonal().head(by_data.rows()).cwiseProduct(by_data.diagonal());
  for (Index j = 0; j < inflation.size(); ++j)
    if (null.cols() > 0 && null.row(j).norm() > 1e-7 * null.norm()) inflation[j] = infinite;
  return inflation;
}

Solution told(const Moments& moments, const Freedom& free, const Reduced& r, const Spectrum& data, const Spectrum& all,
              const VectorXd& c, Solver solver) {
  const MatrixXd inverse = all.inverse();
  const MatrixXd by_data = free.Z * data.inverse() * free.Z.transpose();
  const MatrixXd null_of_data = free.Z * data.null();
  return {.b = free.b_0 + free.Z * c,
          .inverse = free.Z * inverse * free.Z.transpose(),
          .by_data = by_data,
          .null = free.Z * all.null(),
          .null_of_data = null_of_data,
          .variance_inflation = variance_inflation(moments, by_data, null_of_data),
          .condition_number = data.condition_number(),
          .used = (inverse * r.G).trace(),
          .solver = solver};
}

}  // namespace

Freedom freedom(const MatrixXd& C, const VectorXd& d, Index count) {
  if (C.rows() == 0) return {VectorXd::Zero(count), MatrixXd::Identity(count, count)};
  const Eigen::JacobiSVD<MatrixXd> svd(C, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const VectorXd b_0 = svd.solve(d);
  if ((C * b_0 - d).norm() > 1e-9 * (C.norm() * b_0.norm() + d.norm()))
    throw Refusal("the constraints of the regression contradict each other");
  if (svd.rank() == count) throw Refusal("the constraints of the regression leave no coefficient to be found");
  return {b_0, svd.matrixV().rightCols(count - svd.rank())};
}

Solution solve(const MatrixXd& X, const VectorXd& y, const Moments& moments, const Freedom& free,
               const Penalty& penalty) {
  const auto r = reduced(moments, free, penalty);
  const bool errors = moments.errors.size() > 0;
  const auto data = spectrum_of_moments(r.G);
  const auto all = penalty.none() ? data : spectrum_of_moments(r.G + r.P);
  const bool good = data.condition_number() <= well_conditioned && all.condition_number() <= well_conditioned;
  if (good || (errors && all.full()))
    return told(moments, free, r, data, all, by_cholesky(r.G + r.P, r.h + r.g), Solver::normal_equations);
  if (errors) return told(moments, free, r, data, all, all.inverse() * (r.h + r.g), Solver::svd);

  const auto rows = triangle_of(X * free.Z, y - X * free.b_0);
  const auto both = penalty.none() ? rows : with_penalty(rows, free, penalty);
  const auto data_of_rows = spectrum_of_rows(rows.R), all_of_rows = spectrum_of_rows(both.R);
  const bool full = all_of_rows.full();
  return told(moments, free, r, data_of_rows, all_of_rows, by_rows(both.R, both.z, full),
              full ? Solver::qr : Solver::svd);
}

double largest_errors(const Moments& moments, const Freedom& free) {
  const Index p = free.b_0.size(), k = free.Z.cols();
  // [X Z, y − X b_0] = [X y] T
  MatrixXd T = MatrixXd::Zero(p + 1, k + 1);
  T.topLeftCorner(p, k) = free.Z;
  T.col(k).head(p) = -free.b_0;
  T(p, k) = 1.0;
  const MatrixXd M = T.transpose() * moments.rows * T, E = T.transpose() * moments.errors * T;
  const VectorXd over = sizes(M.diagonal()).cwiseInverse();
  const Eigen::LLT<MatrixXd> L(over.asDiagonal() * M * over.asDiagonal());
  if (L.info() != Eigen::Success) return 0.0;  // y is explained without any error
  // det(M − λ E) = 0:  1/λ are the eigenvalues of L⁻¹ E L⁻ᵀ
  const MatrixXd half = L.matrixL().solve(over.asDiagonal() * E * over.asDiagonal());
  const MatrixXd whole = L.matrixL().solve(half.transpose());
  const double largest = Eigen::SelfAdjointEigenSolver<MatrixXd>(whole, Eigen::EigenvaluesOnly).eigenvalues()[k];
  return largest > 0.0 ? 1.0 / largest : 0.0;
}

Axes principal_axes(const MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(covariance);
  return {axes.eigenvalues().reverse(), axes.eigenvectors().rowwise().reverse()};
}

}  // namespace swayaw
