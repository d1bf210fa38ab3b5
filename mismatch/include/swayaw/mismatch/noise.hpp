#pragma once

#include <algorithm>
#include <array>

#include "swayaw/core/channel.hpp"

namespace swayaw {

/// What no model and no instrument gets right, found by likelihood.
struct Noise {
  double scale = 1.5;  ///< of the ordinary imperfection
  bool apart =
      false;  ///< whether each axis of the imperfection has a size of its own, and the imperfection its own memory
  std::array<double, 3> axes{1.0, 1.0, 1.0};  ///< factors on the scale in surge, sway and yaw
  double memory = 1.0;                        ///< of the imperfection, over L/U
  std::array<double, channel_count>
      factor{};  ///< on the noise of each channel, 1 where third differences tell all of it

  Noise() { factor.fill(1.0); }

  /// Of the axis that is worst.
  double largest_scale() const { return scale * std::ranges::max(axes); }

  bool operator==(const Noise&) const = default;
};

}  // namespace swayaw
