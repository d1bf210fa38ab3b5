#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// A force that no other effect knows, from onset to end: as a map of what it goes with, nothing at all, the heading,
/// the motion; and as what drags at a point beside the centreline, weed or a line.
///
/// With q = ½ρL²U_0², u' = u/U_0 − 1, v' = v/U_0, r' = rL/U_0, U = (u² + v²)^½:
///
///     X = q (X_0 + X_cos cos ψ + X_sin sin ψ + X_u u' + X_vv v'² + X_vr v'r' + X_rr r'² + X_dd δ²)
///     Y = q (Y_0 + Y_cos cos ψ + Y_sin sin ψ + Y_v v' + Y_r r' + Y_d δ + Y_vv v'|v'| + Y_rr r'|r'|)
///     N = q L (the same of N)
///
/// to which the drag adds, at drag_y to starboard of the centreline, against the flow past midship:
///
///     X = −½ρL² drag U u,   Y = −½ρL² drag U v,   N = −drag_y X
template <class S = double>
struct UnknownForce {
  S X_0{}, X_cos{}, X_sin{}, X_u{}, X_vv{}, X_vr{}, X_rr{}, X_dd{};
  S Y_0{}, Y_cos{}, Y_sin{}, Y_v{}, Y_r{}, Y_d{}, Y_vv{}, Y_rr{};
  S N_0{}, N_cos{}, N_sin{}, N_v{}, N_r{}, N_d{}, N_vv{}, N_rr{};
  S drag{}, drag_y{};                                     ///< drag_y [m]
  S onset = S(-std::numeric_limits<double>::infinity());  ///< [s]
  S end = S(std::numeric_limits<double>::infinity());     ///< [s]

  static constexpr std::string_view id = "unknown";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::run;
  static constexpr EffectText text{.phrase = "a force without a name",
                                   .label = "something unknown",
                                   .law = "a map of a force that no other kind explains, below",
                                   .confused_with = "whatever it stands for"};
  static constexpr std::string_view never_steady = "under a force that goes with the heading or the time";

  /// A term of usual size is 1e-3 of ½ρL²U_0², as the resistance; moments are at a lever of 0.3 L.
  static constexpr auto parameters() {
    using U = UnknownForce;
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr auto force = [](std::string_view key, S U::*member) {
      return ParameterOf<U, S>{.key = key, .member = member, .required = false, .prior = 1e-3, .floor = 2e-5};
    };
    constexpr auto moment = [](std::string_view key, S U::*member) {
      return ParameterOf<U, S>{.key = key, .member = member, .required = false, .prior = 3e-4, .floor = 5e-6};
    };
    constexpr auto time = [](std::string_view key, S U::*member, double always) {
      return ParameterOf<U, S>{.key = key,
                               .member = member,
                               .unit = "s",
                               .required = false,
                               .fallback = always,
                               .null = always,
                               .prior = 5.0,
                               .law = 0.0,
                               .scale = ShipUnit::time,
                               .decides = false};
    };
    return std::array{
        force("X_0", &U::X_0),
        force("X_cos", &U::X_cos),
        force("X_sin", &U::X_sin),
        force("X_u", &U::X_u),
        force("X_vv", &U::X_vv),
        force("X_vr", &U::X_vr),
        force("X_rr", &U::X_rr),
        force("X_dd", &U::X_dd),
        force("Y_0", &U::Y_0),
        force("Y_cos", &U::Y_cos),
        force("Y_sin", &U::Y_sin),
        force("Y_v", &U::Y_v),
        force("Y_r", &U::Y_r),
        force("Y_d", &U::Y_d),
        force("Y_vv", &U::Y_vv),
        force("Y_rr", &U::Y_rr),
        moment("N_0", &U::N_0),
        moment("N_cos", &U::N_cos),
        moment("N_sin", &U::N_sin),
        moment("N_v", &U::N_v),
        moment("N_r", &U::N_r),
        moment("N_d", &U::N_d),
        moment("N_vv", &U::N_vv),
        moment("N_rr", &U::N_rr),
        ParameterOf<U, S>{
            .key = "drag", .member = &U::drag, .range = non_negative, .required = false, .prior = 1e-3, .floor = 5e-5},
        ParameterOf<U, S>{.key = "drag_y_m",
                          .member = &U::drag_y,
                          .unit = "m",
                          .required = false,
                          .prior = 0.05,
                          .scale = ShipUnit::length,
                          .decides = false},
        time("onset_s", &U::onset, -never),
        time("end_s", &U::end, never)};
  }

