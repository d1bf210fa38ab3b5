#pragma once

#include <vector>

#include "swayaw/identification/state_estimate.hpp"

/// Forces that a recorded ship must have felt, from her estimated motion. docs/state_estimation.md describes the
/// method.
namespace swayaw::inline identification {

/// X, Y, N as indices.
using ForceCovariance = std::array<std::array<double, 3>, 3>;

/// A force with its covariance.
struct EstimatedForce {
  PlanarForce<double> force;
  ForceCovariance covariance;
};

/// The forces at one sample.
struct InverseDynamics {
  double time;
  EstimatedForce
      damping;          ///< of the water, by the velocity of the ship: hull, propeller, rudder and what the model lacks
  EstimatedForce hull;  ///< the same without what the model says of propeller, rudder and rudder–hull interaction
};

/// The force that gives an acceleration to a ship and the water she entrains, the inverse of `acceleration`:
///
///     F = M (a − a_0),   a_0 the acceleration without force, M⁻¹ what each force gives to a ship at rest
///
/// for every model, since acceleration is affine in the force, X apart from Y and N, and masses do not depend on the
/// motion.
template <template <class> class Ship, class S>
PlanarForce<S> force_of(const Ship<S>& ship, const PlanarMotion<S>& motion, const PlanarAcceleration<S>& a) {
  const S zero(0.0), one(1.0);
  const PlanarMotion<S> rest{zero, zero, zero};
  const auto a_0 = acceleration(ship, motion, PlanarForce<S>{zero, zero, zero});
  const auto a_X = acceleration(ship, rest, PlanarForce<S>{one, zero, zero});
  const auto a_Y = acceleration(ship, rest, PlanarForce<S>{zero, one, zero});
  const auto a_N = acceleration(ship, rest, PlanarForce<S>{zero, zero, one});
  const S over_det = one / (a_Y.v * a_N.r - a_N.v * a_Y.r), v = a.v - a_0.v, r = a.r - a_0.r;
  return {.X = (a.u - a_0.u) / a_X.u, .Y = (a_N.r * v - a_N.v * r) * over_det, .N = (a_Y.v * r - a_Y.r * v) * over_det};
}

/// Forces at each sample of an estimated run. With the acceleration a of the model and its unmodelled part d,
///
///     damping = M (a + d) − centrifugal and Coriolis terms − wind
///     hull = damping − propeller − rudder − rudder–hull interaction
///
/// The covariance is J P Jᵀ of the estimated state and unmodelled acceleration, which are correlated. For the model the
/// ship was estimated with; where she differs from the truth, d brings the force back to it as far as the process noise
/// allows.
///
/// Source: [Alexandersson2024] eqs (1)–(3), (39)–(41), with propeller and interaction taken out too
///
/// @throws Refusal  if the run has no rudder angle, or another number of samples than the estimate
std::vector<InverseDynamics> inverse_dynamics(const Ship& ship, const Recording& run, const StateEstimate& estimate);

}  // namespace swayaw::identification
