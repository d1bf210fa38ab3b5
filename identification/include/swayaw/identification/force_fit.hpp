#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/identification/regression.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Coefficients from the forces that recorded ships must have felt: inverse dynamics and regression.
/// docs/identification.md
namespace swayaw::inline identification {

/// How the forces are explained.
struct ForceFitOptions {
  std::vector<std::string> parameters;  ///< to be found, by name as in parameters_of: "N_v"
  EstimationOptions states = {.channels = {},
                              .noise = {},
                              .process_noise = {},
                              .coloured = true,
                              .memory = std::numeric_limits<double>::infinity()};
  bool priors = false;  ///< the parameters as given, with the ship's confidence, count as measurements
  double ridge = 0.0;   ///< see RegressionOptions
};

/// One of the three force equations and the coefficients in it, in the unit of the ship file.
struct ForceEquation {
  ForceComponent component;
  Regression fit;  ///< of forces over ½ρL²U², moments over ½ρL³U²
  std::vector<double>
      bias;  ///< how far errors of the estimated motion may have moved each coefficient: what taking the
             ///< covariance of the smoothed states for that of independent errors in the features would change
};

/// Largest motions in recordings. What is said of a ship from them holds for motions of this size.
struct MotionRange {
  double drift;   ///< largest |beta| [rad]
  double omega;   ///< largest |r'|
  double rudder;  ///< largest |delta| [rad]
};

struct ForceFit {
  Ship ship;                             ///< with the coefficients found; one that is not determined keeps its value
  std::vector<ForceEquation> equations;  ///< those that have a coefficient to be found
  MotionRange range;
  std::vector<StateEstimate> states;  ///< of each run
};

/// Coefficients of a ship that act linearly, by least squares on the forces of inverse dynamics.
///
///     F(t) − F_known(t) = Σ theta_i ∂F/∂theta_i,   F in X, Y or N over ½ρL²U² or ½ρL³U²
///
/// F is the damping force of the estimated motion, F_known what the ship does with these coefficients 0; the features
/// are the exact derivatives of her force model. Standard errors are those of Newey and West, since what a model leaves
/// out is correlated in time.
///
/// Source: [Alexandersson2024] section 3.4
///
/// @throws Refusal  if there is nothing to find, a number does not exist, acts in more than one equation or not
/// linearly, or
///                  a run cannot be estimated
ForceFit fit_forces(const Ship& ship, std::span<const Recording> runs, const ForceFitOptions& options);

/// The same from states that are known already.
ForceFit fit_forces(const Ship& ship, std::span<const Recording> runs, std::vector<StateEstimate> states,
                    const ForceFitOptions& options);

}  // namespace swayaw::identification
