#pragma once

#include <optional>
#include <vector>

#include "swayaw/nonlinear/steady_motion.hpp"

/// Steady turns: where they are, how many there are, and which of them last.
namespace swayaw::inline nonlinear {

/// A point of the r–delta curve.
struct SteadyTurn {
  double delta;  ///< rudder angle, positive to port [rad]
  PlanarMotion<double> motion;
  bool stable;
};

/// The r–delta curve through the straight course, from the largest rudder angle to one side, through all its folds, to
/// the largest to the other. A ship that is unstable on the straight course has several steady turns at small angles.
///
/// The curve is followed in (u, v, r, delta) by pseudo-arclength continuation with exact derivatives, steps of at most
/// `step` in units of U, U/L and rad. It ends at `largest` [rad], or where the ship no longer moves ahead.
///
/// @param propulsion  held along the curve
/// @throws Refusal  if there is no straight course to begin with
std::vector<SteadyTurn> steady_turn_curve(const Ship& ship, const Controls<double>& propulsion, double largest,
                                          double step = 0.02);

/// Every steady motion ahead that was found at these controls: those where the curve passes the rudder angle and those
/// that Newton's method reaches from a fixed grid of starts. Ordered by yaw rate; none if the ship has no steady turn
/// there.
std::vector<SteadyMotion> steady_turns(const Ship& ship, const Controls<double>& controls);

/// The steady turn at that yaw rate [rad/s], its rudder angle sought: the point nearest to amidships where the r–delta
/// curve up to `largest` passes it.
///
/// @param curve  of the same ship and propulsion, to start from
/// @return nothing where the curve does not reach it
std::optional<SteadyTurn> turn_at_yaw_rate(const Ship& ship, const Controls<double>& propulsion,
                                           const std::vector<SteadyTurn>& curve, double yaw_rate, double largest);

/// Width of the hysteresis of an unstable ship: the range of rudder angles between the folds of the r–delta curve
/// nearest to the straight course.
struct InstabilityLoop {
  double width;   ///< of rudder angle [rad]
  double height;  ///< difference of the stable yaw rates at the neutral rudder angle [rad/s]
};

/// Nothing for a ship with one steady turn at every rudder angle.
std::optional<InstabilityLoop> instability_loop(const std::vector<SteadyTurn>& curve);

}  // namespace swayaw::nonlinear
