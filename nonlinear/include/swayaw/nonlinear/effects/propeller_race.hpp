#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Race increase factor kappa, as it is.
template <class S = double>
struct RaceOnRudder {
  S kappa{unchanged};

  static constexpr std::string_view id = "propeller_race";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "another race on the rudder",
                                   .label = "propeller race on the rudder",
                                   .law = "another value (MMG)",
                                   .confused_with = "rudder effectiveness → step of shaft speed"};

  static constexpr auto parameters() {
    return std::array{other_value<RaceOnRudder, S>("kappa", &RaceOnRudder::kappa, "rudder", "kappa", {}, non_negative)};
  }
};

}  // namespace swayaw::nonlinear
