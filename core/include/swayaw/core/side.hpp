#pragma once

#include <string_view>

namespace swayaw::inline core {

/// Port or starboard.
enum class Side { port, starboard };

/// Sign of a heading change or yaw rate to that side: positive to starboard (z down).
constexpr double yaw_sign(Side side) { return side == Side::starboard ? 1.0 : -1.0; }

/// Sign of the rudder angle that turns the ship to that side: positive to port (SNAME).
constexpr double rudder_sign(Side side) { return -yaw_sign(side); }

constexpr std::string_view name_of(Side side) { return side == Side::starboard ? "starboard" : "port"; }

}  // namespace swayaw::core
