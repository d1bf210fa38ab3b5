#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// A channel was smoothed: by a first-order lag of the time T, as instruments do it while they measure, or by a mean
/// over the time T about each sample, as is done afterwards.
template <class S = double>
struct ChannelFilter {
  Channel channel = Channel::r;
  S time{};       ///< T [s]
  S causal{1.0};  ///< 1 for the lag, 0 for the mean

  static constexpr std::string_view id = "channel_filter";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< of one instrument, as it was set that day
  static constexpr EffectText text{
      .phrase = "a channel that was smoothed",
      .label = "smoothed channel",
      .law = "T dy/dt + y = true, T = `time_s`; with `causal = 0` the mean over T about each sample",
      .confused_with = "a late channel, where it is causal → quick rudder, a high rate of samples"};

  /// Its law is that of two looks, not of the filter: a lag of 3 s, 0.2 L/U, of a simulated yaw rate came out 2.6 and
  /// 3.0 s, one of 5 s 5.0 s.
  static constexpr auto parameters() {
    using P = ParameterOf<ChannelFilter, S>;
    return std::array{P{.key = "time_s",
                        .member = &ChannelFilter::time,
                        .unit = "s",
                        .range = non_negative,
                        .prior = 0.1,
                        .floor = 0.02,
                        .law = 0.1,
                        .scale = ShipUnit::time},
                      P{.key = "causal",
                        .member = &ChannelFilter::causal,
                        .range = {.low = 0.0, .high = 1.0},
                        .required = false,
                        .fallback = 1.0,
                        .null = 1.0,
                        .prior = 0.1,
                        .law = 0.0,
                        .decides = false}};
  }

  /// What ships smooth while they measure; all else that is smoothed is a late channel.
  static constexpr bool is_searched_in(Channel channel) {
    return channel == Channel::r || channel == Channel::u || channel == Channel::v ||
           channel == Channel::speed_through_water;
  }

  std::string_view shows_wrong() const { return quantity_shown_by(channel); }
};

template <class S>
void put_on(Instruments<S>& instruments, const ChannelFilter<S>& e) {
  for_each_of_instrument(e.channel, [&](Channel channel) { instruments[channel].smoothing = {e.time, e.causal}; });
}

/// By its time; a mean about each sample, which makes nothing late, is told by `check`.
inline SearchForm<ChannelFilter<>> search_form(const ChannelFilter<>& null, const SearchContext& context) {
  auto form = by_parameters(null, std::span(&context["time_s"], 1));
  form.starts = {{0.5}};
  return form;
}

inline void actuate(const ChannelFilter<>& e, RudderActuator& actuator) {
  if (e.channel == Channel::delta && e.time != 0.0) actuator.record_late = true;
}

}  // namespace swayaw::nonlinear
