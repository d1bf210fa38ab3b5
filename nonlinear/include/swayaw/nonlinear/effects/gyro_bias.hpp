#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw {

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
  static constexpr InstrumentStage stage = InstrumentStage::reading;

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

inline void record(const GyroBias<>& e, Recording& run, int sign) { add(run, Channel::r, sign * e.bias); }

template <class S>
S shown(const GyroBias<S>& e, const ChannelReading<S>& reading, const S& value) {
  return reading.channel == Channel::r ? S(value + e.bias) : value;
}

}  // namespace swayaw
