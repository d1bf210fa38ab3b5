#pragma once

#include <array>
#include <type_traits>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/surroundings/wind.hpp"

/// Water and air around the ship.
namespace swayaw::inline nonlinear {

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

/// The same with another scalar.
template <class To, class From>
Surroundings<To> cast(const Surroundings<From>& around) {
  return {.windage = cast_part<To>(around.windage),
          .wind = {To(around.wind.speed), To(around.wind.from)},
          .current = {To(around.current.speed), To(around.current.to)},
          .windy = around.windy};
}

/// Velocity of the water over ground, northward and eastward [m/s].
template <class S>
struct Drift {
  S north, east;
};

/// V_c (cos psi_c, sin psi_c). Nothing is computed for plain numbers where no current runs; a dual may stand for one.
template <class S>
Drift<S> drift_of(const Current<S>& current) {
  if constexpr (std::is_same_v<S, double>)
    if (current.speed == 0.0) return {0.0, 0.0};
  const auto [s, c] = sin_cos(current.to);
  return {current.speed * c, current.speed * s};
}

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

}  // namespace swayaw::nonlinear
