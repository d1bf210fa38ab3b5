#pragma once

#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/surroundings/recorded_surroundings.hpp"

namespace swayaw::inline nonlinear {

/// Changes of a ship in a recorded wind, whose velocity adds to that of the wind of her effects.
/// @param before  what acts before the first of her own changes
/// @param wind    not empty
/// @return the first of them as of −infinity
std::vector<Change> changes_in_wind(const Change& before, std::span<const Change> own, std::span<const WindPiece> wind);

/// What acts on a ship in a recorded wind, which may be empty: the first as of −infinity, and what changes it.
std::vector<Change> all_changes(const Ship& ship, std::span<const WindPiece> wind);

/// The ship in a recorded wind; as she is where it is empty.
template <class Model>
ActingShip<Model> in_wind(ActingShip<Model> acting, std::span<const WindPiece> wind) {
  if (wind.empty()) return acting;
  const Change before{-std::numeric_limits<double>::infinity(), acting.surroundings.wind, acting.surroundings.windy,
                      acting.added.acting};
  acting.changes = changes_in_wind(before, acting.changes, wind);
  acting.changes.front().apply(acting.surroundings, acting.added);
  acting.changes.erase(acting.changes.begin());
  return acting;
}

}  // namespace swayaw::nonlinear
