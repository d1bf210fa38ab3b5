#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

/// Angles are radians inside; degrees appear at the boundary only, with the unit in the name.
namespace swayaw::inline core {

inline constexpr double pi = std::numbers::pi;

/// Angle in radians from degrees.
constexpr double radians(double degrees) { return degrees * (pi / 180.0); }

/// Angle in degrees from radians.
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

/// The same direction in [-pi, pi].
inline double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

/// The same direction in [0, 2 pi), as directions are told.
inline double from_north(double angle) {
  const double near = wrapped(angle);
  return near < 0.0 ? std::min(near + 2.0 * pi, std::nextafter(2.0 * pi, 0.0)) : near;
}

/// The same direction, less than half a turn from `previous`.
inline double unwrapped(double angle, double previous) { return previous + wrapped(angle - previous); }

}  // namespace swayaw::core
