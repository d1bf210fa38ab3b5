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
};

/// What the page says first: the criteria, how sure they are, what was not sailed.
Page first_screen(const std::vector<JudgedRun>& runs, const TrialQuestion& question);

}  // namespace swayaw::app
