#pragma once

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Drag of the strips of the hull across the flow, beside the polynomial of the model, in closed form.
///
///     Y = −½ρd C_D ∫ |v + x r| (v + x r) dx,   N = −½ρd C_D ∫ x |v + x r| (v + x r) dx,   −L/2 ≤ x ≤ L/2
///
/// With h = L/2, where |v| ≥ h|r| all strips have one sign: ∫ = ±(2 v² h + ⅔ r² h³) and ±4/3 v r h³.
/// Else ∫ = (2 v³ + 6 v h² r²)/(3 |r|) and sgn(r) (½ h⁴r⁴ + v² h² r² − v⁴/6)/r².
template <class S = double>
struct CrossFlowDrag {
  S C_D{};

  static constexpr std::string_view id = "cross_flow_drag";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "cross-flow drag",
      .label = "cross-flow drag",
      .law = "Y = −½ρd C_D ∫ \\|v + xr\\|(v + xr) dx, N = −½ρd C_D ∫ x\\|v + xr\\|(v + xr) dx",
      .confused_with = "cubic terms"};

  /// The floor is 5 % of the coefficient of a bluff section.
  static constexpr auto parameters() {
    return std::array{ParameterOf<CrossFlowDrag, S>{
        .key = "drag_coefficient", .member = &CrossFlowDrag::C_D, .prior = 0.5, .floor = 0.05, .law = 0.1}};
  }

  /// It needs a draught.
  template <class Model>
  static bool acts_on(const Model&) {
    return requires(const Model& m) { m.particulars.d; };
  }
};

template <class Model, class S>
PlanarForce<S> force(const CrossFlowDrag<S>& e, const Model&, const Circumstances<S>& now) {
  const auto& m = now.state.motion;
  const S h = 0.5 * now.ship.L, vv = m.v * m.v, tip = h * m.r, tt = tip * tip;
  const auto pivots = tt > vv;  // a strip inside the hull stands still
  const S one = select(m.v < S(0.0), S(-1.0), S(1.0)), side = select(m.r < S(0.0), S(-1.0), S(1.0));
  const S r = select(pivots, S(side * m.r), S(1.0));
  const S Y = select(pivots, S(2.0 * m.v * (vv + 3.0 * tt) / (3.0 * r)), S(one * 2.0 * h * (vv + tt / 3.0)));
  const S N = select(pivots, S(side * (0.5 * tt * tt + vv * tt - vv * vv / 6.0) / (r * r)),
                     S(one * 4.0 / 3.0 * m.v * tip * h * h));
  const S q = -0.5 * now.ship.rho * now.ship.d * e.C_D;
  return {.X = S(0.0), .Y = q * Y, .N = q * N};
}

}  // namespace swayaw::nonlinear
