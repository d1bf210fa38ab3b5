#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "../models/force_parts.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/effects/acting_effects.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/models/validity.hpp"
#include "swayaw/nonlinear/simulator.hpp"

/// Forces of a model, carried on where it does not hold, for a simulator that must go on: at rest, astern, turning on
/// the spot, with a shaft that turns astern. Within the range they are those of the model, bit for bit. Not installed.
///
/// Out of it, with the held motion m_h (u, v and r moved to the edge of the range, the shaft stopped if it turns
/// astern), a share w that falls from 1 to 0 as u falls from 0.1 U_0 to 0, and a drag D that opposes any motion,
///
///     hull         w H(m_h) + D(m) − w D(m_h)
///     other parts  w P(m_h) + (1 − w) P(m_0),   m_0 straight ahead at max(u, 0): the propeller at bollard pull, and
///     the
///                                               rudder in its race; 0 where the polynomial holds the propulsion
///
/// so the forces are finite and continuous, D alone at rest and astern, and the mirrored motion has the mirrored force.
/// D is the drag of the hull as a plate in each direction, the classical model of low speeds:
///
///     X = −½ρLd C_X u|u|,   Y and N by strips across the flow with C_D
namespace swayaw::inline nonlinear::detail {

/// Range that is taken as it is; docs/simulation.md has the table.
struct HeldRange {
  // The ships of ships/, in turns with 35 deg of rudder, keep u ≥ 0.22 U_0, |v| ≤ 0.8 u and |r| L ≤ 2.1 u.
  static constexpr double least_way = nonlinear::least_way;  ///< u over U_0
  static constexpr double most_way = 2.0;                    ///< u over U_0
  static constexpr double most_drift = 2.0;                  ///< |v| over u
  static constexpr double most_turn = 3.0;                   ///< |r| L over u
  static constexpr double C_X = 0.02;                        ///< R_0' of the MMG ships of ships/: 0.014 to 0.022
  static constexpr double C_D = 1.0;                         ///< of a merchant hull across the flow, about 0.7 to 1.2
  static constexpr double draught = 0.05;                    ///< over L, where the model does not know it
  static constexpr double creep = 1e-6;                      ///< of U_0: what stands for rest in P(m_0)
};

/// A motion moved into the range.
struct HeldMotion {
  PlanarMotion<double> motion;
  double share;  ///< w
  SimulatorState why;
};

inline HeldMotion held(const PlanarMotion<double>& m, double L, double U_0) {
  const double u = std::clamp(m.u, HeldRange::least_way * U_0, HeldRange::most_way * U_0);
  const double v = std::clamp(m.v, -HeldRange::most_drift * u, HeldRange::most_drift * u);
  const double r = std::clamp(m.r, -HeldRange::most_turn * u / L, HeldRange::most_turn * u / L);
  const double x = std::clamp(m.u / (HeldRange::least_way * U_0), 0.0, 1.0);
  const auto why = m.u < u                ? SimulatorState::little_way
                   : v != m.v || r != m.r ? SimulatorState::turns_on_the_spot
                   : m.u > u              ? SimulatorState::too_fast
                                          : SimulatorState::valid;
  return {{u, v, r}, x * x * (3.0 - 2.0 * x), why};
}

/// A shaft that turns astern counts as stopped.
inline Controls<double> held(Controls<double> controls) {
  controls.rev = std::max(controls.rev, 0.0);
  return controls;
}

/// A model whose forces are carried on.
template <class Model>
struct HeldModel {
  Model model;
  ShipFacts<double> facts;  ///< the strips of the hull have her length and draught

  explicit HeldModel(const Model& m) : model(m), facts(ship_facts(m)) {
    if constexpr (!requires { m.particulars.d; }) facts.d = HeldRange::draught * facts.L;
  }

