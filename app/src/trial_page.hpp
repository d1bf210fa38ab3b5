#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swayaw/app/page.hpp"
#include "trial_table.hpp"

namespace swayaw::app {

/// What the page of judged recordings is told besides them.
struct TrialQuestion {
  std::string ship;         ///< simulated beside; empty: none
  std::optional<double> L;  ///< length used [m]
  std::string L_source;     ///< "of the ship file"
  bool si = false;
  std::optional<double> only_speed{};     ///< of a ship that is not simulated at that of the recording [m/s]
  std::vector<std::string> not_judged{};  ///< why runs were left out
};

/// What the page says first: the criteria, how sure they are, what was not sailed.
Page first_screen(const std::vector<JudgedRun>& runs, const TrialQuestion& question);

}  // namespace swayaw::app
