#pragma once

#include <optional>
#include <string>
#include <vector>

#include "local_curve.hpp"

/// A recording prepared for judging: channels with their noise, speed, and what the rudder did.
namespace swayaw::inline identification::detail {

/// A time during which the rudder stays on one side.
struct RudderLeg {
  double sign;      ///< +1 port, −1 starboard, 0 amidships
  double from, to;  ///< passages through half the angle of the manoeuvre (a quarter to amidships) [s]
  double level;     ///< median angle [rad]
};

struct TrialRun {
  const Recording* recording;
  Samples psi, delta, x, y;
  Samples speed;  ///< empty where nothing tells it
  SpeedSource source = SpeedSource::none;
  double rudder_before;  ///< angle before the manoeuvre [rad]
  double largest;        ///< largest angle off that [rad]
  std::vector<RudderLeg> legs;
  double steered_until;  ///< when the rudder goes further than the manoeuvre has it; else the end [s]
  Told execute;
  bool execute_said;

  bool has_track() const { return x.size() >= 5 && y.size() >= 5; }
  double end() const { return psi.time.back(); }
};

/// @throws Refusal  without heading or rudder, or with fewer than ten headings
TrialRun prepared(const Recording& run);

/// Rudder moves between legs, their start on the line through 20 % and 80 % of the way.
std::vector<RudderMove> moves_of(const TrialRun& run);

Approach approach_of(const TrialRun& run, const TrialOptions& options);

/// Way made between two times [m]: the integral of the speed, else the length of the track.
MaybeTold way_between(const TrialRun& run, const Told& from, const Told& to);

/// Rudder angle of the zigzag that the recording says it is, or that is found in it [rad]; nothing where it is none.
std::optional<double> zigzag_rudder(const Recording& run);

/// @throws Refusal  where no manoeuvre can be told
TrialManoeuvre manoeuvre_of(const TrialRun& run);

// ---------------------------------------------------------------- kinds

ZigzagTrial zigzag_trial(const TrialRun& run, const Approach& approach, const TrialManoeuvre& manoeuvre,
                         const std::vector<RudderMove>& moves);
TurnTrial turn_trial(const TrialRun& run, const Approach& approach, std::vector<std::string>& notes);
SpiralTrial spiral_trial(const TrialRun& run);
SteadyTrial steady_trial(const TrialRun& run);

SteeringTrial steering_trial(const TrialRun& run, const TrialResult& result, const TrialOptions& options);

/// Drift angle atan2(−v, u) where u and v are recorded.
Samples drift_samples(const Recording& run);

}  // namespace swayaw::identification::detail
