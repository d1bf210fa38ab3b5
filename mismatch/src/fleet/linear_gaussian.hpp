#pragma once

#include <Eigen/Core>

/// Normal laws whose logarithm is a quadratic, joined and eliminated in closed form. Not installed.
namespace swayaw::inline mismatch::detail {

/// ln p(data | x) = −½ xᵀAx + bᵀx + c: what data tell of x. A may be singular.
struct Told {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  double c = 0.0;

  static Told nothing(Eigen::Index size) {
    return {Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size), 0.0};
  }

  Told& operator+=(const Told& other) {
    A += other.A, b += other.b, c += other.c;
    return *this;
  }

  /// Of y with x = G y.
  Told of(const Eigen::MatrixXd& G) const { return {G.transpose() * A * G, G.transpose() * b, c}; }
};

/// Of y with x = y + L n, n normal with unit covariance and eliminated:
///
///     M = I + LᵀAL,  A' = A − AL M⁻¹ LᵀA,  b' = b − AL M⁻¹ Lᵀb,  c' = c + ½ bᵀL M⁻¹ Lᵀb − ½ ln det M
///
/// @param L  a square root of the covariance, whose columns may be fewer than its rows
Told blurred(const Told& told, const Eigen::MatrixXd& L);

/// A normal law.
struct NormalLaw {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double log_evidence;  ///< of the data
};

/// Posterior of x = m + L n before data.
NormalLaw posterior(const Told& told, const Eigen::VectorXd& m, const Eigen::MatrixXd& L);

}  // namespace swayaw::mismatch::detail
