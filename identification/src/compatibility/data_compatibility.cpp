#include "swayaw/identification/data_compatibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "channel_character.hpp"
#include "derived_channels.hpp"
#include "mistakes.hpp"
#include "relations.hpp"
#include "run_motion.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Kind = InstrumentErrorKind;

bool is_sway(Channel channel) { return channel == Channel::v || channel == Channel::v_ground; }

/// What an error must exceed to matter: below it no answer about a ship changes.
///
/// @param step    between samples [s]
/// @param radius  of the ship's hard turns [m]
double floor_of(const InstrumentError& e, double step, double radius) {
  switch (e.kind) {
    case Kind::zero: return radians(0.003);                // [rad/s]: 1 deg of heading in five minutes
    case Kind::scale: return 0.003;                        // a log is read to 0.05 kn of 15 kn
    case Kind::delay: return std::max(step, least_delay);  // [s]
    case Kind::jump: return least_delay;                   // [s]: it is seen between samples, however far apart
    case Kind::clock_rate: return 0.003;                   // [s/s], as a scale
    case Kind::smoothing: return step;                     // [s]
    case Kind::axes:
      return is_sway(e.channel) ? radians(1.0) : radians(0.3);  // wind and a screw make a degree of drift
    case Kind::lever_arm_x:
    case Kind::lever_arm_y: return 0.01 * radius;  // [m]: of a circle of three lengths a thirtieth of the length
    default: return 0.0;
  }
}

/// Beyond this many standard deviations lies one in 5,000; a run has some ten errors, so one clean run in 500 shows
/// one.
constexpr double beyond_doubt = 3.7;

/// Standard deviations from none. Of a smoothing the data tell the square: an error of it is twice as large.
double deviations(const InstrumentError& e) {
  const double z = std::abs(e.value) / e.standard_error;
  return e.kind == Kind::smoothing ? 0.5 * z : z;
}

/// One run does not tell turned axes from a ship that the wind drifts; runs on other courses do.
enum class Scope { run, runs };

void tell(std::vector<InstrumentError>& errors, Scope scope, double step, double radius) {
  for (auto& e : errors) {
    if (e.kind == Kind::clock) continue;
    if (e.kind == Kind::axes && is_sway(e.channel) && scope == Scope::run) continue;
    e.told = deviations(e) > beyond_doubt && std::abs(e.value) > floor_of(e, step, radius);
  }
}

/// Of the hard turns of the ship [m].
double radius_of(const Recording& run) {
  const auto speeds = speeds_of(run);
  return speeds.empty() ? 0.0 : rms(filled(run, speeds.front())) / hard_yaw_rate(run);
}

// ---------------------------------------------------------------- one run

InstrumentError* find(std::vector<InstrumentError>& errors, Channel channel, Kind kind) {
  const auto found =
      std::ranges::find_if(errors, [&](const InstrumentError& e) { return e.channel == channel && e.kind == kind; });
  return found == errors.end() ? nullptr : &*found;
}

bool is_of_clock_of_positions(const InstrumentError& e) {
  return e.channel == Channel::x && (e.kind == Kind::delay || e.kind == Kind::clock_rate || e.kind == Kind::jump);
}

/// Of two values of one error, by two speeds, that with the smaller standard error. What was told of the clock of the
/// positions is mended before the next speed is asked; there may be any number of jumps.
void add(std::vector<InstrumentError>& errors, const std::vector<InstrumentError>& more) {
  for (const auto& e : more) {
    auto* known = e.kind == Kind::jump ? nullptr : find(errors, e.channel, e.kind);
    if (!known) errors.push_back(e);
    else if (known->told && is_of_clock_of_positions(*known)) continue;
    else if (e.standard_error < known->standard_error) *known = e;
  }
}

/// A heading that is late makes the yaw rate look early: what is told of the heading does not count for the rate.
void share_delay(std::vector<InstrumentError>& errors, double step, double radius) {
  auto *heading = find(errors, Channel::psi, Kind::delay), *rate = find(errors, Channel::r, Kind::delay);
  if (!heading || !rate) return;
  std::vector<InstrumentError> alone{*heading};
  tell(alone, Scope::run, step, radius);
  if (!alone.front().told) return;
  rate->value += heading->value;
  rate->standard_error = std::hypot(rate->standard_error, heading->standard_error);
}

