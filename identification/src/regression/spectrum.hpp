#pragma once

#include <Eigen/Core>

/// What a symmetric matrix says along its axes, the columns measured in units that make its diagonal 1. Not installed.
namespace swayaw::inline identification::detail {

/// A = D V λ Vᵀ D, positive semidefinite but for rounding.
struct Spectrum {
  Eigen::VectorXd size;    ///< D
  Eigen::VectorXd lambda;  ///< ascending
  Eigen::MatrixXd V;
  double least;  ///< λ up to which there is nothing

  bool full() const { return lambda.size() == 0 || lambda[0] > least; }
  double condition_number() const;
  Eigen::Index empty() const { return (lambda.array() <= least).count(); }

  /// Inverse along all that is there.
  Eigen::MatrixXd inverse() const;

  /// Changes that change nothing, in columns.
  Eigen::MatrixXd null() const { return size.cwiseInverse().asDiagonal() * V.leftCols(empty()); }

  /// Share of a coordinate that lies where there is nothing.
  double untold(Eigen::Index coordinate) const { return V.row(coordinate).head(empty()).squaredNorm(); }
};

/// @param nothing  λ over the largest, up to which there is nothing
Spectrum spectrum_of(const Eigen::MatrixXd& A, double nothing);

/// That of RᵀR, from the singular values of R.
Spectrum spectrum_of_rows(const Eigen::MatrixXd& R, double nothing);

/// Sizes of columns from their squares; one that is not there counts as 1.
Eigen::VectorXd column_sizes(const Eigen::VectorXd& squares);

}  // namespace swayaw::identification::detail
