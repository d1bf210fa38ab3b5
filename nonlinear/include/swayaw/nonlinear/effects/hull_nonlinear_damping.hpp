#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Cubic terms of sway and yaw as they are.
template <class S = double>
struct HullNonlinearDamping {
  S Y_vvv{unchanged}, Y_vvr{unchanged}, Y_vrr{unchanged}, Y_rrr{unchanged};
  S N_vvv{unchanged}, N_vvr{unchanged}, N_vrr{unchanged}, N_rrr{unchanged};

  static constexpr std::string_view id = "hull_nonlinear_damping";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "other cubic terms of the hull",
                                   .label = "nonlinear hull damping",
                                   .law = "other values",
                                   .confused_with = "cross-flow drag → wide range of β/r'"};

  static constexpr auto parameters() {
    using H = HullNonlinearDamping;
    constexpr auto term = [](std::string_view key, S H::*member) {
      return other_value<H, S>(key, member, "hull", key, {}, any_number, 0.2);
    };
    return std::array{term("Y_vvv", &H::Y_vvv), term("Y_vvr", &H::Y_vvr), term("Y_vrr", &H::Y_vrr),
                      term("Y_rrr", &H::Y_rrr), term("N_vvv", &H::N_vvv), term("N_vvr", &H::N_vvr),
                      term("N_vrr", &H::N_vrr), term("N_rrr", &H::N_rrr)};
  }
};

}  // namespace swayaw::nonlinear
