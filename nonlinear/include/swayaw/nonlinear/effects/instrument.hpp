#pragma once

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/effects/effect.hpp"

/// Instruments that do not show what is: of a whole run, and of a channel at a time.
///
///     record(effect, run, sign)        sign 1: the true run as the instrument records it; −1: the record put right
///     shown(effect, reading, value)    what it shows where the ones before it show `value`
namespace swayaw {

/// In which order instruments act: where they stand, what they show, when.
enum class InstrumentStage { mounting, reading, clock };

/// A channel at a time.
template <class S = double>
struct ChannelReading {
  Channel channel;
  const ShipState<S>& state;
  S slope;  ///< true change of the channel per second
};

inline void add(Recording& run, Channel channel, double bias) {
  for (double& value : run.channels[index_of(channel)]) value += bias;
}

inline void multiply(Recording& run, Channel channel, double factor) {
  for (double& value : run.channels[index_of(channel)]) value *= factor;
}

}  // namespace swayaw
