#pragma once

#include "swayaw/core/scalar.hpp"

/// Planar motion and force. Axes: x forward, y to starboard, z down, origin midship;
/// docs/notation.md tells all signs.
namespace swayaw::inline core {

/// Velocity of midship in body axes, and yaw rate.
template <class Scalar = double>
struct PlanarMotion {
  Scalar u;  ///< surge [m/s]
  Scalar v;  ///< sway, positive to starboard [m/s]
  Scalar r;  ///< yaw rate, positive to starboard [rad/s]
};

/// Time derivative of a planar motion in body axes.
template <class Scalar = double>
struct PlanarAcceleration {
  Scalar u;  ///< du/dt [m/s^2]
  Scalar v;  ///< dv/dt [m/s^2]
  Scalar r;  ///< dr/dt [rad/s^2]
};

/// Force in body axes and moment about midship.
template <class Scalar = double>
struct PlanarForce {
  Scalar X;  ///< surge force [N]
  Scalar Y;  ///< sway force, positive to starboard [N]
  Scalar N;  ///< yaw moment about midship, positive to starboard [N m]
};

template <class Scalar>
PlanarForce<Scalar> operator+(const PlanarForce<Scalar>& a, const PlanarForce<Scalar>& b) {
  return {a.X + b.X, a.Y + b.Y, a.N + b.N};
}

/// Where the ship is, where she points, how she moves.
template <class Scalar = double>
struct ShipState {
  Scalar x;    ///< midship, earth-fixed, northward [m]
  Scalar y;    ///< midship, earth-fixed, eastward [m]
  Scalar psi;  ///< heading, clockwise from north [rad]
  PlanarMotion<Scalar> motion;
};

/// Port and starboard exchanged.
template <class Scalar>
PlanarMotion<Scalar> mirrored(const PlanarMotion<Scalar>& m) {
  return {m.u, -m.v, -m.r};
}

template <class Scalar>
PlanarForce<Scalar> mirrored(const PlanarForce<Scalar>& f) {
  return {f.X, -f.Y, -f.N};
}

/// U = sqrt(u^2 + v^2) [m/s].
template <class Scalar>
Scalar speed(const PlanarMotion<Scalar>& m) {
  return sqrt(m.u * m.u + m.v * m.v);
}

/// beta = atan2(-v, u) [rad].
template <class Scalar>
Scalar drift_angle(const PlanarMotion<Scalar>& m) {
  return angle_of(Scalar(-m.v), m.u);
}

}  // namespace swayaw::core
