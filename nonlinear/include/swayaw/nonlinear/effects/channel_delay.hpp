#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

/// A channel is recorded late, recorded(t) = true(t − delay).
template <class S = double>
struct ChannelDelay {
  Channel channel = Channel::delta;
  S delay{};  ///< [s], negative where the record is early

  static constexpr std::string_view id = "channel_delay";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< a receiver is as late all day
  static constexpr EffectText text{
      .phrase = "a channel that is late",
      .label = "late channel",
      .law = "recorded(t) = true(t − delay), straight lines between samples; `x` delays both coordinates",
      .confused_with = "steering gear lag"};

  static constexpr auto parameters() {
    return std::array{ParameterOf<ChannelDelay, S>{.key = "delay_s",
                                                   .member = &ChannelDelay::delay,
                                                   .unit = "s",
                                                   .prior = 0.1,
                                                   .floor = 0.01,
                                                   .scale = ShipUnit::time}};
  }

  std::string_view shows_wrong() const { return quantity_shown_by(channel); }
};

template <class S>
void put_on(Instruments<S>& instruments, const ChannelDelay<S>& e) {
  for_each_of_instrument(e.channel, [&](Channel channel) { instruments[channel].delay = e.delay; });
}

/// A rudder angle that is recorded late is known no better than what lies behind it.
inline void actuate(const ChannelDelay<>& e, RudderActuator& actuator) {
  if (e.channel == Channel::delta) actuator.record_late = actuator.record_late || e.delay != 0.0;
}

}  // namespace swayaw::nonlinear
