#pragma once

#include "random_ships.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::test {

/// The windage of a laden ship of that length.
inline Windage<double> windage_of(double L) {
  return *windage_from({.frontal = 0.02 * L * L, .lateral = 0.08 * L * L, .length = L});
}

/// A model tank ship, the same to either side, that shows the wind an area, with parameters that are known to 2 %.
inline Ship symmetric_ship() {
  Ship ship = kvlcc2_l7();
  auto& model = std::get<MmgShip<double>>(ship.model);
  model.propeller.C_2_negative = model.propeller.C_2_positive;
  model.rudder.gamma_R_negative = model.rudder.gamma_R_positive;
  ship.surroundings.windage = windage_of(length(ship));
  ship.confidence.coefficients = 0.02;
  return ship;
}

}  // namespace swayaw::test
