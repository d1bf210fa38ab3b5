#pragma once

#include "swayaw/nonlinear/ship.hpp"
#include "true_ship.hpp"

/// The ship file that a diagnosis is given: the MMG model that comes nearest to the true forces.
namespace swayaw::concealed {

struct FairShip {
  Ship ship;
  PlanarForce<double>
      residue;  ///< root mean square of the error of the whole force over that of the hull's force, in the trials
};

/// Least squares, part by part (hull, propeller with its wake, rudder): first over a grid of drift, yaw rate, rudder
/// and speed, then, from there and only as far as trials tell, over what the ship passes through in zigzags 10/10 and
/// 20/20 and turns with 20 and 35 deg to both sides.
///
/// @param confidence  relative, of every coefficient; of a hull term that is small beside the largest one of its force,
/// that share of the largest
FairShip fair_ship(const TrueShip& truth, double confidence);

/// The same with every coefficient wrong by a normal deviate of its confidence.
Ship slightly_wrong(const Ship& ship, std::uint64_t seed);

}  // namespace swayaw::concealed
