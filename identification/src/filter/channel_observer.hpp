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

/// What was recorded of a channel, at the sample of the filter that it is compared with.
struct Reading {
  Channel channel;
  std::size_t sample;  ///< of the recording
  double time = 0.0;   ///< of that sample [s]
  double since = 0.0;  ///< seconds from the sample of the filter to that of the recording
};

/// Of what readings show: what was before the sample they are compared with, and what comes after it.
enum Side : std::size_t { past, future };

/// Derivatives of a channel.
struct ChannelSlope {
  Eigen::Matrix<double, 6, 1> by_state = Eigen::Matrix<double, 6, 1>::Zero();  ///< x, y, psi, u, v, r
  Eigen::Vector3d by_acceleration = Eigen::Vector3d::Zero();                   ///< u, v, r; where the channel is late
  std::array<Eigen::Vector3d, 2> by_side{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< those of either side
};

/// @param left  of a delay at the sample [s]
inline Side side_of(double left) { return left > 0.0 ? past : future; }

/// What there is to look at on a ship at a sample.
struct Sight {
  ShipState<double> state;
  double phi;  ///< heel [rad]
  /// Times after the sample, the furthest that is shown on either side [s], and the accelerations on the way there, for
  /// the rudder moves on it; needed where a channel is late.
  std::array<double, 2> shown{};
  std::array<PlanarAcceleration<double>, 2> acceleration{};

  /// Derivatives of the accelerations by psi, u, v, r: they change on the way.
  Eigen::Matrix<double, 3, 4> A = Eigen::Matrix<double, 3, 4>::Zero();

  /// Shares of the two on the way to another time, by the straight line through both: a delay that passes 0 finds no
  /// edge between the sides.
  std::array<double, 2> shares(double time) const {
    if (shown[past] == shown[future]) return {1.0, 0.0};
    const double share = (time - shown[past]) / (shown[future] - shown[past]);
    return {1.0 - share, share};
  }

  /// Mean on the way to another time, a + time/2 A (r, a).
  PlanarAcceleration<double> towards(double time) const {
    const auto [p, f] = shares(time);
    const auto &before = acceleration[past], &after = acceleration[future];
    const Eigen::Vector3d a{p * before.u + f * after.u, p * before.v + f * after.v, p * before.r + f * after.r};
    const Eigen::Vector3d mean = a + 0.5 * time * (A.col(0) * state.motion.r + A.rightCols<3>() * a);
    return {mean[0], mean[1], mean[2]};
  }

  /// Of a slope by that mean one by the accelerations at the sample, which go with the state.
  void follow(double time, ChannelSlope& slope) const {
    const Eigen::Vector3d by_mean = slope.by_acceleration;
    slope.by_acceleration += 0.5 * time * A.rightCols<3>().transpose() * by_mean;
    slope.by_state[5] += 0.5 * time * A.col(0).dot(by_mean);
    slope.by_state.tail<4>() += A.transpose() * slope.by_acceleration;
    const auto share = shares(time);
    for (const auto side : {past, future}) slope.by_side[side] = share[side] * slope.by_acceleration;
  }
};

/// Error of an expectation; directions less than half a turn apart.
inline double compared(Channel channel, double measured, double expected) {
  const double error = measured - expected;
  return is_direction(channel) && std::abs(error) > pi ? wrapped(error) : error;
}

/// The instruments of a ship in a stream.
///
/// A reading with a delay τ shows the motion τ ago, so it is compared with the sample nearest to that time; what is
/// left of the delay there, ρ = τ − (time of the reading − time of the sample), moves the state back:
///
///     ψ − ρ r + ρ²/2 a_r,   u − ρ a_u,   v − ρ a_v,   r − ρ a_r
///
/// A smoothed channel shows the mean of two such looks.
class ChannelObserver {
 public:
  /// @param lateness  of the samples of the filter [s], from which delays are counted
  /// @param begin     of the run [s], from which clocks run
  ChannelObserver(const Instruments<double>& instruments, const Current<double>& current, double lateness, double begin)
      : instruments_(counted_from(lateness, instruments)),
        in_duals_(cast<Dual<6>>(instruments_)),
        late_in_duals_(cast<Dual<9>>(instruments_)),
        current_(current),
        begin_(begin) {
    for (const Channel channel : motion_channels()) {
      const auto& error = instruments_[channel];
      late_channels_[index_of(channel)] = !error.is_prompt();
      late_ = late_ || late(channel);
      sums_[index_of(channel)] = sum_shown(channel);
      alone_[index_of(channel)] = state_shown_alone(channel);
    }
  }

  /// Whether some channel is late, so that accelerations are needed.
  bool late() const { return late_; }

  /// Whether accelerations matter to a channel.
  bool late(Channel channel) const { return late_channels_[index_of(channel)]; }

