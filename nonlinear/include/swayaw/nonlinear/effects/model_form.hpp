#pragma once

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// A hull, propeller and rudder of another form than the model's: a smooth force that follows the motion and the rudder
/// alone, nothing at rest, the same in every run; its mirror image turning the other way, but for the terms of the last
/// line and Y_u, N_u.
///
/// With q = ½ρL²U_0², u' = u/U_0, v' = v/U_0, r' = rL/U_0:
///
///     X = q (X_u u'(1 − u') + X_uu u'² + X_vv v'² + X_vr v'r' + X_rr r'² + X_dd u'δ²)
///     Y = q (Y_v u'v' + Y_r u'r' + Y_vv v'|v'| + Y_rr r'|r'| + Y_vr v'|r'| + Y_rv r'|v'| + Y_d u'δ + Y_d15 u'δ₁₅ +
///     Y_a28 u'α₂₈ + Y_u u') + Y_R
///     N = q L (the same of N) − 0.48 L Y_R,     Y_R = q (Y_Rg u'|β_R| + Y_Rw u'β_Pα)
///
/// X_uu is what lacks straight ahead at service speed, X_u what is nothing there.
///
/// δ₁₅ is what of the rudder angle is beyond 15 deg, either way, where lift is lost to a gap; α₂₈ what of the angle of
/// the flow at the rudder, α = δ + 0.45 (v' − 0.9 r')/u', is beyond 28 deg, where it is lost to stall: while the rudder
/// is put over against a turn, not in it. Flow straightening is that of `yoshimura_masumoto_interaction` where C_B B/L
/// is 0.15.
///
/// Y_R is what a rudder behind a single screw differs by from side to side: with the drift at the rudder, β_R = v' −
/// 0.9 r', where the flow is straightened more from one side (γ_R of the MMG model); with that at the propeller, β_P =
/// v' − 0.48 r', and the angle of the flow, where the wake is less on one side (C_2 of the MMG model). The two hold
/// nine tenths of the mirror-even part of the acceleration errors of ship files in PI and Abkowitz form, which have no
/// γ_R for each side; a constant force holds a third to two thirds of it.
template <class S = double>
struct ModelForm {
  S X_u{}, X_uu{}, X_vv{}, X_vr{}, X_rr{}, X_dd{};
  S Y_v{}, Y_r{}, Y_vv{}, Y_rr{}, Y_vr{}, Y_rv{}, Y_d{}, Y_d15{}, Y_a28{}, Y_u{}, Y_Rg{}, Y_Rw{};
  S N_v{}, N_r{}, N_vv{}, N_rr{}, N_vr{}, N_rv{}, N_d{}, N_d15{}, N_a28{}, N_u{};

  static constexpr std::string_view id = "model_form";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "another form of the forces on hull, propeller and rudder",
      .label = "form of the model",
      .law = "a smooth function of motion and rudder, the same in every run, below",
      .confused_with = "any one term of hull or rudder: a name needs fewer parameters for the same force"};

  /// A term of usual size is 1e-3 of ½ρL²U_0², as the resistance; moments are at a lever of 0.2 L.
  static constexpr auto parameters() {
    using F = ModelForm;
    constexpr auto force = [](std::string_view key, S F::*member) {
      return ParameterOf<F, S>{.key = key, .member = member, .required = false, .prior = 1e-3, .floor = 2e-5};
    };
    constexpr auto moment = [](std::string_view key, S F::*member) {
      return ParameterOf<F, S>{.key = key, .member = member, .required = false, .prior = 2e-4, .floor = 5e-6};
    };
    return std::array{
        force("X_u", &F::X_u),    force("X_uu", &F::X_uu),    force("X_vv", &F::X_vv),    force("X_vr", &F::X_vr),
        force("X_rr", &F::X_rr),  force("X_dd", &F::X_dd),    force("Y_v", &F::Y_v),      force("Y_r", &F::Y_r),
        force("Y_vv", &F::Y_vv),  force("Y_rr", &F::Y_rr),    force("Y_vr", &F::Y_vr),    force("Y_rv", &F::Y_rv),
        force("Y_d", &F::Y_d),    force("Y_d15", &F::Y_d15),  force("Y_a28", &F::Y_a28),  force("Y_u", &F::Y_u),
        force("Y_Rg", &F::Y_Rg),  force("Y_Rw", &F::Y_Rw),    moment("N_v", &F::N_v),     moment("N_r", &F::N_r),
        moment("N_vv", &F::N_vv), moment("N_rr", &F::N_rr),   moment("N_vr", &F::N_vr),   moment("N_rv", &F::N_rv),
        moment("N_d", &F::N_d),   moment("N_d15", &F::N_d15), moment("N_a28", &F::N_a28), moment("N_u", &F::N_u)};
  }
};

/// What of an angle, or of what goes with it, is beyond a limit, either way.
template <class S>
S beyond(const S& angle, const S& limit) {
  const S size = size_of(angle), over = select(size > limit, size - limit, S(0.0));
  return select(angle < S(0.0), -over, over);
}

template <class Model, class S>
PlanarForce<S> force(const ModelForm<S>& k, const Model&, const Circumstances<S>& now) {
  const auto& [f, state] = std::tie(now.ship, now.state);
  const S q = 0.5 * f.rho * f.L * f.L * f.U_0 * f.U_0, u = state.motion.u / f.U_0, v = state.motion.v / f.U_0,
          r = state.motion.r * f.L / f.U_0, a = size_of(v), b = size_of(r);
  const S& delta = now.recorded.delta;
  constexpr double straightening = 0.45, lever = -0.9, propeller = -0.48;
  const S beta_R = v + lever * r, beta_P = v + propeller * r;
  const S d = u * delta, alpha = d + straightening * beta_R;  // u'δ, u'α
  const S d2 = delta * delta, d15 = u * beyond(delta, S(radians(15.0))),
          a28 = beyond(alpha, radians(28.0) * size_of(u));
  const S sides = k.Y_Rg * u * size_of(beta_R) + k.Y_Rw * beta_P * alpha;
  return {.X = q * (u * (k.X_u * (1.0 - u) + k.X_uu * u) + k.X_vv * v * v + k.X_vr * v * r + k.X_rr * r * r +
                    k.X_dd * u * d2),
          .Y = q * (v * (k.Y_v * u + k.Y_vv * a + k.Y_vr * b) + r * (k.Y_r * u + k.Y_rr * b + k.Y_rv * a) + k.Y_d * d +
                    k.Y_d15 * d15 + k.Y_a28 * a28 + k.Y_u * u + sides),
          .N = q * f.L *
               (v * (k.N_v * u + k.N_vv * a + k.N_vr * b) + r * (k.N_r * u + k.N_rr * b + k.N_rv * a) + k.N_d * d +
                k.N_d15 * d15 + k.N_a28 * a28 + k.N_u * u + propeller * sides)};
}

}  // namespace swayaw::nonlinear
