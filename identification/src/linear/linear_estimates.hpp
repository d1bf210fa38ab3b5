#pragma once

#include <Eigen/Core>

#include "swayaw/identification/linear_fit.hpp"

/// What follows from fitted constants and their covariance. Not installed.
namespace swayaw::inline identification::detail {

/// Fitted constants: a1, b1, c1, a2, b2, c2, or without drift e0, e1, nw0, nw1.
struct FittedConstants {
  Eigen::VectorXd value;
  Eigen::MatrixXd covariance;

  bool with_drift() const { return value.size() == 6; }
};

/// Fills coefficients, transfer functions, indices, time constants, covariance, combinations and stability of a fit.
void tell_constants(const FittedConstants& constants, LinearFit& fit);

/// Coupled equations with a given transfer function of yaw. Drift is replaced by x with dx/ds' = −e0 omega' + nw0 delta
/// and d(omega')/ds' = x − e1 omega' + nw1 delta.
template <class S>
SwayYawCoefficients<S> yaw_only_ship(const S& e0, const S& e1, const S& nw0, const S& nw1) {
  return {.a1 = S(0.0), .b1 = -e0, .c1 = nw0, .a2 = S(1.0), .b2 = -e1, .c2 = nw1};
}

}  // namespace swayaw::identification::detail
