#pragma once

#include <algorithm>
#include <cmath>

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw {

/// A channel is recorded late, recorded(t) = true(t − delay). The two coordinates of a position are of one receiver: x
/// stands for both.
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
  static constexpr InstrumentStage stage = InstrumentStage::clock;

  static constexpr auto parameters() {
    return std::array{ParameterOf<ChannelDelay, S>{.key = "delay_s",
                                                   .member = &ChannelDelay::delay,
                                                   .unit = "s",
                                                   .prior = 0.1,
                                                   .floor = 0.01,
                                                   .scale = ShipUnit::time}};
  }

  /// The quantity that it shows wrong; none where the rudder is late.
  std::string_view shows_wrong() const {
    switch (channel) {
      case Channel::x:
      case Channel::y: return "position";
      case Channel::psi: return "heading";
      case Channel::r: return "yaw_rate";
      case Channel::delta: return {};
      default: return "speed";
    }
  }
};

/// Value at a time by straight lines, drawn on beyond the ends.
inline double drawn_on(std::span<const double> times, std::span<const double> values, double time) {
  const auto after = std::ranges::upper_bound(times, time) - times.begin();
  const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(times) - 1));
  return values[k - 1] + (values[k] - values[k - 1]) * (time - times[k - 1]) / (times[k] - times[k - 1]);
}

/// Every sample gets the value of `delay` ago; samples that are missing stay so.
inline void delay_channel(Recording& run, Channel channel, double delay) {
  if (!run.has(channel)) return;
  const Interpolant known(run, channel);
  if (known.times().size() < 2) return;
  auto& values = run.channels[index_of(channel)];
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) values[i] = drawn_on(known.times(), known.values(), run.time[i] - delay);
}

inline void record(const ChannelDelay<>& e, Recording& run, int sign) {
  delay_channel(run, e.channel, sign * e.delay);
  if (e.channel == Channel::x) delay_channel(run, Channel::y, sign * e.delay);
}

/// value − delay d(value)/dt
template <class S>
S shown(const ChannelDelay<S>& e, const ChannelReading<S>& reading, const S& value) {
  const bool late = e.channel == reading.channel || (e.channel == Channel::x && reading.channel == Channel::y);
  return late ? S(value - e.delay * reading.slope) : value;
}

/// A rudder angle that is recorded late is known no better than what lies behind it.
inline void actuate(const ChannelDelay<>& e, RudderActuator& actuator) {
  if (e.channel == Channel::delta) actuator.record_delay = e.delay;
}

}  // namespace swayaw
