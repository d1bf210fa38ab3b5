#pragma once

#include <limits>

#include "swayaw/nonlinear/effects/instrument.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// The clock of one channel against that of the run: a reading at the time t is late by
///
///     rate (t − begin of the run) + by H(t − at)
///
/// A clock that jumps more than once is as many of these, each with its own `at`.
template <class S = double>
struct ClockDrift {
  Channel channel = Channel::delta;
  S rate{};                                           ///< [s/s]
  S at = S(std::numeric_limits<double>::infinity());  ///< of a jump, on the clock of the run [s]
  S by{};                                             ///< later from then on [s]

  static constexpr std::string_view id = "clock_drift";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::run;  ///< clocks are set between runs
  static constexpr EffectText text{
      .phrase = "a channel whose clock runs or jumps against the others",
      .label = "clock of a channel",
      .law = "recorded(t) = true(t − rate (t − begin) − `by_s` H(t − `at_s`)); one for each jump",
      .confused_with = "a late channel → a longer run; current, where it is the clock of the positions"};

  /// A clock that is 0.03 % slow is late by 0.3 s after a quarter of an hour, half a sample at most recordings' rate.
  static constexpr auto parameters() {
    using P = ParameterOf<ClockDrift, S>;
    constexpr double never = std::numeric_limits<double>::infinity();
    return std::array{
        P{.key = "rate", .member = &ClockDrift::rate, .required = false, .prior = 3e-3, .floor = 3e-4, .law = 0.0},
        P{.key = "at_s",
          .member = &ClockDrift::at,
          .unit = "s",
          .required = false,
          .fallback = never,
          .null = never,
          .prior = 5.0,
          .law = 0.0,
          .scale = ShipUnit::time,
          .decides = false},
        P{.key = "by_s",
          .member = &ClockDrift::by,
          .unit = "s",
          .required = false,
          .prior = 0.1,
          .floor = 0.01,
          .law = 0.0,
          .scale = ShipUnit::time}};
  }

  /// What may stand on a clock of its own, and moves fast enough to tell.
  static constexpr bool is_searched_in(Channel channel) {
    return channel == Channel::x || channel == Channel::psi || channel == Channel::r || channel == Channel::delta;
  }

  std::string_view shows_wrong() const { return quantity_shown_by(channel); }
};

/// What a file must give besides.
template <class S>
std::string_view needed_besides(const ClockDrift<S>& e) {
  const bool jumps = e.at < S(std::numeric_limits<double>::infinity());
  if (jumps != (e.by != S(0.0))) return "a jump needs at_s and by_s";
  return {};
}

/// Jumps of one clock.
template <class S>
bool stand_beside(const ClockDrift<S>& a, const ClockDrift<S>& b) {
  return a.at != b.at;
}

/// Rates and jumps add up.
template <class S>
void put_on(Instruments<S>& instruments, const ClockDrift<S>& e) {
  for_each_of_instrument(e.channel, [&](Channel channel) {
    auto& clock = instruments[channel].clock;
    clock.rate = clock.rate + e.rate;
    if (e.by != S(0.0)) clock.jumps.push_back({e.at, e.by});
  });
}

/// A clock that runs slow or fast. One that jumps has an edge at every sample, which no fit gets over: `check` tells
/// it.
inline SearchForm<ClockDrift<>> search_form(const ClockDrift<>& null, const SearchContext& context) {
  return by_parameters(null, std::span(&context["rate"], 1));
}

inline void actuate(const ClockDrift<>& e, RudderActuator& actuator) {
  const bool acts = e.rate != 0.0 || e.by != 0.0;
  if (e.channel == Channel::delta && acts) actuator.record_late = true;
}

}  // namespace swayaw::nonlinear
