#pragma once

#include <optional>

#include "swayaw/core/channel.hpp"
#include "swayaw/nonlinear/surroundings.hpp"

/// What a channel shows of the state of a ship. Not installed.
namespace swayaw {

/// A channel as a function of state and current, for double and dual.
template <class S>
S shown(Channel channel, const ShipState<S>& s, const Current<S>& current) {
  switch (channel) {
    case Channel::x: return s.x;
    case Channel::y: return s.y;
    case Channel::psi: return s.psi;
    case Channel::r: return s.motion.r;
    case Channel::v: return s.motion.v;
    default: break;
  }
  if (channel == Channel::u || channel == Channel::speed_through_water) return s.motion.u;
  const auto ground = over_ground(current, s);
  if (channel == Channel::u_ground) return ground.u;
  if (channel == Channel::v_ground) return ground.v;
  if (channel == Channel::speed_over_ground) return speed(ground);
  return s.psi + atan2(ground.v, ground.u);  // course over ground
}

inline bool is_direction(Channel channel) { return channel == Channel::psi || channel == Channel::course_over_ground; }

/// Least noise that a channel is credited with: rounding of numbers.
inline double floor_of(Channel channel, double L, double U) {
  switch (channel) {
    case Channel::x:
    case Channel::y: return 1e-7 * L;
    case Channel::psi:
    case Channel::course_over_ground: return 1e-7;
    case Channel::r: return 1e-7 * U / L;
    default: return 1e-7 * U;
  }
}

}  // namespace swayaw
