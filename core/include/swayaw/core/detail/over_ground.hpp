#pragma once

#include <array>

#include "swayaw/core/channel.hpp"

namespace swayaw::inline core::detail {

/// Velocities that a receiver makes of its own positions: slopes of the same track, as late as it is.
inline constexpr std::array velocities_over_ground{Channel::u_ground, Channel::v_ground, Channel::speed_over_ground,
                                                   Channel::course_over_ground};

}  // namespace swayaw::core::detail
