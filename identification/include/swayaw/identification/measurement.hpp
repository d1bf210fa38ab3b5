#pragma once

#include <array>
#include <optional>
#include <vector>

#include "swayaw/core/channel.hpp"

namespace swayaw::inline identification {

/// The channels that estimates of states and trajectory fits compare: those that show the motion, without heel.
inline std::vector<Channel> measured_channels() {
  const auto all = motion_channels();
  std::vector<Channel> channels(all.begin(), all.end());
  std::erase(channels, Channel::phi);
  return channels;
}

/// Standard deviation of white measurement noise, channel by channel, SI; nothing where it is to be estimated.
using MeasurementNoise = std::array<std::optional<double>, channel_count>;

}  // namespace swayaw::identification
