#pragma once

#include <array>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/parameter.hpp"

namespace swayaw {

/// How fast and how far the rudder moves.
template <class S = double>
struct SteeringGear {
  S rate;       ///< [rad/s]
  S max_angle;  ///< [rad]

  static constexpr auto parameters() {
    using P = Parameter<SteeringGear, S>;
    constexpr double degree = pi / 180.0;
    return std::array{
        P{.key = "rate_deg_s", .member = &SteeringGear::rate, .unit = "deg/s", .range = positive, .si = degree},
        P{.key = "max_angle_deg", .member = &SteeringGear::max_angle, .unit = "deg",
          .range = {.low = 0.0, .high = 90.0, .above_low = true}, .si = degree},
    };
  }
};

/// @throws std::domain_error  if an ordered angle [rad] is not positive or beyond the largest
void require_rudder(double angle, const SteeringGear<double>& gear);

}  // namespace swayaw
