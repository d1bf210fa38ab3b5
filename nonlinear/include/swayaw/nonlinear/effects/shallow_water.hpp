#pragma once

#include <limits>

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/effects/shallow_water_derivatives.hpp"
#include "swayaw/nonlinear/models/models.hpp"

namespace swayaw::inline nonlinear {

/// Water of finite depth: factors on hull, added mass, wake and flow straightening; see shallow_water_factors.
template <class S = double>
struct ShallowWater {
  S depth_over_draught{std::numeric_limits<double>::infinity()};
  S sway{1.0}, yaw{1.0}, cubic{1.0}, mass{1.0}, resistance{1.0}, wake{0.5};  ///< how much of the usual growth she shows

  ShallowWaterGrowth<S> growth() const { return {sway, yaw, cubic, mass, resistance, wake}; }

  static constexpr std::string_view id = "shallow_water";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::group;  ///< one depth a day
  static constexpr EffectText text{
      .phrase = "shallow water",
      .label = "shallow water",
      .law = "factors on hull, added mass, wake and flow straightening by the depth h/d ≥ 1.1, below",
      .confused_with = "linear derivatives, mass → another depth"};

  /// The priors of the growth are the spread of published laws (docs/effects.md, finite depth).
  /// Depths of ships whose shallow water follows other laws were told 11 % off (rms of 11, `swayaw_concealed` as on
  /// board, seeds 44 and 46), where the runs alone tell them to 7 %.
  static constexpr auto parameters() {
    using W = ShallowWater;
    using P = ParameterOf<W, S>;
    constexpr auto growth = [](std::string_view key, S W::*member, double usual) {
      return P{.key = key,
               .member = member,
               .range = non_negative,
               .required = false,
               .fallback = usual,
               .null = usual,
               .prior = 0.5,
               .decides = false};
    };
    return std::array{P{.key = "depth_over_draught",
                        .member = &W::depth_over_draught,
                        .range = {.low = 1.1},
                        .null = std::numeric_limits<double>::infinity(),
                        .prior = 2.0,
                        .floor = 0.1,
                        .law = 0.08},
                      growth("sway", &W::sway, 1.0),
                      growth("yaw", &W::yaw, 1.0),
                      growth("cubic", &W::cubic, 1.0),
                      growth("mass", &W::mass, 1.0),
                      growth("resistance", &W::resistance, 1.0),
                      growth("wake", &W::wake, 0.5)};
  }
};

template <class Ship, class S>
ShallowWaterFactors<S> shallow_factors(const Ship& ship, const ShallowWater<S>& e) {
  const auto& p = ship.particulars;
  return shallow_water_factors(S(p.nabla / (p.L * p.B * p.d)), e.depth_over_draught, e.growth());
}

template <class Hull, class S>
void change_hull(Hull& h, const ShallowWaterFactors<S>& f) {
  for (S* linear : {&h.Y_v, &h.N_v}) *linear = *linear * f.sway;
  for (S* linear : {&h.Y_r, &h.N_r}) *linear = *linear * f.yaw;
  for (S* cubic : {&h.Y_vvv, &h.Y_vvr, &h.Y_vrr, &h.Y_rrr, &h.N_vvv, &h.N_vvr, &h.N_vrr, &h.N_rrr})
    *cubic = *cubic * f.cubic;
}

/// 1 − t and 1 − w of a propeller.
template <class S>
void change_wake(S& t, S& w, const ShallowWaterFactors<S>& f) {
  t = 1.0 - (1.0 - t) * f.one_minus_t;
  w = 1.0 - (1.0 - w) * f.one_minus_w;
}

template <class S>
void change(MmgShip<S>& ship, const ShallowWater<S>& e) {
  const auto f = shallow_factors(ship, e);
  ship.hull.R_0 = ship.hull.R_0 * f.R_0;
  change_hull(ship.hull, f);
  ship.added_mass.m_x = ship.added_mass.m_x * f.m_x;
  ship.added_mass.m_y = ship.added_mass.m_y * f.m_y;
  ship.added_mass.J_z = ship.added_mass.J_z * f.J_z;
  change_wake(ship.propeller.t_P, ship.propeller.w_P0, f);
  ship.rudder.gamma_R_negative = ship.rudder.gamma_R_negative * f.gamma_R;
  ship.rudder.gamma_R_positive = ship.rudder.gamma_R_positive * f.gamma_R;
}

template <PrimeShip Ship>
void change(Ship& ship, const ShallowWater<typename Ship::Scalar>& e) {
  const auto f = shallow_factors(ship, e);
  ship.hull.X_0 = ship.hull.X_0 * f.R_0;
  ship.hull.X_u = ship.hull.X_u * f.R_0;
  change_hull(ship.hull, f);
  ship.added_mass.X_udot = ship.added_mass.X_udot * f.m_x;
  ship.added_mass.Y_vdot = ship.added_mass.Y_vdot * f.m_y;
  ship.added_mass.N_rdot = ship.added_mass.N_rdot * f.J_z;
  change_wake(ship.propeller.t_P, ship.propeller.w_f, f);
  if constexpr (requires { ship.rudder.kappa_v; }) {
    ship.rudder.kappa_v = ship.rudder.kappa_v * f.gamma_R;
    ship.rudder.kappa_r = ship.rudder.kappa_r * f.gamma_R;
  }
}

/// Draught over depth, and how much of the usual growth she shows: all of it, and each kind.
inline SearchForm<ShallowWater<>> search_form(const ShallowWater<>&, const SearchContext&) {
  SearchForm<ShallowWater<>> form{
      .id = std::string(ShallowWater<>::id),
      .coordinates = {{.name = "draught over depth", .deviation = 0.5, .low = 0.0, .high = 0.9}},
      .at = {},
      .starts = {}};
  for (const auto* kind : {"growth", "sway", "yaw", "cubic", "mass", "resistance"})
    form.coordinates.push_back({.name = kind, .deviation = 0.35, .low = -0.7, .high = 0.7});
  form.coordinates.push_back({.name = "wake", .centre = 0.5, .deviation = 0.5, .low = 0.0, .high = 2.0});
  form.at = [](std::span<const double> c) {
    if (c[0] < 0.02) return ShallowWater<>{};
    const auto grown = [&](std::size_t i) { return std::exp(c[1] + c[i]); };
    return ShallowWater<>{1.0 / c[0], grown(2), grown(3), grown(4), grown(5), grown(6), c[7]};
  };
  for (const double x : {0.45, 0.7}) form.starts.push_back({x, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5});
  return form;
}

}  // namespace swayaw::nonlinear
