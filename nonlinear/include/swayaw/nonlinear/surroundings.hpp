#pragma once

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/branch.hpp"

/// Water and air around the ship, and the equations of motion in them.
namespace swayaw {

/// A uniform stream. Motion of the ship is counted through the water, so the stream only carries her along:
/// in axes that drift with it nothing else changes.
template <class S = double>
struct Current {
  S speed{};  ///< [m/s]
  S to{};     ///< direction it runs to, clockwise from north [rad]
};

template <class S = double>
struct Surroundings {
  Current<S> current;
};

/// x, y, psi, u, v, r, or their rates.
template <class S = double>
using StateVector = std::array<S, 6>;

template <class S>
StateVector<S> vector_of(const ShipState<S>& s) {
  return {s.x, s.y, s.psi, s.motion.u, s.motion.v, s.motion.r};
}

template <class S>
ShipState<S> state_of(const StateVector<S>& s) {
  return {s[0], s[1], s[2], {s[3], s[4], s[5]}};
}

/// Equations of motion, on a branch of the force model.
///
///     dx/dt = u cos(psi) − v sin(psi) + V_c cos(psi_c),   dpsi/dt = r
///     dy/dt = u sin(psi) + v cos(psi) + V_c sin(psi_c),   (du, dv, dr)/dt by the model
template <template <class> class Model, class S, std::size_t N>
StateVector<S> rates_of(const Model<S>& ship, const Surroundings<S>& around, const ShipState<S>& state, const Controls<S>& controls,
                        const Branch<S, N>& branch) {
  const auto& m = state.motion;
  const auto a = acceleration(ship, m, forces(ship, m, controls, branch).total());
  const S c = cos(state.psi), s = sin(state.psi);
  const auto& [V_c, psi_c] = around.current;
  return {m.u * c - m.v * s + V_c * cos(psi_c), m.u * s + m.v * c + V_c * sin(psi_c), m.r, a.u, a.v, a.r};
}

}  // namespace swayaw
