#pragma once

#include <string_view>
#include <vector>

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

/// What ship files are written for.
enum class FileForm { mmg, pi, abkowitz };
std::string_view name_of(FileForm form);

/// The file of a ship of any structure in a form, for cases as on board. From the fair MMG file, taken over into the
/// terms of the form, every coefficient of hull and rudder is moved to the least squares of the accelerations that the
/// ship passes through in the same trials. `residue` is that of the accelerations, over those that the hull's force
/// gives.
FairShip fair_ship(const TrueShip& truth, FileForm form, double confidence);

/// A state that a ship passes through.
struct TruePoint {
  States state;
  Moment moment;
};

/// Every 0.16 L/U of zigzags 10/10 and 20/20 and turns with 20 and 35 deg to both sides, with nothing hidden.
std::vector<TruePoint> trial_points(const TrueShip& truth);

/// A fit knows a force, not each of its terms: a term of the hull that is small in a turn with v' = 0.25 and r' = 0.5
/// is trusted to the same share of the largest one of its force.
Confidence confidence_of(const Ship& ship, double least);

/// The same with every coefficient wrong by a normal deviate of its confidence.
Ship slightly_wrong(const Ship& ship, std::uint64_t seed);

}  // namespace swayaw::concealed
