#pragma once

#include "commands.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Files of `swayaw simulate`, for ships of all models.
namespace swayaw::app {

inline bool wants_files(const SimulateArguments& a) { return !a.out.empty() || !a.svg.empty(); }

/// Writes the files that were asked for. The plot is drawn first: without gnuplot nothing is written.
void write_files(const Recording& run, const SimulateArguments& a);

/// The same for a nonlinear ship, with forces by part if they were asked for.
void write_run(Recording& run, const Ship& ship, const SimulateArguments& a);

}  // namespace swayaw::app
