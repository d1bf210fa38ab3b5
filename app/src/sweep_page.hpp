#pragma once

#include "swayaw/app/page.hpp"
#include "swayaw/app/sweep/reduce.hpp"
#include "swayaw/app/sweep/run.hpp"
#include "user_units.hpp"

namespace swayaw::app {

/// The results of a sweep, a picture for the first ships and results.
Page sweep_page(const SweepWork& work, const SweepSummary& summary, const SweepCount& count, double seconds,
                const std::filesystem::path& results, const UserUnits& units);

/// "overshoot_1_deg" as people say it: "overshoot 1".
std::string spoken(const SweepColumn& column);

/// "zigzag 10/10", "turn 35", "indices"
std::string task_words(const SweepPlan& plan);

}  // namespace swayaw::app