  /// How late a reading is in the mean of its looks [s].
  double delay(Channel channel, double time) const {
    return late(channel) ? late_by(channel, time) + instruments_[channel].smoothing.mean() : 0.0;
  }

  /// Calls f(time after the sample that is looked at [s]) with each look of a reading.
  template <class F>
  void for_each_look(const Reading& reading, F&& f) const {
    const double left = reading.since - late_by(reading.channel, reading.time);
    const auto& smoothing = instruments_[reading.channel].smoothing;
    if (!smoothing.acts()) return f(left);
    for (const auto& look : smoothing.looks()) f(left - look.delay);
  }

  /// The state that the channel shows alone, but for a bias; nothing for the others.
  std::optional<int> state_alone(Channel channel) const {
    const int state = alone_[index_of(channel)];
    return state < 0 ? std::nullopt : std::optional(state);
  }

  /// Recorded minus true value of such a channel.
  double bias(Channel channel) const { return instruments_[channel].bias; }

  /// Whether the channel shows a sum of states, accelerations and heel, so that its slopes are the same everywhere.
  bool linear(Channel channel) const { return sum_of(channel) != nullptr; }

  double value(const Reading& reading, const Sight& sight) const {
    const double late = late_by(reading.channel, reading.time) - reading.since;
    const auto* sum = sum_of(reading.channel);
    const auto shown = [&](double delay) {
      const double left = late + delay;
      return sum ? at(*sum, sight, left) : computed(reading.channel, sight, left);
    };
    return filtered(reading.channel, instruments_[reading.channel].smoothing, shown);
  }

  /// The value with its derivatives.
  double value(const Reading& reading, const Sight& sight, ChannelSlope& slope) const {
    const auto& smoothing = instruments_[reading.channel].smoothing;
    if (!smoothing.acts()) return look(reading, sight, 0.0, slope);
    std::array<ChannelSlope, 2> slopes;
    std::size_t looks = 0;
    const double shown = filtered(reading.channel, smoothing,
                                  [&](double delay) { return look(reading, sight, delay, slopes[looks++]); });
    const double share = smoothing.looks()[1].weight;
    const auto mean = [share](const auto& first, const auto& second) {
      return ((1.0 - share) * first + share * second).eval();
    };
    slope = {mean(slopes[0].by_state, slopes[1].by_state), mean(slopes[0].by_acceleration, slopes[1].by_acceleration)};
    for (const auto side : {past, future}) slope.by_side[side] = mean(slopes[0].by_side[side], slopes[1].by_side[side]);
    return shown;
  }

  /// Derivative of the channel by the heel, along which it is about straight.
  double by_phi(const Reading& reading, const Sight& sight) const {
    if (const auto* sum = sum_of(reading.channel)) return sum->by_phi;
    constexpr double step = 1e-4;  // rad
    Sight more = sight, less = sight;
    more.phi += step, less.phi -= step;
    return (value(reading, more) - value(reading, less)) / (2.0 * step);
  }

  /// Whether another observer may see something else.
  bool differs(const ChannelObserver& other) const { return !same_place(other) || instruments_ != other.instruments_; }
  bool differs(const ChannelObserver& other, Channel channel) const {
    return !same_place(other) || instruments_[channel] != other.instruments_[channel] ||
           (is_body_velocity(channel) && instruments_.velocity_axes != other.instruments_.velocity_axes);
  }

 private:
  using Slopes = Eigen::Matrix<double, 6, 1>;

  static Instruments<double> counted_from(double lateness, Instruments<double> instruments) {
    for (const Channel channel : motion_channels()) instruments[channel].delay -= lateness;
    return instruments;
  }

  /// How late a reading is, but for what smoothing does [s].
  double late_by(Channel channel, double time) const { return instruments_[channel].late({time, begin_}); }

  /// One look, some seconds earlier than the reading is late.
  double look(const Reading& reading, const Sight& sight, double delay, ChannelSlope& slope) const {
    const double left = late_by(reading.channel, reading.time) + delay - reading.since;
    const auto* sum = sum_of(reading.channel);
    if (sum) slope = slope_of(*sum, left);
    const double shown = sum ? at(*sum, sight, left) : computed(reading.channel, sight, left, slope);
    if (left != 0.0) sight.follow(-left, slope);
    return shown;
  }

  bool same_place(const ChannelObserver& other) const {
    return instruments_.antenna_x == other.instruments_.antenna_x &&
           instruments_.antenna_y == other.instruments_.antenna_y && current_.speed == other.current_.speed &&
           current_.to == other.current_.to;
  }

  /// What a channel without delay shows as constant + slopes · state + slope · heel.
  struct Sum {
    Slopes by_state;
    double by_phi, constant;
  };

