#pragma once

#include <array>
#include <optional>

#include "swayaw/core/channel.hpp"

namespace swayaw {

/// The channels that measure the motion of a ship. Speed over ground and course are nonlinear in her state.
inline constexpr std::array<Channel, 11> measured_channels{Channel::x,
                                                           Channel::y,
                                                           Channel::psi,
                                                           Channel::u,
                                                           Channel::v,
                                                           Channel::u_ground,
                                                           Channel::v_ground,
                                                           Channel::speed_through_water,
                                                           Channel::speed_over_ground,
                                                           Channel::course_over_ground,
                                                           Channel::r};

/// Standard deviation of white measurement noise, channel by channel, SI; nothing where it is to be estimated.
using MeasurementNoise = std::array<std::optional<double>, channel_count>;

}  // namespace swayaw
