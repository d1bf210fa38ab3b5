#pragma once

#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// From which part does a force come?
namespace swayaw::inline nonlinear {

/// Forces about midship, split by part, and what they do to the ship.
struct ForceBreakdown {
  /// hull, propeller, rudder, rudder_hull_interaction where the model has one, wind where there is some, and effects
  /// that add a force, by their names
  std::vector<ForcePart<double>> parts;
  PlanarForce<double> total;                ///< drives the equations of motion of the model
  PlanarAcceleration<double> acceleration;  ///< of midship in body axes
};

/// The rudder angle is that of the rudder. Gusts do not blow, and the heel is that of a steady motion.
///
/// @throws Refusal  if no force model holds for the motion or the controls (validity.hpp)
ForceBreakdown force_breakdown(const Ship& ship, const ShipState<double>& state, const Controls<double>& controls);

/// Forces by part as columns X_hull_N, Y_hull_N, N_hull_N_m, … beside the samples of a run, recorded or simulated.
/// Samples of which the motion, the rudder or the propulsion is missing, or for which no force model holds, get none.
///
/// @throws Refusal  if the run lacks u, v, r, rudder, or shaft speed and thrust, altogether
void add_forces(Recording& run, const Ship& ship);

}  // namespace swayaw::nonlinear
