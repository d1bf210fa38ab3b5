#pragma once

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// The part of a recording that force models answer for.
namespace swayaw::app {

/// Why the ship cannot sail the first two ship lengths of the run; empty where she can.
std::string why_not(const Ship& ship, const Recording& run);

/// The part of a run that the ship can sail, its times as recorded; stderr says which part, and why not the rest.
///
/// A run whose models hold throughout (validity.hpp) is given back as it is. Of another, which begins at rest, ends
/// with the ship stopped or has a shaft that turns astern, the part with the most way is used in which she makes
/// `least_way` or more; as it is, too, where no part is two ship lengths long.
Recording with_way_ahead(const Ship& ship, Recording run);

}  // namespace swayaw::app
