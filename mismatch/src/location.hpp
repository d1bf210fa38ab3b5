#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swayaw/mismatch/diagnose.hpp"
#include "trial.hpp"

/// Where in the runs, and where in the motion, force is missing. Not installed.
namespace swayaw::inline mismatch::detail {

/// What the missing force goes with.
struct Located {
  std::vector<MismatchPlace> places;  ///< one for each run
  std::string symmetry;               ///< in words; empty if it follows the motion alone
};

/// @param ship  the refitted baseline
Located located(const Trial& trial, const Ship& ship, const Noise& noise);

/// From when to when most of the missing force acts in the middle of the runs, if more than half of them agree with
/// that within a length of way [s]. Noise, or waves, may lengthen it in some.
std::optional<std::pair<double, double>> common_interval(const Located& located, double time_unit);

}  // namespace swayaw::mismatch::detail
