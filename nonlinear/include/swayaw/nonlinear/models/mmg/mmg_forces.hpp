#pragma once

#include <array>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"
#include "swayaw/nonlinear/models/parts/rudder_lift_loss.hpp"

/// Forces of the MMG standard model, written once for double, dual and pack.
/// Valid for way ahead, u > 0, and a shaft that turns ahead, or a given thrust (validity.hpp). Source: [Yasukawa2015]
namespace swayaw::inline nonlinear {

/// Drift angles as propeller and rudder see them.
template <class S>
struct MmgDrift {
  S propeller;  ///< beta_P = beta − x_P' r'
  S rudder;     ///< beta_R = beta − l_R' r'
};

template <class S>
MmgDrift<S> local_drift(const MmgShip<S>& ship, const PlanarMotion<S>& motion) {
  const S beta = drift_angle(motion);
  const S r_prime = motion.r * ship.particulars.L / speed(motion);
  return {beta - ship.propeller.x_P * r_prime, beta - ship.rudder.l_R * r_prime};
}

/// Names of the branches.
struct MmgBranch {
  static constexpr std::size_t propeller = 0, rudder = 1, torque = 2;
};

/// Axial speed at the propeller with the wake change of a turning ship [m/s].
///
///     u_P = u (1 − w_P0) (1 + (1 − exp(−C_1 |beta_P|)) (C_2 − 1)),   C_2 by the sign of beta_P
///
/// Source: [Yasukawa2015] eqs (13)–(16)
template <class S>
S propeller_inflow(const MmgPropeller<S>& p, const S& u, const S& beta_P, const Mask<S>& from_starboard) {
  const S C_2 = select(from_starboard, p.C_2_positive, p.C_2_negative);
  const S size = select(from_starboard, beta_P, S(-beta_P));  // |beta_P|
  return u * (1.0 - p.w_P0) * (1.0 + (1.0 - decay(S(p.C_1 * size))) * (C_2 - 1.0));
}

/// Propeller torque Q = ρ n² D⁵ K_Q(J) = ρ D³ (q_0 n²D² + q_1 nD u_P + q_2 u_P²) [N m].
template <class S>
S torque(const MmgShip<S>& ship, const S& rev, const S& u_P) {
  const auto& p = ship.propeller;
  const S nD = rev * p.D;
  return ship.water.rho * p.D * p.D * p.D * (nD * (p.q_0 * nD + p.q_1 * u_P) + p.q_2 * u_P * u_P);
}

/// Shaft speed at which the propeller takes all the torque that the engine gives, Q = Q_max [1/s].
template <class S>
S rev_at_full_torque(const MmgShip<S>& ship, const S& u_P) {
  const auto& p = ship.propeller;
  const S half = 0.5 * p.q_1 * u_P;
  const S constant = p.q_2 * u_P * u_P - ship.engine.Q_max / (ship.water.rho * p.D * p.D * p.D);
  // q_0 (nD)² + q_1 u_P nD + constant = 0, the larger root
  return (-half + root_of_positive(half * half - p.q_0 * constant)) / (p.q_0 * p.D);
}

/// beta_P selects C_2, beta_R selects gamma_R, and the torque of the ordered shaft speed what the engine can do.
template <class S>
std::array<S, 3> branch_functions(const MmgShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls) {
  const auto [beta_P, beta_R] = local_drift(ship, motion);
  if (!ship.engine.torque_limited() || controls.by_thrust) return {beta_P, beta_R, S(1.0)};
  const S u_P = propeller_inflow(ship.propeller, motion.u, beta_P, beta_P > S(0.0));
  return {beta_P, beta_R, 1.0 - torque(ship, controls.rev, u_P) / ship.engine.Q_max};
}

/// Forces split by part, about midship.
template <class S>
struct MmgForces {
  PlanarForce<S> hull;
  PlanarForce<S> propeller;
  PlanarForce<S> rudder;

  PlanarForce<S> total() const { return hull + propeller + rudder; }

