#pragma once

#include <cmath>

#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

namespace swayaw::test {

/// The same ship n times as long: times grow with the square root of n.
inline MmgShip<double> froude_scaled(MmgShip<double> ship, double n) {
  const double root = std::sqrt(n);
  auto& p = ship.particulars;
  for (double* length : {&p.L, &p.B, &p.d, &p.x_G, &p.k_zz, &ship.propeller.D, &ship.rudder.H_R}) *length *= n;
  p.nabla *= n * n * n;
  for (double* area : {&p.A_front, &p.A_lateral, &ship.rudder.A_R}) *area *= n * n;
  p.U_0 *= root;
  ship.steering_gear.rate /= root;
  return ship;
}

}  // namespace swayaw::test
