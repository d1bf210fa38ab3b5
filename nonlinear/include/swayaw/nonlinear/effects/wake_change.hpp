#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Wake change in a turn, as it is.
template <class S = double>
struct WakeChange {
  S C_1{unchanged}, C_2_positive{unchanged}, C_2_negative{unchanged};

  static constexpr std::string_view id = "wake_change";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "another wake in turns",
                                   .label = "wake change in drift",
                                   .law = "other values; a constant wake begins to change",
                                   .confused_with = "shaft speed drop, stall"};

  static constexpr auto parameters() {
    using W = WakeChange;
    return std::array{
        other_value<W, S>("C1", &W::C_1, "propeller", "wake_C1", {}, non_negative),
        other_value<W, S>("C2_positive", &W::C_2_positive, "propeller", "wake_C2_positive", {}, non_negative),
        other_value<W, S>("C2_negative", &W::C_2_negative, "propeller", "wake_C2_negative", {}, non_negative)};
  }
};

/// A wake that a file keeps constant begins to change.
template <class Model, class S>
void prepare(Model& model, const WakeChange<S>&) {
  if constexpr (requires { model.propeller.wake; }) model.propeller.wake.index = 1;
}

}  // namespace swayaw::nonlinear
