#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../trial/trial.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// Where in the runs, and where in the motion, force is missing. Not installed.
namespace swayaw::inline mismatch::detail {

/// What the missing force goes with.
struct Located {
  std::vector<MismatchPlace> places;                  ///< one for each run
  std::optional<std::pair<double, double>> most{};    ///< between what times most force is missing in all runs [s]
  std::optional<std::pair<double, double>> common{};  ///< the same where it is missing there in each of them
  std::string symmetry;                               ///< in words; empty if it follows the motion alone
};

/// @param ship  the refitted baseline
Located located(const Trial& trial, const Ship& ship, const Noise& noise);

}  // namespace swayaw::mismatch::detail
