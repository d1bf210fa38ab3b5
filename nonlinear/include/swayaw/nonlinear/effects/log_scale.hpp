#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

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

template <class S>
void put_on(Instruments<S>& instruments, const LogScale<S>& e) {
  instruments[Channel::u].scale = instruments[Channel::speed_through_water].scale = e.scale;
}

}  // namespace swayaw::nonlinear
