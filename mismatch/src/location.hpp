#pragma once

#include <span>
#include <string>
#include <vector>

#include "swayaw/mismatch/diagnose.hpp"

/// Where in the runs, and where in the motion, force is missing. Not installed.
namespace swayaw {

/// What the missing force goes with.
struct Located {
  std::vector<MismatchPlace> places;  ///< one for each run
  std::string symmetry;               ///< in words; empty if it follows the motion alone
};

/// @param ship  the refitted baseline
Located located(const Ship& ship, std::span<const Recording> runs, const Noise& noise);

}  // namespace swayaw