  /// That of a channel; nothing where it is no sum, or is late and shows a place, which goes back along the heading.
  const Sum* sum_of(Channel channel) const {
    const auto& sum = sums_[index_of(channel)];
    return sum && !(late(channel) && sum->by_state.head<2>().any()) ? &*sum : nullptr;
  }

  static ChannelSlope slope_of(const Sum& sum, double left) {
    const double psi = sum.by_state[2];
    ChannelSlope slope{.by_state = sum.by_state};
    slope.by_state[5] -= left * psi;
    slope.by_acceleration = -left * sum.by_state.tail<3>();
    slope.by_acceleration[2] += 0.5 * left * left * psi;
    return slope;
  }

  static double at(const Sum& sum, const Sight& sight, double left) {
    const auto& s = sight.state;
    const auto a = sight.towards(-left);
    const auto& by = sum.by_state;
    const double now = sum.constant + by[0] * s.x + by[1] * s.y + by[2] * s.psi + by[3] * s.motion.u +
                       by[4] * s.motion.v + by[5] * s.motion.r + sum.by_phi * sight.phi;
    return now - left * (by[2] * (s.motion.r - 0.5 * left * a.r) + by[3] * a.u + by[4] * a.v + by[5] * a.r);
  }

  double computed(Channel channel, const Sight& sight, double left) const {
    const auto there = left == 0.0 ? sight.state : moved_back(sight.state, current_, sight.towards(-left), left);
    return instruments_[channel].reading(looked_at(channel, instruments_, kinematics(there, current_, sight.phi)));
  }

  double computed(Channel channel, const Sight& sight, double left, ChannelSlope& slope) const {
    if (left == 0.0) return computed<6>(channel, in_duals_, sight, left, slope);
    return computed<9>(channel, late_in_duals_, sight, left, slope);
  }

  /// By the six states, and the three accelerations where there are nine numbers.
  template <int Size>
  double computed(Channel channel, const Instruments<Dual<Size>>& instruments, const Sight& sight, double left,
                  ChannelSlope& slope) const {
    using D = Dual<Size>;
    const auto& s = sight.state;
    const ShipState<D> state{D(s.x, 0), D(s.y, 1), D(s.psi, 2), {D(s.motion.u, 3), D(s.motion.v, 4), D(s.motion.r, 5)}};
    const Current<D> current{D(current_.speed), D(current_.to)};
    const auto there = [&] {
      if constexpr (Size == 9) {
        const auto a = sight.towards(-left);
        const PlanarAcceleration<D> acceleration{D(a.u, 6), D(a.v, 7), D(a.r, 8)};
        return moved_back(state, current, acceleration, D(left));
      } else {
        return state;
      }
    }();
    const auto looked = looked_at(channel, instruments, kinematics(there, current, D(sight.phi)));
    const D shown = instruments[channel].reading(looked);
    slope = {.by_state = shown.v.template head<6>()};
    if constexpr (Size == 9) slope.by_acceleration = shown.v.template tail<3>();
    return shown.a;
  }

  /// By what it shows at places where no state is 0, and elsewhere; nothing where that is no such sum.
  std::optional<Sum> sum_shown(Channel channel) const {
    constexpr double rounding = 1e-12;
    const Sight here{{1.1, 1.2, 0.3, {1.4, 0.5, 0.6}}, 0.1};
    const Sight there{{-2.0, 0.7, -1.9, {2.3, -0.6, -1.2}}, -0.2};
    ChannelSlope slope, elsewhere;
    const double shown = computed(channel, here, 0.0, slope), expected = computed(channel, there, 0.0, elsewhere);
    if (slope.by_state != elsewhere.by_state) return std::nullopt;
    Sum sum{.by_state = slope.by_state, .by_phi = 0.0, .constant = 0.0};
    Sight heeled = here;
    heeled.phi += 1.0;
    sum.by_phi = computed(channel, heeled, 0.0) - shown;
    sum.constant = shown - at(sum, here, 0.0);
    return std::abs(at(sum, there, 0.0) - expected) < rounding ? std::optional(sum) : std::nullopt;
  }

  int state_shown_alone(Channel channel) const {
    const auto& sum = sums_[index_of(channel)];
    if (late(channel) || !sum) return -1;
    for (int i = 0; i < 6; ++i)
      if (sum->by_state == Slopes::Unit(i)) return i;
    return -1;
  }

  Instruments<double> instruments_;
  Instruments<Dual<6>> in_duals_;
  Instruments<Dual<9>> late_in_duals_;
  Current<double> current_;
  double begin_;
  bool late_ = false;
  std::array<bool, channel_count> late_channels_{};
  std::array<std::optional<Sum>, channel_count> sums_{};
  std::array<int, channel_count> alone_{};
};

}  // namespace swayaw::identification::detail
