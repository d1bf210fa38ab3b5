#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/rounding.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/sensors.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "voyage.hpp"

/// What the manoeuvres share. Not installed.
namespace swayaw {

/// Straight ahead at the origin.
inline Moment approach(double speed, const Controls<double>& propulsion) {
  return {0.0, {0.0, 0.0, 0.0, {speed, 0.0, 0.0}}, propulsion};
}

/// 0, step, 2 step, … up to the end.
inline std::vector<double> sample_times(double step, double end) {
  const auto count = static_cast<std::size_t>(end / step * (1.0 + 1e-12)) + 1;
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) times[i] = static_cast<double>(i) * step;
  return times;
}

/// Speed and propulsion of the approach, when to stop at the latest, and when to take samples.
struct Plan {
  double speed;
  Controls<double> propulsion;
  double end;
  std::vector<double> times;
};

/// @param longest  duration in ship lengths at approach speed, unless the options give one
template <class Model>
Plan plan(const Model& ship, const ManoeuvreOptions& options, double longest) {
  const double speed = require_positive(options.speed.value_or(ship.particulars.U_0), "approach speed [m/s]");
  const double time_unit = ship.particulars.L / speed;
  const double end = require_positive(options.duration.value_or(longest * time_unit), "duration [s]");
  const double step = require_positive(options.step.value_or(round_down(0.02 * time_unit)), "step [s]");
  return {speed, propulsion(ship, speed, options.rev, options.thrust), end,
          options.sampled ? sample_times(step, end) : std::vector<double>{}};
}

template <class Sailing>
Moment now(const Sailing& voyage) {
  return {voyage.time(), voyage.state(), voyage.controls()};
}

/// Way made until a time, ∫ U dt by the trapezoidal rule over the samples and the moment `last` after them [m]; nothing
/// without samples.
inline std::optional<double> way_made(const std::vector<Moment>& samples, const Moment& last, double until) {
  if (samples.size() < 2) return std::nullopt;
  double way = 0.0;
  const auto add = [&](const Moment& a, const Moment& b) {
    const double U0 = speed(a.state.motion), U1 = speed(b.state.motion), length = b.time - a.time;
    const double share = length > 0.0 ? std::clamp((until - a.time) / length, 0.0, 1.0) : 0.0;
    way += share * length * (U0 + 0.5 * share * (U1 - U0));
  };
  for (std::size_t i = 1; i < samples.size() && samples[i - 1].time < until; ++i) add(samples[i - 1], samples[i]);
  add(samples.back(), last);
  return way;
}

/// States and thrust as her instruments record them.
template <class Model>
Recording recording_of(const std::vector<Moment>& moments, const ActingShip<Model>& acting) {
  const auto& ship = acting.model;
  Recording run;
  for (const auto& m : moments) run.time.push_back(m.time);
  const auto fill = [&](Channel channel, auto&& value) {
    auto column = run.fill(channel);
    for (std::size_t i = 0; i < moments.size(); ++i) column[i] = value(moments[i]);
  };
  fill(Channel::x, [](const Moment& m) { return m.state.x; });
  fill(Channel::y, [](const Moment& m) { return m.state.y; });
  fill(Channel::psi, [](const Moment& m) { return m.state.psi; });
  fill(Channel::u, [](const Moment& m) { return m.state.motion.u; });
  fill(Channel::v, [](const Moment& m) { return m.state.motion.v; });
  fill(Channel::r, [](const Moment& m) { return m.state.motion.r; });
  fill(Channel::delta, [](const Moment& m) { return m.shown; });
  const bool by_thrust = !moments.empty() && moments.front().controls.by_thrust;
  if (!by_thrust && takes_shaft_speed(ship)) fill(Channel::rev, [](const Moment& m) { return m.controls.rev; });
  fill(Channel::thrust,
       [&](const Moment& m) { return thrust(ship, m.state.motion, driven(acting.added, m.state.motion, m.controls)); });
  for_each_acting(acting.added, [&](auto i, const auto&) {
    for (std::size_t k = hidden_place[i.value]; k < hidden_place[i.value + 1]; ++k)
      if (const auto channel = hidden_quantities[k].channel)
        fill(*channel, [k](const Moment& m) { return m.hidden[k]; });
  });
  return acting.sensors.empty() ? run : as_recorded(std::move(run), acting.sensors);
}

}  // namespace swayaw
