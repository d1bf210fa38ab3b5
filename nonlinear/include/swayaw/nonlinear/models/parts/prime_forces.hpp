#pragma once

#include <concepts>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/models/parts/prime_parts.hpp"

/// Hull, propellers and equations of motion that the physics-informed and the physics-uninformed model share.
/// Valid for way ahead, u > 0, and a shaft that turns ahead, or a given thrust (validity.hpp). Source:
/// [Alexandersson2024]
namespace swayaw::inline nonlinear {

/// A ship made of the parts of prime_parts.hpp and a rudder.
template <class Ship>
concept PrimeShip = requires(const Ship& ship) {
  { ship.particulars } -> std::same_as<const PrimeParticulars<typename Ship::Scalar>&>;
  { ship.hull } -> std::same_as<const PrimeHull<typename Ship::Scalar>&>;
  { ship.propeller } -> std::same_as<const PrimePropeller<typename Ship::Scalar>&>;
};

/// Acceleration of gravity of the published calculations [m/s^2].
inline constexpr double prime_gravity = 9.81;

/// Motion in the prime system.
template <class S>
struct PrimeMotion {
  S q;        ///< ½ρL²U² [N]
  S u, v, r;  ///< u' = (u − U_0)/U with U_0 = Fn_0 sqrt(gL), v' = v/U, r' = rL/U
};

/// Source: [Alexandersson2024] table 1, eqs (36), (37)
template <PrimeShip Ship>
PrimeMotion<typename Ship::Scalar> prime_motion(const Ship& ship, const PlanarMotion<typename Ship::Scalar>& m) {
  using S = typename Ship::Scalar;
  const auto& p = ship.particulars;
  const S UU = m.u * m.u + m.v * m.v;
  const S over_U = 1.0 / sqrt(UU);
  return {
      .q = 0.5 * ship.water.rho * p.L * p.L * UU,
      .u = (m.u - p.Fn_0 * sqrt(prime_gravity * p.L)) * over_U,
      .v = m.v * over_U,
      .r = m.r * p.L * over_U,
  };
}

/// Resistance and hydrodynamic derivatives.
///
///     X_H = ½ρL²U² (X_0' + X_u' u' + X_vv' v'² + X_vr' v'r' + X_rr' r'²)
///     Y_H = ½ρL²U² (Y_0' + Y_v' v' + Y_r' r' + Y_vvv' v'³ + Y_vvr' v'²r' + Y_vrr' v'r'² + Y_rrr' r'³)
///     N_H = ½ρL³U² (N_0' + N_v' v' + …), alike
///
/// Source: [Alexandersson2024] eqs (A.1)–(A.3)
template <class S>
PlanarForce<S> hull_force(const PrimeHull<S>& h, const S& L, const PrimeMotion<S>& m) {
  const S vv = m.v * m.v, vr = m.v * m.r, rr = m.r * m.r;
  const S Y = h.Y_0 + m.v * (h.Y_v + h.Y_vvv * vv + h.Y_vvr * vr + h.Y_vrr * rr) + m.r * (h.Y_r + h.Y_rrr * rr);
  const S N = h.N_0 + m.v * (h.N_v + h.N_vvv * vv + h.N_vvr * vr + h.N_vrr * rr) + m.r * (h.N_r + h.N_rrr * rr);
  return {.X = m.q * (h.X_0 + h.X_u * m.u + h.X_vv * vv + h.X_vr * vr + h.X_rr * rr), .Y = m.q * Y, .N = m.q * L * N};
}

template <PrimeShip Ship>
PlanarForce<typename Ship::Scalar> hull_force(const Ship& ship, const PlanarMotion<typename Ship::Scalar>& motion) {
  return hull_force(ship.hull, ship.particulars.L, prime_motion(ship, motion));
}

// -------------------------------------------------------------- propellers

/// beta_P = beta − x_P' r', whose sign selects C_2; 1 where the wake is constant.
template <PrimeShip Ship>
typename Ship::Scalar wake_branch_function(const Ship& ship, const PlanarMotion<typename Ship::Scalar>& m) {
  using S = typename Ship::Scalar;
  if (!ship.propeller.wake_changes()) return S(1.0);
  return drift_angle(m) - ship.propeller.x_P * m.r / speed(m);
}

/// Axial speed of the water at the propellers [m/s].
///
///     V_A = u (1 − w_f),   and with `wake = "mmg"` times   1 + (1 − exp(−C_1 |beta_P|)) (C_2 − 1)
///
/// Source: [Alexandersson2024] eq (B.14); [Yasukawa2015] eqs (13)–(16)
template <PrimeShip Ship>
typename Ship::Scalar propeller_inflow(const Ship& ship, const PlanarMotion<typename Ship::Scalar>& m,
                                       const Mask<typename Ship::Scalar>& beta_P_positive) {
  using S = typename Ship::Scalar;
  const auto& p = ship.propeller;
  const S V_A = m.u * (1.0 - p.w_f);
  if (!p.wake_changes()) return V_A;
  const S beta_P = wake_branch_function(ship, m);
  const S C_2 = select(beta_P_positive, p.C_2_positive, p.C_2_negative);
  const S size = select(beta_P_positive, beta_P, S(-beta_P));  // |beta_P|
  return V_A * (1.0 + (1.0 - exp(-p.C_1 * size)) * (C_2 - 1.0));
}

/// Thrust of each propeller [N]: measured, or of the open-water curve at the shaft speed, where there is one.
/// A single propeller is the port one.
///
///     T = ρ n² D⁴ K_T(J) = ρ D² (k_0 n²D² + k_1 nD V_A + k_2 V_A²),   J = V_A/(nD)
template <PrimeShip Ship>
Sides<typename Ship::Scalar> propeller_thrust(const Ship& ship, const Controls<typename Ship::Scalar>& controls,
                                              const typename Ship::Scalar& V_A) {
  using S = typename Ship::Scalar;
  const auto& p = ship.propeller;
  if (controls.by_thrust) {
    if (p.twin()) return controls.thrust;
    return {controls.thrust.port + controls.thrust.starboard, S(0.0)};
  }
  const S nD = controls.rev * p.D;
  const S T = ship.water.rho * p.D * p.D * (nD * (p.k_0 * nD + p.k_1 * V_A) + p.k_2 * V_A * V_A);
  return {T, p.twin() ? T : S(0.0)};
}

/// X_P = (1 − t) T,  N_P = −X_P y_P, of all propellers. Source: [Alexandersson2024] eqs (7)–(11)
template <class S>
PlanarForce<S> propeller_force(const PrimePropeller<S>& p, const Sides<S>& thrust) {
  const S port = (1.0 - p.t_P) * thrust.port, starboard = (1.0 - p.t_P) * thrust.starboard;
  return {.X = port + starboard, .Y = S(0.0), .N = -(port * p.y_P_port + starboard * p.y_P_starboard)};
}

/// Thrust of all propellers [N].
template <PrimeShip Ship>
typename Ship::Scalar thrust(const Ship& ship, const PlanarMotion<typename Ship::Scalar>& motion,
                             const Controls<typename Ship::Scalar>& controls) {
  using S = typename Ship::Scalar;
  const auto T =
      propeller_thrust(ship, controls, propeller_inflow(ship, motion, wake_branch_function(ship, motion) > S(0.0)));
  return T.port + T.starboard;
}

// -------------------------------------------------------------- equations of motion

/// Yaw inertia about midship [kg m^2], given or m (k_zz² + x_G²).
template <PrimeShip Ship>
typename Ship::Scalar yaw_inertia(const Ship& ship) {
  using S = typename Ship::Scalar;
  const auto& p = ship.particulars;
  return select(p.I_z > S(0.0), p.I_z, S(ship.water.rho * p.nabla * (p.k_zz * p.k_zz + p.x_G * p.x_G)));
}

/// Mass of the ship herself.
template <PrimeShip Ship>
RigidBody rigid_body(const Ship& ship) {
  return {.m = ship.water.rho * ship.particulars.nabla, .x_G = ship.particulars.x_G, .I_z = yaw_inertia(ship)};
}

/// Acceleration that a force gives to ship and entrained water.
///
///     m (du/dt − v r − x_G r²)       = X + X_udot du/dt
///     m (dv/dt + u r + x_G dr/dt)    = Y + Y_vdot dv/dt + Y_rdot dr/dt
///     I_z dr/dt + m x_G (dv/dt + u r) = N + N_vdot dv/dt + N_rdot dr/dt
///
/// Source: [Alexandersson2024] eqs (1)–(3)
template <PrimeShip Ship>
PlanarAcceleration<typename Ship::Scalar> acceleration(const Ship& ship,
                                                       const PlanarMotion<typename Ship::Scalar>& motion,
                                                       const PlanarForce<typename Ship::Scalar>& force) {
  using S = typename Ship::Scalar;
  const auto& a = ship.added_mass;
  const auto& [u, v, r] = motion;
  const S& L = ship.particulars.L;
  const S m = ship.water.rho * ship.particulars.nabla;
  const S coupling = m * ship.particulars.x_G;
  const S unit = 0.5 * ship.water.rho * L * L * L;  // of mass
  // [M_vv M_vr; M_rv M_rr] [dv/dt; dr/dt] = [Y − m u r; N − m x_G u r]
  const S M_vv = m - unit * a.Y_vdot, M_vr = coupling - unit * L * a.Y_rdot;
  const S M_rv = coupling - unit * L * a.N_vdot, M_rr = yaw_inertia(ship) - unit * L * L * a.N_rdot;
  const S Y = force.Y - m * u * r;
  const S N = force.N - coupling * u * r;
  const S over_det = 1.0 / (M_vv * M_rr - M_vr * M_rv);
  return {
      .u = (force.X + m * v * r + coupling * r * r) / (m - unit * a.X_udot),
      .v = (M_rr * Y - M_vr * N) * over_det,
      .r = (M_vv * N - M_rv * Y) * over_det,
  };
}

}  // namespace swayaw::nonlinear
