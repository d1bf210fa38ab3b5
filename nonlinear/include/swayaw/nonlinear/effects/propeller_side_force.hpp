#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// Transverse force of a single screw, at the propeller, positive to starboard.
///
///     Y = share T + constant,   N = x_P Y
template <class S = double>
struct PropellerSideForce {
  S share{};     ///< over the thrust
  S constant{};  ///< [N]

  static constexpr std::string_view id = "propeller_side_force";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "a side force of the propeller",
                                   .label = "propeller side force",
                                   .law = "Y = share T + constant at the propeller, N = x_P Y",
                                   .confused_with = "rudder offset → two shaft speeds"};

  static constexpr auto parameters() {
    using P = ParameterOf<PropellerSideForce, S>;
    return std::array{P{.key = "share_of_thrust",
                        .member = &PropellerSideForce::share,
                        .range = {-1.0, 1.0},
                        .prior = 0.05,
                        .floor = 0.005},
                      P{.key = "constant_N",
                        .member = &PropellerSideForce::constant,
                        .unit = "N",
                        .required = false,
                        .prior = 0.05,
                        .floor = 0.005,
                        .scale = ShipUnit::force}};
  }

  /// It needs a thrust.
  template <class Model>
  static bool acts_on(const Model&) {
    return requires(const Model& m) { m.propeller; };
  }
};

template <class Model, class S>
PlanarForce<S> force(const PropellerSideForce<S>& e, const Model& model, const Circumstances<S>& now) {
  const S Y = e.share * thrust(model, now.state.motion, now.actual) + e.constant;
  return {.X = S(0.0), .Y = Y, .N = now.ship.x_P * Y};
}

/// The share alone: a constant force is a rudder offset's twin. What a tenth of the thrust does is undone by 1.0 deg of
/// rudder on the Nawigator, 1.9 on the KCS, 2.2 on the KVLCC2, 3.9 on the Esso Osaka; single screws need one or two, so
/// that a fifth is more than any.
inline SearchForm<PropellerSideForce<>> search_form(const PropellerSideForce<>& null, const SearchContext& context) {
  constexpr double most = 0.2;
  return by_moves(null, {from_null(context["share_of_thrust"], -most, most)}, {{0.0}});
}

}  // namespace swayaw::nonlinear
