#include "swayaw/nonlinear/sensors.hpp"

#include <algorithm>
#include <cmath>

namespace swayaw {
namespace {

void add(Recording& run, Channel channel, double bias) {
  for (double& value : run.channels[index_of(channel)]) value += bias;
}

void multiply(Recording& run, Channel channel, double factor) {
  for (double& value : run.channels[index_of(channel)]) value *= factor;
}

// ---------------------------------------------------------------- antenna

/// Velocity over ground of a point of the ship: u − r y, v + r x.
void move_velocity(Recording& run, double x, double y) {
  if (!run.has(Channel::r)) return;
  const auto r = run[Channel::r];
  auto &u = run.channels[index_of(Channel::u_ground)], &v = run.channels[index_of(Channel::v_ground)];
  for (std::size_t i = 0; i < u.size(); ++i) u[i] -= r[i] * y;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += r[i] * x;
}

/// The same for speed and course.
void move_course(Recording& run, double x, double y) {
  if (!run.has(Channel::r) || !run.has(Channel::speed_over_ground) || !run.has(Channel::course_over_ground)) return;
  auto &speed = run.channels[index_of(Channel::speed_over_ground)],
       &course = run.channels[index_of(Channel::course_over_ground)];
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double c = std::cos(run[Channel::psi][i]), s = std::sin(run[Channel::psi][i]), r = run[Channel::r][i];
    const double north = speed[i] * std::cos(course[i]) - r * (y * c + x * s),
                 east = speed[i] * std::sin(course[i]) + r * (x * c - y * s);
    speed[i] = std::hypot(north, east);
    course[i] += std::remainder(std::atan2(east, north) - course[i], 2.0 * pi);
  }
}

/// Position and velocity of the point that lies (x, y) from the one that they are of. The heading is the true one.
void move_place(Recording& run, double x, double y) {
  auto &north = run.channels[index_of(Channel::x)], &east = run.channels[index_of(Channel::y)];
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double c = std::cos(run[Channel::psi][i]), s = std::sin(run[Channel::psi][i]);
    if (!north.empty()) north[i] += x * c - y * s;
    if (!east.empty()) east[i] += x * s + y * c;
  }
  move_velocity(run, x, y);
  move_course(run, x, y);
}

// ---------------------------------------------------------------- delay

/// Value at a time by straight lines, drawn on beyond the ends.
double drawn_on(std::span<const double> times, std::span<const double> values, double time) {
  const auto after = std::ranges::upper_bound(times, time) - times.begin();
  const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(times) - 1));
  return values[k - 1] + (values[k] - values[k - 1]) * (time - times[k - 1]) / (times[k] - times[k - 1]);
}

/// Every sample gets the value of `delay` ago; samples that are missing stay so.
void delay_channel(Recording& run, Channel channel, double delay) {
  if (!run.has(channel)) return;
  const Interpolant known(run, channel);
  if (known.times().size() < 2) return;
  auto& values = run.channels[index_of(channel)];
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) values[i] = drawn_on(known.times(), known.values(), run.time[i] - delay);
}

void delay_by(Recording& run, const ChannelDelay<>& late, double sign) {
  delay_channel(run, late.channel, sign * late.delay);
  if (late.channel == Channel::x) delay_channel(run, Channel::y, sign * late.delay);
}

}  // namespace

Recording as_recorded(Recording run, std::span<const Effect> effects) {
  if (const auto* arm = find<AntennaLeverArm<>>(effects)) move_place(run, arm->x, arm->y);
  for (const auto& effect : effects) {
    if (const auto* heading = std::get_if<HeadingBias<>>(&effect)) add(run, Channel::psi, heading->bias);
    if (const auto* gyro = std::get_if<GyroBias<>>(&effect)) add(run, Channel::r, gyro->bias);
    if (const auto* log = std::get_if<LogScale<>>(&effect))
      for (const Channel channel : {Channel::u, Channel::speed_through_water}) multiply(run, channel, log->scale);
  }
  for (const auto& effect : effects)
    if (const auto* late = std::get_if<ChannelDelay<>>(&effect)) delay_by(run, *late, 1.0);
  return run;
}

Recording as_it_was(Recording run, std::span<const Effect> effects) {
  for (const auto& effect : effects)
    if (const auto* late = std::get_if<ChannelDelay<>>(&effect)) delay_by(run, *late, -1.0);
  for (const auto& effect : effects) {
    if (const auto* heading = std::get_if<HeadingBias<>>(&effect)) add(run, Channel::psi, -heading->bias);
    if (const auto* gyro = std::get_if<GyroBias<>>(&effect)) add(run, Channel::r, -gyro->bias);
    if (const auto* log = std::get_if<LogScale<>>(&effect))
      for (const Channel channel : {Channel::u, Channel::speed_through_water}) multiply(run, channel, 1.0 / log->scale);
  }
  if (const auto* arm = find<AntennaLeverArm<>>(effects)) move_place(run, -arm->x, -arm->y);
  return run;
}

}  // namespace swayaw
