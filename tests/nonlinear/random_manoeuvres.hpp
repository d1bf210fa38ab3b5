#pragma once

#include "random_ships.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/settling.hpp"

/// What the tests of manoeuvres share.
namespace swayaw::test {

inline Ship with_model(const MmgShip<double>& model) {
  return {.name = "test ship", .model = model, .confidence = {}, .surroundings = {}};
}

/// To both sides what she is to that of negative beta_R; `symmetric` of model_ships.hpp takes the other.
inline MmgShip<double> symmetric_as_negative(MmgShip<double> ship) {
  ship.rudder.gamma_R_positive = ship.rudder.gamma_R_negative;
  ship.propeller.C_2_positive = ship.propeller.C_2_negative;
  return ship;
}

/// U/L [rad/s].
inline double yaw_unit(const MmgShip<double>& ship) { return ship.particulars.U_0 / ship.particulars.L; }

/// Waits until accelerations are far below what a test looks at.
inline constexpr Settling patient{.tolerance = 1e-9, .longest = 2000.0};
inline const ManoeuvreOptions precise{.tolerance = 1e-12, .sampled = false};

}  // namespace swayaw::test
