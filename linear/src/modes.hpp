#pragma once

#include "swayaw/linear/response.hpp"

/// Motion of a ship whose poles are real and well apart, split into its two modes. Not installed.
namespace swayaw::inline linear::detail {

/// exp(l s) and its integrals from 0: once, twice, three times.
struct ExponentialMoments {
  double e, p1, p2, p3;
};

namespace detail {

/// 1/3! + z/4! + … + z¹²/15!, for |z| ≤ 1/2 to the last digit; by Estrin's scheme.
inline double third_moment_series(double z) {
  const double z2 = z * z, z4 = z2 * z2;
  const double a = (1.0 / 6.0 + z * (1.0 / 24.0)) + z2 * (1.0 / 120.0 + z * (1.0 / 720.0));
  const double b = (1.0 / 5040.0 + z * (1.0 / 40320.0)) + z2 * (1.0 / 362880.0 + z * (1.0 / 3628800.0));
  const double c = (1.0 / 39916800.0 + z * (1.0 / 479001600.0)) + z2 * (1.0 / 6227020800.0 + z * (1.0 / 87178291200.0));
  return a + z4 * (b + z4 * (c + z4 * (1.0 / 1307674368000.0)));
}

/// Downwards, p_k = s^k/k! + l p_{k+1}: for small |l s|.
inline ExponentialMoments moments_by_series(double l, double s) {
  const double p3 = s * s * s * third_moment_series(l * s);
  const double p2 = 0.5 * s * s + l * p3, p1 = s + l * p2;
  return {1.0 + l * p1, p1, p2, p3};
}

/// Upwards, p_{k+1} = (p_k − s^k/k!)/l.
inline ExponentialMoments moments_by_exponential(double l, double over_l, double s) {
  const double e = exp(l * s);
  const double p1 = (e - 1.0) * over_l, p2 = (p1 - s) * over_l;
  return {e, p1, p2, (p2 - 0.5 * s * s) * over_l};
}

}  // namespace detail

/// @param over_l  1/l, not used where |l s| is small
inline ExponentialMoments moments(double l, double over_l, double s) {
  return std::abs(l * s) < 0.5 ? detail::moments_by_series(l, s) : detail::moments_by_exponential(l, over_l, s);
}

/// Poles and the projection of a state on the first mode, P_1 = (A − l2)/(l1 − l2); the rest is the second mode.
struct Modes {
  double l1, l2;
  double over_l1, over_l2;
  double yaw_beta, yaw_omega;      ///< row of P_1 for omega
  double drift_beta, drift_omega;  ///< row of P_1 for beta
  double yaw_gain, drift_gain;     ///< P_1 c: what the rudder does to the first mode of omega and of beta

  Modes(const SwayYawCoefficients<double>& m, double slow, double fast)
      : l1(slow), l2(fast), over_l1(1.0 / slow), over_l2(1.0 / fast) {
    const double over = 1.0 / (slow - fast);
    yaw_beta = m.a2 * over;
    yaw_omega = (m.b2 - fast) * over;
    drift_beta = (m.a1 - fast) * over;
    drift_omega = m.b1 * over;
    yaw_gain = yaw_beta * m.c1 + yaw_omega * m.c2;
    drift_gain = drift_beta * m.c1 + drift_omega * m.c2;
  }
};

}  // namespace swayaw::linear::detail
