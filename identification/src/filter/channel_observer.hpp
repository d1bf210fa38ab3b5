#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"

/// What the channels of a run show of the state of a filter, and how that changes with the state. Not installed.
namespace swayaw::inline identification::detail {

/// Derivative of a channel by x, y, psi, u, v, r.
using ChannelSlope = Eigen::Matrix<double, 6, 1>;

/// What there is to look at on a ship at a sample.
struct Sight {
  ShipState<double> state;
  PlanarAcceleration<double> acceleration;  ///< needed where a channel is late
  double phi;                               ///< heel [rad]
};

/// Error of an expectation; directions less than half a turn apart.
inline double compared(Channel channel, double measured, double expected) {
  const double error = measured - expected;
  return is_direction(channel) && std::abs(error) > pi ? wrapped(error) : error;
}

/// The instruments of a ship in a stream.
class ChannelObserver {
 public:
  ChannelObserver(const Instruments<double>& instruments, const Current<double>& current)
      : instruments_(instruments), in_duals_(cast<D>(instruments)), current_(current) {
    for (const auto& error : instruments.channels) late_ = late_ || error.delay != 0.0;
    for (const Channel channel : motion_channels()) alone_[index_of(channel)] = state_shown_alone(channel);
  }

  /// Whether some channel is late, so that accelerations are needed.
  bool late() const { return late_; }

  /// The state that the channel shows alone, but for a bias; nothing for the others.
  std::optional<int> state_alone(Channel channel) const {
    const int state = alone_[index_of(channel)];
    return state < 0 ? std::nullopt : std::optional(state);
  }

  /// Recorded minus true value of such a channel.
  double bias(Channel channel) const { return instruments_[channel].bias; }

  double value(Channel channel, const Sight& sight) const {
    return observe(channel, instruments_, [&](double delay) {
      const bool now = delay == 0.0;
      return kinematics(now ? sight.state : moved_back(sight.state, current_, sight.acceleration, delay), current_,
                        sight.phi);
    });
  }

  /// The value with its derivatives.
  double value(Channel channel, const Sight& sight, ChannelSlope& slope) const {
    const auto& s = sight.state;
    const ShipState<D> state{D(s.x, 0), D(s.y, 1), D(s.psi, 2), {D(s.motion.u, 3), D(s.motion.v, 4), D(s.motion.r, 5)}};
    const Current<D> current{D(current_.speed), D(current_.to)};
    const D shown = observe(channel, in_duals_, [&](const D& delay) {
      const bool now = delay == D(0.0);
      return kinematics(now ? state : moved_back(state, current, sight.acceleration, delay), current, D(sight.phi));
    });
    slope = shown.v;
    return shown.a;
  }

  /// Whether accelerations matter to a channel.
  bool late(Channel channel) const { return instruments_[channel].delay != 0.0; }

  /// Whether another observer may see something else.
  bool differs(const ChannelObserver& other) const { return !same_place(other) || instruments_ != other.instruments_; }
  bool differs(const ChannelObserver& other, Channel channel) const {
    return !same_place(other) || instruments_[channel] != other.instruments_[channel];
  }

 private:
  using D = Dual<6>;

  bool same_place(const ChannelObserver& other) const {
    return instruments_.antenna_x == other.instruments_.antenna_x &&
           instruments_.antenna_y == other.instruments_.antenna_y && current_.speed == other.current_.speed &&
           current_.to == other.current_.to;
  }

  /// By its derivatives where no state is 0: a channel that shows one state alone has a unit vector there.
  int state_shown_alone(Channel channel) const {
    if (instruments_[channel].delay != 0.0) return -1;
    ChannelSlope slope;
    value(channel, {{1.1, 1.2, 0.3, {1.4, 0.5, 0.6}}, {0.7, 0.8, 0.9}, 0.1}, slope);
    for (int i = 0; i < 6; ++i)
      if (slope == ChannelSlope::Unit(i)) return i;
    return -1;
  }

  Instruments<double> instruments_;
  Instruments<D> in_duals_;
  Current<double> current_;
  bool late_ = false;
  std::array<int, channel_count> alone_{};
};

}  // namespace swayaw::identification::detail
