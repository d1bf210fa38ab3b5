#pragma once

#include "linear_run.hpp"
#include "swayaw/linear/sway_yaw.hpp"

/// Starting values by linear regression. Not installed.
///
/// With φ = (τ (1 − τ))³ over a piece of `width` ship lengths, zero with two derivatives at both ends, partial
/// integration moves every derivative from the data to φ:
///
///     −∫φ' beta ds = a1 ∫φ beta ds + b1 ∫φ omega' ds + c1 ∫φ delta ds + k ∫φ ds
///
/// so that the noise is averaged and no sample is differentiated. One equation for each piece; least squares.
namespace swayaw::inline identification::detail {

/// Sway and yaw from drift and yaw rate.
SwayYawCoefficients<double> regressed_coefficients(const std::vector<LinearRun>& runs, double width);

/// e0, e1, nw0, nw1 from yaw rate alone; nb0 and nb1 are 0.
SwayYawTransfer<double> regressed_yaw(const std::vector<LinearRun>& runs, double width);

/// Guess of the white noise of a channel.
double noise_of(const std::vector<LinearRun>& runs, double LinearSample::*channel);

}  // namespace swayaw::identification::detail
