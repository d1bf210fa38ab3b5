#pragma once

#include <span>

#include "commands.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Wind and depth as measured: which of it a command is to use, and what of it cannot be used.
namespace swayaw::app {

/// The recording without what is to be ignored.
Recording without(Recording run, const Ignored& ignored);

/// One line on stderr for each run with wind or depth that cannot act on the ship: what would be needed.
void tell_in_vain(const Ship& ship, std::span<const Recording> runs);

}  // namespace swayaw::app
