#pragma once

#include <array>

#include "swayaw/core/channel.hpp"

namespace swayaw {

/// What no model and no instrument gets right, found by likelihood.
struct Noise {
  double scale = 1.5;                            ///< of the ordinary imperfection
  std::array<double, channel_count> factor{};    ///< on the noise of each channel, 1 where third differences tell all of it

  Noise() { factor.fill(1.0); }
  bool operator==(const Noise&) const = default;
};

}  // namespace swayaw
