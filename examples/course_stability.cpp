// Is the ship stable on a straight course? The derivatives of sway force and yaw moment by sway and yaw rate come from
// the force functions themselves, evaluated with dual numbers.
#include <fmt/format.h>

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace {

using namespace swayaw;

/// Product of the two poles of sway and yaw; negative when a small disturbance grows.
/// The flow straightening of the rudder differs between the sides, so the ship is looked at just beside straight ahead.
double product_of_poles(const MmgShip<double>& parameters, double drift) {
  using D = Dual<2>;
  const double U = parameters.particulars.U_0, n = self_propulsion_rev(parameters, U);
  const PlanarMotion<D> motion{D(U), D(-U * drift, 0), D(0.0, 1)};
  const auto ship = cast<D>(parameters);
  const auto a = acceleration(ship, motion, forces(ship, motion, Controls<D>{D(0.0), D(n)}).total());
  return a.v.v[0] * a.r.v[1] - a.v.v[1] * a.r.v[0];
}

}  // namespace

int main(int, char** arguments) {
  const Ship ship = read_ship(arguments[1]);
  const auto& parameters = std::get<MmgShip<double>>(ship.model);
  for (const auto& [side, drift] : {std::pair{"starboard", 1e-9}, std::pair{"port", -1e-9}}) {
    const double product = product_of_poles(parameters, drift);
    fmt::print("{}, bow just to {}: product of the poles {:+.2e} 1/s2, {}\n", ship.name, side, product,
               product > 0.0 ? "stable" : "unstable");
  }
}
