#pragma once

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/branch.hpp"
#include "swayaw/nonlinear/wind.hpp"

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
  Windage<S> windage;  ///< what the ship shows the wind
  Wind<S> wind;
  Current<S> current;
  bool windy = false;  ///< without it there is no air at all; its drag on a ship in calm is part of her resistance
};

/// Velocity of midship over ground in body axes.
///
///     u + V_c cos(psi_c − psi),   v + V_c sin(psi_c − psi)
template <class S>
PlanarMotion<S> over_ground(const Current<S>& current, const ShipState<S>& state) {
  const S relative = current.to - state.psi;
  return {state.motion.u + current.speed * cos(relative), state.motion.v + current.speed * sin(relative),
          state.motion.r};
}

/// Load of the wind; nothing where there is none.
template <class S>
PlanarForce<S> wind_load(const Surroundings<S>& around, const ShipState<S>& state) {
  if (!around.windy) return {S(0.0), S(0.0), S(0.0)};
  return wind_force(around.windage, around.wind, over_ground(around.current, state), state.psi);
}

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
StateVector<S> rates_of(const Model<S>& ship, const Surroundings<S>& around, const ShipState<S>& state,
                        const Controls<S>& controls, const Branch<S, N>& branch) {
  const auto& m = state.motion;
  auto force = forces(ship, m, controls, branch).total();
  if (around.windy) force = force + wind_load(around, state);
  const auto a = acceleration(ship, m, force);
  const auto [s, c] = sin_cos(state.psi);
  const auto& [V_c, psi_c] = around.current;
  return {m.u * c - m.v * s + V_c * cos(psi_c), m.u * s + m.v * c + V_c * sin(psi_c), m.r, a.u, a.v, a.r};
}

}  // namespace swayaw
