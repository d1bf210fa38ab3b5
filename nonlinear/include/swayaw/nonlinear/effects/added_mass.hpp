#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Added masses as they are: m_x, m_y, J_z of the MMG model, acceleration derivatives of the others.
template <class S = double>
struct AddedMass {
  S m_x{unchanged}, m_y{unchanged}, J_z{unchanged};
  S X_udot{unchanged}, Y_vdot{unchanged}, Y_rdot{unchanged}, N_vdot{unchanged}, N_rdot{unchanged};

  static constexpr std::string_view id = "added_mass";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "another added mass",
      .label = "added mass",
      .law = "other values, those the model has: `m_x` `m_y` `J_z`, or the acceleration derivatives",
      .confused_with = "steering gear lag, loading"};

  static constexpr auto parameters() {
    using A = AddedMass;
    constexpr auto term = [](std::string_view key, S A::*member) {
      return other_value<A, S>(key, member, "added_mass", key);
    };
    return std::array{term("m_x", &A::m_x),       term("m_y", &A::m_y),       term("J_z", &A::J_z),
                      term("X_udot", &A::X_udot), term("Y_vdot", &A::Y_vdot), term("Y_rdot", &A::Y_rdot),
                      term("N_vdot", &A::N_vdot), term("N_rdot", &A::N_rdot)};
  }
};

}  // namespace swayaw::nonlinear
