#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "swayaw/linear/zigzag.hpp"

/// Exact response to a rudder that moves in straight lines of time.
namespace swayaw::inline linear {

/// Rudder angle over dimensionless time, straight lines between the points and held after the last. Two points at one
/// time are a step.
struct RudderHistory {
  std::vector<double> s;      ///< ship lengths, never descending; the motion starts at the first
  std::vector<double> delta;  ///< rudder angle [rad], positive to port
};

/// The rudder is at `angle` [rad] from s' = 0.
RudderHistory rudder_step(double angle);

/// From midships at `rate` [rad per ship length], for `duration` ship lengths.
/// @throws std::domain_error  if the duration is not positive
RudderHistory rudder_ramp(double rate, double duration);

/// From midships to `angle` [rad] at `rate` [rad per ship length, positive], then held.
/// @throws std::domain_error  if the rate is not positive
RudderHistory rudder_ramp_and_hold(double angle, double rate);

/// The rudder of a zigzag.
RudderHistory rudder_history(const LinearZigzag<double>& zigzag);

/// @throws std::domain_error  if a history is empty, its lists differ in length, a number is not finite or time runs
/// back
void require_history(const RudderHistory& history);

/// The motion from `start` until s' = `until` as legs, each in closed form.
/// @throws std::domain_error  for a history that is none, or `until` before its start
template <class S>
std::vector<Leg<S>> legs(const LinearResponse<S>& ship, const RudderHistory& history, double until,
                         const LinearState<S>& start = {S(0.0), S(0.0), S(0.0)}) {
  require_history(history);
  if (!(until >= history.s.front())) throw std::domain_error("a motion cannot end before its rudder history starts");
  std::vector<Leg<S>> result;
  LinearState<S> state = start;
  const auto sail = [&](double from, double to, const RudderLine<S>& rudder) {
    result.push_back({S(from), S(to - from), state, rudder, to < until ? LegEnd::arrival : LegEnd::limit});
    state = state_after(ship, state, rudder, S(to - from));
  };
  const auto &s = history.s, &delta = history.delta;
  for (std::size_t i = 0; i + 1 < s.size() && s[i] < until; ++i)
    if (s[i + 1] > s[i])
      sail(s[i], std::min(s[i + 1], until), {S(delta[i]), S((delta[i + 1] - delta[i]) / (s[i + 1] - s[i]))});
  if (until > s.back() || result.empty()) sail(std::min(s.back(), until), until, {S(delta.back()), S(0.0)});
  return result;
}

/// The leg that holds the time s', the later one where two meet.
/// @throws std::domain_error  if there are no legs, or s' is before the first or after the last
template <class S>
const Leg<S>& leg_at(const std::vector<Leg<S>>& all, double s) {
  if (all.empty() || !(s >= value_of(all.front().from))) throw std::domain_error("the time is before the first leg");
  const double end = value_of(all.back().from) + value_of(all.back().length);
  if (s > end + 1e-12 * (1.0 + std::abs(end))) throw std::domain_error("the time is after the last leg");
  const auto after = std::upper_bound(all.begin(), all.end(), s,
                                      [](double time, const Leg<S>& leg) { return time < value_of(leg.from); });
  return *(after - 1);
}

/// Rudder angle at the time s'.
template <class S>
S rudder_at(const std::vector<Leg<S>>& all, double s) {
  const auto& leg = leg_at(all, s);
  return leg.rudder.value + leg.rudder.rate * (s - leg.from);
}

/// State at the time s'.
template <class S>
LinearState<S> state_at(const LinearResponse<S>& ship, const std::vector<Leg<S>>& all, double s) {
  const auto& leg = leg_at(all, s);
  return state_after(ship, leg.start, leg.rudder, S(s - leg.from));
}

/// States at the given times, in any order, of a ship under a rudder history.
/// @throws std::domain_error  for a history that is none, or a time before its start
template <class S>
std::vector<LinearState<S>> response_to(const LinearResponse<S>& ship, const RudderHistory& history,
                                        const std::vector<double>& times,
                                        const LinearState<S>& start = {S(0.0), S(0.0), S(0.0)}) {
  std::vector<LinearState<S>> states;
  if (times.empty()) return states;
  const auto all = legs(ship, history, *std::max_element(times.begin(), times.end()), start);
  states.reserve(times.size());
  for (const double s : times) states.push_back(state_at(ship, all, s));
  return states;
}

}  // namespace swayaw::linear
