#pragma once

#include <cstddef>
#include <vector>

#include "swayaw/app/sweep/work.hpp"

/// What is done with recordings. Not seen outside the sweep.
namespace swayaw::app {

std::vector<SweepColumn> results_of_case(const SweepPlan& plan);

/// One case, by the program itself in a process of its own: whatever becomes of it, the sweep goes on.
SweepBlock block_of_case(const SweepPlan& plan, std::size_t place);

}  // namespace swayaw::app
