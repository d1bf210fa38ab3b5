#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/force_effects.hpp"
#include "swayaw/nonlinear/instrument_effects.hpp"
#include "swayaw/nonlinear/models.hpp"
#include "swayaw/nonlinear/surroundings.hpp"

/// Forces of effects that a model has no place for, written once for double and dual. docs/effects.md tells sources.
namespace swayaw {

/// What goes on out of sight, or the rates of it: heel and its rate, and the motion that the damping remembers.
template <class S = double>
struct Hidden {
  S phi{};  ///< heel, starboard side down [rad]
  S p{};    ///< d(phi)/dt [rad/s]
  S v{};    ///< lagged sway [m/s]
  S r{};    ///< lagged yaw rate [rad/s]
};

/// The numbers of added forces, with those of the ship that they need. A force that is not there is not computed.
template <class S = double>
struct AddedForces {
  bool cross_flow = false, waves = false, side_force = false, roll = false, memory = false, droop = false;
  bool mapped = false;  ///< whether the unknown force acts now
  S rho{}, L{}, d{};
  S U_0{1.0};  ///< service speed [m/s]
  S x_P{};     ///< propeller forward of midship [m]
  S k_xx{};    ///< radius of gyration in roll [m]
  CrossFlowDrag<S> drag;
  WaveDrift<S> wave;
  PropellerSideForce<S> side;
  RollCoupling<S> coupling;  ///< all numbers known
  FluidMemory<S> lag;
  ShaftSpeedDrop<S> drop;
  UnknownForce<S> map;

