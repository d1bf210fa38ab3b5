#pragma once

#include <vector>

#include "swayaw/linear/zigzag.hpp"

namespace swayaw::inline linear {

/// State at the start of a step.
struct EulerStep {
  double s;  ///< ship lengths
  LinearState<double> state;
  double delta;  ///< rudder angle [rad]
};

/// A zigzag by Euler's method.
struct EulerZigzag {
  std::vector<LinearReversal<double>> reversals;  ///< `leg` counts steps; the peak is that of the samples
  std::vector<EulerStep> steps;
};

/// The zigzag as Artyszuk 2016 integrates it, kept to redraw the figures of that paper; `linear_zigzag` is exact.
///
/// At the start of a step |psi| is tested against H. Then psi, beta, omega' and delta advance together, with the
/// derivatives of the state at its start:
///
///     x⁺ = x + ds' dx/ds',   delta moves by at most rate ds' towards its order
///
/// A reversal is up to one step late and the rudder acts one step after it moves: the overshoots of that paper's ship
/// come out 10 to 15 % above the exact ones at ds' = 0.05.
///
/// @param step  ds' [ship lengths]
/// @throws std::domain_error  if an angle, the rate or the step is not positive
/// Source: [Artyszuk2016] section 6
EulerZigzag euler_zigzag(const SwayYawCoefficients<double>& ship, const LinearZigzagOrder& order, double step = 0.05);

}  // namespace swayaw::linear
