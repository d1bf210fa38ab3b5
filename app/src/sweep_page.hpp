#pragma once

#include "swayaw/app/page.hpp"
#include "swayaw/app/sweep/reduce.hpp"
#include "swayaw/app/sweep/run.hpp"
#include "user_units.hpp"

namespace swayaw::app {

/// Words and how often they come, most often first.
using WordCounts = std::vector<std::pair<std::string, std::size_t>>;

/// What there is to tell when a sweep is done.
struct Swept {
  SweepSummary summary;
  SweepCount count;
  double seconds;
  std::vector<std::pair<std::size_t, std::string>> notes;  ///< the first ones
  std::size_t note_count;
  WordCounts verdicts{}, first_effects{};  ///< of diagnoses
};

/// The results of a sweep, a picture for the first ships and results.
Page sweep_page(const SweepWork& work, const Swept& swept, const std::filesystem::path& results,
                const UserUnits& units);

/// "overshoot_1_deg" as people say it: "overshoot 1".
std::string spoken(const SweepColumn& column);

/// "zigzag 10/10", "turn 35", "indices"
std::string task_words(const SweepPlan& plan);

}  // namespace swayaw::app
