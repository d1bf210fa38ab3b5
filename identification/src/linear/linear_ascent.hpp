#pragma once

#include "linear_likelihood.hpp"

/// Fisher scoring. Not installed.
namespace swayaw::inline identification::detail {

struct LinearAscent {
  Parameters p;
  double log_likelihood;
  bool converged = false;
};

/// Levenberg–Marquardt with the expected information as curvature. It ends where a step predicts less than 1e-6 of log
/// likelihood, that is 1e-3 standard errors, or where rounding allows no better place although it predicts less than
/// 1e-3.
LinearAscent climb(const LinearProblem& problem, const Parameters& start);

}  // namespace swayaw::identification::detail