std::vector<double> gaps_in(const Recording& run) {
  std::vector<double> gaps;
  const auto lost = gaps_of(run, Channel::psi);
  for (std::size_t i = 0; i < lost.size(); ++i)
    if (lost[i] > 0.0) gaps.insert(gaps.end(), {run.time[i] - lost[i], run.time[i]});
  return gaps;
}

/// A log alone, without sway, cannot tell the clock of the positions; a velocity with sway can, and comes first.
Recording with_clock_of_positions(const Recording& run, const std::vector<InstrumentError>& errors) {
  RunCheck clock;
  for (const auto& e : errors)
    if (e.told && is_of_clock_of_positions(e)) clock.errors.push_back(e);
  return clock.errors.empty() ? run : repaired(run, clock);
}

/// Errors of the kinematics of a run without mistakes.
std::vector<InstrumentError> errors_of(const Recording& run) {
  std::vector<InstrumentError> errors;
  const double step = usual_step(run.time), radius = radius_of(run);
  auto on_time = run;
  for (const Channel speed : speeds_of(run)) {
    add(errors, track_errors(on_time, speed));
    if (const auto drift = drift_on_straight_courses(run, speed)) add(errors, {*drift});
    tell(errors, Scope::run, step, radius);
    on_time = with_clock_of_positions(run, errors);
  }
  add(errors, yaw_rate_errors(run));
  share_delay(errors, step, radius);
  tell(errors, Scope::run, step, radius);
  return errors;
}

InstrumentError reversed_rudder(const Recording& run) {
  const Channel rudder = run.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  return {.channel = rudder, .kind = Kind::sign, .value = -1.0, .standard_error = 0.0, .told = true};
}

/// Sway that was not measured is no sway; velocities over ground that were made of the positions tell nothing of them.
void leave_out_derived(Recording& run, RunCheck& check) {
  for (const auto& [surge, sway] :
       {std::pair(Channel::u_ground, Channel::v_ground), std::pair(Channel::u, Channel::v)}) {
    const auto made_of = sway_made_of(run, surge, sway);
    if (!made_of) continue;
    check.derived.push_back({sway, *made_of});
    run.channels[index_of(sway)].clear();
    if (!made_of->ends_with("positions")) continue;
    check.derived.push_back({surge, *made_of});
    run.channels[index_of(surge)].clear();
  }
}

void note_what_is_missing(const Recording& run, std::vector<std::string>& notes) {
  const bool track = run.has(Channel::x) && run.has(Channel::y);
  if (!run.has(Channel::r)) notes.push_back("no yaw rate: zero, scale and clock of a gyro");
  else if (!tells_scale_of_gyro(run)) notes.push_back("no turn that begins or ends: scale of a gyro");
  if (!track) notes.push_back("no positions: scale of the log, compass and clocks against the track");
  const auto speeds = speeds_of(run);
  if (track && speeds.size() == 1 && speeds[0] != Channel::u_ground && !run.has(Channel::v))
    notes.push_back(
        "no sway: clocks but for their jumps, antenna and compass, and the scale of the log while the ship turns");
  if (track && speeds.empty()) notes.push_back("no speed beside the track: scale, compass and clocks of positions");
}

}  // namespace

const InstrumentError* RunCheck::mistake() const {
  const auto found = std::ranges::find_if(errors, [](const InstrumentError& e) { return is_mistake(e.kind); });
  return found == errors.end() ? nullptr : &*found;
}

namespace {

/// Samples of 1e300 or 1e-300 square to what is no number.
void leave_out_beyond_numbers(RunCheck& check) {
  const auto is_beyond = [](const InstrumentError& e) {
    return !std::isfinite(e.value) || !std::isfinite(e.standard_error);
  };
  for (const auto& e : check.errors)
    if (is_beyond(e)) {
      const auto words = fmt::format("errors of {}: samples of the run are too large or too small to reckon with",
                                     short_name(e.channel));
      if (std::ranges::count(check.cannot_tell, words) == 0) check.cannot_tell.push_back(words);
    }
  std::erase_if(check.errors, is_beyond);
}

}  // namespace