  std::array<ForcePart<S>, 3> parts() const { return {{{"hull", hull}, {"propeller", propeller}, {"rudder", rudder}}}; }
};

/// Resistance and hydrodynamic derivatives on v' = v/U and r' = rL/U.
///
///     X_H = ½ρLdU² (−R_0' + X_vv' v'² + X_vr' v'r' + X_rr' r'² + X_vvvv' v'⁴)
///     Y_H = ½ρLdU² (Y_v' v' + Y_r' r' + Y_vvv' v'³ + Y_vvr' v'²r' + Y_vrr' v'r'² + Y_rrr' r'³)
///     N_H = ½ρL²dU² (N_v' v' + …), alike
///
/// Source: [Yasukawa2015] eqs (7), (8)
template <class S>
PlanarForce<S> hull_force(const MmgShip<S>& ship, const PlanarMotion<S>& motion) {
  const auto& [L, B, d, nabla, x_G, k_zz, U_0, A_front, A_lateral] = ship.particulars;
  const auto& h = ship.hull;
  const S U = speed(motion);
  const S v = motion.v / U;      // v'
  const S r = motion.r * L / U;  // r'
  const S vv = v * v, vr = v * r, rr = r * r;
  const S q = 0.5 * ship.water.rho * L * d * U * U;
  return {
      .X = q * (h.X_vv * vv + h.X_vr * vr + h.X_rr * rr + h.X_vvvv * vv * vv - h.R_0),
      .Y = q * (v * (h.Y_v + h.Y_vvv * vv + h.Y_vvr * vr + h.Y_vrr * rr) + r * (h.Y_r + h.Y_rrr * rr)),
      .N = q * L * (v * (h.N_v + h.N_vvv * vv + h.N_vvr * vr + h.N_vrr * rr) + r * (h.N_r + h.N_rrr * rr)),
  };
}

/// Water that reaches propeller and rudder.
template <class S>
struct PropellerFlow {
  S u_P;     ///< u (1 − w_P) [m/s]
  S thrust;  ///< T [N]
};

/// Thrust at the ordered shaft speed, or at what the engine can turn of it; or the measured thrust.
///
///     T = ρ n² D⁴ K_T(J) = ρ D² (k_0 n² D² + k_1 n D u_P + k_2 u_P²),   J = u_P/(nD)
///
/// Source: [Yasukawa2015] eqs (10)–(12)
template <class S>
PropellerFlow<S> propeller_flow(const MmgShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls,
                                const S& beta_P, const Branch<S, 3>& branch) {
  const auto& p = ship.propeller;
  const S u_P = propeller_inflow(p, motion.u, beta_P, branch[MmgBranch::propeller]);
  if (controls.by_thrust) return {.u_P = u_P, .thrust = controls.thrust.port + controls.thrust.starboard};
  S rev = controls.rev;
  if (ship.engine.torque_limited()) rev = select(branch[MmgBranch::torque], rev, rev_at_full_torque(ship, u_P));
  const S nD = rev * p.D;
  return {.u_P = u_P, .thrust = ship.water.rho * p.D * p.D * (nD * (p.k_0 * nD + p.k_1 * u_P) + p.k_2 * u_P * u_P)};
}

/// X_P = (1 − t_P) T.
template <class S>
PlanarForce<S> propeller_force(const MmgPropeller<S>& propeller, const S& thrust) {
  return {.X = (1.0 - propeller.t_P) * thrust, .Y = S(0.0), .N = S(0.0)};
}

/// Force of the rudder in the race, and of the hull near it.
///
///     u_R = ε sqrt(η (u_P + κ (sqrt(u_P² + 8T/(πρD²)) − u_P))² + (1 − η) u_P²),   η = D/H_R
///     v_R = U gamma_R beta_R
///     F_N = ½ρ A_R f_alpha U_R² sin(alpha_R),   alpha_R = delta − atan(v_R/u_R)
///         = ½ρ A_R f_alpha U_R (u_R sin(delta) − v_R cos(delta))
///     X_R = −(1 − t_R) F_N sin(delta)
///     Y_R = −(1 + a_H) F_N cos(delta)
///     N_R = −(x_R + a_H x_H) F_N cos(delta)
///
/// Where the rudder stalls, or has a gap above it, F_N is multiplied by stall_factor(alpha_R) and
/// open_gap_factor(delta). Here delta is positive to starboard, as in the source; the argument is positive to port.
/// Source: [Yasukawa2015] eqs (17)–(24)
template <class S>
PlanarForce<S> rudder_force(const MmgShip<S>& ship, const PlanarMotion<S>& motion, const S& delta_to_port,
                            const S& beta_R, const PropellerFlow<S>& flow, const Mask<S>& from_starboard) {
  const auto& k = ship.rudder;
  const S& D = ship.propeller.D;
  const S u_P = flow.u_P;
  // axial speed far behind the propeller, from the momentum theorem
  const S u_race = root_of_positive(u_P * u_P + (8.0 / pi) * flow.thrust / (ship.water.rho * D * D));
  const S u_behind = u_P + k.kappa * (u_race - u_P);
  const S eta = D / k.H_R;
  const S u_R = k.epsilon * sqrt(eta * u_behind * u_behind + (1.0 - eta) * u_P * u_P);
  const S v_R = speed(motion) * select(from_starboard, k.gamma_R_positive, k.gamma_R_negative) * beta_R;
  const auto [sin_to_port, cos_delta] = sin_cos(delta_to_port);
  const S sin_delta = -sin_to_port;
  const S U_R = sqrt(u_R * u_R + v_R * v_R);
  S F_N = 0.5 * ship.water.rho * k.A_R * k.f_alpha * U_R * (u_R * sin_delta - v_R * cos_delta);
  if (any(k.alpha_s > S(0.0))) F_N = F_N * stall_factor(k.stall(), S(-delta_to_port - angle_of(v_R, u_R)));
  if (any(k.s < S(0.0))) F_N = F_N * open_gap_factor(k.delta_lim, k.s, delta_to_port);
  const S lever = ship.particulars.L * (k.x_R + k.a_H * k.x_H);
  return {.X = -(1.0 - k.t_R) * F_N * sin_delta, .Y = -(1.0 + k.a_H) * F_N * cos_delta, .N = -lever * F_N * cos_delta};
}

/// All forces, on a given branch.
template <class S>
MmgForces<S> forces(const MmgShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls,
                    const Branch<S, 3>& branch) {
  const auto [beta_P, beta_R] = local_drift(ship, motion);
  const auto flow = propeller_flow(ship, motion, controls, beta_P, branch);
  return {
      .hull = hull_force(ship, motion),
      .propeller = propeller_force(ship.propeller, flow.thrust),
      .rudder = rudder_force(ship, motion, controls.delta, beta_R, flow, branch[MmgBranch::rudder]),
  };
}

/// Propeller thrust T [N].
template <class S>
S thrust(const MmgShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls) {
  return propeller_flow(ship, motion, controls, local_drift(ship, motion).propeller, branch_at(ship, motion, controls))
      .thrust;
}

/// m = ρ∇, I_z = m (k_zz² + x_G²).
inline RigidBody rigid_body(const MmgShip<double>& ship) {
  const auto& p = ship.particulars;
  const double m = ship.water.rho * p.nabla;
  return {.m = m, .x_G = p.x_G, .I_z = m * (p.k_zz * p.k_zz + p.x_G * p.x_G)};
}

/// Acceleration that a force gives to ship and entrained water.
///
///     (m + m_x) du/dt − (m + m_y) v r − m x_G r² = X
///     (m + m_y) dv/dt + (m + m_x) u r + m x_G dr/dt = Y
///     (I_zG + m x_G² + J_z) dr/dt + m x_G (dv/dt + u r) = N
///
/// With `surge_coupling = "m"` the term (m + m_y) v r of the first equation is m v r, for derivatives X_vr' that hold
/// m_y.
///
/// Source: [Yasukawa2015] eq (4)
template <class S>
PlanarAcceleration<S> acceleration(const MmgShip<S>& ship, const PlanarMotion<S>& motion, const PlanarForce<S>& force) {
  const auto& [L, B, d, nabla, x_G, k_zz, U_0, A_front, A_lateral] = ship.particulars;
  const auto& [u, v, r] = motion;
  const S m = ship.water.rho * nabla;
  const S added = 0.5 * ship.water.rho * L * L * d;  // unit of added mass
  const S mass_x = m + added * ship.added_mass.m_x;
  const S mass_y = m + added * ship.added_mass.m_y;
  const S coupling = m * x_G;
  const S inertia = m * (k_zz * k_zz + x_G * x_G) + added * L * L * ship.added_mass.J_z;
  const S mass_vr = ship.added_mass.surge_coupling.index == 0 ? mass_y : m;
  const S Y = force.Y - mass_x * u * r;
  const S N = force.N - coupling * u * r;
  const S over_det = 1.0 / (mass_y * inertia - coupling * coupling);
  return {
      .u = (force.X + mass_vr * v * r + coupling * r * r) / mass_x,
      .v = (inertia * Y - coupling * N) * over_det,
      .r = (mass_y * N - coupling * Y) * over_det,
  };
}

}  // namespace swayaw::nonlinear
