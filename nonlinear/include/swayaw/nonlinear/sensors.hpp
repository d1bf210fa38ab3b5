#pragma once

#include <span>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/effects.hpp"

/// What the instruments make of a motion. Effects that are not of sensors are passed over.
namespace swayaw {

/// A true run as her instruments record it.
///
///     psi, r: plus the bias        u, speed through the water: times the scale
///     x, y: of the antenna, p + R(psi) l        velocity over ground: of the antenna, plus r × l
///     a late channel: the value of delay_s ago, by straight lines between the samples, drawn on beyond the first and
///     the last
Recording as_recorded(Recording truth, std::span<const Effect> effects);

/// A recorded run without what the instruments did to it: the inverse.
Recording as_it_was(Recording recorded, std::span<const Effect> effects);

}  // namespace swayaw