RunCheck check_run(const Recording& run) {
  if (run.samples() < samples_for_check)
    throw Refusal(fmt::format("{}: {} samples are too few to check instruments by; {} are needed", run.name,
                              run.samples(), samples_for_check));
  RunCheck check{.run = run.name, .group = group_of(run)};
  for (std::size_t c = 0; c < channel_count; ++c)
    if (run.has(static_cast<Channel>(c))) check.channels.push_back(character_of(run, static_cast<Channel>(c)));
  const auto measured = measured_samples(run, check.channels);
  check.gaps = gaps_in(measured);
  check.errors = mistakes_of(measured);
  auto mended = without(measured, check.errors);
  leave_out_derived(mended, check);
  const auto reversed = rudder_is_reversed(mended);
  if (!reversed) check.cannot_tell.push_back("to which side the rudder is positive: it moves too little");
  else if (*reversed) check.errors.push_back(reversed_rudder(mended));
  add(check.errors, errors_of(mended));
  leave_out_beyond_numbers(check);
  note_what_is_missing(mended, check.cannot_tell);
  return check;
}

// ---------------------------------------------------------------- several runs

namespace {

/// How late a clock that jumps is tells nothing of other runs.
bool is_of_this_run_alone(const RunCheck& run, const InstrumentError& e) {
  const auto jumps = [](const InstrumentError& other) { return other.kind == Kind::jump && other.told; };
  return is_of_clock_of_positions(e) && std::ranges::any_of(run.errors, jumps);
}

/// Whether the clock of its positions does not keep time.
bool has_bad_clock(const RunCheck& run) {
  return std::ranges::any_of(run.errors, [](const InstrumentError& e) {
    return e.told && (e.kind == Kind::clock || e.kind == Kind::clock_rate || e.kind == Kind::jump);
  });
}

/// A clock that runs slow, and is put right by leaps, makes the way by positions wrong in every run alike: no number of
/// runs tells the scale of a speed better than the best of them. Twelve of R/V Gunnerus together would have it 3.9
/// ± 1.3 % too large, where it is 2.0 % too small.
double least_error_of_scale(std::span<const RunCheck> runs, const std::vector<const InstrumentError*>& scales) {
  if (scales[0]->kind != Kind::scale || scales[0]->channel == Channel::r || std::ranges::none_of(runs, has_bad_clock))
    return 0.0;
  return std::ranges::min(scales, {}, &InstrumentError::standard_error)->standard_error;
}

/// What an error may be by every run.
std::vector<std::string_view> common_readings(const std::vector<const InstrumentError*>& runs) {
  auto common = runs[0]->readings;
  for (const auto* e : runs)
    std::erase_if(common, [&](std::string_view reading) { return std::ranges::count(e->readings, reading) == 0; });
  return common;
}

}  // namespace

std::vector<InstrumentError> pooled(std::span<const RunCheck> runs) {
  std::vector<InstrumentError> result;
  std::vector<std::vector<const InstrumentError*>> alike;
  for (const auto& run : runs)
    for (const auto& e : run.errors) {
      if (is_mistake(e.kind) || e.standard_error <= 0.0 || is_of_this_run_alone(run, e)) continue;
      if (e.kind == Kind::jump) continue;
      const auto same = std::ranges::find_if(
          alike, [&](const auto& group) { return group[0]->channel == e.channel && group[0]->kind == e.kind; });
      if (same == alike.end()) alike.push_back({&e});
      else same->push_back(&e);
    }
  for (const auto& group : alike) {
    double information = 0.0, sum = 0.0, scatter = 0.0;
    for (const auto* e : group) information += 1.0 / (e->standard_error * e->standard_error);
    for (const auto* e : group) sum += e->value / (e->standard_error * e->standard_error);
    const double mean = sum / information;
    for (const auto* e : group) scatter += std::pow((e->value - mean) / e->standard_error, 2);
    // χ² over its degrees of freedom: how much further apart the runs are than their standard errors say
    const double excess = group.size() > 1 ? std::max(1.0, scatter / static_cast<double>(group.size() - 1)) : 1.0;
    const double standard_error = std::max(std::sqrt(excess / information), least_error_of_scale(runs, group));
    result.push_back({group[0]->channel, group[0]->kind, mean, standard_error});
    result.back().readings = common_readings(group);
  }
  tell(result, Scope::runs, 0.0, 0.0);
  return result;
}

}  // namespace swayaw::identification
