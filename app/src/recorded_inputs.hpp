#pragma once

#include <span>
#include <string>

#include "commands.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// What a recording tells of all that acts on the ship: what of it a command is to use, what cannot be used, and what
/// is taken in place of what it does not tell.
namespace swayaw::app {

/// The recording without what is to be ignored.
Recording without(Recording run, const Ignored& ignored);

/// One line on stderr for each run with wind or depth that cannot act on the ship: what would be needed.
void tell_in_vain(const Ship& ship, std::span<const Recording> runs);

/// One line on stderr if runs do not tell what propels her: what is assumed (assumed_propulsion).
void tell_propulsion(const Ship& ship, std::span<const Recording> runs);

/// What drives a replay: "the recorded rudder and shaft speed".
std::string drivers(const Ship& ship, const Recording& run);

}  // namespace swayaw::app
