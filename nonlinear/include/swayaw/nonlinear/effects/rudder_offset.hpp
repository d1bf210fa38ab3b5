#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"

namespace swayaw::inline nonlinear {

/// Actual minus recorded rudder angle, positive to port.
template <class S = double>
struct RudderOffset {
  S offset{};  ///< [rad]

  static constexpr std::string_view id = "rudder_offset";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr Scope scope = Scope::group;  ///< an indicator is set once a day
  static constexpr EffectText text{.phrase = "an offset of the rudder",
                                   .label = "rudder offset",
                                   .law = "actual minus recorded angle",
                                   .confused_with = "propeller side force, heading bias"};

  /// The floor of 0.3 deg is that of practice.
  static constexpr auto parameters() {
    return std::array{ParameterOf<RudderOffset, S>{.key = "offset_rad",
                                                   .member = &RudderOffset::offset,
                                                   .unit = "rad",
                                                   .range = {-0.6, 0.6},
                                                   .prior = radians(2.0),
                                                   .floor = radians(0.3)}};
  }
};

inline void actuate(const RudderOffset<>& e, RudderActuator& actuator) { actuator.offset = e.offset; }

}  // namespace swayaw::nonlinear
