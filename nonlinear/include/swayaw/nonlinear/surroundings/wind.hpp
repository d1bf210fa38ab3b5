#pragma once

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/surroundings/windage.hpp"

/// Load of the wind on the ship above water. docs/wind.md tells formulas, signs and sources.
///
/// Wind from ahead pushes X < 0, wind from starboard pushes Y < 0.
namespace swayaw::inline nonlinear {

/// Steady true wind over the ground.
template <class S = double>
struct Wind {
  S speed = S(0.0);  ///< [m/s]
  S from = S(0.0);   ///< direction it comes from, clockwise from north [rad]
};

/// Velocity of the air relative to midship in body axes.
template <class S = double>
struct ApparentWind {
  S u;  ///< [m/s], negative for wind from ahead
  S v;  ///< [m/s], negative for wind from starboard
};

/// Air seen from the ship.
///
///     u_A = −V cos(from − psi) − u,   v_A = −V sin(from − psi) − v
///
/// `over_ground` is the velocity of midship over ground in body axes; the yaw rate is not felt.
template <class S>
ApparentWind<S> apparent_wind(const Wind<S>& wind, const PlanarMotion<S>& over_ground, const S& psi) {
  const S relative = wind.from - psi;
  return {-wind.speed * cos(relative) - over_ground.u, -wind.speed * sin(relative) - over_ground.v};
}

/// The same for a ship whose motion is counted over ground.
template <class S>
ApparentWind<S> apparent_wind(const Wind<S>& wind, const ShipState<S>& state) {
  return apparent_wind(wind, state.motion, state.psi);
}

/// V_A² [m²/s²].
template <class S>
S speed_squared(const ApparentWind<S>& air) {
  return air.u * air.u + air.v * air.v;
}

/// V_A [m/s]; 0 with derivative 0 in still air.
template <class S>
S speed(const ApparentWind<S>& air) {
  const S square = speed_squared(air);
  const auto blows = square > S(1e-200);
  return select(blows, S(sqrt(select(blows, square, S(1.0)))), S(0.0));
}

/// alpha = atan2(−v_A, −u_A) in [−pi, pi] [rad]; 0 in still air, where no direction is seen.
template <class S>
S angle_of_attack(const ApparentWind<S>& air) {
  const auto blows = speed_squared(air) > S(1e-200);
  return atan2(S(-air.v), select(blows, S(-air.u), S(1.0)));
}

/// X, Y [N] and N about midship [N m] of the air that passes the ship. Zero with zero derivatives in still air.
template <class S>
PlanarForce<S> wind_force(const Windage<S>& w, const ApparentWind<S>& air) {
  const auto C = coefficients_at(w, angle_of_attack(air));
  const S q = 0.5 * w.rho * speed_squared(air);
  return {.X = q * w.A_F * C.X, .Y = q * w.A_L * C.Y, .N = q * w.A_L * w.L_OA * C.N};
}

/// Load of a true wind on a ship that moves over ground and heads psi.
template <class S>
PlanarForce<S> wind_force(const Windage<S>& windage, const Wind<S>& wind, const PlanarMotion<S>& over_ground,
                          const S& psi) {
  return wind_force(windage, apparent_wind(wind, over_ground, psi));
}

}  // namespace swayaw::nonlinear
