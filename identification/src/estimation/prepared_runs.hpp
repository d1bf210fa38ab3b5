#pragma once

#include "swayaw/identification/map_fit.hpp"

/// Runs made ready for a fit, step by step. Not installed.
namespace swayaw::inline identification::detail {

/// All that instruments measured, with the noise of each channel.
std::vector<PreparedRun> runs_with_all_samples(const Ship& ship, std::span<const Recording> runs,
                                               std::span<const Channel> channels);

/// One heel in four L/U. It follows from the motion by an equation without process noise; what that leaves out lasts as
/// long as the motion, so that heels in between repeat one another's errors. Of 28 ships of another structure that roll
/// as their files do not say, nothing else hidden, eight seemed to have an antenna off midship with all heels, four of
/// six of those with one in each L/U, none of six with one in four.
void thin_heel(PreparedRun& run, double time_unit);

}  // namespace swayaw::identification::detail
