#pragma once

#include <string_view>

namespace swayaw::inline core {

/// Whether these words name a drive that steers by turning its thrust: azimuth thruster, pod, Z-drive, Voith-Schneider
/// propeller or water jet. No model here has one.
bool names_steered_thrust(std::string_view words);

/// What is said of such a drive.
inline constexpr std::string_view no_steered_thrust =
    "steers by turning its thrust; every model here has rudders behind propellers, and would put down to a rudder what "
    "is thrust. Such a ship is not simulated, estimated or identified";

}  // namespace swayaw::core
