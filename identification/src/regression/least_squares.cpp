#include "least_squares.hpp"

#include <algorithm>
#include <limits>

#include "spectrum.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Condition number up to which the normal equations, which square it, keep 1e-10.
constexpr double well_conditioned = 300.0;

/// Relative singular value below which a combination counts as not there: of orthogonal factors, and of moments.
constexpr double nothing_of_rows = 1e-11, nothing_of_moments = 1e-6;

Spectrum of_moments(const MatrixXd& G) { return spectrum_of(G, nothing_of_moments * nothing_of_moments); }
Spectrum of_rows(const MatrixXd& R) { return spectrum_of_rows(R, nothing_of_rows * nothing_of_rows); }

using core::detail::Triangle;

/// Of columns that are scaled for it.
Triangle triangle_of(const MatrixXd& X, const VectorXd& y) {
  const Index p = X.cols(), n = std::max(X.rows(), p);
  MatrixXd rows = MatrixXd::Zero(n, p);
  rows.topRows(X.rows()) = X;
  VectorXd right = VectorXd::Zero(n);
  right.head(y.size()) = y;
  const VectorXd size = column_sizes(rows.colwise().squaredNorm().transpose());
  auto triangle = core::detail::triangle(rows * size.cwiseInverse().asDiagonal(), right);
  triangle.R *= size.asDiagonal();
  return triangle;
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

VectorXd by_normal_equations(const MatrixXd& A, const VectorXd& right) {
  const VectorXd over = column_sizes(A.diagonal()).cwiseInverse();
  const MatrixXd scaled = over.asDiagonal() * A * over.asDiagonal();
  return over.asDiagonal() * core::detail::solve_symmetric(scaled, over.asDiagonal() * right);
}

/// Least squares of few rows, truncated where something is not determined.
VectorXd by_rows(const MatrixXd& R, const VectorXd& z, bool full) {
  const VectorXd over = column_sizes(R.colwise().squaredNorm().transpose()).cwiseInverse();
  const MatrixXd scaled = R * over.asDiagonal();
  const VectorXd c = full ? core::detail::least_squares(scaled, z)
                          : core::detail::singular_values(scaled).least_norm(z, nothing_of_rows);
  return over.asDiagonal() * c;
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
  const auto svd = core::detail::singular_values(C);
  const double nothing = std::numeric_limits<double>::epsilon() * static_cast<double>(std::min(C.rows(), C.cols()));
  const Index rank = svd.rank(nothing);
  const VectorXd b_0 = svd.least_norm(d, nothing);
  if ((C * b_0 - d).norm() > 1e-9 * (C.norm() * b_0.norm() + d.norm()))
    throw Refusal("the constraints of the regression contradict each other");
  if (rank == count) throw Refusal("the constraints of the regression leave no coefficient to be found");
  return {b_0, svd.V.rightCols(count - rank)};
}

Solution solve(const MatrixXd& X, const VectorXd& y, const Moments& moments, const Freedom& free,
               const Penalty& penalty) {
  const auto r = reduced(moments, free, penalty);
  const bool errors = moments.errors.size() > 0;
  const auto data = of_moments(r.G);
  const auto all = penalty.none() ? data : of_moments(r.G + r.P);
  const bool good = data.condition_number() <= well_conditioned && all.condition_number() <= well_conditioned;
  if (good || (errors && all.full()))
    return told(moments, free, r, data, all, by_normal_equations(r.G + r.P, r.h + r.g), Solver::normal_equations);
  if (errors) return told(moments, free, r, data, all, all.inverse() * (r.h + r.g), Solver::svd);

  const auto rows = triangle_of(X * free.Z, y - X * free.b_0);
  const auto both = penalty.none() ? rows : with_penalty(rows, free, penalty);
  const auto data_of_rows = of_rows(rows.R), all_of_rows = of_rows(both.R);
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
  const VectorXd over = column_sizes(M.diagonal()).cwiseInverse();
  // det(M − λ E) = 0; where M is not positive y is explained without any error
  const double over_lambda = core::detail::largest_eigenvalue(over.asDiagonal() * E * over.asDiagonal(),
                                                              over.asDiagonal() * M * over.asDiagonal());
  return over_lambda > 0.0 ? 1.0 / over_lambda : 0.0;
}

}  // namespace swayaw::identification::detail
