#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/simulation/rudder_track.hpp"

/// A play and a lag that follow an angle line by line, in closed form. They hand on what they do piece by piece, so a
/// track can keep the pieces and a simulator pass them by. Not installed.
namespace swayaw::inline nonlinear::detail {

/// A play of that width: y rests while |x − y| < width/2.
class PlayFollower {
 public:
  PlayFollower(double width, double start) : width_(width), y_(start) {}

  double angle() const { return y_; }

  /// Calls put(line) for what is left of a line of that duration.
  template <class Put>
  void follow(const AngleLine& x, double duration, Put&& put) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double side = std::copysign(1.0, x.rate);
    // the near flank of the play takes the rudder along from here on
    const double free = x.rate == 0.0 ? never : std::max(0.0, (y_ + side * 0.5 * width_ - x.angle) / x.rate);
    if (free > 0.0) put(AngleLine{x.time, y_, 0.0});
    if (free >= duration) return;
    put(AngleLine{x.time + free, y_, x.rate});
    y_ += x.rate * (duration - free);
  }

 private:
  double width_, y_;
};

/// A lag with its largest rate, d(y)/dt = (x − y)/T.
class LagFollower {
 public:
  LagFollower(double lag, double rate, double start) : T_(lag), rate_(rate), y_(start) {}

  double angle() const { return y_; }

  /// Calls put(motion) for what the rudder does behind a line that ends at `end`.
  template <class Put>
  void follow(const AngleLine& x, double end, Put&& put) {
    const double reach = T_ > 0.0 ? rate_ * T_ : 0.0;  // |e| from which on the rate is the largest
    double time = x.time;
    while (time < end) {
      const double e = along(x, time) - y_;
      const double way = std::copysign(1.0, e == 0.0 ? x.rate : e),
                   gain = rate_ - way * x.rate;  // gain = −d|e|/dt at the largest rate
      const bool far = std::abs(e) > reach + slack, leaves = gain < 0.0 && std::abs(e) >= reach - slack;
      if (far || leaves) time = hurry(x, time, e, reach, way, gain, end, put);
      else time = trail(x, time, e, reach, end, put);
    }
  }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  static constexpr double slack = 1e-12;  ///< of angles that are the same but for rounding [rad]

  /// Angle of a line at a time; a line at rest may last for ever.
  static double along(const AngleLine& x, double time) {
    return x.rate == 0.0 ? x.angle : x.angle + x.rate * (time - x.time);
  }

  /// At the largest rate, until |e| has come down to the reach. @return when that is
  template <class Put>
  double hurry(const AngleLine& x, double time, double e, double reach, double way, double gain, double end,
               Put&& put) {
    const double needed = gain > 0.0 ? (std::abs(e) - reach) / gain : never;
    const bool arrives = time + needed < end;
    put(RudderMotion<>::moving(time, y_, way * rate_));
    if (!arrives && end == never) return end;
    // at the time that is returned, however coarse the clock: else the rudder arrives again and again, one rounding
    // later
    const double until = arrives ? std::max(time + needed, std::nextafter(time, never)) : end;
    y_ = arrives ? along(x, until) - way * reach : y_ + way * rate_ * (end - time);
    return until;
  }

  /// e(t) = b T + (e_0 − b T) exp(−t/T), until it reaches the largest rate. @return when that is
  template <class Put>
  double trail(const AngleLine& x, double time, double e, double reach, double end, Put&& put) {
    const double line = along(x, time), behind = x.rate * T_;  // of a rudder that follows a long line
    const auto motion = T_ > 0.0 ? RudderMotion<>::trailing(time, line - behind, x.rate, e - behind, T_)
                                 : RudderMotion<>::moving(time, line, x.rate);
    put(motion);
    double until = end;
    if (T_ > 0.0 && std::abs(behind) > reach) {
      const double left = (std::copysign(reach, behind) - behind) / (e - behind);
      if (left > 0.0 && left < 1.0) until = std::min(end, time - T_ * std::log(left));
    }
    if (until < never) y_ = motion.at(until);
    return until;
  }

  double T_, rate_, y_;
};

}  // namespace swayaw::nonlinear::detail
