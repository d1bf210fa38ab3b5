#pragma once

#include "linear_likelihood.hpp"

/// Fisher scoring. Not installed.
namespace swayaw::inline identification::detail {

struct LinearAscent {
  Parameters p;
  double log_likelihood;
  bool converged = false;
};

/// The descent of `descent.hpp` with the expected information as curvature. It ends where a step predicts less than
/// 1e-6 of log likelihood, that is 1e-3 standard errors, or where none of those that are tried is better; then it has
/// converged if the last predicts less than 1e-3.
LinearAscent climb(const LinearProblem& problem, const Parameters& start);

}  // namespace swayaw::identification::detail
