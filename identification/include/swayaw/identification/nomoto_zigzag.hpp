#pragma once

#include "swayaw/core/recording.hpp"

namespace swayaw::inline identification {

/// First-order equation T dr/dt + r = K (delta + delta_r), rudder positive to port, so K is negative for a stable ship.
struct NomotoZigzag {
  double K;               ///< [1/s]
  double T;               ///< [s]
  double delta_r;         ///< rudder offset: recorded angle plus this acts [rad]
  std::size_t intervals;  ///< used
  double residual;        ///< rms of the heading changes left unexplained [rad]
};

/// Nomoto's analysis of a zigzag. Integrated from t1 to t2 the equation reads
///
///     T [r] + [psi] = K (∫ delta dt + delta_r (t2 − t1))
///
/// Between heading peaks [r] vanishes and K and delta_r remain; between passages through the mean heading [psi]
/// vanishes and T remains. All intervals between successive peaks and between successive passages are solved together
/// by least squares, so that samples next to a peak or a passage serve as well. The yaw rate is recorded, or the slope
/// of the heading over three samples.
///
/// Valid for a ship of first order. One of second order has on the right K T3 [delta] and on the left T1 T2 [dr/dt] and
/// T1 + T2 for T: K comes out too small in magnitude where T3 > T1 T2/T, and T with it. Source: [Nomoto1960]
///
/// @throws Refusal  if the run does not tell rudder or heading, or has fewer than three heading peaks
NomotoZigzag nomoto_zigzag_analysis(const Recording& run);

}  // namespace swayaw::identification
