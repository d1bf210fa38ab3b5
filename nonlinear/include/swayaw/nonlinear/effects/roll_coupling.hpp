#pragma once

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// Height of the metacentre over the keel [m], KM = KB + BM, of a ship of usual form:
///
///     KB = d (5/6 − C_B/(3 C_W)),   BM = (0.1216 C_W − 0.0410) B²/(C_B d),   C_W = (1 + 2 C_B)/3   [Parsons2003]
///
/// 23.9 m for KVLCC2 and 13.7 m for KCS, where SIMMAN has 24.3 m and 14.9 m.
template <class S>
S metacentre(const ShipFacts<S>& ship) {
  const S C_B = ship.nabla / (ship.L * ship.B * ship.d), C_W = (1.0 + 2.0 * C_B) / 3.0;
  const S KB = ship.d * (5.0 / 6.0 - C_B / (3.0 * C_W));
  return KB + (0.1216 * C_W - 0.0410) * ship.B * ship.B / (C_B * ship.d);
}

/// Heel that changes sway force and yaw moment. The water that holds the hull sideways, m (dv/dt + u r), does so below
/// the centre of gravity, and heels her; the part of it that the rudder makes, Y_R, acts deeper.
///
///     Y = ½ρLdU² Y_phi phi,   N = ½ρL²dU² N_phi phi
///     d²phi/dt² + 2 zeta omega d(phi)/dt + omega² phi = −(lever (dv/dt + u r) + rudder_lever Y_R/m)/k_xx²
///     omega² = g GM/k_xx²
///
/// Solved for phi and q = d(phi)/dt + lever v/k_xx², whose rates need no acceleration:
///
///     d(phi)/dt = q − lever v/k_xx²
///     dq/dt = −(lever u r + rudder_lever Y_R/m)/k_xx² − 2 zeta omega d(phi)/dt − omega² phi
///
/// Y_phi and N_phi where a file gives neither: the container ship of [Son1982]. k_xx = 0.4 B and GM are customary
/// guesses. The lever is KM − GM − 0.65 d: there, over the keel, the side force of that ship goes, by K_v/Y_v =
/// K_r/Y_r.
template <class S = double>
struct RollCoupling {
  S GM{unchanged};     ///< metacentric height [m]; 0.05 B unless given
  S Y_phi{};           ///< sway force by heel over ½ρLdU²
  S N_phi{};           ///< yaw moment by heel over ½ρL²dU²
  S zeta{0.1};         ///< damping over critical
  S lever{unchanged};  ///< height of the centre of gravity over the point where the water holds the hull [m]; as
                       ///< `metacentre` and GM tell unless given
  S rudder_lever{};    ///< height of that point over the force of the rudder [m]

  static constexpr std::string_view id = "roll_coupling";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::group;  ///< GM is of a loading
  static constexpr EffectText text{
      .phrase = "heel that acts on sway and yaw",
      .label = "roll coupling",
      .law =
          "Y = ½ρLdU² Y_φ φ, N = ½ρL²dU² N_φ φ, φ'' + 2ζω φ' + ω² φ = −(lever (v' + u r) + rudder_lever Y_R/m)/k_xx², "
          "ω² = g GM/k_xx², k_xx = 0.4 B, Y_R the side force of the rudder; GM is 0.05 B and the lever KM − GM − "
          "0.65 d unless given, one parameter at least is",
      .confused_with = "fluid memory → resonance at ω"};

  /// Heel, starboard side down [rad], and q [rad/s].
  static constexpr std::array hidden{HiddenQuantity{"phi", ShipUnit::one, Channel::phi},
                                     HiddenQuantity{"q", ShipUnit::yaw_rate}};

  static constexpr auto parameters() {
    using P = ParameterOf<RollCoupling, S>;
    // container ship of [Son1982], −0.000063 and −0.0001424 in ½ρL²U², L/d = 20.6
    constexpr double Y_phi = -0.000063 * 175.0 / 8.5, N_phi = -0.0001424 * 175.0 / 8.5;
    return std::array{P{.key = "GM_m",
                        .member = &RollCoupling::GM,
                        .unit = "m",
                        .range = positive,
                        .required = false,
                        .fallback = unchanged,
                        .null = unchanged,
                        .prior = 0.5,
                        .law = 0.2,
                        .scale = ShipUnit::own,
                        .decides = false},
                      P{.key = "Y_phi",
                        .member = &RollCoupling::Y_phi,
                        .required = false,
                        .fallback = Y_phi,
                        .prior = 0.02,
                        .floor = 0.001},
                      P{.key = "N_phi",
                        .member = &RollCoupling::N_phi,
                        .required = false,
                        .fallback = N_phi,
                        .prior = 0.02,
                        .floor = 0.001},
                      P{.key = "zeta",
                        .member = &RollCoupling::zeta,
                        .range = non_negative,
                        .required = false,
                        .fallback = 0.1,
                        .null = 0.1,
                        .prior = 0.05,
                        .decides = false},
                      P{.key = "lever_m",
                        .member = &RollCoupling::lever,
                        .unit = "m",
                        .required = false,
                        .fallback = unchanged,
                        .null = unchanged,
                        .prior = 0.3,
                        .scale = ShipUnit::own,
                        .decides = false},
                      P{.key = "rudder_lever_m",
                        .member = &RollCoupling::rudder_lever,
                        .unit = "m",
                        .required = false,
                        .prior = 0.01,
                        .scale = ShipUnit::length,
                        .decides = false}};
  }

