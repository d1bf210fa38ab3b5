#pragma once

#include <string>

#include "swayaw/app/page.hpp"
#include "swayaw/mismatch/fleet.hpp"
#include "user_units.hpp"

namespace swayaw::app {

/// "ship_2", "rudder offset", "+1.20 ± 0.05 deg since 2026-03-04" and so on, worst first: what all views of a fleet
/// tell of what was found.
struct FleetLine {
  std::string vessel, what, size, since, interval, probability;
  double floors;
};
std::vector<FleetLine> lines_of(const FleetDiagnosis& diagnosis, const UserUnits& units);

/// @param ship  name of the class
Page fleet_page(const FleetDiagnosis& diagnosis, const std::string& ship, const UserUnits& units);

}  // namespace swayaw::app
