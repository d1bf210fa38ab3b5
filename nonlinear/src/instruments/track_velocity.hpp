#pragma once

#include <optional>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// Velocity through the water from a recorded track. Not installed.
namespace swayaw::inline nonlinear::detail {

/// Surge and sway.
struct SurgeSway {
  double u, v;  ///< [m/s]
};

/// Velocity through the water at `time` that explains the positions in [from, to] best, in least squares. With t from
/// `time` on and ψ as recorded,
///
///     x − V_c cos(psi_c) t = x_0 + ∫ (u + u̇ t) cos ψ − (v + v̇ t) sin ψ dt
///     y − V_c sin(psi_c) t = y_0 + ∫ (u + u̇ t) sin ψ + (v + v̇ t) cos ψ dt
///
/// so a ship that turns is told as well as one on a straight course.
///
/// @param degree  2 as written, 1 without u̇ and v̇; lowered where there are fewer than four positions
/// @return nothing with fewer than two positions
std::optional<SurgeSway> velocity_from_track(const Recording& run, const Current<double>& current, double time,
                                             double from, double to, int degree);

}  // namespace swayaw::nonlinear::detail
