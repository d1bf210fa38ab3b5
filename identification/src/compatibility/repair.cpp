#include <algorithm>
#include <cmath>

#include "channel_character.hpp"
#include "mistakes.hpp"
#include "run_motion.hpp"
#include "swayaw/identification/data_compatibility.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "track_regression.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Kind = InstrumentErrorKind;

/// Channels that the instrument of a channel has, too.
std::vector<Channel> of_the_same_instrument(Channel channel) {
  switch (channel) {
    case Channel::x: return {Channel::x, Channel::y};
    case Channel::u: return {Channel::u, Channel::v};
    case Channel::u_ground: return {Channel::u_ground, Channel::v_ground};
    default: return {channel};
  }
}

// ---------------------------------------------------------------- clocks

/// A measured value and when it was true.
struct Dated {
  double time, value;
};

/// c(t) = c₀(t − tau(t)): the values by the times at which they were true.
std::vector<Dated> dated(const Recording& run, Channel channel, const TrackClock& clock) {
  std::vector<Dated> values;
  for (std::size_t i = 0; i < run.samples(); ++i)
    if (!std::isnan(run[channel][i])) values.push_back({run.time[i] - clock.late(run.time[i]), run[channel][i]});
  std::ranges::sort(values, {}, &Dated::time);
  return values;
}

/// Every sample gets what was true at its time, by straight lines. Where nothing was measured nothing is made up: a
/// repaired run is evidence, so that beyond its ends, and where its clock leapt, it is silent.
void set_clock(Recording& run, Channel channel, const TrackClock& clock) {
  const double longest = longest_line(run.time);
  for (const Channel c : of_the_same_instrument(channel)) {
    if (!run.has(c)) continue;
    const auto known = dated(run, c, clock);
    auto& values = run.channels[index_of(c)];
    std::size_t k = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      while (k < known.size() && known[k].time < run.time[i]) ++k;
      if (std::isnan(values[i])) continue;
      if (k < known.size() && known[k].time == run.time[i]) values[i] = known[k].value;
      else if (k == 0 || k == known.size() || known[k].time - known[k - 1].time > longest) values[i] = missing;
      else {
        const double share = (run.time[i] - known[k - 1].time) / (known[k].time - known[k - 1].time);
        values[i] = known[k - 1].value + share * (known[k].value - known[k - 1].value);
      }
    }
  }
}

/// The clock of a channel by what was told of it.
TrackClock clock_of(Channel channel, std::span<const InstrumentError> told, const std::vector<double>& time) {
  TrackClock clock{.middle = 0.5 * (time.front() + time.back())};
  for (const auto& e : told) {
    if (e.channel != channel) continue;
    if (e.kind == Kind::delay) clock.delay = e.value;
    if (e.kind == Kind::clock_rate) clock.rate = e.value;
    if (e.kind == Kind::jump) clock.jumps.push_back({e.at, e.at_standard_error, e.value});
  }
  return clock;
}

bool is_of_clock(const InstrumentError& e) {
  return e.kind == Kind::delay || e.kind == Kind::clock_rate || e.kind == Kind::jump;
}

void set_clocks(Recording& run, std::span<const InstrumentError> told) {
  std::vector<Channel> set;
  for (const auto& e : told) {
    if (!is_of_clock(e) || std::ranges::count(set, e.channel) > 0) continue;
    set.push_back(e.channel);
    set_clock(run, e.channel, clock_of(e.channel, told, run.time));
  }
}

// ---------------------------------------------------------------- the rest

/// Velocity axes turned to starboard by eps: (u, v) in the axes of the hull.
void turn_axes(Recording& run, Channel surge, double eps) {
  const auto both = of_the_same_instrument(surge);
  auto &u = run.channels[index_of(both[0])], &v = run.channels[index_of(both[1])];
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto in_hull = in_turned_axes(PlanarMotion<double>{u[i], v[i], 0.0}, -eps);
    u[i] = in_hull.u, v[i] = in_hull.v;
  }
}

/// Zeros, scales and the antenna.
Instruments<double> instruments_of(std::span<const InstrumentError> told) {
  Instruments<double> instruments;
  for (const auto& e : told)
    for (const Channel c : of_the_same_instrument(e.channel)) {
      if (e.kind == Kind::scale) instruments[c].scale = 1.0 + e.value;
      if (e.kind == Kind::zero) instruments[c].bias = e.value;
      // the track's heading is the compass's and eps
      if (e.kind == Kind::axes && c == Channel::psi) instruments[c].bias = -e.value;
      if (e.kind == Kind::lever_arm_x) instruments.antenna_x = e.value;
      if (e.kind == Kind::lever_arm_y) instruments.antenna_y = e.value;
    }
  return instruments;
}

void leave_out(Recording& run, Channel channel, std::span<const std::size_t> samples) {
  for (const std::size_t i : samples) run.channels[index_of(channel)][i] = missing;
}

/// An antenna that was told beside velocities over ground is off the point that these are of: they stay.
Recording put_right(const Recording& run, std::span<const InstrumentError> told) {
  auto result = as_it_was(run, instruments_of(told));
  if (!run.has(Channel::u_ground) || !run.has(Channel::v_ground)) return result;
  auto without_antenna = instruments_of(told);
  without_antenna.antenna_x = without_antenna.antenna_y = 0.0;
  const auto there = as_it_was(run, without_antenna);
  for (const Channel c : {Channel::u_ground, Channel::v_ground})
    result.channels[index_of(c)] = there.channels[index_of(c)];
  return result;
}

}  // namespace

Recording without_outliers(Recording run) {
  for (const Channel channel : motion_channels())
    if (run.has(channel)) leave_out(run, channel, character_of(run, channel).outliers);
  return run;
}

Recording repaired(const Recording& run, const RunCheck& check) {
  auto result = run;
  for (const auto& c : check.channels) leave_out(result, c.channel, c.outliers);
  std::vector<InstrumentError> mistakes, told;
  for (const auto& e : check.errors)
    if (is_mistake(e.kind)) mistakes.push_back(e);
    else if (e.told) told.push_back(e);
  result = without(std::move(result), mistakes);
  set_clocks(result, told);
  result = put_right(result, told);
  for (const auto& e : told)
    if (e.kind == Kind::axes && (e.channel == Channel::u || e.channel == Channel::u_ground))
      turn_axes(result, e.channel, e.value);
  return result;
}

}  // namespace swayaw::identification
