#include "swayaw/nonlinear/instruments/instruments.hpp"

#include <algorithm>
#include <cmath>

namespace swayaw::inline nonlinear {
namespace {

// ---------------------------------------------------------------- antenna

double sample_or(const Recording& run, Channel channel, std::size_t i, double otherwise) {
  return run[channel].empty() ? otherwise : run[channel][i];
}

/// Velocity over ground as it was recorded: by its parts, or by speed and course.
PlanarMotion<double> ground_of(const Recording& run, std::size_t i) {
  if (run.has(Channel::u_ground))
    return {sample_or(run, Channel::u_ground, i, 0.0), sample_or(run, Channel::v_ground, i, 0.0), 0.0};
  const double speed = sample_or(run, Channel::speed_over_ground, i, missing);
  const double angle = sample_or(run, Channel::course_over_ground, i, missing) - run[Channel::psi][i];
  return {speed * std::cos(angle), speed * std::sin(angle), 0.0};
}

/// What a sample tells; without a yaw rate she does not turn.
Kinematics<double> kinematics_at(const Recording& run, std::size_t i) {
  const auto of = [&](Channel channel, double otherwise) { return sample_or(run, channel, i, otherwise); };
  const ShipState<double> state{of(Channel::x, 0.0),
                                of(Channel::y, 0.0),
                                of(Channel::psi, missing),
                                {of(Channel::u, 0.0), of(Channel::v, 0.0), of(Channel::r, 0.0)}};
  return {state, ground_of(run, i), of(Channel::phi, 0.0)};
}

/// Position and velocity over ground as of the point (x, y) from the one that they are of; what cannot be told stays.
void move_place(Recording& run, double x, double y) {
  if ((x == 0.0 && y == 0.0) || !run.has(Channel::psi)) return;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const auto there = at_point(kinematics_at(run, i), x, y);
    for (const Channel channel : {Channel::x, Channel::y, Channel::u_ground, Channel::v_ground,
                                  Channel::speed_over_ground, Channel::course_over_ground}) {
      if (run[channel].empty() || std::isnan(run[channel][i])) continue;
      double& value = run.channels[index_of(channel)][i];
      const double moved = observe(channel, there);
      if (std::isfinite(moved)) value = is_direction(channel) ? value + wrapped(moved - value) : moved;
    }
  }
}

// ---------------------------------------------------------------- axes

/// Velocities in axes turned to starboard; where one of the two is not known the other stays.
void turn_velocities(Recording& run, double angle) {
  if (angle == 0.0) return;
  for (const auto& [forward, sideways] :
       {std::pair{Channel::u, Channel::v}, std::pair{Channel::u_ground, Channel::v_ground}}) {
    if (!run.has(forward) || !run.has(sideways)) continue;
    auto &u = run.channels[index_of(forward)], &v = run.channels[index_of(sideways)];
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const auto turned = in_turned_axes(PlanarMotion<double>{u[i], v[i], 0.0}, angle);
      if (std::isfinite(turned.u + turned.v)) u[i] = turned.u, v[i] = turned.v;
    }
  }
}

// ---------------------------------------------------------------- time

/// Samples of a channel that are known, in time.
struct KnownSamples {
  std::vector<double> time, value;

  /// On a straight line, drawn on beyond the ends. @param k  place of the sample after the last time asked for
  double at(double t, std::size_t& k) const {
    while (k + 1 < time.size() && time[k] <= t) ++k;
    while (k > 1 && time[k - 1] > t) --k;
    return value[k - 1] + (value[k] - value[k - 1]) * (t - time[k - 1]) / (time[k] - time[k - 1]);
  }
};

/// Those of a channel, each at the time that `when` tells of that of the sample; of two at one time the later reading.
template <class When>
KnownSamples known_samples(const Recording& run, Channel channel, When&& when) {
  std::vector<std::pair<double, double>> samples;
  for (std::size_t i = 0; i < run.samples(); ++i)
    if (std::isfinite(run[channel][i])) samples.emplace_back(when(run.time[i]), run[channel][i]);
  // a clock that leaps back puts them out of order; of seven turns at 10 Hz 7 % of a diagnosis was to sort what no
  // clock had moved
  if (!std::ranges::is_sorted(samples, {}, &std::pair<double, double>::first))
    std::ranges::stable_sort(samples, {}, &std::pair<double, double>::first);
  KnownSamples known;
  known.time.reserve(samples.size()), known.value.reserve(samples.size());
  for (const auto& [time, value] : samples)
    if (!known.time.empty() && !(time > known.time.back())) known.value.back() = value;
    else known.time.push_back(time), known.value.push_back(value);
  return known;
}

/// Every sample gets what there was when its instrument looked; samples that are missing stay so.
void make_late(Recording& run, Channel channel, const ChannelError<double>& error, double begin) {
  if (error.is_prompt() || !run.has(channel)) return;
  const auto known = known_samples(run, channel, [](double time) { return time; });
  if (known.time.size() < 2) return;
  const auto looks = error.smoothing.looks();
  std::array<std::size_t, 2> place{1, 1};
  auto& values = run.channels[index_of(channel)];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const double time = run.time[i] - error.late({run.time[i], begin});
    values[i] = error.smoothing.acts() ? mean_look(channel, known.at(time - looks[0].delay, place[0]),
                                                   known.at(time - looks[1].delay, place[1]), looks[1].weight)
                                       : known.at(time, place[0]);
  }
}

/// Every sample gets what was looked at in the mean at its time.
void make_prompt(Recording& run, Channel channel, const ChannelError<double>& error) {
  if (error.is_prompt() || !run.has(channel)) return;
  const double mean = error.smoothing.mean();
  const auto known = known_samples(run, channel, [&](double time) {
    return time - error.late({time, run.time.front()}) - mean;
  });
  if (known.time.size() < 2) return;
  std::size_t place = 1;
  auto& values = run.channels[index_of(channel)];
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) values[i] = known.at(run.time[i], place);
}

template <class F>
void for_each_channel(Recording& run, const Instruments<double>& instruments, F&& f) {
  for (std::size_t i = 0; i < channel_count; ++i)
    if (const auto channel = static_cast<Channel>(i); run.has(channel)) f(channel, instruments[channel]);
}

}  // namespace

Recording as_recorded(Recording run, const Instruments<double>& instruments, std::optional<double> begin) {
  if (run.samples() == 0) return run;
  move_place(run, instruments.antenna_x, instruments.antenna_y);
  turn_velocities(run, instruments.velocity_axes);
  for_each_channel(run, instruments, [&](Channel channel, const ChannelError<double>& error) {
    for (double& value : run.channels[index_of(channel)]) value = error.reading(value);
    make_late(run, channel, error, begin.value_or(run.time.front()));
  });
  return run;
}

Recording as_it_was(Recording run, const Instruments<double>& instruments) {
  for_each_channel(run, instruments, [&](Channel channel, const ChannelError<double>& error) {
    make_prompt(run, channel, error);
    for (double& value : run.channels[index_of(channel)]) value = error.truth(value);
  });
  turn_velocities(run, -instruments.velocity_axes);
  move_place(run, -instruments.antenna_x, -instruments.antenna_y);
  return run;
}

}  // namespace swayaw::nonlinear
