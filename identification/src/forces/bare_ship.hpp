#pragma once

#include <fmt/format.h>

#include <string_view>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

namespace swayaw::inline identification::detail {

/// Refuses effects of a ship that a fit does not know: forces, changed parameters and gusts, and those of instruments
/// where `sensors` are not known. Steady wind, current, and what lies between indicator and rudder act.
/// @throws Refusal  naming the effect
inline void require_known_effects(const Ship& ship, std::string_view fit, bool sensors) {
  for (const auto& effect : ship.effects) {
    const auto acts_besides = []<class Kind>(const Kind&) {
      return GivesCurrent<Kind> || (GivesWind<Kind> && !BeginsAndEnds<Kind>) || ActuatesRudder<Kind>;
    };
    const bool is_sensor = place_of(effect) == EffectPlace::sensor,
               known = is_sensor ? sensors : std::visit(acts_besides, effect);
    if (!known && !is_null(effect))
      throw Refusal(fmt::format("the {} does not know {}; take it out of the ship file", fit, id_of(effect)));
  }
}

}  // namespace swayaw::identification::detail
