#pragma once

#include <vector>

#include "swayaw/linear/zigzag.hpp"

namespace swayaw::inline linear {

/// Where the ship is, in ship lengths from the start of the first leg.
struct TrackPoint {
  double x;    ///< to the north
  double y;    ///< to the east
  double psi;  ///< heading [rad]
};

/// Way made good along a leg from its start for `length` ship lengths, at constant speed. The course is psi − beta:
///
///     x/L = ∫ cos(psi − beta) ds',   y/L = ∫ sin(psi − beta) ds'
///
/// by Gauss–Legendre quadrature, the interval halved until whole and halves agree to 1e-14, at most 16 times.
TrackPoint run_along(const LinearResponse<double>& ship, const Leg<double>& leg, double length);

/// Track through legs that follow each other, of a zigzag or a rudder history, at the given times in any order.
/// @throws std::domain_error  if there are no legs, or a time is before the first or after the last
std::vector<TrackPoint> track(const LinearResponse<double>& ship, const std::vector<Leg<double>>& legs,
                              const std::vector<double>& times);

}  // namespace swayaw::linear
