#pragma once

#include <limits>
#include <string_view>

/// What every fit says of its parameters.
namespace swayaw::inline identification {

/// Do the data tell a constant?
enum class Verdict {
  determined,         ///< the value is at least 10 standard errors
  weakly_determined,  ///< at least 2: the sign is known
  not_determined,     ///< less than 2, or nothing in the data depends on it
};

/// "determined", "weakly determined", "not determined"
std::string_view in_words(Verdict verdict);

/// A number with its standard error. Not a number, with infinite error, where the data do not tell it.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::infinity();

  Verdict verdict() const;
};

/// How a fit ended.
enum class FitStatus {
  converged,
  iteration_limit,  ///< the parameters are the best found
  rank_deficient,   ///< some combination of the constants does not show in the data at all
};

/// "converged", "iteration limit", "rank deficient"
std::string_view in_words(FitStatus status);

}  // namespace swayaw::identification
