#pragma once

#include <span>
#include <vector>

#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

/// From the recorded rudder angle to that of the rudder: play, lag, rate and offset in closed form.
namespace swayaw::inline nonlinear {

/// A straight line from a time on, until the next one begins.
struct AngleLine {
  double time;   ///< [s]
  double angle;  ///< there [rad]
  double rate;   ///< [rad/s]
};

/// Angle of the lines at a time: of the last that has begun, or the first.
double angle_at(std::span<const AngleLine> lines, double time);

/// A motion of the steering gear from a time on as straight lines. Exponentials are drawn with chords that are off by
/// less than 1e-6 rad.
std::vector<AngleLine> lines_of(const RudderMotion<>& motion, double from);

/// A recorded angle as lines, held at both ends. @param angle  one for each time
std::vector<AngleLine> lines_through(std::span<const double> time, std::span<const double> angle);

/// What is left of the lines behind a play of that width: y rests while |x − y| < width/2.
/// @param start  y at the first line
std::vector<AngleLine> behind_play(std::span<const AngleLine> lines, double width, double start);

/// The rudder behind the lines: d(y)/dt = (x − y)/T, at most the rate.
/// @param start  y at the first line
std::vector<RudderMotion<>> behind_lag(std::span<const AngleLine> lines, double lag, double rate, double start);

/// Motions of the rudder one after the other; each holds until the next begins.
class RudderTrack {
 public:
  RudderTrack() = default;

  /// The rudder behind a recorded angle, at rest with it before.
  RudderTrack(const RudderActuator& actuator, std::span<const AngleLine> recorded);

  /// The rudder behind a recorded angle that from its first line on is another; until then as `before`.
  RudderTrack(const RudderActuator& actuator, std::span<const AngleLine> recorded, const RudderTrack& before);

  double at(double time) const;

  /// At times in order, each found from the one before.
  std::vector<double> at(std::span<const double> times) const;

  std::span<const RudderMotion<>> motions() const { return motions_; }

 private:
  void follow(const RudderActuator& actuator, std::span<const AngleLine> recorded, double played, double lagged);

  std::vector<AngleLine> played_;        ///< behind the play
  std::vector<RudderMotion<>> motions_;  ///< behind the lag, with the offset
  double offset_ = 0.0;
};

}  // namespace swayaw::nonlinear
