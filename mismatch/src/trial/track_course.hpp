#pragma once

#include <optional>
#include <span>

#include "swayaw/identification/map_fit.hpp"

/// Where a ship points and where she goes. Not installed.
namespace swayaw::inline mismatch::detail {

/// Recorded heading less the course of the track, where she holds her course [rad]: the median over stretches of a time
/// unit in which the heading stays within 3 deg. A stream or a wind turns it one way on one course and the other way on
/// the opposite; an error of the compass, and a force from side to side, the same on all.
/// @param time_unit  L/U [s]
/// @return nothing where no run has positions and heading, or she does not hold courses 60 deg apart
std::optional<double> heading_off_track(std::span<const PreparedRun> runs, double time_unit);

}  // namespace swayaw::mismatch::detail
