#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/side.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"

/// A recorded manoeuvre judged: what was sailed, its indices with standard errors, K and T, the criteria of
/// MSC.137(76). Heading and rudder suffice; more is told where more is recorded. docs/trial.md describes the methods.
namespace swayaw::inline identification {

/// A number read from a recording. The standard error is that of instrument noise, rounding and sampling; wind, waves
/// and the helmsman are not in it.
struct Told {
  double value;
  double standard_error;  ///< not a number where none was derived
};

/// A number that the recording may not tell.
using MaybeTold = std::optional<Told>;

struct TrialOptions {
  std::optional<double> L;            ///< ship length [m]
  std::optional<double> U;            ///< approach speed [m/s], in place of the recorded one
  double max_rudder = radians(35.0);  ///< rudder of the turning circle in MSC.137(76): 35 deg, or the largest [rad]
};

// ---------------------------------------------------------------- what was sailed

enum class TrialKind { zigzag, turn, spiral, steady };

/// "zigzag", "turn", "spiral", "steady run"
std::string_view name_of(TrialKind kind);

struct TrialManoeuvre {
  TrialKind kind;
  double rudder;     ///< D, to the whole degree where it was not said [rad]; 0 of a steady run
  double heading;    ///< H of a zigzag [rad], else 0
  bool said;         ///< by the run itself; else told from rudder and heading
  std::string name;  ///< "zigzag 10/10", "turn 35", "spiral", "steady run"
};

/// Where a speed comes from: the log shows that ahead only, water and ground are speeds of surge and sway together.
enum class SpeedSource { none, given, log, water, ground, positions };

std::string_view in_words(SpeedSource source);

/// Whether the speed is that through the water.
constexpr bool through_water(SpeedSource s) { return s == SpeedSource::log || s == SpeedSource::water; }

/// The ship before the first rudder order.
struct Approach {
  Told execute;  ///< when the rudder begins to move [s]
  bool execute_said;
  Told heading;     ///< [rad]
  MaybeTold speed;  ///< [m/s]
  SpeedSource speed_source;
  double rudder;  ///< mean angle, positive to port [rad]
  double before;  ///< recorded time before the execute [s]
};

/// A rudder order as it was carried out.
struct RudderMove {
  Told start;                  ///< [s]
  double from, to;             ///< angle before and held after, positive to port [rad]
  std::optional<double> rate;  ///< mean of the middle part of the way, positive [rad/s]; nothing in one sample
};

// ---------------------------------------------------------------- zigzag

/// A heading peak of a zigzag, and the execute before it.
struct TrialReversal {
  Side side;                 ///< to which the heading is off
  MaybeTold execute;         ///< the heading passes H [s]
  MaybeTold rudder_start;    ///< the rudder begins to go back [s]
  MaybeTold heading_then;    ///< heading off the approach then [rad]
  MaybeTold peak_time;       ///< [s]
  MaybeTold overshoot;       ///< of the peak beyond H [rad]
  MaybeTold beyond_start;    ///< of the peak beyond heading_then [rad]
  MaybeTold overshoot_time;  ///< from execute to peak [s]
};

struct ZigzagTrial {
  Side first;
  std::vector<TrialReversal> reversals;
  MaybeTold period;           ///< of the last full cycle, from execute to the next but one [s]
  MaybeTold reach;            ///< from the first execute until the heading is back at that of the approach [s]
  MaybeTold initial_turning;  ///< way made when the heading first reaches H [m]
  double end;                 ///< of the zigzag [s]: the end of the run, or where it was broken off
  bool broken_off = false;    ///< the rudder was reversed once more without the heading having reached H
};

// ---------------------------------------------------------------- turning circle

/// Lengths of a turning circle [m], along and across the heading of the approach.
struct CircleTold {
  MaybeTold advance, transfer;  ///< at 90 deg
  MaybeTold tactical_diameter;  ///< at 180 deg
  MaybeTold final_diameter;     ///< of the steady turn
  MaybeTold initial_turning;    ///< way made at 10 deg
};

/// Drift of the track over ground, of current and wind together.
struct DriftTold {
  Told north, east;   ///< [m/s]
  Told speed;         ///< [m/s]
  Told direction;     ///< to which it sets, clockwise from north [rad]
  std::size_t pairs;  ///< of places with headings 360 deg apart
};

struct TurnTrial {
  Side side;
  double heading_change;                            ///< in all [rad]
  MaybeTold time_90, time_180, time_270, time_360;  ///< from the execute [s]
  CircleTold recorded;                              ///< of the track as it was recorded
  std::optional<DriftTold> drift;                   ///< nothing where the turn does not tell it
  std::optional<CircleTold> corrected;              ///< of the track without that drift
  MaybeTold final_yaw_rate;                         ///< positive to starboard [rad/s]
  MaybeTold final_speed;                            ///< [m/s]
  MaybeTold final_drift;                            ///< drift angle atan2(−v, u) [rad]
  MaybeTold speed_kept;                             ///< final over approach speed
  MaybeTold gain;               ///< final yaw rate over rudder angle, positive where the ship follows her rudder [1/s]
  MaybeTold residual_yaw_rate;  ///< pull-out: yaw rate left after the rudder went amidships [rad/s]
};

// ---------------------------------------------------------------- spiral, steady run

struct SpiralStep {
  double delta;     ///< rudder held, positive to port [rad]
  double from, to;  ///< [s]
  Told yaw_rate;    ///< of the second half [rad/s]
};

struct SpiralTrial {
  std::vector<SpiralStep> steps;     ///< as they were sailed
  std::optional<double> loop_width;  ///< between the outermost rudder angles with two yaw rates [rad]
  MaybeTold loop_height;             ///< largest difference of yaw rate at one rudder angle [rad/s]
};

struct SteadyTrial {
  Told helm;         ///< mean rudder angle, positive to port [rad]
  Told yaw_rate;     ///< [rad/s]
  MaybeTold speed;   ///< [m/s]
  MaybeTold drift;   ///< drift angle through the water, atan2(−v, u) [rad]
  MaybeTold leeway;  ///< of the track over ground, positive to starboard of the heading [rad]
};

// ---------------------------------------------------------------- K and T

/// T dr/dt + r = K (delta + offset) with delta positive to STARBOARD, as Nomoto's K is read: positive for a stable
/// ship. Inside the library rudder angles are positive to port and K has the other sign.
struct NomotoTold {
  Told K;                             ///< [1/s]
  Told T;                             ///< [s]
  Told offset;                        ///< acts beside the recorded angle, positive to starboard [rad]
  double residual;                    ///< rms of the heading left unexplained [rad]
  std::vector<double> time, heading;  ///< the fitted heading off the approach [rad]; empty for the worked method
};

/// T1 T2 d²r/dt² + (T1 + T2) dr/dt + r = K (delta + T3 d(delta)/dt), the same sign. A number whose standard error is
/// more than half of it is not told.
struct SecondOrderTold {
  Told K;            ///< [1/s]
  Told T1T2;         ///< [s²]
  Told T1_plus_T2;   ///< [s]
  MaybeTold T1, T2;  ///< [s]; nothing for a complex pair
  Told T3;           ///< [s]
  bool K_told, T1_told, T2_told, T3_told;
};

struct SteeringTrial {
  std::optional<NomotoTold> worked;         ///< Nomoto's own method, without standard errors
  std::optional<NomotoTold> least_squares;  ///< of the heading of the whole manoeuvre
  std::optional<SecondOrderTold> second;
  MaybeTold K_prime, T_prime;  ///< K L/U, T U/L by least squares
  MaybeTold P;  ///< Norrbin's P: heading change per rudder angle one ship length after the execute, as recorded
  std::optional<double> P_of_fit;  ///< K' (1 − T' + T' exp(−1/T'))
};

// ---------------------------------------------------------------- criteria

/// A criterion of MSC.137(76) on a recorded number.
struct JudgedCriterion {
  std::string_view name;
  Side side;
  MaybeTold value;           ///< in `unit`
  double limit;              ///< in `unit`
  std::string_view unit;     ///< "L" or "deg"
  std::optional<bool> pass;  ///< nothing where value ± 2 standard errors holds the limit, or the value is not told
};

/// Pass, fail, or nothing where the interval of two standard errors about the value holds the limit.
std::optional<bool> judged(const Told& value, double limit);

struct TrialResult {
  std::string run;
  TrialManoeuvre manoeuvre;
  Approach approach;
  std::vector<RudderMove> rudder;
  std::optional<ZigzagTrial> zigzag;
  std::optional<TurnTrial> turn;
  std::optional<SpiralTrial> spiral;
  std::optional<SteadyTrial> steady;
  MaybeTold time_10;  ///< from the execute to the first 10 deg change of heading [s]
  SteeringTrial steering;
  std::vector<JudgedCriterion> imo;  ///< empty without length or speed
  bool against_rudder = false;       ///< the ship turns against her rudder: the sign of the rudder is wrong
  std::vector<std::string> notes;    ///< what cannot be told and why, one sentence each
};

/// Judges a recorded manoeuvre.
///
/// Headings at peaks, times of passages and places are read from cubics fitted to the samples about them, over as many
/// samples as agree within their noise; so no number is that of the sample nearest.
///
/// @throws Refusal            "RUN: …" where the run tells no manoeuvre: no heading, the rudder does not move, too
/// short
/// @throws std::domain_error  if L or U is not positive
TrialResult judge_trial(const Recording& run, const TrialOptions& options = {});

/// What a result says to the criteria, with the limits of `criteria_of`.
std::vector<JudgedCriterion> criteria_of(const TrialResult& trial, double L, double U, double max_rudder);

/// One line of the verdict of several trials.
struct ImoSummary {
  bool any = false;                  ///< whether anything was judged
  std::vector<std::string> failed;   ///< "tactical_diameter to port"
  std::vector<std::string> open;     ///< value crosses the limit, or was not reached
  std::vector<std::string> missing;  ///< no run tells it on either side
};

/// Of all runs together. The six steering criteria need a 10/10 and a 20/20 zigzag and a turning circle.
ImoSummary summary_of(std::span<const TrialResult> trials);

}  // namespace swayaw::identification