  bool any() const { return cross_flow || waves || side_force || roll || memory || droop || mapped; }
  bool hidden() const { return roll || memory; }
};

/// The same with another scalar.
template <class To, class From>
AddedForces<To> cast(const AddedForces<From>& a) {
  return {a.cross_flow,
          a.waves,
          a.side_force,
          a.roll,
          a.memory,
          a.droop,
          a.mapped,
          To(a.rho),
          To(a.L),
          To(a.d),
          To(a.U_0),
          To(a.x_P),
          To(a.k_xx),
          cast_effect<To>(a.drag),
          cast_effect<To>(a.wave),
          cast_effect<To>(a.side),
          cast_effect<To>(a.coupling),
          cast_effect<To>(a.lag),
          cast_effect<To>(a.drop),
          cast_effect<To>(a.map)};
}

inline constexpr double effect_gravity = 9.81;  ///< [m/s²]

// ---------------------------------------------------------------- actuator

/// The controls with the shaft speed that an engine keeps when the ship loses speed, n (1 − relative_drop (1 − u/U_0)).
/// A thrust stays as it is.
template <class S>
Controls<S> driven(const AddedForces<S>& added, const PlanarMotion<S>& m, Controls<S> controls) {
  if (!added.droop) return controls;
  controls.rev = controls.rev * (1.0 - added.drop.relative_drop * (1.0 - m.u / added.U_0));
  return controls;
}

// ---------------------------------------------------------------- forces

/// Drag of strips across the flow, in closed form.
///
///     Y = −½ρd C_D ∫ |v + x r| (v + x r) dx,   N = −½ρd C_D ∫ x |v + x r| (v + x r) dx,   −L/2 ≤ x ≤ L/2
///
/// With h = L/2, where |v| ≥ h|r| all strips have one sign: ∫ = ±(2 v² h + ⅔ r² h³) and ±4/3 v r h³.
/// Else ∫ = (2 v³ + 6 v h² r²)/(3 |r|) and sgn(r) (½ h⁴r⁴ + v² h² r² − v⁴/6)/r².
template <class S>
PlanarForce<S> cross_flow_force(const AddedForces<S>& a, const PlanarMotion<S>& m) {
  const S h = 0.5 * a.L, vv = m.v * m.v, tip = h * m.r, tt = tip * tip;
  const auto pivots = tt > vv;  // a strip inside the hull stands still
  const S one = select(m.v < S(0.0), S(-1.0), S(1.0)), side = select(m.r < S(0.0), S(-1.0), S(1.0));
  const S r = select(pivots, S(side * m.r), S(1.0));
  const S Y = select(pivots, S(2.0 * m.v * (vv + 3.0 * tt) / (3.0 * r)), S(one * 2.0 * h * (vv + tt / 3.0)));
  const S N = select(pivots, S(side * (0.5 * tt * tt + vv * tt - vv * vv / 6.0) / (r * r)),
                     S(one * 4.0 / 3.0 * m.v * tip * h * h));
  const S q = -0.5 * a.rho * a.d * a.drag.C_D;
  return {.X = S(0.0), .Y = q * Y, .N = q * N};
}

/// Mean drift of waves that come in at alpha = from − psi, 0 from ahead.
///
///     X = −ahead F cos(alpha),   Y = −F sin(alpha) |sin(alpha)|,   N = moment F L sin(2 alpha)
///
/// Seakeeping tests show both signs of the moment, by ship and wave length.
template <class S>
PlanarForce<S> wave_drift_force(const AddedForces<S>& a, const S& psi) {
  const auto [s, c] = sin_cos(S(a.wave.from - psi));
  const S& F = a.wave.force;
  return {.X = -a.wave.ahead * F * c, .Y = -F * s * size_of(s), .N = 2.0 * a.wave.moment * F * a.L * s * c};
}

/// Y = share T + constant,  N = x_P Y.
template <class S>
PlanarForce<S> side_force(const AddedForces<S>& a, const S& thrust) {
  const S Y = a.side.share * thrust + a.side.constant;
  return {.X = S(0.0), .Y = Y, .N = a.x_P * Y};
}

/// Y = ½ρLdU² Y_phi phi,  N = ½ρL²dU² N_phi phi.
template <class S>
PlanarForce<S> heel_force(const AddedForces<S>& a, const PlanarMotion<S>& m, const S& phi) {
  const S q = 0.5 * a.rho * a.L * a.d * (m.u * m.u + m.v * m.v) * phi;
  return {.X = S(0.0), .Y = q * a.coupling.Y_phi, .N = q * a.L * a.coupling.N_phi};
}

/// Linear damping of the hull by a sway and a yaw rate, at the speed U.
template <class S>
PlanarForce<S> linear_damping(const MmgShip<S>& ship, const S& U, const S& v, const S& r) {
  const auto& [p, h] = std::tie(ship.particulars, ship.hull);
  const S q = 0.5 * ship.water.rho * p.L * p.d * U;
  return {.X = S(0.0), .Y = q * (h.Y_v * v + h.Y_r * r * p.L), .N = q * p.L * (h.N_v * v + h.N_r * r * p.L)};
}

template <PrimeShip Ship>
PlanarForce<typename Ship::Scalar> linear_damping(const Ship& ship, const typename Ship::Scalar& U,
                                                  const typename Ship::Scalar& v, const typename Ship::Scalar& r) {
  using S = typename Ship::Scalar;
  const auto& h = ship.hull;
  const S L = ship.particulars.L, q = 0.5 * ship.water.rho * L * L * U;
  return {.X = S(0.0), .Y = q * (h.Y_v * v + h.Y_r * r * L), .N = q * L * (h.N_v * v + h.N_r * r * L)};
}

template <class S>
PlanarForce<S> linear_damping(const AbkowitzShip<S>& ship, const S& U, const S& v, const S& r) {
  const auto& h = ship.hull;
  const S L = ship.particulars.L,
          q = 0.5 * ship.water.rho * L * L * (ship.particulars.primes_at_nominal_speed() ? ship.particulars.U_0 : U);
  return {.X = S(0.0), .Y = q * (h.Y_v * v + h.Y_r * r * L), .N = q * L * (h.N_v * v + h.N_r * r * L)};
}

/// share (D(v_s, r_s) − D(v, r)) with the linear damping D of the hull.
template <class Model, class S>
PlanarForce<S> memory_force(const Model& ship, const AddedForces<S>& a, const PlanarMotion<S>& m,
                            const Hidden<S>& hidden) {
  const auto f = linear_damping(ship, speed(m), S(hidden.v - m.v), S(hidden.r - m.r));
  return {.X = S(0.0), .Y = a.lag.share * f.Y, .N = a.lag.share * f.N};
}

/// With q = ½ρL²U_0², u' = u/U_0 − 1, v' = v/U_0, r' = rL/U_0:
///
///     X = q (X_0 + X_cos cos ψ + X_sin sin ψ + X_u u' + X_vv v'² + X_vr v'r' + X_rr r'² + X_dd δ²)
///     Y = q (Y_0 + Y_cos cos ψ + Y_sin sin ψ + Y_v v' + Y_r r' + Y_d δ + Y_vv v'|v'| + Y_rr r'|r'|),   N = q L (the
///     same of N)
template <class S>
PlanarForce<S> unknown_force(const AddedForces<S>& a, const ShipState<S>& state, const S& delta) {
  const auto& k = a.map;
  const auto [s, c] = sin_cos(state.psi);
  const S q = 0.5 * a.rho * a.L * a.L * a.U_0 * a.U_0, u = state.motion.u / a.U_0 - 1.0, v = state.motion.v / a.U_0,
          r = state.motion.r * a.L / a.U_0;
  const S vv = v * size_of(v), rr = r * size_of(r);
  return {
      .X = q * (k.X_0 + k.X_cos * c + k.X_sin * s + k.X_u * u + k.X_vv * v * v + k.X_vr * v * r + k.X_rr * r * r +
                k.X_dd * delta * delta),
      .Y = q * (k.Y_0 + k.Y_cos * c + k.Y_sin * s + k.Y_v * v + k.Y_r * r + k.Y_d * delta + k.Y_vv * vv + k.Y_rr * rr),
      .N = q * a.L *
           (k.N_0 + k.N_cos * c + k.N_sin * s + k.N_v * v + k.N_r * r + k.N_d * delta + k.N_vv * vv + k.N_rr * rr)};
}

/// Calls add(name, force) for every force that is there. `controls` as recorded.
template <class Model, class S, class Add>
void for_each_added(const Model& ship, const AddedForces<S>& a, const ShipState<S>& state, const Hidden<S>& hidden,
                    const Controls<S>& controls, Add&& add) {
  const auto& m = state.motion;
  if (a.cross_flow) add(CrossFlowDrag<S>::id, cross_flow_force(a, m));
  if (a.waves) add(WaveDrift<S>::id, wave_drift_force(a, state.psi));
  if (a.side_force) add(PropellerSideForce<S>::id, side_force(a, thrust(ship, m, driven(a, m, controls))));
  if (a.roll) add(RollCoupling<S>::id, heel_force(a, m, hidden.phi));
  if (a.memory) add(FluidMemory<S>::id, memory_force(ship, a, m, hidden));
  if (a.mapped) add(UnknownForce<S>::id, unknown_force(a, state, controls.delta));
}

/// Sum of the added forces.
template <class Model, class S>
PlanarForce<S> added_force(const Model& ship, const AddedForces<S>& a, const ShipState<S>& state,
                           const Hidden<S>& hidden, const Controls<S>& controls) {
  PlanarForce<S> sum{S(0.0), S(0.0), S(0.0)};
  for_each_added(ship, a, state, hidden, controls, [&](std::string_view, const PlanarForce<S>& f) { sum = sum + f; });
  return sum;
}

// ---------------------------------------------------------------- what goes on out of sight

/// Rates of heel and memory.
///
///     d²phi/dt² + 2 zeta omega d(phi)/dt + omega² phi = −lever u r/k_xx²,   omega² = g GM/k_xx²
///     d(v_s)/dt = (v − v_s)/tau,   d(r_s)/dt = (r − r_s)/tau
template <class S>
Hidden<S> hidden_rates(const AddedForces<S>& a, const PlanarMotion<S>& m, const Hidden<S>& h) {
  Hidden<S> rate{};
  if (a.roll) {
    const S over_kk = 1.0 / (a.k_xx * a.k_xx), omega = sqrt(effect_gravity * a.coupling.GM * over_kk);
    rate.phi = h.p;
    rate.p = -a.coupling.lever * m.u * m.r * over_kk - omega * (2.0 * a.coupling.zeta * h.p + omega * h.phi);
  }
  if (a.memory) {
    rate.v = (m.v - h.v) / a.lag.tau;
    rate.r = (m.r - h.r) / a.lag.tau;
  }
  return rate;
}

/// Heel and memory of a motion that has lasted long: phi = −lever u r/(g GM), v_s = v, r_s = r.
template <class S>
Hidden<S> steady_hidden(const AddedForces<S>& a, const PlanarMotion<S>& m) {
  Hidden<S> h{S(0.0), S(0.0), m.v, m.r};
  if (a.roll) h.phi = -a.coupling.lever * m.u * m.r / (effect_gravity * a.coupling.GM);
  return h;
}

/// Force of model and effects in a motion that lasts, without what depends on the heading: wind, waves, an unknown
/// force that does.
template <template <class> class Model, class S, std::size_t N>
PlanarForce<S> steady_force(const Model<S>& ship, const AddedForces<S>& added, const PlanarMotion<S>& m,
                            const Controls<S>& controls, const Branch<S, N>& branch) {
  const auto own = forces(ship, m, driven(added, m, controls), branch).total();
  if (!added.any()) return own;
  auto still = added;
  still.waves = false;
  still.map.X_cos = still.map.X_sin = still.map.Y_cos = still.map.Y_sin = still.map.N_cos = still.map.N_sin = S(0.0);
  return own + added_force(ship, still, ShipState<S>{S(0.0), S(0.0), S(0.0), m}, steady_hidden(added, m), controls);
}

template <template <class> class Model, class S>
PlanarForce<S> steady_force(const Model<S>& ship, const AddedForces<S>& added, const PlanarMotion<S>& m,
                            const Controls<S>& controls) {
  if (!added.any()) return forces(ship, m, controls).total();
  return steady_force(ship, added, m, controls, branch_at(ship, m, driven(added, m, controls)));
}

}  // namespace swayaw
