#include "swayaw/nonlinear/rudder_track.hpp"

#include <algorithm>
#include <cmath>

namespace swayaw {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double slack = 1e-12;  ///< of angles that are the same but for rounding [rad]

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
  double y = start;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& x = lines[i];
    const double duration = end_of(lines, i) - x.time, side = std::copysign(1.0, x.rate);
    // the near flank of the play takes the rudder along from here on
    const double free = x.rate == 0.0 ? never : std::max(0.0, (y + side * 0.5 * width - x.angle) / x.rate);
    if (free > 0.0) result.push_back({x.time, y, 0.0});
    if (free >= duration) continue;
    result.push_back({x.time + free, y, x.rate});
    y = after({0.0, y, x.rate}, duration - free);
  }
  return result;
}

// ---------------------------------------------------------------- lag

namespace {

/// The rudder behind one line, until it ends.
class Follower {
 public:
  Follower(double lag, double rate, double start) : T_(lag), rate_(rate), y_(start) {}

  void follow(const AngleLine& x, double end, std::vector<RudderMotion<>>& motions) {
    const double reach = T_ > 0.0 ? rate_ * T_ : 0.0;  // |e| from which on the rate is the largest
    double time = x.time;
    while (time < end) {
      const double e = after(x, time - x.time) - y_;
      const double way = std::copysign(1.0, e == 0.0 ? x.rate : e),
                   gain = rate_ - way * x.rate;  // gain = −d|e|/dt at the largest rate
      const bool far = std::abs(e) > reach + slack, leaves = gain < 0.0 && std::abs(e) >= reach - slack;
      if (far || leaves) time = hurry(x, time, e, reach, way, gain, end, motions);
      else time = trail(x, time, e, reach, end, motions);
    }
  }

 private:
  /// At the largest rate, until |e| has come down to the reach. @return when that is
  double hurry(const AngleLine& x, double time, double e, double reach, double way, double gain, double end,
               std::vector<RudderMotion<>>& motions) {
    const double needed = gain > 0.0 ? (std::abs(e) - reach) / gain : never;
    const bool arrives = time + needed < end;
    motions.push_back(RudderMotion<>::moving(time, y_, way * rate_));
    if (!arrives && end == never) return end;
    y_ = arrives ? after(x, time + needed - x.time) - way * reach : y_ + way * rate_ * (end - time);
    return arrives ? std::max(time + needed, std::nextafter(time, never)) : end;
  }

  /// e(t) = b T + (e_0 − b T) exp(−t/T), until it reaches the largest rate. @return when that is
  double trail(const AngleLine& x, double time, double e, double reach, double end,
               std::vector<RudderMotion<>>& motions) {
    const double line = after(x, time - x.time), behind = x.rate * T_;  // of a rudder that follows a long line
    if (T_ > 0.0) motions.push_back(RudderMotion<>::trailing(time, line - behind, x.rate, e - behind, T_));
    else motions.push_back(RudderMotion<>::moving(time, line, x.rate));
    double until = end;
    if (T_ > 0.0 && std::abs(behind) > reach) {
      const double left = (std::copysign(reach, behind) - behind) / (e - behind);
      if (left > 0.0 && left < 1.0) until = std::min(end, time - T_ * std::log(left));
    }
    if (until < never) y_ = motions.back().at(until);
    return until;
  }

  double T_, rate_, y_;
};

}  // namespace

std::vector<RudderMotion<>> behind_lag(std::span<const AngleLine> lines, double lag, double rate, double start) {
  std::vector<RudderMotion<>> motions;
  Follower rudder(lag, rate, start);
  for (std::size_t i = 0; i < lines.size(); ++i) rudder.follow(lines[i], end_of(lines, i), motions);
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

}  // namespace swayaw
