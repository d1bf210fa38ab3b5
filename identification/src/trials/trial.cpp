#include "swayaw/identification/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "trial_run.hpp"

namespace swayaw::inline identification {
namespace {

using namespace detail;

/// Time from the execute to the first 10 deg change of heading on either side.
MaybeTold first_ten(const TrialRun& run, const Approach& approach) {
  MaybeTold result;
  for (const double sign : {1.0, -1.0}) {
    const auto t =
        passage(run.psi, approach.heading.value + sign * radians(10.0), sign, approach.execute.value, run.end());
    if (t && (!result || t->value < result->value)) result = t;
  }
  if (!result) return result;
  const auto slope = local_cubic(run.psi, result->value)->slope(result->value);
  return Told{
      result->value - approach.execute.value,
      together(result->standard_error, approach.heading.standard_error / slope.value, approach.execute.standard_error)};
}

/// Whether the heading goes to the side of the rudder: positive rudder angles turn to port.
bool turns_against(const TrialRun& run, const TrialResult& result) {
  if (run.legs.size() < 2) return false;
  if (result.steering.least_squares)
    return result.steering.least_squares->K.value / result.steering.least_squares->T.value < 0.0;
  if (result.turn) return result.turn->heading_change * yaw_sign(result.turn->side) * run.legs[1].level > 0.0;
  return false;
}

void require_heading(const TrialRun& run, const TrialManoeuvre& manoeuvre) {
  const auto [low, high] = std::ranges::minmax(run.psi.value);
  const double needed = manoeuvre.kind == TrialKind::zigzag ? manoeuvre.heading : radians(10.0);
  if (manoeuvre.kind == TrialKind::spiral || manoeuvre.kind == TrialKind::steady) return;
  if (high - low < needed)
    throw Refusal(fmt::format("{}: too short for a {}: the heading changes by {:.1f} deg, {:.6g} are needed",
                              run.recording->name, manoeuvre.name, degrees(high - low), degrees(needed)));
}

void add_notes(TrialResult& result, const TrialOptions& options) {
  auto& notes = result.notes;
  if (result.against_rudder)
    notes.push_back(
        "the ship turns against her rudder: rudder_positive may be wrong: add # rudder_positive = \"starboard\" "
        "above the header row, or \"port\" if it says starboard now");
  if (result.zigzag && result.zigzag->reversals.empty() && !result.zigzag->broken_off)
    notes.push_back("the rudder is never reversed: no overshoot can be told");
  if (result.zigzag && result.zigzag->broken_off)
    notes.push_back(
        fmt::format("the zigzag ends at {:.0f} s: after that the rudder is reversed without the heading having "
                    "reached {:.6g} deg",
                    result.zigzag->end, degrees(result.manoeuvre.heading)));
  const bool judged_by_imo = result.zigzag || result.turn;
  if (judged_by_imo && !options.L)
    notes.push_back("no ship length: give --length or --ship for the criteria of MSC.137(76)");
  if (judged_by_imo && !result.approach.speed)
    notes.push_back("no speed recorded: give --speed for the criteria of MSC.137(76)");
  if (result.approach.speed_source == SpeedSource::ground || result.approach.speed_source == SpeedSource::positions)
    notes.push_back("the approach speed is that over ground");
}

}  // namespace

TrialResult judge_trial(const Recording& recording, const TrialOptions& options) {
  if (options.L) require_positive(*options.L, "ship length L [m]");
  if (options.U) require_positive(*options.U, "approach speed U [m/s]");
  const auto run = prepared(recording);
  TrialResult result{.run = recording.name,
                     .manoeuvre = manoeuvre_of(run),
                     .approach = approach_of(run, options),
                     .rudder = {},
                     .zigzag = {},
                     .turn = {},
                     .spiral = {},
                     .steady = {},
                     .time_10 = {},
                     .steering = {},
                     .imo = {},
                     .notes = {}};
  require_heading(run, result.manoeuvre);
  switch (result.manoeuvre.kind) {
    case TrialKind::zigzag:
      result.rudder = moves_of(run);
      result.zigzag = zigzag_trial(run, result.approach, result.manoeuvre, result.rudder);
      break;
    case TrialKind::turn:
      result.rudder = moves_of(run);
      result.turn = turn_trial(run, result.approach, result.notes);
      break;
    case TrialKind::spiral: result.spiral = spiral_trial(run); break;
    case TrialKind::steady: result.steady = steady_trial(run); break;
  }
  if (result.zigzag || result.turn) result.time_10 = first_ten(run, result.approach);
  result.steering = steering_trial(run, result, options);
  result.against_rudder = turns_against(run, result);
  if (options.L && result.approach.speed)
    result.imo = criteria_of(result, *options.L, result.approach.speed->value, options.max_rudder);
  add_notes(result, options);
  return result;
}

}  // namespace swayaw::identification