  /// What is left of it where no heading is meant.
  std::optional<UnknownForce> without_heading() const {
    auto e = *this;
    e.X_cos = e.X_sin = e.Y_cos = e.Y_sin = e.N_cos = e.N_sin = S(0.0);
    return e;
  }

  bool goes_with_heading_or_time() const {
    if (std::isfinite(onset) || std::isfinite(end)) return true;
    const auto there = [](const S& c) { return !(c == S(0.0)); };
    return there(X_cos) || there(X_sin) || there(Y_cos) || there(Y_sin) || there(N_cos) || there(N_sin);
  }

  bool lets_turns_be_steady() const { return !goes_with_heading_or_time(); }
};

template <class Model, class S>
PlanarForce<S> force(const UnknownForce<S>& k, const Model&, const Circumstances<S>& now) {
  const auto& [f, state] = std::tie(now.ship, now.state);
  const S& delta = now.recorded.delta;
  const auto [s, c] = sin_cos(state.psi);
  const S q = 0.5 * f.rho * f.L * f.L * f.U_0 * f.U_0, u = state.motion.u / f.U_0 - 1.0, v = state.motion.v / f.U_0,
          r = state.motion.r * f.L / f.U_0;
  const S vv = v * size_of(v), rr = r * size_of(r);
  const S drag = 0.5 * f.rho * f.L * f.L * k.drag * speed(state.motion);
  return {.X = -drag * state.motion.u + q * (k.X_0 + k.X_cos * c + k.X_sin * s + k.X_u * u + k.X_vv * v * v +
                                             k.X_vr * v * r + k.X_rr * r * r + k.X_dd * delta * delta),
          .Y = -drag * state.motion.v + q * (k.Y_0 + k.Y_cos * c + k.Y_sin * s + k.Y_v * v + k.Y_r * r + k.Y_d * delta +
                                             k.Y_vv * vv + k.Y_rr * rr),
          .N = drag * state.motion.u * k.drag_y + q * f.L *
                                                      (k.N_0 + k.N_cos * c + k.N_sin * s + k.N_v * v + k.N_r * r +
                                                       k.N_d * delta + k.N_vv * vv + k.N_rr * rr)};
}

/// A constant force on the ship from a time to a time, as of a tug.
inline SearchForm<UnknownForce<>> search_form(const UnknownForce<>& null, const SearchContext& context) {
  std::vector<ParameterMove> moves;
  for (const auto* key : {"X_0", "Y_0", "N_0"}) moves.push_back(from_null(context[key]));
  for (const auto* key : {"onset_s", "end_s"}) moves.push_back(in_run(context[key], context));
  auto form = by_moves(null, std::move(moves), starts_in_run({{0.0, 0.0, 0.0}}, context.duration / context.time_unit));
  form.at = [at = std::move(form.at), unit = context.time_unit](std::span<const double> c) {
    return not_too_short(at(c), unit);
  };
  return form;
}

/// What drags at one side, all the time: its size and its moment, by which it differs from more resistance.
inline SearchForm<UnknownForce<>> drag_form(const UnknownForce<>& null, const SearchContext& context) {
  constexpr double least = 0.02;  // of its prior deviation: without a drag its place means nothing
  return {
      .id = std::string(UnknownForce<>::id),
      .coordinates = {{.name = "drag", .low = least}, {.name = "moment", .acts = true}},
      .at =
          [null, size = context["drag"].deviation, lever = context["drag_y_m"].deviation](std::span<const double> c) {
            constexpr double farthest = 2.0;  // of its prior deviation: a tenth of the length, the side of a beamy ship
            auto effect = null;
            effect.drag = size * c[0];
            effect.drag_y = lever * std::clamp(c[1] / c[0], -farthest, farthest);
            return effect;
          },
      .starts = {{1.0, 0.0}}};
}

}  // namespace swayaw::nonlinear
