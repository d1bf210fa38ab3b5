#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "swayaw/core/recording.hpp"

namespace swayaw::app {

/// How recordings are read before they are worked with.
struct Reading {
  std::string_view rudder_positive;  ///< "port" or "starboard", whatever the files say; empty: as they say
  bool no_check = false;             ///< instruments are not checked
};

/// Recordings whose instruments were checked by kinematics; what was found of each is told in one line on stderr.
///
/// @throws Refusal  "FILE: what is wrong; what to do", if a sign or a unit is wrong beyond doubt
std::vector<Recording> checked_runs(const std::vector<std::filesystem::path>& files, const Reading& reading);

}  // namespace swayaw::app
