#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "swayaw/app/sweep/work.hpp"

/// What is done with recordings. Not seen outside the sweep.
namespace swayaw::app {

std::vector<SweepColumn> results_of_case(const SweepPlan& plan);

/// What the JSON of the command says of a case; a note in place of numbers where it is none.
SweepBlock block_of_document(const SweepPlan& plan, std::size_t place, std::string_view text);

/// One case, by the program itself in a process of its own: whatever becomes of it, the sweep goes on.
SweepBlock block_of_case(const SweepPlan& plan, std::size_t place);

}  // namespace swayaw::app
