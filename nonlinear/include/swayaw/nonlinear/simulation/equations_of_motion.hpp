#pragma once

#include <type_traits>

#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// The right-hand side of the equations of motion, once for every stepper: docs/decisions/006 tells which there are.
///
/// Effects that add forces or slow the shaft (acting_effects.hpp) come as an argument, and so does what surrounds the
/// ship. Where there are none, NoEffects and StillSurroundings leave nothing to compute and nothing to ask.
namespace swayaw::inline nonlinear {

/// A ship without effects.
struct NoEffects {};

/// Neither wind nor current.
struct StillSurroundings {};

/// Without effects the shaft turns as ordered.
template <class S>
const Controls<S>& driven(const NoEffects&, const PlanarMotion<S>&, const Controls<S>& controls) {
  return controls;
}

/// Acceleration of midship, on a branch of the force model, by the forces of the model, the wind and the effects.
///
/// `hidden` is what goes on out of sight, as the effects need it; `controls` are those recorded or ordered.
template <class Model, class Around, class Effects, class S, class Hidden, class ModelBranch>
PlanarAcceleration<S> acceleration_of(const Model& ship, const Around& around, const Effects& effects,
                                      const ShipState<S>& state, const Hidden& hidden, const Controls<S>& controls,
                                      const ModelBranch& branch) {
  const auto& m = state.motion;
  auto force = forces(ship, m, driven(effects, m, controls), branch).total();
  if constexpr (!std::is_same_v<Around, StillSurroundings>)
    if (around.windy) force = force + wind_load(around, state);
  if constexpr (!std::is_same_v<Effects, NoEffects>)
    force = force + added_force(ship, effects, state, hidden, controls);
  return acceleration(ship, m, force);
}

/// Equations of motion.
///
///     dx/dt = u cos(psi) − v sin(psi) + V_c cos(psi_c),   dpsi/dt = r
///     dy/dt = u sin(psi) + v cos(psi) + V_c sin(psi_c),   (du, dv, dr)/dt by acceleration_of
template <class Model, class Effects, class S, class Hidden, class ModelBranch>
StateVector<S> rates_of(const Model& ship, const Surroundings<S>& around, const Effects& effects,
                        const ShipState<S>& state, const Hidden& hidden, const Controls<S>& controls,
                        const ModelBranch& branch) {
  const auto& m = state.motion;
  const auto a = acceleration_of(ship, around, effects, state, hidden, controls, branch);
  const auto [s, c] = sin_cos(state.psi);
  const auto [north, east] = drift_of(around.current);
  return {m.u * c - m.v * s + north, m.u * s + m.v * c + east, m.r, a.u, a.v, a.r};
}

/// The same for a ship without effects.
template <class Model, class S, class ModelBranch>
StateVector<S> rates_of(const Model& ship, const Surroundings<S>& around, const ShipState<S>& state,
                        const Controls<S>& controls, const ModelBranch& branch) {
  return rates_of(ship, around, NoEffects{}, state, NoEffects{}, controls, branch);
}

}  // namespace swayaw::nonlinear
