#pragma once

#include <array>
#include <optional>
#include <span>

#include "swayaw/core/channel_table.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// What the instruments make of a motion: the same law in simulation, filter and fit. docs/effects.md tells signs.
namespace swayaw::inline nonlinear {

/// The instruments as the effects make them; effects of other kinds are passed over.
template <class S>
Instruments<S> instruments_of(std::span<const EffectIn<S>> effects) {
  Instruments<S> instruments;
  const auto put = [&](const auto& e) {
    if constexpr (requires { put_on(instruments, e); }) put_on(instruments, e);
  };
  for (const auto& effect : effects) std::visit(put, effect);
  return instruments;
}

// ---------------------------------------------------------------- observation

/// What there is to look at on a ship in a stream.
template <class S>
Kinematics<S> kinematics(const ShipState<S>& state, const Current<S>& current, const S& phi = S(0.0)) {
  return {state, over_ground(current, state), phi};
}

/// Position and velocity over ground of the point l = (x, y) of the ship: p + R(psi) l, V + r × l.
template <class S>
Kinematics<S> at_point(Kinematics<S> k, const S& x, const S& y) {
  const auto [s, c] = sin_cos(k.state.psi);
  k.state.x = k.state.x + x * c - y * s;
  k.state.y = k.state.y + x * s + y * c;
  k.ground.u = k.ground.u - k.state.motion.r * y;
  k.ground.v = k.ground.v + k.state.motion.r * x;
  return k;
}

/// A velocity in axes turned to starboard by an angle.
template <class S>
PlanarMotion<S> in_turned_axes(const PlanarMotion<S>& m, const S& angle) {
  const auto [s, c] = sin_cos(angle);
  return {m.u * c + m.v * s, m.v * c - m.u * s, m.r};
}

/// Whether a channel shows a part of a velocity in axes of the ship.
constexpr bool is_body_velocity(Channel channel) {
  return channel == Channel::u || channel == Channel::v || channel == Channel::u_ground || channel == Channel::v_ground;
}

/// The motion some seconds ago, by the midpoint rule and constant accelerations.
template <class S, class A>
ShipState<S> moved_back(const ShipState<S>& s, const Current<S>& current, const PlanarAcceleration<A>& a,
                        const S& delay) {
  const auto back = [&](const ShipState<S>& rate_at, const S& t) {
    const auto ground = over_ground(current, rate_at);
    const auto [sine, cosine] = sin_cos(rate_at.psi);
    return ShipState<S>{s.x - t * (ground.u * cosine - ground.v * sine),
                        s.y - t * (ground.u * sine + ground.v * cosine),
                        s.psi - t * rate_at.motion.r,
                        {s.motion.u - t * a.u, s.motion.v - t * a.v, s.motion.r - t * a.r}};
  };
  return back(back(s, S(0.5 * delay)), delay);
}

/// What a channel would show of a motion that its instrument looks at, but for scale and bias.
template <class S>
S looked_at(Channel channel, const Instruments<S>& instruments, const Kinematics<S>& motion) {
  auto seen = at_point(motion, instruments.antenna_x, instruments.antenna_y);
  if (is_body_velocity(channel)) {
    seen.state.motion = in_turned_axes(seen.state.motion, instruments.velocity_axes);
    seen.ground = in_turned_axes(seen.ground, instruments.velocity_axes);
  }
  return observe(channel, seen);
}

/// The mean of two looks; directions are less than half a turn apart.
template <class S>
S mean_look(Channel channel, const S& first, const S& second, const S& weight_of_second) {
  S apart = second - first;
  if (is_direction(channel)) {
    if (S(pi) < apart) apart = apart - S(2.0 * pi);
    if (apart < S(-pi)) apart = apart + S(2.0 * pi);
  }
  return first + weight_of_second * apart;
}

/// What a channel shows through its filter.
/// @param shown  S shown(S delay): what one look shows, so many seconds earlier than the reading is late
template <class S, class Shown>
S filtered(Channel channel, const ChannelSmoothing<S>& smoothing, Shown&& shown) {
  if (!smoothing.acts()) return shown(S(0.0));
  const auto [first, second] = smoothing.looks();
  return mean_look(channel, shown(first.delay), shown(second.delay), second.weight);
}

/// What the instrument of a channel shows.
///
/// @param at       Kinematics<S> at(S delay): what there was to look at so many seconds ago, 0 for now
/// @param reading  when; needed where the clock of the channel is wrong
template <class S, class At>
S observe(Channel channel, const Instruments<S>& instruments, At&& at, const ReadingTime& reading = {}) {
  const auto& error = instruments[channel];
  const S late = error.late(reading);
  const auto shown = [&](const S& delay) { return looked_at(channel, instruments, at(late + delay)); };
  return error.reading(filtered(channel, error.smoothing, shown));
}

/// A true run as the instruments record it. A late or smoothed channel has the values of a while ago, by straight lines
/// between the samples, drawn on beyond the first and the last.
/// @param begin  of the run, which the truth may be a part of [s]: clocks count from there; unless given, its first
///               sample
Recording as_recorded(Recording truth, const Instruments<double>& instruments, std::optional<double> begin = {});

/// A recorded run without what the instruments did to it: the inverse, but that what smoothing took away is gone; the
/// channel is no later for it.
Recording as_it_was(Recording recorded, const Instruments<double>& instruments);

}  // namespace swayaw::nonlinear
