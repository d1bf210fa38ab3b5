#pragma once

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/core/side.hpp"
#include "swayaw/linear/linear_ship.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Small motions about a steady one, by exact derivatives of the ship's forces.
namespace swayaw::inline nonlinear {

/// A motion and the controls that keep it.
struct OperatingPoint {
  PlanarMotion<double> motion;
  Controls<double> controls;
};

/// Derivatives of du/dt, dv/dt, dr/dt (rows) by u, v, r and delta (columns), in SI.
struct AccelerationDerivatives {
  std::array<std::array<double, 4>, 3> d{};

  AccelerationDerivatives& operator+=(const AccelerationDerivatives& other);
};

/// What one part of the ship contributes.
struct PartDerivatives {
  std::string name;  ///< hull, propeller, rudder, …, or centrifugal: what follows from mass and added mass turning with
                     ///< the ship
  AccelerationDerivatives derivatives;
};

struct Linearization {
  OperatingPoint point;
  PrimeScale scale;  ///< length, and speed of the operating point
  AccelerationDerivatives whole;
  std::vector<PartDerivatives> parts;  ///< add up to the whole
  SnameDerivatives<double> masses;  ///< m', x_G', I_z' and added masses in ½ρL³ … ½ρL⁵; the derivatives are 0
  std::array<std::complex<double>, 3> poles;  ///< of u, v and r together [1/s]
};

/// Linear motion about a steady motion of the ship.
///
/// Effects that change numbers or add a force act, with heel and memory those of a steady motion; wind, waves and what
/// lies between order and rudder do not.
///
/// Where the forces have a kink at the operating point, as the MMG rudder has straight ahead, the derivatives are those
/// of a turn to one side, or without a side the mean of both.
///
/// @throws Refusal  if the ship does not move ahead, or accelerates there by more than 1e-6 U²/L
Linearization linearize(const Ship& ship, const OperatingPoint& point, std::optional<Side> side = std::nullopt);

/// The same about a motion that need not be steady, such as a speed at which the thrust is not that of self-propulsion:
/// the derivatives hold while the motion is near it.
///
/// @throws Refusal  if the ship does not move ahead
Linearization linearize_transient(const Ship& ship, const OperatingPoint& point,
                                  std::optional<Side> side = std::nullopt);

/// Whether the derivatives of turns to port and to starboard differ there; the motion need not be steady.
bool has_kink(const Ship& ship, const OperatingPoint& point);

/// Coupled equations of drift and yaw at constant speed; drift counts from that of the operating point, beta = −v/U.
SwayYawCoefficients<double> sway_yaw(const AccelerationDerivatives& derivatives, const PrimeScale& scale);

/// Sway and yaw derivatives in ½ρL²U² and ½ρL³U², with the masses of the ship. Y_r' holds −m_x' of models that have the
/// added mass of surge in the centripetal force.
SnameDerivatives<double> sname(const Linearization& linear);

/// The ship in small motions about the operating point, in the form that the linear floor works with.
LinearShip linear_ship(const Ship& ship, const Linearization& linear);

/// Straight ahead at that speed, with self-propulsion.
/// @throws Refusal  as self_propulsion, or if the straight course is no steady motion
OperatingPoint straight_course(const Ship& ship, double speed);

/// Straight ahead at the speed that this propulsion gives.
/// @throws Refusal  if there is none
OperatingPoint straight_course(const Ship& ship, const Controls<double>& propulsion);

}  // namespace swayaw::nonlinear
