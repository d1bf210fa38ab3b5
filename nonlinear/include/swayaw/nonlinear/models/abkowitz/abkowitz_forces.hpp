#pragma once

#include <array>
#include <limits>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/abkowitz/abkowitz_ship.hpp"
#include "swayaw/nonlinear/models/branch.hpp"

/// Forces of Abkowitz's polynomial, written once for double, dual and pack.
/// Valid near the speed U_0 and within the drift, yaw rate and rudder angles the coefficients were found for; the
/// propeller runs as it does straight ahead at U_0, whatever the controls say. Not for u ≤ 0 (validity.hpp). Source:
/// [Abkowitz1964], [Chislett1965]
namespace swayaw::inline nonlinear {

/// The polynomial has one piece.
template <class S>
std::array<S, 0> branch_functions(const AbkowitzShip<S>&, const PlanarMotion<S>&, const Controls<S>&) {
  return {};
}

/// Forces split by part, about midship. What the propeller does is part of the hull's.
template <class S>
struct AbkowitzForces {
  PlanarForce<S> hull;
  PlanarForce<S> rudder;

  PlanarForce<S> total() const { return hull + rudder; }

  std::array<ForcePart<S>, 2> parts() const { return {{{"hull", hull}, {"rudder", rudder}}}; }
};

/// The motion in primes, and the unit of force.
template <class S>
struct AbkowitzPrimes {
  S u;     ///< (u − U_0)/V
  S v;     ///< v/V
  S r;     ///< rL/V
  S unit;  ///< ½ρL²V² [N]
};

template <class S>
AbkowitzPrimes<S> primes_of(const AbkowitzShip<S>& ship, const PlanarMotion<S>& motion) {
  const auto& p = ship.particulars;
  const S V = p.primes_at_nominal_speed() ? p.U_0 : speed(motion);
  return {.u = (motion.u - p.U_0) / V,
          .v = motion.v / V,
          .r = motion.r * p.L / V,
          .unit = 0.5 * ship.water.rho * p.L * p.L * V * V};
}

/// Force on the mass of the ship that turns her velocity, counted as what the water must give:
///
///     X = −m v r − m x_G r²,   Y = m u r,   N = m x_G u r
template <class S>
PlanarForce<S> centripetal_force(const AbkowitzShip<S>& ship, const PlanarMotion<S>& motion) {
  const auto& [u, v, r] = motion;
  const S& L = ship.particulars.L;
  const S m = 0.5 * ship.water.rho * L * L * L * ship.inertia.m;
  const S coupling = m * L * ship.inertia.x_G;  // m x_G
  return {.X = -m * v * r - coupling * r * r, .Y = m * u * r, .N = coupling * u * r};
}

/// Terms without the rudder, in primes of u − U_0, v, r:
///
///     X_H = ½ρL²V² (X_u u + X_uu u² + X_uuu u³ + X_vv v² + X_vr v r + X_rr r² + u (X_vvu v² + X_vru v r + X_rru r²))
///     Y_H = ½ρL²V² (Y_0 + Y_0u u + Y_0uu u² + (Y_v + Y_vu u + Y_vuu u²) v + (Y_r + Y_ru u + Y_ruu u²) r
///                   + Y_vvv v³ + Y_vvr v² r + Y_vrr v r² + Y_rrr r³)
///     N_H = ½ρL³V² (N_0 + …), alike
///
/// Where the derivatives hold the centrifugal force of the ship, it is taken out: what is returned is the force of the
/// water.
template <class S>
PlanarForce<S> hull_force(const AbkowitzShip<S>& ship, const PlanarMotion<S>& motion) {
  const auto& h = ship.hull;
  const auto [u, v, r, unit] = primes_of(ship, motion);
  const S vv = v * v, vr = v * r, rr = r * r;
  const PlanarForce<S> force{
      .X = unit * (u * (h.X_u + u * (h.X_uu + u * h.X_uuu)) + vv * (h.X_vv + h.X_vvu * u) +
                   vr * (h.X_vr + h.X_vru * u) + rr * (h.X_rr + h.X_rru * u)),
      .Y = unit * (h.Y_0 + u * (h.Y_0u + u * h.Y_0uu) +
                   v * (h.Y_v + u * (h.Y_vu + u * h.Y_vuu) + h.Y_vvv * vv + h.Y_vvr * vr + h.Y_vrr * rr) +
                   r * (h.Y_r + u * (h.Y_ru + u * h.Y_ruu) + h.Y_rrr * rr)),
      .N = unit * ship.particulars.L *
           (h.N_0 + u * (h.N_0u + u * h.N_0uu) +
            v * (h.N_v + u * (h.N_vu + u * h.N_vuu) + h.N_vvv * vv + h.N_vvr * vr + h.N_vrr * rr) +
            r * (h.N_r + u * (h.N_ru + u * h.N_ruu) + h.N_rrr * rr)),
  };
  return ship.inertia.centripetal_in_derivatives() ? force + centripetal_force(ship, motion) : force;
}

/// Terms with the rudder angle d, positive to port, in primes of u − U_0, v, r:
///
///     X_R = ½ρL²V² ((X_dd + X_udd u) d² + ((X_vd + X_uvd u) v + (X_rd + X_urd u) r) d)
///     Y_R = ½ρL²V² ((Y_d + Y_ud u + Y_uud u² + Y_vvd v² + Y_vrd v r + Y_rrd r²) d + (Y_vdd v + Y_rdd r) d² + Y_ddd d³)
///     N_R = ½ρL³V² ((N_d + …) d + …), alike
template <class S>
PlanarForce<S> rudder_force(const AbkowitzShip<S>& ship, const PlanarMotion<S>& motion, const S& delta) {
  const auto& k = ship.rudder;
  const auto [u, v, r, unit] = primes_of(ship, motion);
  const S vv = v * v, vr = v * r, rr = r * r, dd = delta * delta;
  return {
      .X = unit * delta * (delta * (k.X_dd + k.X_udd * u) + v * (k.X_vd + k.X_uvd * u) + r * (k.X_rd + k.X_urd * u)),
      .Y = unit * delta *
           (k.Y_d + u * (k.Y_ud + u * k.Y_uud) + k.Y_vvd * vv + k.Y_vrd * vr + k.Y_rrd * rr +
            delta * (k.Y_vdd * v + k.Y_rdd * r) + k.Y_ddd * dd),
      .N = unit * ship.particulars.L * delta *
           (k.N_d + u * (k.N_ud + u * k.N_uud) + k.N_vvd * vv + k.N_vrd * vr + k.N_rrd * rr +
            delta * (k.N_vdd * v + k.N_rdd * r) + k.N_ddd * dd),
  };
}

/// All forces; there is but one branch.
template <class S>
AbkowitzForces<S> forces(const AbkowitzShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls,
                         const Branch<S, 0>&) {
  return {.hull = hull_force(ship, motion), .rudder = rudder_force(ship, motion, controls.delta)};
}

/// Not a number: the polynomial does not tell thrust from resistance.
template <class S>
S thrust(const AbkowitzShip<S>&, const PlanarMotion<S>&, const Controls<S>&) {
  return S(std::numeric_limits<double>::quiet_NaN());
}

/// m = m' ½ρL³, I_z = I_z' ½ρL⁵.
inline RigidBody rigid_body(const AbkowitzShip<double>& ship) {
  const double L = ship.particulars.L, mass = 0.5 * ship.water.rho * L * L * L;
  return {.m = mass * ship.inertia.m, .x_G = ship.inertia.x_G * L, .I_z = mass * L * L * ship.inertia.I_z};
}

/// Acceleration that a force gives to ship and entrained water.
///
///     (m − X_udot) du/dt − m v r − m x_G r² = X
///     (m − Y_vdot) dv/dt + (m x_G − Y_rdot) dr/dt + m u r = Y
///     (m x_G − N_vdot) dv/dt + (I_z − N_rdot) dr/dt + m x_G u r = N
///
/// Source: [Abkowitz1964]
template <class S>
PlanarAcceleration<S> acceleration(const AbkowitzShip<S>& ship, const PlanarMotion<S>& motion,
                                   const PlanarForce<S>& force) {
  const auto& i = ship.inertia;
  const S& L = ship.particulars.L;
  const S mass = 0.5 * ship.water.rho * L * L * L;  // unit of mass
  const auto turning = centripetal_force(ship, motion);
  const S X = (force.X - turning.X) / mass;
  const S Y = (force.Y - turning.Y) / mass;
  const S N = (force.N - turning.N) / (mass * L);
  const S m_vv = i.m - i.Y_vdot, m_vr = i.m * i.x_G - i.Y_rdot;
  const S m_rv = i.m * i.x_G - i.N_vdot, m_rr = i.I_z - i.N_rdot;
  const S over_det = 1.0 / (m_vv * m_rr - m_vr * m_rv);
  return {
      .u = X / (i.m - i.X_udot),
      .v = (m_rr * Y - m_vr * N) * over_det,
      .r = (m_vv * N - m_rv * Y) * over_det / L,
  };
}

}  // namespace swayaw::nonlinear
