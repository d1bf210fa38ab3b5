#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "swayaw/core/motion.hpp"
#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/models/controls.hpp"

/// What every force model of the nonlinear floor shares. A model XShip<S> comes with
///
///     branch_functions(ship, motion, controls)   the force has a kink or a jump where one of them passes zero
///     forces(ship, motion, controls, branch)     smooth on a branch; split by part
///     acceleration(ship, motion, force)          affine in the force
///     thrust(ship, motion, controls)             of all propellers
///     rigid_body(ship)                           mass without entrained water
///
/// Why the branch is an argument: docs/decisions/001
namespace swayaw::inline nonlinear {

/// Which of the branch functions are positive.
template <class S, std::size_t N>
using Branch = std::array<Mask<S>, N>;

/// The branch that belongs to a motion.
template <template <class> class Ship, class S>
Branch<S, Ship<S>::branch_count> branch_at(const Ship<S>& ship, const PlanarMotion<S>& motion,
                                           const Controls<S>& controls) {
  const auto g = branch_functions(ship, motion, controls);
  Branch<S, Ship<S>::branch_count> branch{};
  for (std::size_t i = 0; i < g.size(); ++i) branch[i] = g[i] > S(0.0);
  return branch;
}

/// Mass of the ship herself, without entrained water.
struct RigidBody {
  double m;    ///< [kg]
  double x_G;  ///< centre of gravity forward of midship [m]
  double I_z;  ///< moment of inertia about midship [kg m^2]
};

/// Forces split by part, on the branch of the motion.
template <template <class> class Ship, class S>
auto forces(const Ship<S>& ship, const PlanarMotion<S>& motion, const Controls<S>& controls) {
  return forces(ship, motion, controls, branch_at(ship, motion, controls));
}

/// The force of one part of a ship.
template <class S = double>
struct ForcePart {
  std::string_view name;  ///< as in the output of `swayaw forces`
  PlanarForce<S> force;
};

}  // namespace swayaw::nonlinear
