#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

/// Recorded over true yaw rate.
template <class S = double>
struct GyroScale {
  S scale{1.0};

  static constexpr std::string_view id = "gyro_scale";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< of one gyro, at one temperature
  static constexpr EffectText text{.phrase = "a factor of the yaw-rate gyro",
                                   .label = "yaw-rate gyro factor",
                                   .law = "recorded over true r",
                                   .confused_with = "nothing: ∫r against ψ, in turns"};

  /// Gyros on board are off by 0.5 to 1.5 %, that of the 3 m Esso Osaka by 1.5 %: a trace.
  static constexpr auto parameters() {
    return std::array{ParameterOf<GyroScale, S>{.key = "scale",
                                                .member = &GyroScale::scale,
                                                .range = positive,
                                                .null = 1.0,
                                                .prior = 0.03,
                                                .floor = 0.02,
                                                .law = 0.0}};
  }

  /// The quantity that it shows wrong.
  std::string_view shows_wrong() const { return "yaw_rate"; }
};

template <class S>
void put_on(Instruments<S>& instruments, const GyroScale<S>& e) {
  instruments[Channel::r].scale = e.scale;
}

}  // namespace swayaw::nonlinear
