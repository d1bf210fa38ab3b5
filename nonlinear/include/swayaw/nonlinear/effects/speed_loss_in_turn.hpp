#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Surge derivatives as they are.
template <class S = double>
struct SpeedLossInTurn {
  S X_vv{unchanged}, X_vr{unchanged}, X_rr{unchanged}, X_vvvv{unchanged};

  static constexpr std::string_view id = "speed_loss_in_turn";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "another loss of speed in turns",
                                   .label = "speed loss in turns",
                                   .law = "other values",
                                   .confused_with = "shaft speed drop → shaft speed recorded"};

  static constexpr auto parameters() {
    using H = SpeedLossInTurn;
    constexpr auto term = [](std::string_view key, S H::*member) {
      return other_value<H, S>(key, member, "hull", key, {}, any_number, 0.2);
    };
    return std::array{term("X_vv", &H::X_vv), term("X_vr", &H::X_vr), term("X_rr", &H::X_rr),
                      term("X_vvvv", &H::X_vvvv)};
  }
};

}  // namespace swayaw::nonlinear
