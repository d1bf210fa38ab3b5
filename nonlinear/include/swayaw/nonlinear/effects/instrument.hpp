#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "swayaw/nonlinear/effects/effect.hpp"

/// Instruments that do not show what is.
///
///     put_on(instruments, effect)    changes what the instruments of a ship show
namespace swayaw::inline nonlinear {

/// When a reading was taken [s].
struct ReadingTime {
  double time = 0.0;   ///< on the clock of the run
  double begin = 0.0;  ///< of the run
};

/// The clock of a channel against that of the run. A reading at the time t is late by
///
///     rate (t − begin) + Σ_j by_j H(t − at_j)
template <class S = double>
struct ClockError {
  struct Jump {
    S at{};  ///< on the clock of the run [s]
    S by{};  ///< later from then on [s]

    bool operator==(const Jump&) const = default;
  };

  S rate{};  ///< [s/s], positive where the clock of the channel is slow: it falls behind
  std::vector<Jump> jumps{};

  bool is_good() const { return rate == S(0.0) && jumps.empty(); }

  /// [s]
  S late(const ReadingTime& reading) const {
    S sum = rate * S(reading.time - reading.begin);
    for (const auto& jump : jumps)
      if (!(S(reading.time) < jump.at)) sum = sum + jump.by;
    return sum;
  }

  bool operator==(const ClockError&) const = default;
};

/// What an instrument had looked at: the truth so many seconds before the time that it shows, with what share.
template <class S = double>
struct Look {
  S delay{};
  S weight{1.0};
};

/// A smoothed channel. For a motion that is slow for its filter that is mean, spread and skewness of the time that it
/// looks at; two looks have the same three:
///
///     symmetric, a mean over T:   mean 0, spread T/√12, skewness 0
///     causal, T dy/dt + y = q:    mean T, spread T,     skewness 2
///
/// What is left out is of the fourth order in T over the time in which the motion changes.
template <class S = double>
struct ChannelSmoothing {
  S time{};    ///< T [s]
  S causal{};  ///< 0 for the symmetric one, 1 for the causal one

  bool acts() const { return time != S(0.0); }

  /// By which it is late in the mean [s].
  S mean() const { return causal * time; }

  std::array<Look<S>, 2> looks() const {
    using std::sqrt;
    const S spread = time * (causal + (S(1.0) - causal) / S(std::sqrt(12.0)));
    const S half_skewness = causal, root = sqrt(S(1.0) + half_skewness * half_skewness);
    const S share = half_skewness / root;
    return {Look<S>{mean() + spread * (half_skewness - root), S(0.5) * (S(1.0) + share)},
            Look<S>{mean() + spread * (half_skewness + root), S(0.5) * (S(1.0) - share)}};
  }

  bool operator==(const ChannelSmoothing&) const = default;
};

/// What an instrument makes of a quantity q: at the time t it shows scale q + bias, with the smoothed q of the time
/// t − delay − (error of its clock at t).
template <class S = double>
struct ChannelError {
  S scale{1.0};
  S bias{};
  S delay{};  ///< [s], negative where the record is early
  ClockError<S> clock{};
  ChannelSmoothing<S> smoothing{};

  S reading(const S& q) const { return scale * q + bias; }
  S truth(const S& shown) const { return (shown - bias) / scale; }

  /// How late a reading is, but for what smoothing does [s].
  S late(const ReadingTime& reading) const { return clock.is_good() ? delay : delay + clock.late(reading); }

  /// Late in the mean of its looks, on a good clock [s].
  S mean_delay() const { return smoothing.acts() ? delay + smoothing.mean() : delay; }

  /// Whether it shows what is now.
  bool is_prompt() const { return delay == S(0.0) && clock.is_good() && !smoothing.acts(); }

  bool operator==(const ChannelError&) const = default;
};

/// The instruments of a ship; perfect ones at first.
template <class S = double>
struct Instruments {
  std::array<ChannelError<S>, channel_count> channels{};
  S antenna_x{};      ///< where position and velocity over ground are measured, forward of midship [m]
  S antenna_y{};      ///< to starboard [m]
  S velocity_axes{};  ///< of u and v, through the water and over ground, to starboard of those of the ship [rad]

  ChannelError<S>& operator[](Channel channel) & { return channels[index_of(channel)]; }
  const ChannelError<S>& operator[](Channel channel) const& { return channels[index_of(channel)]; }
  ChannelError<S> operator[](Channel channel) && { return channels[index_of(channel)]; }  ///< of a temporary

  bool operator==(const Instruments&) const = default;
};

/// Calls f(channel) with the channels of the instrument that a channel is of: the two coordinates of a position are of
/// one receiver, x stands for both.
template <class F>
void for_each_of_instrument(Channel channel, F&& f) {
  f(channel);
  if (channel == Channel::x) f(Channel::y);
}

/// The quantity that a channel shows wrong that is late or smoothed; none where it is the rudder.
inline std::string_view quantity_shown_by(Channel channel) {
  switch (channel) {
    case Channel::x:
    case Channel::y: return "position";
    case Channel::psi: return "heading";
    case Channel::r: return "yaw_rate";
    case Channel::delta: return {};
    default: return "speed";
  }
}

/// The same with another scalar.
template <class To, class From>
Instruments<To> cast(const Instruments<From>& from) {
  Instruments<To> to;
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto& e = from.channels[i];
    to.channels[i] = {
        To(e.scale), To(e.bias), To(e.delay), {To(e.clock.rate)}, {To(e.smoothing.time), To(e.smoothing.causal)}};
    for (const auto& jump : e.clock.jumps) to.channels[i].clock.jumps.push_back({To(jump.at), To(jump.by)});
  }
  to.antenna_x = To(from.antenna_x);
  to.antenna_y = To(from.antenna_y);
  to.velocity_axes = To(from.velocity_axes);
  return to;
}

}  // namespace swayaw::nonlinear
