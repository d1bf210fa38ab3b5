#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "swayaw/app/sweep/work.hpp"
#include "varied_ship.hpp"

/// What is done with the ships of a block. Not seen outside the sweep.
namespace swayaw::app {

std::vector<SweepColumn> results_of(const SweepPlan& plan);

/// How many items make a block: some milliseconds of work.
std::size_t block_size_of(const SweepPlan& plan, const VariedShip& ship);

/// Fills the results of a block, whose parameters are filled already.
void fill_results(const SweepPlan& plan, const VariedShip& ship, SweepBlock& block);

}  // namespace swayaw::app
