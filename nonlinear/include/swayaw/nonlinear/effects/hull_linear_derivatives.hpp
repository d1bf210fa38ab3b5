#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Y_v, Y_r, N_v, N_r as they are.
template <class S = double>
struct HullLinearDerivatives {
  S Y_v{unchanged}, Y_r{unchanged}, N_v{unchanged}, N_r{unchanged};

  static constexpr std::string_view id = "hull_linear_derivatives";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "other linear derivatives of the hull",
                                   .label = "linear hull derivatives",
                                   .law = "other values, in the primes of the model",
                                   .confused_with = "shallow water, loading"};

  static constexpr auto parameters() {
    using H = HullLinearDerivatives;
    constexpr auto term = [](std::string_view key, S H::*member) {
      return other_value<H, S>(key, member, "hull", key);
    };
    return std::array{term("Y_v", &H::Y_v), term("Y_r", &H::Y_r), term("N_v", &H::N_v), term("N_r", &H::N_r)};
  }
};

}  // namespace swayaw::nonlinear
