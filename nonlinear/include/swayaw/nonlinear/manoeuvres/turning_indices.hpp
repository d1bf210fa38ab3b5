#pragma once

#include <optional>
#include <span>

#include "swayaw/nonlinear/manoeuvre.hpp"

namespace swayaw::inline nonlinear {

/// Six numbers that tell a turning circle. A turn to port is told as its mirror image to starboard.
/// Source: [Kulbiej2021] section 4.1
struct TurningIndices {
  double u_s;  ///< surge of the steady turn [m/s]
  double v_s;  ///< sway of the steady turn [m/s], negative
  double r_s;  ///< yaw rate of the steady turn [rad/s]
  double D;    ///< diameter of the steady turn over L
  double Ad;   ///< advance over L
  double Td;   ///< tactical diameter over L
};

/// @param L  ship length [m]
/// @return nothing if the ship did not turn by 180 deg, or has no steady turn to settle in
std::optional<TurningIndices> turning_indices(const TurningCircle& circle, double L);

/// How far indices are from measured ones, relative to the measured.
struct IndexError {
  double squares;   ///< Σ (1 − I/I_measured)²
  double absolute;  ///< Σ |1 − I/I_measured|
};

/// Over all six indices of all turns. Source: [Kulbiej2021] section 4.1, whose formula has lost the square that its
/// text names
/// @throws std::domain_error  if the turns are not as many, or a measured index is 0
IndexError index_error(std::span<const TurningIndices> turns, std::span<const TurningIndices> measured);

}  // namespace swayaw::nonlinear
