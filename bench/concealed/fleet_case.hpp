#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/mismatch/fleet.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Fleets of sisters over a year, as they bring their recordings home, in which something changes on some of them.
/// docs/results/fleets.md
namespace swayaw::concealed {

/// What changes on a vessel.
struct TrueChange {
  std::string effect;  ///< as in ship files
  ChangeShape shape;
  double size;   ///< of the parameter, at the end; SI
  double since;  ///< days since 1970
};

struct FleetCase {
  std::string structure;  ///< of the ships
  Ship ship;              ///< the file: fitted to the class, wrong by its confidence
  std::vector<FleetRun> runs;
  std::vector<std::optional<TrueChange>> changes;  ///< by vessel; nothing where nothing changes
  std::vector<std::string> vessels;
};

/// Two to four sisters that differ by 2 %, six to twelve days each over a year and two runs a day, weather and errors
/// of instruments as on board; something changes on about half of them, none in a fleet with an even seed where
/// `quiet`.
FleetCase fleet_by_chance(std::uint64_t seed, bool quiet = false);

}  // namespace swayaw::concealed
