#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/models/parts/rudder_lift_loss.hpp"

namespace swayaw::inline nonlinear {

/// Lift lost to the gap between rudder and horn, 1 + s (|delta| − delta_lim)² beyond delta_lim, in place of a gap of
/// her own. Source: [Alexandersson2024] eq (30)
template <class S = double>
struct RudderGap {
  S delta_lim{unchanged};  ///< [rad]
  S s{unchanged};          ///< [1/rad²]

  static constexpr std::string_view id = "rudder_gap";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "the gap above the rudder",
      .label = "rudder gap",
      .law =
          "lift times 1 + s (\\|δ\\| − δ_lim)² beyond δ_lim, in place of a gap of her own; of the MMG rudder never "
          "below 0",
      .confused_with = "stall: one class below 30°"};
  static constexpr bool takes_rudder_lift = true;

  static constexpr auto parameters() {
    using P = ParameterOf<RudderGap, S>;
    return std::array{P{.key = "delta_lim_rad",
                        .member = &RudderGap::delta_lim,
                        .unit = "rad",
                        .range = {.low = 0.0, .high = 0.5 * pi},
                        .null = unchanged,
                        .prior = 0.2,
                        .decides = false,
                        .table = "rudder",
                        .replaces = {"gap_angle_rad", {}}},
                      P{.key = "s",
                        .member = &RudderGap::s,
                        .unit = "1/rad2",
                        .range = {.high = 0.0},
                        .null = unchanged,
                        .prior = 1.0,
                        .floor = 0.2,
                        .table = "rudder",
                        .replaces = {"gap_strength", {}}}};
  }
};

/// About the ship's own gap.
inline SearchForm<RudderGap<>> search_form(const RudderGap<>&, const SearchContext& context) {
  const double from = context["delta_lim_rad"].null, loss = -context["s"].null;
  return {.id = std::string(RudderGap<>::id),
          .coordinates = {{.name = "from", .centre = from, .deviation = 0.3, .low = 0.0, .high = std::max(0.5, from)},
                          {.name = "loss", .centre = loss, .low = 0.0, .high = 10.0 + loss}},
          .at =
              [](std::span<const double> c) {
                return RudderGap<>{c[0], -c[1]};
              },
          .starts = {{from + 0.1, loss + 0.3}}};
}

/// Whether it changes the lift that her own gap leaves at 35 deg by no more than every rudder loses.
inline bool is_of_every_ship(const RudderGap<>&, std::span<const Parameter> parameters) {
  const auto left = [&](double Parameter::*value) {
    return open_gap_factor(parameters[0].*value, parameters[1].*value, radians(35.0));
  };
  return std::abs(left(&Parameter::null) - left(&Parameter::value)) <= ordinary_lift_loss_at_35_deg;
}

/// A rudder whose lift falls a little with its angle, 1 − loss delta²: what every lift curve does and no linear one
/// knows.
inline SearchForm<RudderGap<>> usual_lift_loss() {
  return {.id = std::string(RudderGap<>::id),
          .coordinates = {{.name = "loss", .deviation = 0.2, .step = 0.02, .low = 0.0, .high = 1.0}},
          .at =
              [](std::span<const double> c) {
                return RudderGap<>{0.0, -c[0]};
              },
          .starts = {{0.0}}};
}

}  // namespace swayaw::nonlinear
