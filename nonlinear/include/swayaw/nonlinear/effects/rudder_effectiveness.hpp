#pragma once

#include "swayaw/nonlinear/effects/other_values.hpp"

namespace swayaw::inline nonlinear {

/// Lift of the rudder times a factor.
template <class S = double>
struct RudderEffectiveness {
  S factor{1.0};

  static constexpr std::string_view id = "rudder_effectiveness";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "another lift of the rudder",
                                   .label = "rudder effectiveness",
                                   .law = "lift of the rudder times it",
                                   .confused_with = "a_H, flow straightening, race"};

  static constexpr auto parameters() {
    return std::array{ParameterOf<RudderEffectiveness, S>{.key = "factor",
                                                          .member = &RudderEffectiveness::factor,
                                                          .range = positive,
                                                          .null = 1.0,
                                                          .prior = 0.2,
                                                          .floor = 0.05}};
  }
};

template <class S>
void change(MmgShip<S>& ship, const RudderEffectiveness<S>& e) {
  ship.rudder.f_alpha = ship.rudder.f_alpha * e.factor;
}

template <class S>
void change(PiShip<S>& ship, const RudderEffectiveness<S>& e) {
  ship.rudder.lift_factor = ship.rudder.lift_factor * e.factor;
}

template <class S>
void change(PuShip<S>& ship, const RudderEffectiveness<S>& e) {
  scale_coefficients(ship, "rudder", e.factor);
}

template <class S>
void change(AbkowitzShip<S>& ship, const RudderEffectiveness<S>& e) {
  scale_coefficients(ship, "rudder", e.factor);
}

}  // namespace swayaw::nonlinear