  double L() const { return model.particulars.L; }
  double U_0() const { return model.particulars.U_0; }
};

/// D of a motion.
template <class Model>
PlanarForce<double> low_speed_drag(const HeldModel<Model>& ship, const PlanarMotion<double>& m) {
  const ShipState<double> state{0.0, 0.0, 0.0, m};
  const Controls<double> none{};
  auto drag = force(CrossFlowDrag<>{HeldRange::C_D}, ship.model, {ship.facts, state, none, none, {}});
  drag.X = -0.5 * ship.facts.rho * ship.facts.L * ship.facts.d * HeldRange::C_X * m.u * std::abs(m.u);
  return drag;
}

inline PlanarForce<double> mixed(double a, const PlanarForce<double>& f, double b, const PlanarForce<double>& g) {
  return {a * f.X + b * g.X, a * f.Y + b * g.Y, a * f.N + b * g.N};
}

/// Parts of the force, the hull first; `total()` as the right-hand side asks for it.
template <std::size_t N>
struct HeldForces {
  std::array<ForcePart<double>, N> part;

  PlanarForce<double> total() const {
    auto sum = part[0].force;
    for (std::size_t i = 1; i < N; ++i) sum = sum + part[i].force;
    return sum;
  }
};

template <class Model>
auto parts_of(const Model& model, const PlanarMotion<double>& m, const Controls<double>& c,
              const Branch<double, Model::branch_count>& branch) {
  const auto parts = force_parts(model, forces(model, m, c, branch));
  return HeldForces<std::tuple_size_v<std::decay_t<decltype(parts)>>>{parts};
}

/// Out of the range.
template <class Model>
auto forces_carried_on(const HeldModel<Model>& ship, const PlanarMotion<double>& m, const HeldMotion& at,
                       const Controls<double>& controls, const Branch<double, Model::branch_count>& branch) {
  const auto c = held(controls);
  const double w = at.share;
  auto split = parts_of(ship.model, at.motion, c, branch);
  const auto drag = mixed(1.0, low_speed_drag(ship, m), -w, low_speed_drag(ship, at.motion));
  split.part[0].force = mixed(w, split.part[0].force, 1.0, drag);
  if (w == 1.0) return split;
  const PlanarMotion<double> ahead{std::max(m.u, HeldRange::creep * ship.U_0()), 0.0, 0.0};
  const auto slow = parts_of(ship.model, ahead, c, branch_at(ship.model, ahead, c));
  constexpr bool has_propeller = requires { ship.model.propeller; };
  for (std::size_t i = 1; i < split.part.size(); ++i)
    split.part[i].force = mixed(w, split.part[i].force, has_propeller ? 1.0 - w : 0.0, slow.part[i].force);
  return split;
}

template <class Model>
auto forces(const HeldModel<Model>& ship, const PlanarMotion<double>& m, const Controls<double>& controls,
            const Branch<double, Model::branch_count>& branch) {
  const auto at = held(m, ship.L(), ship.U_0());
  const bool astern = !controls.by_thrust && controls.rev < 0.0;
  if (at.why == SimulatorState::valid && !astern) return parts_of(ship.model, m, controls, branch);
  return forces_carried_on(ship, m, at, controls, branch);
}

template <class Model>
PlanarAcceleration<double> acceleration(const HeldModel<Model>& ship, const PlanarMotion<double>& m,
                                        const PlanarForce<double>& force) {
  return acceleration(ship.model, m, force);
}

/// Branch of the force at the held motion.
template <class Model>
auto held_branch(const HeldModel<Model>& ship, const PlanarMotion<double>& m, const Controls<double>& controls) {
  return branch_at(ship.model, held(m, ship.L(), ship.U_0()).motion, held(controls));
}

// ---------------------------------------------------------------- effects

/// Effects of the ship and a force from outside, such as a tug's.
struct HeldEffects {
  ActingEffects<double> effects;
  PlanarForce<double> given{0.0, 0.0, 0.0};
  bool any;
};

inline Controls<double> driven(const HeldEffects& a, const PlanarMotion<double>& m, const Controls<double>& controls) {
  return driven(a.effects, m, controls);
}

/// The effects as at the held motion.
template <class Model>
PlanarForce<double> added_force(const HeldModel<Model>& ship, const HeldEffects& a, const ShipState<double>& state,
                                const Hidden<double>& hidden, const Controls<double>& controls) {
  if (!a.any) return a.given;
  auto at = state;
  at.motion = held(state.motion, ship.L(), ship.U_0()).motion;
  return a.given + added_force(ship.model, a.effects, at, hidden, held(controls));
}

}  // namespace swayaw::nonlinear::detail
