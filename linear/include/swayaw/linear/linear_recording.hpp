#pragma once

#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/linear/dimensional.hpp"
#include "swayaw/linear/zigzag.hpp"

namespace swayaw::inline linear {

/// A motion in legs as a recording of samples every `step` seconds from t = 0: heading, yaw rate, rudder, the track
/// from the origin, and the velocity of a constant speed, u = U cos(beta), v = −U sin(beta).
///
/// Ends with the legs, or where |omega'| passes 100: the ship runs away.
///
/// @throws std::domain_error  if there are no legs or the step is not positive
Recording recording_of(const SwayYawCoefficients<double>& ship, std::vector<Leg<double>> legs, const PrimeScale& scale,
                       double step);

}  // namespace swayaw::linear
