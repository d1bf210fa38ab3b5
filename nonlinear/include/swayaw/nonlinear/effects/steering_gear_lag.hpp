#pragma once

#include <limits>

#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// The rudder follows the recorded angle late: d(delta)/dt = (delta_rec − delta)/T, at most the rate.
template <class S = double>
struct SteeringGearLag {
  S lag{};                                              ///< T [s]
  S rate = S(std::numeric_limits<double>::infinity());  ///< [rad/s]

  static constexpr std::string_view id = "steering_gear_lag";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "a rudder that follows late",
                                   .label = "steering gear lag",
                                   .law = "dδ/dt = (δ_rec − δ)/T, at most the rate; T = `lag_s`",
                                   .confused_with = "delay of the rudder channel, fluid memory"};

  static constexpr auto parameters() {
    using P = ParameterOf<SteeringGearLag, S>;
    constexpr double none = std::numeric_limits<double>::infinity();
    return std::array{P{.key = "lag_s",
                        .member = &SteeringGearLag::lag,
                        .unit = "s",
                        .range = non_negative,
                        .prior = 0.2,
                        .floor = 0.01,
                        .scale = ShipUnit::time},
                      P{.key = "rate_rad_s",
                        .member = &SteeringGearLag::rate,
                        .unit = "rad/s",
                        .range = positive,
                        .required = false,
                        .fallback = none,
                        .null = none,
                        .prior = 0.05}};
  }
};

inline void actuate(const SteeringGearLag<>& e, RudderActuator& actuator) {
  actuator.lag = e.lag;
  actuator.rate = e.rate;
}

/// Lag over its usual size, and how many times slower than the ship's gear the rudder moves; 0 for no limit.
inline SearchForm<SteeringGearLag<>> search_form(const SteeringGearLag<>&, const SearchContext& context) {
  SearchForm<SteeringGearLag<>> form{
      .id = std::string(SteeringGearLag<>::id),
      .coordinates = {{.name = "lag", .low = 0.0}, {.name = "slowness", .deviation = 0.7, .low = 0.0}},
      .at = {},
      .starts = {{0.3, 0.5}, {1.0, 0.1}}};
  form.at = [unit = context["lag_s"].deviation, rate = context.rudder_rate](std::span<const double> c) {
    SteeringGearLag<> gear{.lag = unit * c[0]};
    if (c[1] > 0.02) gear.rate = rate / c[1];
    return gear;
  };
  return form;
}

}  // namespace swayaw::nonlinear
