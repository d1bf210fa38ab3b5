#pragma once

#include "swayaw/linear/sway_yaw.hpp"

namespace swayaw::inline linear {

/// Linear derivatives in the SNAME form, all primed in one system (½ρL³ for mass, ½ρL²U² for force, or their L²T
/// twins):
///
///     (m' − Y_vdot) dv'/ds' + (m' x_G − Y_rdot) dr'/ds' = Y_v v' + (Y_r − m') r' + Y_delta delta
///     (m' x_G − N_vdot) dv'/ds' + (I_z − N_rdot) dr'/ds' = N_v v' + (N_r − m' x_G) r' + N_delta delta
///
/// about midship, delta positive to port. v' = v/U = −beta, r' = omega'.
template <class S = double>
struct SnameDerivatives {
  S m;                  ///< mass
  S x_G;                ///< centre of gravity forward of midship over length
  S I_z;                ///< moment of inertia about midship
  S Y_vdot, Y_rdot;     ///< added masses, sway
  S N_vdot, N_rdot;     ///< added masses, yaw
  S Y_v, Y_r, Y_delta;  ///< sway
  S N_v, N_r, N_delta;  ///< yaw
};

/// The sign of a rudder angle that turns the ship to port.
enum class RudderConvention { positive_to_port, positive_to_starboard };

/// Coefficients of the coupled equations, A = M⁻¹F with the signs of v' = −beta.
template <class S>
SwayYawCoefficients<S> coefficients(const SnameDerivatives<S>& d,
                                    RudderConvention rudder = RudderConvention::positive_to_port) {
  const S m11 = d.m - d.Y_vdot, m12 = d.m * d.x_G - d.Y_rdot;
  const S m21 = d.m * d.x_G - d.N_vdot, m22 = d.I_z - d.N_rdot;
  const S f12 = d.Y_r - d.m, f22 = d.N_r - d.m * d.x_G;
  const S over = 1.0 / (m11 * m22 - m12 * m21);
  const double sign = rudder == RudderConvention::positive_to_port ? 1.0 : -1.0;
  const auto v = [&](const S& Y, const S& N) { return (m22 * Y - m12 * N) * over; };
  const auto r = [&](const S& Y, const S& N) { return (m11 * N - m21 * Y) * over; };
  return {
      .a1 = v(d.Y_v, d.N_v),
      .b1 = -v(f12, f22),
      .c1 = -v(d.Y_delta, d.N_delta) * sign,
      .a2 = -r(d.Y_v, d.N_v),
      .b2 = r(f12, f22),
      .c2 = r(d.Y_delta, d.N_delta) * sign,
  };
}

/// The derivatives Y_v … N_delta that give the coefficients, with mass, inertia and added masses as in `inertia`; F = M
/// A.
template <class S>
SnameDerivatives<S> sname_derivatives(const SwayYawCoefficients<S>& c, SnameDerivatives<S> inertia,
                                      RudderConvention rudder = RudderConvention::positive_to_port) {
  auto& d = inertia;
  const S m11 = d.m - d.Y_vdot, m12 = d.m * d.x_G - d.Y_rdot;
  const S m21 = d.m * d.x_G - d.N_vdot, m22 = d.I_z - d.N_rdot;
  const double sign = rudder == RudderConvention::positive_to_port ? 1.0 : -1.0;
  d.Y_v = m11 * c.a1 - m12 * c.a2;
  d.N_v = m21 * c.a1 - m22 * c.a2;
  d.Y_r = m12 * c.b2 - m11 * c.b1 + d.m;
  d.N_r = m22 * c.b2 - m21 * c.b1 + d.m * d.x_G;
  d.Y_delta = (m12 * c.c2 - m11 * c.c1) * sign;
  d.N_delta = (m22 * c.c2 - m21 * c.c1) * sign;
  return inertia;
}

}  // namespace swayaw::linear
