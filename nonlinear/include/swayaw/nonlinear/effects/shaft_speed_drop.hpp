#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// The shaft turns slower than recorded where the ship has lost speed, n (1 − relative_drop (1 − u/U_0)): an engine at
/// its limit of torque. It counts the loss of speed alone; drift at the propeller loads the engine too.
template <class S = double>
struct ShaftSpeedDrop {
  S relative_drop{};

  static constexpr std::string_view id = "shaft_speed_drop";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "a shaft that slows under load",
      .label = "shaft speed drop in turns",
      .law =
          "n (1 − drop (1 − u/U_0)), U_0 the service speed: an engine at its limit of torque slows with the ship. "
          "Recorded thrust stays as it is",
      .confused_with = "added mass, X_vr → shaft speed recorded"};

  /// Engines with a governor and a lag of their own were told by this law 0.30 of the drop off (median of 11,
  /// `swayaw_concealed` as on board, seeds 44 and 46), where the runs alone tell it to 0.13.
  static constexpr auto parameters() {
    return std::array{ParameterOf<ShaftSpeedDrop, S>{.key = "relative_drop",
                                                     .member = &ShaftSpeedDrop::relative_drop,
                                                     .range = {-1.0, 1.0},
                                                     .prior = 0.3,
                                                     .floor = 0.02,
                                                     .law = 0.2}};
  }

  /// It needs a propeller that is driven at a shaft speed.
  template <class Model>
  static bool acts_on(const Model& model) {
    return takes_shaft_speed(model);
  }
};

/// The shaft speed that the engine keeps; a thrust stays as it is.
template <class S>
void drive(const ShaftSpeedDrop<S>& e, const ShipFacts<S>& ship, const PlanarMotion<S>& m, Controls<S>& controls) {
  controls.rev = controls.rev * (1.0 - e.relative_drop * (1.0 - m.u / ship.U_0));
}

/// An engine never quickens under load. What holds its torque slows by some 0.3 of the loss of speed, as the torque
/// coefficient of a propeller at a standstill is twice that at its working point, and more where drift loads it, which
/// the law does not count: 0.5 has been seen, 0.7 is more than any.
inline SearchForm<ShaftSpeedDrop<>> search_form(const ShaftSpeedDrop<>& null, const SearchContext& context) {
  constexpr double most = 0.7;
  return by_moves(null, {from_null(context["relative_drop"], 0.0, most)}, {{0.0}});
}

}  // namespace swayaw::nonlinear
