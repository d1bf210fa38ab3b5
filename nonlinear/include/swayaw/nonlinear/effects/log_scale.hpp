#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw {

/// Recorded over true speed through the water.
template <class S = double>
struct LogScale {
  S scale{1.0};

  static constexpr std::string_view id = "log_scale";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< a log is calibrated once a day
  static constexpr EffectText text{.phrase = "a factor of the speed log",
                                   .label = "speed log factor",
                                   .law = "recorded over true u and speed through water",
                                   .confused_with = "current"};
  static constexpr InstrumentStage stage = InstrumentStage::reading;

  static constexpr auto parameters() {
    return std::array{ParameterOf<LogScale, S>{.key = "scale",
                                               .member = &LogScale::scale,
                                               .range = positive,
                                               .null = 1.0,
                                               .prior = 0.05,
                                               .floor = 0.01,
                                               .law = 0.0}};
  }

  /// The quantity that it shows wrong.
  std::string_view shows_wrong() const { return "speed"; }
};

inline void record(const LogScale<>& e, Recording& run, int sign) {
  for (const Channel channel : {Channel::u, Channel::speed_through_water})
    multiply(run, channel, sign > 0 ? e.scale : 1.0 / e.scale);
}

template <class S>
S shown(const LogScale<S>& e, const ChannelReading<S>& reading, const S& value) {
  const bool logged = reading.channel == Channel::u || reading.channel == Channel::speed_through_water;
  return logged ? S(value * e.scale) : value;
}

}  // namespace swayaw
