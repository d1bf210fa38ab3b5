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
    for (const Channel channel : motion_channels()) {
      sums_[index_of(channel)] = sum_shown(channel);
      alone_[index_of(channel)] = state_shown_alone(channel);
    }
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

  /// Whether the channel shows a sum of states, accelerations and heel, so that its slopes are the same everywhere.
  bool linear(Channel channel) const { return sums_[index_of(channel)].has_value(); }

  double value(Channel channel, const Sight& sight) const {
    const auto& sum = sums_[index_of(channel)];
    return sum ? sum->at(sight) : computed(channel, sight);
  }

  /// The value with its derivatives.
  double value(Channel channel, const Sight& sight, ChannelSlope& slope) const {
    const auto& sum = sums_[index_of(channel)];
    if (!sum) return computed(channel, sight, slope);
    slope = sum->by_state;
    return sum->at(sight);
  }

  /// Derivative of the channel by the heel, along which it is about straight.
  double by_phi(Channel channel, const Sight& sight) const {
    if (const auto& sum = sums_[index_of(channel)]) return sum->by_phi;
    constexpr double step = 1e-4;  // rad
    Sight more = sight, less = sight;
    more.phi += step, less.phi -= step;
    return (computed(channel, more) - computed(channel, less)) / (2.0 * step);
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

  /// What a channel shows as constant + slopes · (state, acceleration, heel).
  struct Sum {
    ChannelSlope by_state;
    Eigen::Vector3d by_acceleration;
    double by_phi, constant;

    double at(const Sight& sight) const {
      const auto& [s, a, phi] = sight;
      return constant + by_state[0] * s.x + by_state[1] * s.y + by_state[2] * s.psi + by_state[3] * s.motion.u +
             by_state[4] * s.motion.v + by_state[5] * s.motion.r + by_acceleration[0] * a.u + by_acceleration[1] * a.v +
             by_acceleration[2] * a.r + by_phi * phi;
    }
  };

  double computed(Channel channel, const Sight& sight) const {
    return observe(channel, instruments_, [&](double delay) {
      const bool now = delay == 0.0;
      return kinematics(now ? sight.state : moved_back(sight.state, current_, sight.acceleration, delay), current_,
                        sight.phi);
    });
  }

  double computed(Channel channel, const Sight& sight, ChannelSlope& slope) const {
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

  /// By what it shows at places where no state is 0, and elsewhere; nothing where that is no such sum.
  std::optional<Sum> sum_shown(Channel channel) const {
    constexpr double rounding = 1e-12;
    const Sight here{{1.1, 1.2, 0.3, {1.4, 0.5, 0.6}}, {0.7, 0.8, 0.9}, 0.1};
    const Sight there{{-2.0, 0.7, -1.9, {2.3, -0.6, -1.2}}, {-0.4, 0.3, -1.1}, -0.2};
    Sum sum{
        .by_state = ChannelSlope::Zero(), .by_acceleration = Eigen::Vector3d::Zero(), .by_phi = 0.0, .constant = 0.0};
    ChannelSlope elsewhere;
    const double shown = computed(channel, here, sum.by_state), expected = computed(channel, there, elsewhere);
    if (sum.by_state != elsewhere) return std::nullopt;
    const auto change = [&](double PlanarAcceleration<double>::*part) {
      Sight more = here, less = here;
      more.acceleration.*part += 1.0, less.acceleration.*part -= 1.0;
      return 0.5 * (computed(channel, more) - computed(channel, less));
    };
    using A = PlanarAcceleration<double>;
    if (late(channel)) sum.by_acceleration << change(&A::u), change(&A::v), change(&A::r);
    Sight heeled = here;
    heeled.phi += 1.0;
    sum.by_phi = computed(channel, heeled) - shown;
    sum.constant = shown - sum.at(here);
    return std::abs(sum.at(there) - expected) < rounding ? std::optional(sum) : std::nullopt;
  }

  int state_shown_alone(Channel channel) const {
    const auto& sum = sums_[index_of(channel)];
    if (late(channel) || !sum) return -1;
    for (int i = 0; i < 6; ++i)
      if (sum->by_state == ChannelSlope::Unit(i)) return i;
    return -1;
  }

  Instruments<double> instruments_;
  Instruments<D> in_duals_;
  Current<double> current_;
  bool late_ = false;
  std::array<std::optional<Sum>, channel_count> sums_{};
  std::array<int, channel_count> alone_{};
};

}  // namespace swayaw::identification::detail
