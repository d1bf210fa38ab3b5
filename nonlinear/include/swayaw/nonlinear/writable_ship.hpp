#pragma once

#include <string>
#include <vector>

#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::inline nonlinear {

/// A ship whose numbers all lie in the ranges of the ship file, and what had to give way for that.
struct WritableShip {
  Ship ship;
  std::vector<std::string> changed;  ///< "m_y = -0.208 was found, which no ship file holds; 0.223 stands there"
};

/// The ship as a file can hold her. A fit knows of no range: a number that lies outside, or is not finite, gives way to
/// that of the ship the fit began with; one of an effect to the nearest that is allowed.
///
/// @param beginning  of the same model
WritableShip writable(const Ship& found, const Ship& beginning);

}  // namespace swayaw::nonlinear
