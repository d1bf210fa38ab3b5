#pragma once

#include <optional>
#include <span>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/equilibria.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/settling.hpp"

/// Spiral tests: which yaw rate belongs to which rudder angle. docs/manoeuvres.md tells definitions.
namespace swayaw::inline nonlinear {

// ---------------------------------------------------------------- direct spiral

struct SpiralOrder {
  double largest = radians(25.0);  ///< rudder angle at both ends [rad]
  double step = radians(5.0);      ///< between rudder angles, which are its multiples [rad]
  Side first = Side::starboard;    ///< side turned to first
  Settling settling;               ///< at every angle
};

/// What became of the ship at one rudder angle.
struct SpiralPoint {
  double delta;  ///< rudder angle, positive to port [rad]
  PlanarMotion<double> motion;
  double held;   ///< time since the order [s]
  bool settled;  ///< the motion was steady
};

/// Where the way out and the way back differ by more than 1e-3 U/L in yaw rate.
struct SpiralLoop {
  double width;   ///< between the outermost such rudder angles [rad]; the true width is up to two steps larger
  double height;  ///< largest difference of yaw rate at one rudder angle [rad/s]
};

struct Spiral {
  std::vector<SpiralPoint> down;         ///< from the largest angle on the first side to the largest on the other
  std::vector<SpiralPoint> up;           ///< and back; begins with the point where `down` ends
  std::optional<SpiralLoop> loop;        ///< of the two; nothing where they agree
  std::vector<SteadyTurn> curve;         ///< all steady turns up to the largest angle, the unstable ones too
  std::optional<InstabilityLoop> exact;  ///< of that curve
  double approach_speed;                 ///< [m/s]
  Controls<double> propulsion;           ///< held during the manoeuvre
  Recording run;
};

/// Dieudonné's spiral: the rudder goes from the largest angle on one side to that on the other and back in steps, and
/// is held at each until the ship turns steadily. A course-unstable ship goes two ways at small angles.
///
/// `duration` of the options is not used; samples are near 0.2 L/U apart unless a step is given.
/// @throws std::domain_error  if the largest angle is not positive or beyond the ship's, or the step is not positive or
/// larger
/// @throws Refusal            as steady_turn_curve and zigzag do, or for a ship in wind
/// Source: [MSC/Circ.1053] appendix 4
Spiral spiral(const Ship& ship, const SpiralOrder& order = {}, const ManoeuvreOptions& options = {});

/// The multiples of `step` between ±largest, and both ends; from the largest down [rad].
std::vector<double> spiral_angles(double largest, double step);

// ---------------------------------------------------------------- reverse spiral

/// A yaw rate and the rudder that holds it.
struct HeldYawRate {
  double r;  ///< [rad/s]
  std::optional<SteadyTurn>
      turn;  ///< nothing where no rudder angle up to the largest holds it; not stable where it takes a helmsman
};

struct ReverseSpiralOrder {
  double largest = radians(25.0);  ///< rudder angle [rad]
  int steps = 10;  ///< yaw rates on each side of 0, up to the smaller one of the two turns at the largest angle
};

struct ReverseSpiral {
  std::vector<HeldYawRate> points;  ///< from the largest yaw rate to port to the largest to starboard
  double approach_speed;            ///< [m/s]
  Controls<double> propulsion;      ///< held
};

/// Bech's reverse spiral: for each yaw rate the mean rudder angle of a helmsman who keeps it. The angle is that of the
/// exact steady turn, so nothing is simulated and the unstable part of the curve is passed without a jump.
///
/// Of the options only speed and propulsion are used.
/// @throws as spiral does
/// Source: [Bech1968]
ReverseSpiral reverse_spiral(const Ship& ship, const ReverseSpiralOrder& order = {},
                             const ManoeuvreOptions& options = {});

/// The same at given yaw rates. Where several angles hold a yaw rate, the smallest.
std::vector<HeldYawRate> held_yaw_rates(const Ship& ship, const Controls<double>& propulsion,
                                        std::span<const double> yaw_rates, double largest);

}  // namespace swayaw::nonlinear