  /// It needs beam and draught.
  template <class Model>
  static bool acts_on(const Model&) {
    return requires(const Model& m) { m.particulars.B; };
  }

  /// All parameters known.
  RollCoupling completed(const ShipFacts<S>& ship) const {
    auto e = *this;
    if (std::isnan(value_of(e.GM))) e.GM = 0.05 * ship.B;
    if (std::isnan(value_of(e.lever))) e.lever = metacentre(ship) - e.GM - 0.65 * ship.d;
    return e;
  }
};

template <class Model, class S>
PlanarForce<S> force(const RollCoupling<S>& e, const Model&, const Circumstances<S>& now) {
  const auto& m = now.state.motion;
  const S q = 0.5 * now.ship.rho * now.ship.L * now.ship.d * (m.u * m.u + m.v * m.v) * now.hidden[0];
  return {.X = S(0.0), .Y = q * e.Y_phi, .N = q * now.ship.L * e.N_phi};
}

/// Whether the force of the rudder heels her by itself.
template <class S>
bool follows_rudder(const RollCoupling<S>& e) {
  return value_of(e.rudder_lever) != 0.0;
}

/// @param by_rudder  Y_R/m [m/s²]
template <class S>
std::array<S, 2> hidden_rates(const RollCoupling<S>& e, const ShipFacts<S>& ship, const PlanarMotion<S>& m,
                              std::span<const S> hidden, const S& by_rudder) {
  const S over_kk = 1.0 / (ship.k_xx * ship.k_xx), lever = e.lever * over_kk, p = hidden[1] - lever * m.v;
  const S omega = sqrt(effect_gravity * e.GM * over_kk);
  return {p,
          -lever * m.u * m.r - e.rudder_lever * over_kk * by_rudder - omega * (2.0 * e.zeta * p + omega * hidden[0])};
}

/// phi = −(lever u r + rudder_lever Y_R/m)/(g GM), and no roll rate
template <class S>
std::array<S, 2> steady_hidden(const RollCoupling<S>& e, const ShipFacts<S>& ship, const PlanarMotion<S>& m,
                               const S& by_rudder) {
  return {-(e.lever * m.u * m.r + e.rudder_lever * by_rudder) / (effect_gravity * e.GM),
          e.lever * m.v / (ship.k_xx * ship.k_xx)};
}

/// Moment and damping of the heel are known but for factors. A heel that is recorded is explained by rolling alone; it
/// acts where sway force or yaw moment show it. KCS rolls in three tests of MARIN as if the rudder acted 3 m, 0.3 d,
/// below the point where the water holds her: what is left of her heel falls from 24 to 40 % of it to 9 to 16 %.
///
/// From 0.05 B, GM of ships lies within 0.01 B (the container ship of [Son1982] has 0.012 B) and 0.25 B; from 0.1,
/// damping within 0.02 and half of the critical. Beyond, heel is a memory of some other kind, and too stiff for the
/// steps of a filter.
inline SearchForm<RollCoupling<>> search_form(const RollCoupling<>& null, const SearchContext& context) {
  auto Y = from_null(context["Y_phi"]), N = from_null(context["N_phi"]);
  Y.coordinate.acts = N.coordinate.acts = true;
  // main dimensions tell KM to 8 % (KCS), which is a quarter of the lever; beyond three times it is no lever of a hull
  constexpr double lever_known_to = 0.3;
  constexpr FactorRange of_lever{.low = 0.3, .high = 3.0};
  constexpr FactorRange of_GM{.low = 0.2, .high = 5.0}, of_damping{.low = 0.2, .high = 5.0};
  return by_moves(
      null,
      {by_factor(context["GM_m"], 1.0, of_GM), std::move(Y), std::move(N), by_factor(context["zeta"], 0.7, of_damping),
       by_factor(context["lever_m"], lever_known_to, of_lever), from_null(context["rudder_lever_m"])},
      {{0.0, 0.1, -0.1, 0.0, 0.0, 0.0}, {-1.2, 0.1, -0.1, 0.0, 0.0, 0.0}});
}

}  // namespace swayaw::nonlinear
