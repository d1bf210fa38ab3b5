#pragma once

#include <optional>

#include "coloured_regression.hpp"
#include "relations.hpp"

/// The track against the way by velocity and heading, on a clock that may jump.
namespace swayaw::inline identification::detail {

enum TrackColumn : Eigen::Index {
  scale,
  axes,
  delay,
  drift,
  heading_delay,
  lever_x,
  lever_y,
  current_x,
  current_y,
  start_x,
  start_y,
  first_jump  ///< and as many columns as there are jumps
};

/// From `at` on a clock is late by `size` more [s].
struct ClockJump {
  double at;
  double at_error;  ///< standard error, by the fixes around it [s]
  double size;
};

/// How late positions are:   tau(t) = delay + rate (t − middle) + Σ_j size_j H(t − at_j)
struct TrackClock {
  double delay = 0.0;   ///< [s]
  double rate = 0.0;    ///< [s/s]
  double middle = 0.0;  ///< of the run [s]
  std::vector<ClockJump> jumps;

  double late(double t) const;
};

/// What a clock may do besides its delay and its jumps.
enum class ClockKind {
  good,       ///< nothing
  steady,     ///< run fast or slow
  wandering,  ///< that, and walk
};

/// A velocity in body axes.
struct VelocitySource {
  Channel surge;
  Channel sway;
  bool has_sway;
  bool through_water;
};

VelocitySource source_of(const Recording& run, Channel speed);

/// Velocity over the earth as the instruments have it, and the way by it.
struct DeadReckoning {
  std::vector<double> V_x, V_y, I_x, I_y;
  std::vector<double> H_x, H_y;  ///< ∫ r (−V_y, V_x) dt
  std::vector<double> c, s;      ///< of the heading
};

DeadReckoning dead_reckoning(const Recording& run, const VelocitySource& source);

/// The same at the times t − tau(t): as positions on that clock show it.
DeadReckoning seen_on(const TrackClock& clock, const std::vector<double>& time, const DeadReckoning& d);

double usual_speed(const DeadReckoning& d);

/// In which a ship turns by a tenth of a radian when she turns hard: a manoeuvre is slower, waves are not [s].
double block_of(const Recording& run);

/// Samples whose positions are to be compared: with a place on the way by velocity, which begins and ends with the run.
std::vector<bool> reckoned_on(const TrackClock& clock, const std::vector<double>& time);

/// Rows of x and y, in time: p − p_0 − I and the columns of the errors.
TimeSeries rows_of(const Recording& run, const VelocitySource& source, const TrackClock& clock,
                   const DeadReckoning& reckoned, const std::vector<bool>& usable);

/// Where a fit begins.
struct TrackFrom {
  TrackClock clock;
  std::optional<ErrorModel> errors;  ///< of a fit that was close
};

struct TrackFit {
  ColouredFit fit;
  TrackClock clock;  ///< `fit.beta` of delay, drift and jumps is the same
  ClockKind kind;
  TimeSeries series;
  Eigen::VectorXd prior;
};

/// One fit after the other while the clock, the one error that bends the columns of the others, moves.
///
/// @param usable  samples that are compared
TrackFit settled(const Recording& run, const VelocitySource& source, const DeadReckoning& reckoned, ClockKind kind,
                 const TrackFrom& from, const std::vector<bool>& usable);

/// On the clock that is far likelier than simpler ones, with as many jumps as are likely.
TrackFit on_likeliest_clock(const Recording& run, const VelocitySource& source);

}  // namespace swayaw::identification::detail
