#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// What the rudder induces on the hull, as it is.
template <class S = double>
struct RudderHullInteraction {
  S a_H{unchanged}, x_H{unchanged};

  static constexpr std::string_view id = "rudder_hull_interaction";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "another rudder-hull interaction",
                                   .label = "rudder–hull interaction",
                                   .law = "other values; x_H as the model counts it",
                                   .confused_with = "rudder effectiveness"};

  static constexpr auto parameters() {
    using R = RudderHullInteraction;
    return std::array{other_value<R, S>("a_H", &R::a_H, "rudder", "a_H"),
                      other_value<R, S>("x_H", &R::x_H, "rudder", "x_H_prime", "x_H")};
  }
};

}  // namespace swayaw::nonlinear
