#pragma once

#include <optional>
#include <span>

namespace swayaw::inline core::detail {

/// How large a recorded yaw rate is against the change of a recorded heading, whatever their units: c of
/// c Δψ = ∫ r dt over windows, by least squares. Nothing where the ship does not turn enough to tell.
/// @param psi  heading; a jump of more than half of `turn` counts the short way
std::optional<double> yaw_rate_ratio(std::span<const double> time, std::span<const double> psi, double turn,
                                     std::span<const double> r);

/// Mean of speeds along a track in metres, or in degrees of latitude and longitude [m/s].
std::optional<double> track_speed(std::span<const double> time, std::span<const double> x, std::span<const double> y,
                                  bool in_degrees);

}  // namespace swayaw::core::detail
