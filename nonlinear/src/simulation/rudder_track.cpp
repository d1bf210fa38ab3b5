#include "swayaw/nonlinear/simulation/rudder_track.hpp"

#include <algorithm>
#include <cmath>

#include "rudder_follower.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The line on which a time lies.
template <class Line>
std::size_t line_at(std::span<const Line> lines, double time, auto&& begin) {
  const auto after = std::ranges::upper_bound(lines, time, {}, begin) - lines.begin();
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - 1, 0));
}

/// When the next line begins.
double end_of(std::span<const AngleLine> lines, std::size_t i) {
  return i + 1 < lines.size() ? lines[i + 1].time : never;
}

/// Angle of a line some time after it begins; a line at rest may last for ever.
double after(const AngleLine& line, double time) {
  return line.rate == 0.0 ? line.angle : line.angle + line.rate * time;
}

}  // namespace

double angle_at(std::span<const AngleLine> lines, double time) {
  const auto& line = lines[line_at(lines, time, &AngleLine::time)];
  return after(line, time - line.time);
}

// ---------------------------------------------------------------- lines

std::vector<AngleLine> lines_of(const RudderMotion<>& motion, double from) {
  constexpr double allowed = 1e-6;
  std::vector<AngleLine> lines;
  double time = from;
  while (true) {
    const double kink = motion.next_kink(time), T = motion.fading(time);
    double end = std::min(kink, time + 1.0);
    if (T > 0.0) {
      // a chord of exp(−t/T) with amplitude A is off by A (h/T)²/8
      const double A = std::abs(motion.at(time + 50.0 * T) - motion.at(time));
      if (A < allowed) break;
      end = std::min(kink, time + T * std::min(1.0, std::sqrt(8.0 * allowed / A)));
    }
    const double rate = (motion.at(end) - motion.at(time)) / (end - time);
    lines.push_back({time, motion.at(time), rate});
    if (kink == never && T == 0.0) return lines;
    time = T > 0.0 ? end : kink;
  }
  lines.push_back({time, motion.at(time), 0.0});
  return lines;
}

std::vector<AngleLine> lines_through(std::span<const double> time, std::span<const double> angle) {
  std::vector<AngleLine> lines;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool last = i + 1 == time.size();
    lines.push_back({time[i], angle[i], last ? 0.0 : (angle[i + 1] - angle[i]) / (time[i + 1] - time[i])});
  }
  return lines;
}

// ---------------------------------------------------------------- play

std::vector<AngleLine> behind_play(std::span<const AngleLine> lines, double width, double start) {
  if (!(width > 0.0)) return {lines.begin(), lines.end()};
  std::vector<AngleLine> result;
  PlayFollower play(width, start);
  for (std::size_t i = 0; i < lines.size(); ++i)
    play.follow(lines[i], end_of(lines, i) - lines[i].time, [&](const AngleLine& line) { result.push_back(line); });
  return result;
}

// ---------------------------------------------------------------- lag

std::vector<RudderMotion<>> behind_lag(std::span<const AngleLine> lines, double lag, double rate, double start) {
  std::vector<RudderMotion<>> motions;
  LagFollower rudder(lag, rate, start);
  for (std::size_t i = 0; i < lines.size(); ++i)
    rudder.follow(lines[i], end_of(lines, i), [&](const RudderMotion<>& motion) { motions.push_back(motion); });
  return motions;
}

// ---------------------------------------------------------------- all

RudderTrack::RudderTrack(const RudderActuator& actuator, std::span<const AngleLine> recorded) {
  follow(actuator, recorded, recorded.front().angle, recorded.front().angle);
}

RudderTrack::RudderTrack(const RudderActuator& actuator, std::span<const AngleLine> recorded,
                         const RudderTrack& before) {
  const double now = recorded.front().time;
  follow(actuator, recorded, angle_at(before.played_, now), before.at(now) - before.offset_);
}

void RudderTrack::follow(const RudderActuator& actuator, std::span<const AngleLine> recorded, double played,
                         double lagged) {
  offset_ = actuator.offset;
  played_ = behind_play(recorded, actuator.width, played);
  motions_ = behind_lag(played_, actuator.lag, actuator.rate, lagged);
  for (auto& motion : motions_) motion = motion.shifted(offset_);
}

double RudderTrack::at(double time) const {
  const std::span<const RudderMotion<>> motions(motions_);
  const auto& motion = motions[line_at(motions, time, &RudderMotion<>::start)];
  return motion.at(std::max(time, motion.start()));
}

std::vector<double> RudderTrack::at(std::span<const double> times) const {
  std::vector<double> angles;
  angles.reserve(times.size());
  auto motion = motions_.begin();
  for (const double time : times) {
    while (motion + 1 != motions_.end() && (motion + 1)->start() <= time) ++motion;
    angles.push_back(motion->at(std::max(time, motion->start())));
  }
  return angles;
}

}  // namespace swayaw::nonlinear
