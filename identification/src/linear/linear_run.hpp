#pragma once

#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/identification/linear_fit.hpp"

/// A recording as the linear equations see it. Not installed.
namespace swayaw::inline identification::detail {

/// Time in ship lengths; a measurement that is missing or not used is NaN.
struct LinearSample {
  double s;      ///< ∫ U/L dt since the first sample
  double rate;   ///< U/L [1/s]
  double delta;  ///< [rad]
  double psi;    ///< [rad]
  double r;      ///< [rad/s]
  double beta;   ///< [rad]
};

using LinearRun = std::vector<LinearSample>;

/// @throws Refusal  as `fit_linear`
LinearRun linear_run(const Recording& run, const LinearFitOptions& options);

}  // namespace swayaw::identification::detail
