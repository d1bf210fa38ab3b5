#pragma once

#include <optional>
#include <string>

#include "swayaw/core/recording.hpp"

namespace swayaw::inline identification::detail {

/// What a sway was made of if it was not measured: "a constant", "the yaw rate", "the slope of the positions". It is,
/// where so little is left of it that not even the noise of what it was made of is its own.
///
/// @param run  measured samples
std::optional<std::string> sway_made_of(const Recording& run, Channel surge, Channel sway);

}  // namespace swayaw::identification::detail
