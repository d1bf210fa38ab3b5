#pragma once

#include <optional>
#include <string>

#include "swayaw/app/page.hpp"
#include "swayaw/linear/linear_ship.hpp"

namespace swayaw::app {

/// Small motions of a ship; where the forces have a kink straight ahead, those of turns to each side besides.
struct SteeringSides {
  LinearShip mean;
  std::optional<LinearShip> port, starboard;
};

/// What her steering indices say: stability on course, and how soon and how much she turns by the rudder.
///
/// @param file   of the ship
/// @param speed  [m/s]
Page indices_page(const SteeringSides& sides, const std::string& file, double speed, bool si);

}  // namespace swayaw::app
