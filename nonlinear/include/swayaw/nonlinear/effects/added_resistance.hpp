#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/models/models.hpp"

namespace swayaw::inline nonlinear {

/// Resistance straight ahead times 1 + relative_increase: R_0, or X_0 and X_u. Fouling, roughness.
template <class S = double>
struct AddedResistance {
  S relative_increase{};

  static constexpr std::string_view id = "added_resistance";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::group;  ///< a hull is as foul as it is that day
  static constexpr EffectText text{.phrase = "more resistance",
                                   .label = "added resistance",
                                   .law = "resistance straight ahead times 1 + it: R_0, or X_0 and X_u",
                                   .confused_with = "wake, thrust → coasting"};

  static constexpr auto parameters() {
    return std::array{ParameterOf<AddedResistance, S>{.key = "relative_increase",
                                                      .member = &AddedResistance::relative_increase,
                                                      .range = {.low = -1.0, .above_low = true},
                                                      .prior = 0.3,
                                                      .floor = 0.05,
                                                      .law = 0.06}};
  }
};

template <class S>
void change(MmgShip<S>& ship, const AddedResistance<S>& e) {
  ship.hull.R_0 = ship.hull.R_0 * (1.0 + e.relative_increase);
}

template <PrimeShip Ship>
void change(Ship& ship, const AddedResistance<typename Ship::Scalar>& e) {
  ship.hull.X_0 = ship.hull.X_0 * (1.0 + e.relative_increase);
  ship.hull.X_u = ship.hull.X_u * (1.0 + e.relative_increase);
}

/// More of it, never less: a resistance that is smaller than the file says is a number that is wrong.
inline SearchForm<AddedResistance<>> search_form(const AddedResistance<>& null, const SearchContext& context) {
  return by_moves(null, {from_null(context["relative_increase"], 0.0, HUGE_VAL)}, {{0.0}});
}

}  // namespace swayaw::nonlinear
