#pragma once

#include <utility>
#include <vector>

#include "swayaw/core/detail/median.hpp"
#include "swayaw/core/recording.hpp"

/// Rudder, heading and speed of a log, and where its rudder is held. Not installed.
namespace swayaw::inline core::detail {

/// Samples of one channel that are there.
struct Track {
  std::vector<double> time;   ///< [s]
  std::vector<double> value;  ///< [deg] of angles

  std::size_t size() const { return time.size(); }

  /// Between samples by a straight line, held before and after them.
  double at(double t) const;

  /// First sample at t or later.
  std::size_t from(double t) const;

  /// Mean of the samples from one time to before another; NaN where there are none.
  double mean(double begin, double end) const;

  /// Lowest and highest of these samples; zeros where there are none.
  std::pair<double, double> range(double begin, double end) const;
};

/// @param unit  SI value of what the track counts in
Track track_of(const Recording& run, Channel channel, double unit);

/// [deg], without steps of a turn.
Track heading_track(const Recording& run);

/// The order where the rudder follows it: it has no noise. An autopilot's order while a hand steers is none. [deg]
Track rudder_track(const Recording& run);

/// Through the water where it is told, else over ground [m/s]; empty where no speed is told.
Track speed_track(const Recording& run);

/// Medians of seven samples: without noise, single corrections and gaps, edges as they are.
Track smoothed(const Track& track);

/// An interval in which the rudder is put to one side.
struct Hold {
  double from, to;    ///< within which it is at its level [s]
  double level;       ///< [deg]
  double flat;        ///< share of the samples within the tolerance of the level
  double begin, end;  ///< within which it is beyond the threshold [s]
  double duration() const { return to - from; }
};

/// The rudder between two samples, the second not included.
Hold hold_between(const Track& rudder, std::size_t begin, std::size_t end);

/// Where the rudder is beyond the threshold [deg], to either side; it stays counted until half of it.
std::vector<Hold> holds_beyond(const Track& rudder, double threshold);

/// Where a change of the rudder from one level to another begins that has come to its end at `arrived`: the line
/// through the samples between 15 and 85 % of the way, drawn back; where they are few, through 30 and 70 %.
double start_of_change(const Track& rudder, double from_level, double to_level, double arrived);

}  // namespace swayaw::core::detail
