#pragma once

#include <array>

#include "swayaw/nonlinear/effects/effect.hpp"

/// Instruments that do not show what is.
///
///     put_on(instruments, effect)    changes what the instruments of a ship show
namespace swayaw::inline nonlinear {

/// What an instrument makes of a quantity q: it shows scale q(t − delay) + bias at the time t.
template <class S = double>
struct ChannelError {
  S scale{1.0};
  S bias{};
  S delay{};  ///< [s], negative where the record is early

  S reading(const S& q) const { return scale * q + bias; }
  S truth(const S& shown) const { return (shown - bias) / scale; }

  bool operator==(const ChannelError&) const = default;
};

/// The instruments of a ship; perfect ones at first.
template <class S = double>
struct Instruments {
  std::array<ChannelError<S>, channel_count> channels{};
  S antenna_x{};      ///< where position and velocity over ground are measured, forward of midship [m]
  S antenna_y{};      ///< to starboard [m]
  S velocity_axes{};  ///< of u and v, through the water and over ground, to starboard of those of the ship [rad]

  ChannelError<S>& operator[](Channel channel) { return channels[index_of(channel)]; }
  const ChannelError<S>& operator[](Channel channel) const { return channels[index_of(channel)]; }

  bool operator==(const Instruments&) const = default;
};

/// The same with another scalar.
template <class To, class From>
Instruments<To> cast(const Instruments<From>& from) {
  Instruments<To> to;
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto& e = from.channels[i];
    to.channels[i] = {To(e.scale), To(e.bias), To(e.delay)};
  }
  to.antenna_x = To(from.antenna_x);
  to.antenna_y = To(from.antenna_y);
  to.velocity_axes = To(from.velocity_axes);
  return to;
}

}  // namespace swayaw::nonlinear
