#pragma once

#include "commands.hpp"
#include "swayaw/core/recording.hpp"

/// Files of `swayaw simulate`, for ships of all models.
namespace swayaw::app {

inline bool wants_files(const SimulateArguments& a) { return !a.out.empty() || !a.svg.empty(); }

/// Writes the files that were asked for. The plot is drawn first: without gnuplot nothing is written.
void write_files(const Recording& run, const SimulateArguments& a);

}  // namespace swayaw::app
