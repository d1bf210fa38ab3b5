#pragma once

#include "swayaw/linear/indices.hpp"

namespace swayaw::inline linear {

/// Length and speed that make quantities dimensionless: s' = tU/L, omega' = rL/U.
struct PrimeScale {
  double L;  ///< [m]
  double U;  ///< [m/s]
};

/// Steering indices with dimension. T in seconds; Kb is an angle per angle; Kr is the yaw rate per rudder angle.
template <class S = double>
struct DimensionalIndices {
  S T1T2_s2;       ///< [s^2]
  S T1_plus_T2_s;  ///< [s]
  S T3b_s;         ///< [s]
  S T3w_s;         ///< [s]
  S Kb;            ///< [-]
  S Kr_per_s;      ///< [1/s]
};

/// T = T' L/U, Kr = Kw U/L.
template <class S>
DimensionalIndices<S> dimensional(const SteeringIndices<S>& i, const PrimeScale& scale) {
  const double t = scale.L / scale.U;
  return {i.T1T2 * (t * t), i.T1_plus_T2 * t, i.T3b * t, i.T3w * t, i.Kb, i.Kw / t};
}

/// The inverse of `dimensional`.
template <class S>
SteeringIndices<S> to_prime(const DimensionalIndices<S>& i, const PrimeScale& scale) {
  const double t = scale.L / scale.U;
  return {i.T1T2_s2 / (t * t), i.T1_plus_T2_s / t, i.T3b_s / t, i.T3w_s / t, i.Kb, i.Kr_per_s * t};
}

/// The coupled equations in seconds, for v and r:
///
///     dv/dt = Y_v v + Y_r r + Y_delta delta,   dr/dt = N_v v + N_r r + N_delta delta,   v = −U beta
template <class S = double>
struct DimensionalSwayYaw {
  S v_v;      ///< dv/dt by v [1/s]
  S v_r;      ///< dv/dt by r [m/s]
  S v_delta;  ///< dv/dt by delta [m/s^2]
  S r_v;      ///< dr/dt by v [1/(m s)]
  S r_r;      ///< dr/dt by r [1/s]
  S r_delta;  ///< dr/dt by delta [1/s^2]
};

template <class S>
DimensionalSwayYaw<S> dimensional(const SwayYawCoefficients<S>& m, const PrimeScale& scale) {
  const double U = scale.U, L = scale.L, rate = U / L;
  return {m.a1 * rate, -m.b1 * U, -m.c1 * (U * rate), -m.a2 * (rate / L), m.b2 * rate, m.c2 * (rate * rate)};
}

template <class S>
SwayYawCoefficients<S> to_prime(const DimensionalSwayYaw<S>& d, const PrimeScale& scale) {
  const double U = scale.U, L = scale.L, rate = U / L;
  return {d.v_v / rate,        -d.v_r / U,   -d.v_delta / (U * rate),
          -d.r_v / (rate / L), d.r_r / rate, d.r_delta / (rate * rate)};
}

}  // namespace swayaw::linear
