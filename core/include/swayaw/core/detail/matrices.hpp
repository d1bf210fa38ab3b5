#pragma once

#include <Eigen/Core>
#include <vector>

/// Dense matrices: decompositions, each compiled once, for what Eigen makes of one takes the compiler seconds and
/// hundreds of megabytes; and their rows for answers. Not for users, who have Eigen.
namespace swayaw::inline core::detail {

// ---------------------------------------------------------------- equations

/// A⁻¹, by LU with partial pivots.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);

/// x with A x = b, by LU with partial pivots.
Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The same of a symmetric positive A, by LLᵀ; by LDLᵀ where rounding leaves it not positive.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// ln det A of a symmetric positive A.
double log_determinant(const Eigen::MatrixXd& A);

// ---------------------------------------------------------------- least squares

/// AᵀA, half of it worked out.
Eigen::MatrixXd gram(const Eigen::MatrixXd& A);

/// x of least ‖A x − b‖, by Householder reflections with column pivots.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Of those x the one of least norm; the rank of A may be short.
Eigen::VectorXd least_norm(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// As many rows as columns that say the same as all rows: ‖A x − b‖² = ‖R x − z‖² + a constant.
struct Triangle {
  Eigen::MatrixXd R;
  Eigen::VectorXd z;
};

/// @param A  at least as many rows as columns
Triangle triangle(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

// ---------------------------------------------------------------- axes

/// Principal axes of a covariance or an information: sizes, largest first, and axes in columns.
struct PrincipalAxes {
  Eigen::VectorXd size;
  Eigen::MatrixXd axis;
};

/// @param A  symmetric
PrincipalAxes principal_axes(const Eigen::MatrixXd& A);

/// Largest λ with det(A − λ B) = 0, A symmetric, B symmetric and positive; not a number where B is not positive.
double largest_eigenvalue(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// A = U diag(size) Vᵀ, sizes largest first; U with as many columns as there are sizes, V square.
struct SingularValues {
  Eigen::MatrixXd U;
  Eigen::VectorXd size;
  Eigen::MatrixXd V;

  /// How many are larger than `nothing` times the largest.
  Eigen::Index rank(double nothing) const;

  /// x of least ‖A x − b‖ and of least norm, smaller singular values taken as 0.
  Eigen::VectorXd least_norm(const Eigen::VectorXd& b, double nothing) const;
};

SingularValues singular_values(const Eigen::MatrixXd& A);

// ---------------------------------------------------------------- answers

std::vector<std::vector<double>> rows_of(const Eigen::MatrixXd& A);

}  // namespace swayaw::core::detail
