#pragma once

#include <algorithm>
#include <string_view>

#include "random_ships.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::test {

/// The L7 model of KVLCC2, whose coefficients are known to 2 %.
inline Ship well_known_ship() {
  Ship ship = kvlcc2_l7();
  ship.confidence.coefficients = 0.02;
  return ship;
}

/// An effect of a diagnosis; nullptr if it was not found.
inline const FoundEffect* found(const Diagnosis& d, std::string_view id) {
  const auto effect = std::ranges::find(d.effects, id, [](const FoundEffect& e) { return id_of(e.effect); });
  return effect == d.effects.end() ? nullptr : &*effect;
}

}  // namespace swayaw::test
