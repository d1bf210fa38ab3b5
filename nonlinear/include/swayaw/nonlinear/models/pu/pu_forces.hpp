#pragma once

#include <array>

#include "swayaw/nonlinear/models/parts/prime_forces.hpp"
#include "swayaw/nonlinear/models/pu/pu_ship.hpp"

/// Forces of the physics-uninformed model, written once for double, dual and pack.
/// Valid for way ahead, u > 0, and a shaft that turns ahead, or a given thrust (validity.hpp). Source:
/// [Alexandersson2024]
namespace swayaw::inline nonlinear {

/// The sign of beta_P selects the wake change.
template <class S>
std::array<S, 1> branch_functions(const PuShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>&) {
  return {wake_branch_function(ship, motion)};
}

/// Forces split by part, about midship. The rudder holds its interaction with the hull.
template <class S>
struct PuForces {
  PlanarForce<S> hull;
  PlanarForce<S> propeller;
  PlanarForce<S> rudder;

  PlanarForce<S> total() const { return hull + propeller + rudder; }

  std::array<ForcePart<S>, 3> parts() const { return {{{"hull", hull}, {"propeller", propeller}, {"rudder", rudder}}}; }
};

/// All forces, on a given branch.
template <class S>
PuForces<S> forces(const PuShip<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls,
                   const Branch<S, 1>& branch) {
  const auto m = prime_motion(ship, motion);
  return {
      .hull = hull_force(ship.hull, ship.particulars.L, m),
      .propeller =
          propeller_force(ship.propeller, propeller_thrust(ship, controls, propeller_inflow(ship, motion, branch[0]))),
      .rudder = rudder_force(ship.rudder, ship.particulars.L, m, controls.delta),
  };
}

}  // namespace swayaw::nonlinear
