#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Flow straightening at the rudder, as it is: gamma_R and l_R of the MMG model, kappa_v and kappa_r of the lifting
/// line.
template <class S = double>
struct FlowStraightening {
  S gamma_R_negative{unchanged}, gamma_R_positive{unchanged}, l_R{unchanged}, kappa_v{unchanged}, kappa_r{unchanged};

  static constexpr std::string_view id = "flow_straightening";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "another flow straightening at the rudder",
      .label = "flow straightening at the rudder",
      .law = "other values, those the model has: `gamma_R_…` and `l_R`, or `kappa_v` and `kappa_r`",
      .confused_with = "rudder offset → straight run"};

  static constexpr auto parameters() {
    using F = FlowStraightening;
    return std::array{other_value<F, S>("gamma_R_negative", &F::gamma_R_negative, "rudder", "gamma_R_negative"),
                      other_value<F, S>("gamma_R_positive", &F::gamma_R_positive, "rudder", "gamma_R_positive"),
                      other_value<F, S>("l_R", &F::l_R, "rudder", "l_R_prime"),
                      other_value<F, S>("kappa_v", &F::kappa_v, "rudder", "kappa_v"),
                      other_value<F, S>("kappa_r", &F::kappa_r, "rudder", "kappa_r")};
  }
};

}  // namespace swayaw::nonlinear
