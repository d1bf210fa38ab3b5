#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

/// Recorded minus true yaw rate.
template <class S = double>
struct GyroBias {
  S bias{};  ///< [rad/s]

  static constexpr std::string_view id = "gyro_bias";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::run;  ///< the zero of a gyro wanders
  static constexpr EffectText text{.phrase = "a zero error of the yaw-rate gyro",
                                   .label = "zero error of the yaw-rate gyro",
                                   .law = "recorded minus true r",
                                   .confused_with = "nothing: ∫r against ψ"};

  static constexpr auto parameters() {
    return std::array{ParameterOf<GyroBias, S>{.key = "bias_rad_s",
                                               .member = &GyroBias::bias,
                                               .unit = "rad/s",
                                               .prior = 0.02,
                                               .floor = 0.002,
                                               .law = 0.0,
                                               .scale = ShipUnit::yaw_rate}};
  }

  /// The quantity that it shows wrong.
  std::string_view shows_wrong() const { return "yaw_rate"; }
};

template <class S>
void put_on(Instruments<S>& instruments, const GyroBias<S>& e) {
  instruments[Channel::r].bias = e.bias;
}

}  // namespace swayaw::nonlinear
