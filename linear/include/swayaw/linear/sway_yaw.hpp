#pragma once

#include <array>

#include "swayaw/core/parameter.hpp"
#include "swayaw/core/scalar.hpp"

namespace swayaw::inline linear {

/// Linear sway–yaw equations of a ship at constant speed, dimensionless time s' = tU/L:
///
///     d(beta)/ds'  = a1 beta + b1 omega' + c1 delta
///     d(omega')/ds' = a2 beta + b2 omega' + c2 delta
///
/// beta drift angle [rad], omega' = rL/U, delta rudder angle positive to port [rad].
/// Source: [Artyszuk2016] eq. (1)
template <class S = double>
struct SwayYawCoefficients {
  S a1, b1, c1;  ///< drift
  S a2, b2, c2;  ///< yaw

  static constexpr auto parameters() {
    constexpr auto coefficient = [](std::string_view key, S SwayYawCoefficients::*member) {
      return ParameterOf<SwayYawCoefficients, S>{key, member, "-", any_number, Role::coefficient};
    };
    return std::array{
        coefficient("a1", &SwayYawCoefficients::a1), coefficient("b1", &SwayYawCoefficients::b1),
        coefficient("c1", &SwayYawCoefficients::c1), coefficient("a2", &SwayYawCoefficients::a2),
        coefficient("b2", &SwayYawCoefficients::b2), coefficient("c2", &SwayYawCoefficients::c2),
    };
  }
};

/// det A = a1 b2 − a2 b1 = 1/(T1 T2); negative for an unstable ship.
template <class S>
S determinant(const SwayYawCoefficients<S>& m) {
  return m.a1 * m.b2 - m.a2 * m.b1;
}

/// tr A = a1 + b2 = −(T1 + T2)/(T1 T2).
template <class S>
S trace(const SwayYawCoefficients<S>& m) {
  return m.a1 + m.b2;
}

/// Whether both poles lie in the left half-plane: det A > 0 and tr A < 0.
/// Source: [Artyszuk2016] eqs (27), (28)
template <class S>
bool is_stable(const SwayYawCoefficients<S>& m) {
  return determinant(m) > S(0.0) && trace(m) < S(0.0);
}

/// Whether the poles are a complex pair.
template <class S>
bool has_complex_poles(const SwayYawCoefficients<S>& m) {
  const S t = trace(m);
  return t * t < 4.0 * determinant(m);
}

/// Laplace transforms of drift and yaw over that of the rudder:
///
///     beta/delta   = (nb1 s + nb0) / (s² + e1 s + e0)
///     omega'/delta = (nw1 s + nw0) / (s² + e1 s + e0)
///
/// Regular for every ship: stable, unstable, neutral (e0 = 0), complex poles, Kb = 0 or Kw = 0.
template <class S = double>
struct SwayYawTransfer {
  S e0;   ///< 1/(T1 T2)
  S e1;   ///< (T1 + T2)/(T1 T2)
  S nb0;  ///< Kb/(T1 T2)
  S nb1;  ///< Kb T3b/(T1 T2)
  S nw0;  ///< Kw/(T1 T2)
  S nw1;  ///< Kw T3w/(T1 T2)
};

/// Transfer functions of the coupled equations.
template <class S>
SwayYawTransfer<S> transfer_functions(const SwayYawCoefficients<S>& m) {
  return {
      .e0 = determinant(m),
      .e1 = -trace(m),
      .nb0 = m.b1 * m.c2 - m.b2 * m.c1,
      .nb1 = m.c1,
      .nw0 = m.a2 * m.c1 - m.a1 * m.c2,
      .nw1 = m.c2,
  };
}

/// nb0 nw1 − nb1 nw0: minus the determinant of the controllability matrix [c  A c].
/// Zero when the rudder excites one mode only, or when no coupled equations have these transfer functions.
template <class S>
S controllability(const SwayYawTransfer<S>& h) {
  return h.nb0 * h.nw1 - h.nb1 * h.nw0;
}

/// Coupled equations with given transfer functions, the inverse of `transfer_functions`.
/// Valid for controllability(h) ≠ 0; infinite or not a number otherwise.
template <class S>
SwayYawCoefficients<S> coefficients_from(const SwayYawTransfer<S>& h) {
  const S over_D = 1.0 / controllability(h);
  return {
      .a1 = -(h.nb1 * h.nw1 * h.e0 + h.nw0 * (h.nb0 - h.nb1 * h.e1)) * over_D,
      .b1 = (h.nb0 * (h.nb0 - h.nb1 * h.e1) + h.nb1 * h.nb1 * h.e0) * over_D,
      .c1 = h.nb1,
      .a2 = -(h.nw0 * (h.nw0 - h.nw1 * h.e1) + h.nw1 * h.nw1 * h.e0) * over_D,
      .b2 = (h.nw1 * h.nb1 * h.e0 + h.nb0 * (h.nw0 - h.nw1 * h.e1)) * over_D,
      .c2 = h.nw1,
  };
}

}  // namespace swayaw::linear
