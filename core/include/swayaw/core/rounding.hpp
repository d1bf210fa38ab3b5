#pragma once

#include <cmath>

namespace swayaw::inline core {

/// 1, 2 or 5 times a power of ten, not above x > 0.
inline double round_down(double x) {
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  const double lead = x / decade;
  return decade * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

}  // namespace swayaw::core
