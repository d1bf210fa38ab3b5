#pragma once

#include "swayaw/nonlinear/models/pi/pi_forces.hpp"
#include "swayaw/nonlinear/models/pu/pu_forces.hpp"

namespace swayaw::inline nonlinear {

/// Rudder amidships and what carries the ship straight ahead at that speed: the shaft speed where the propeller has an
/// open-water curve, else the thrust, equal on both sides.
///
///     X_H + X_R + (1 − t) T + push = 0   at v = r = delta = 0; the drag X_R of the rudders depends on the thrust
///
/// @param push  of whatever else acts on her, positive ahead [N]
/// @throws std::domain_error  if the speed is not positive
/// @throws Refusal            if nothing balances the resistance
Controls<double> self_propulsion(const PiShip<double>& ship, double speed, double push = 0.0);
Controls<double> self_propulsion(const PuShip<double>& ship, double speed, double push = 0.0);

/// Whether the propeller has an open-water curve.
inline bool takes_shaft_speed(const PiShip<double>& ship) { return ship.propeller.has_open_water_curve(); }
inline bool takes_shaft_speed(const PuShip<double>& ship) { return ship.propeller.has_open_water_curve(); }

}  // namespace swayaw::nonlinear
