#pragma once

#include <optional>
#include <vector>

#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/zigzag.hpp"

/// The closed curve that a zigzag draws in the plane of drift angle and yaw rate omega'. A first-order ship draws a
/// line; the loop shows T3b and T3w.
namespace swayaw::inline linear {

/// Measures of a loop. Length, width and inclination are those of the ellipse with the same area moments of second
/// order.
template <class S = double>
struct LoopMeasures {
  S area;                ///< |∮ beta d(omega')| [rad]
  S length;              ///< long axis
  S width;               ///< short axis
  S inclination;         ///< of the long axis from the beta axis towards omega' [rad]
  S beta_max;            ///< largest |beta| [rad]
  S omega_max;           ///< largest |omega'|
  S omega_at_beta_zero;  ///< |omega'| where beta passes zero, the largest of several
  S beta_at_omega_zero;  ///< |beta| where omega' passes zero, the largest of several [rad]
  S distance_from_line;  ///< root mean square in time, from the first-order line omega' = (Kw/Kb) beta
};

/// The loop of the last full cycle of a zigzag, from the last reversal but two to the last; an open one is closed by
/// its chord.
///
/// @return nothing with fewer than three reversals
std::optional<LoopMeasures<double>> drift_yaw_loop(const SwayYawCoefficients<double>& ship,
                                                   const LinearZigzag<double>& zigzag);

/// A zigzag sailed until each reversal repeats the one before on the other side.
struct LimitCycle {
  LinearZigzag<double> zigzag;
  bool settled;  ///< whether it repeats to 1e-12
};

/// @param longest_reversals  when to give up
LimitCycle limit_cycle(const SwayYawCoefficients<double>& ship, LinearZigzagOrder order,
                       std::size_t longest_reversals = 400);

/// Loop and overshoots with their derivatives by T3b and T3w, the other indices held.
struct LoopSensitivity {
  LoopMeasures<double> value, by_T3b, by_T3w;
  std::vector<double> overshoot, overshoot_by_T3b, overshoot_by_T3w;  ///< [rad], one for each reversal
  double period, period_by_T3b, period_by_T3w;                        ///< [ship lengths]
  bool settled;                                                       ///< the loop is the limit cycle
};

/// Exact derivatives by dual numbers through the inverse formulas, the zigzag and the loop.
///
/// @return nothing when the zigzag has fewer than three reversals
/// @throws std::domain_error  if T3b = T3w, where no such ship exists
std::optional<LoopSensitivity> loop_sensitivity(const SteeringIndices<double>& indices, const LinearZigzagOrder& order);

}  // namespace swayaw::linear
