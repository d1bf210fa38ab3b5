#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "swayaw/core/recording.hpp"

namespace swayaw::inline identification {
struct RunCheck;
}

namespace swayaw::app {

std::vector<Recording> loaded_runs(const std::vector<std::filesystem::path>& files, std::string_view rudder_positive);

/// What becomes of runs with too few samples for a check.
enum class ShortRuns { refused, passed_over };

/// One for each run.
///
/// @throws Refusal  of a run that is too short, unless it is passed over
std::vector<RunCheck> checks_of(const std::vector<Recording>& runs, ShortRuns short_runs);

/// Recordings whose instruments were checked by kinematics; what was found of each is told in one line on stderr.
///
/// @throws Refusal  "FILE: what is wrong; what to do", if a sign or a unit is wrong beyond doubt
std::vector<Recording> checked_runs(const std::vector<std::filesystem::path>& files, const Reading& reading);

}  // namespace swayaw::app
