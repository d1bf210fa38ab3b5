#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// Play between the recorded angle and the rudder: she rests until the angle has come the width back.
template <class S = double>
struct SteeringGearBacklash {
  S width{};  ///< [rad]

  static constexpr std::string_view id = "steering_gear_backlash";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{.phrase = "play in the steering gear",
                                   .label = "steering gear play",
                                   .law = "the rudder rests while \\|δ_rec − δ\\| < b/2; b = `width_rad`",
                                   .confused_with = "lag"};

  static constexpr auto parameters() {
    return std::array{ParameterOf<SteeringGearBacklash, S>{.key = "width_rad",
                                                           .member = &SteeringGearBacklash::width,
                                                           .unit = "rad",
                                                           .range = non_negative,
                                                           .prior = radians(3.0),
                                                           .floor = radians(0.3)}};
  }
};

inline void actuate(const SteeringGearBacklash<>& e, RudderActuator& actuator) { actuator.width = e.width; }

/// From a play that there is: without any the first of it does nothing that a slope could show.
inline SearchForm<SteeringGearBacklash<>> search_form(const SteeringGearBacklash<>& null,
                                                      const SearchContext& context) {
  auto form = by_parameters(null, context.parameters);
  form.starts = {{0.3}};
  return form;
}

}  // namespace swayaw::nonlinear
