#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/models/parts/rudder_lift_loss.hpp"

namespace swayaw::inline nonlinear {

/// Lift lost beyond an angle of attack; see stall_factor.
template <class S = double>
struct RudderStall {
  S angle{0.5 * pi};  ///< [rad]
  S depth{0.5};
  S width{0.05};  ///< [rad]

  static constexpr std::string_view id = "rudder_stall";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "a rudder that stalls",
      .label = "rudder stall",
      .law =
          "lift times 1 − D (l(\\|α_R\\|) − l(0))/(1 − l(0)), l(α) = 1/(1 + exp(−(α − α_s)/w)); α_s = "
          "`stall_angle_rad`, D = `depth`, w = `width_rad`",
      .confused_with = "gap, cubic terms → rudder staircase"};
  static constexpr bool takes_rudder_lift = true;

  /// Depth and width: half of the lift over about 0.2 rad, between the losses of [Whicker1958].
  static constexpr auto parameters() {
    using P = ParameterOf<RudderStall, S>;
    return std::array{P{.key = "stall_angle_rad",
                        .member = &RudderStall::angle,
                        .unit = "rad",
                        .range = {.low = 0.0, .high = 0.5 * pi, .above_low = true},
                        .null = 0.5 * pi,
                        .prior = 0.6,
                        .floor = 0.05,
                        .table = "rudder",
                        .replaces = {"stall_angle_rad", {}}},
                      P{.key = "depth",
                        .member = &RudderStall::depth,
                        .range = {0.0, 1.0},
                        .required = false,
                        .fallback = 0.5,
                        .null = 0.5,
                        .prior = 0.2,
                        .decides = false,
                        .table = "rudder",
                        .replaces = {"stall_depth", {}}},
                      P{.key = "width_rad",
                        .member = &RudderStall::width,
                        .unit = "rad",
                        .range = positive,
                        .required = false,
                        .fallback = 0.05,
                        .null = 0.05,
                        .prior = 0.02,
                        .decides = false,
                        .table = "rudder",
                        .replaces = {"stall_width_rad", {}}}};
  }
};

/// Below 11 deg no rudder stalls: a wing of infinite span hardly does, and the lower the aspect ratio the later. What
/// seems to stall at 5 deg has less lift at every angle, which is another lift of the rudder: so it was in two of 300
/// cases as on board (seed 34).
inline constexpr double least_stall_angle = 0.2;  // [rad]

inline SearchForm<RudderStall<>> search_form(const RudderStall<>& null, const SearchContext& context) {
  ParameterMove at{{.name = "stall angle", .centre = 0.6, .deviation = 0.5, .low = least_stall_angle, .high = 0.5 * pi},
                   context["stall_angle_rad"].index,
                   [](double c) { return c; }};
  return by_moves(null, {std::move(at), from_null(context["depth"]), by_factor(context["width_rad"], 0.5)},
                  {{0.25, 0.0, 0.0}, {0.4, 0.0, 0.0}});
}

/// Whether it costs so little lift at 35 deg that it does what every rudder does.
inline bool is_of_every_ship(const RudderStall<>& e, std::span<const Parameter>) {
  return 1.0 - stall_factor(Stall<double>{e.angle, e.depth, e.width}, radians(35.0)) <= ordinary_lift_loss_at_35_deg;
}

}  // namespace swayaw::nonlinear
