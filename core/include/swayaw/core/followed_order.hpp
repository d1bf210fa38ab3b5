#pragma once

#include <span>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/core/steering_gear.hpp"

/// The angle of a rudder of which only the order was recorded.
namespace swayaw::inline core {

/// Angles [rad] of a rudder that follows orders [rad] given at these times [s], each from the time before; it begins at
/// the first of them.
std::vector<double> followed_order(const SteeringGear<double>& gear, std::span<const double> times,
                                   std::span<const double> orders);

/// A run that tells the ordered angle alone, with that of a rudder that follows it, missing where the order is; any
/// other run as it is.
Recording with_followed_order(Recording run, const SteeringGear<double>& gear);

}  // namespace swayaw::core
