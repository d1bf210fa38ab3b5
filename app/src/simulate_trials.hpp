#pragma once

#include "commands.hpp"
#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::app {

/// `swayaw simulate` with spirals, pull-outs, the Williamson turn and the IMO criteria: writes and prints.
void run_trial(const Ship& ship, const SimulateArguments& arguments);

}  // namespace swayaw::app
