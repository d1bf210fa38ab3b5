#include "manoeuvre_run.hpp"

#include "../steady/acting_propulsion.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "swayaw/core/rounding.hpp"
#include "swayaw/nonlinear/models/validity.hpp"

namespace swayaw::inline nonlinear::detail {
namespace {

/// 0, step, 2 step, … up to the end.
std::vector<double> sample_times(double step, double end) {
  const auto count = static_cast<std::size_t>(end / step * (1.0 + 1e-12)) + 1;
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) times[i] = static_cast<double>(i) * step;
  return times;
}

void fill_motion(Recording& run, const std::vector<Sample>& samples, const Current<double>& current) {
  constexpr std::array channels{Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r};
  std::array<std::span<double>, channels.size()> columns;
  for (std::size_t k = 0; k < channels.size(); ++k) columns[k] = run.fill(channels[k]);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto seen = kinematics(samples[i].state, current);
    for (std::size_t k = 0; k < channels.size(); ++k) columns[k][i] = observe(channels[k], seen);
  }
}

}  // namespace

namespace {

/// @param propulsion(speed)  at the approach speed
template <class Model, class Propulsion>
Plan plan_of(const Model& ship, const ManoeuvreOptions& options, double longest, Propulsion&& propulsion) {
  const double speed = require_positive(options.speed.value_or(ship.particulars.U_0), "approach speed [m/s]");
  const double time_unit = ship.particulars.L / speed;
  const double end = require_positive(options.duration.value_or(longest * time_unit), "duration [s]");
  const double step = require_positive(options.step.value_or(round_down(0.02 * time_unit)), "step [s]");
  const auto controls = propulsion(speed);
  require_valid({speed, 0.0, 0.0}, controls, ship.particulars.L);
  return {speed, controls, end, options.sampled ? sample_times(step, end) : std::vector<double>{}};
}

}  // namespace

template <class Model>
Plan plan(const Model& ship, const ManoeuvreOptions& options, double longest) {
  return plan_of(ship, options, longest,
                 [&](double speed) { return propulsion(ship, speed, options.rev, options.thrust); });
}

template <class Model>
Plan plan(const ActingShip<Model>& ship, const ManoeuvreOptions& options, double longest) {
  return plan_of(ship.model, options, longest,
                 [&](double speed) { return acting_propulsion(ship, speed, options.rev, options.thrust); });
}

std::optional<double> way_made(const std::vector<Sample>& samples, const Sample& last, double until) {
  if (samples.size() < 2) return std::nullopt;
  double way = 0.0;
  const auto add = [&](const Sample& a, const Sample& b) {
    const double U0 = speed(a.state.motion), U1 = speed(b.state.motion), length = b.time - a.time;
    const double share = length > 0.0 ? std::clamp((until - a.time) / length, 0.0, 1.0) : 0.0;
    way += share * length * (U0 + 0.5 * share * (U1 - U0));
  };
  for (std::size_t i = 1; i < samples.size() && samples[i - 1].time < until; ++i) add(samples[i - 1], samples[i]);
  add(samples.back(), last);
  return way;
}

template <class Model>
Recording recording_of(const std::vector<Sample>& samples, const ActingShip<Model>& acting,
                       std::optional<double> begin) {
  const auto& ship = acting.model;
  Recording run;
  run.time.reserve(samples.size());
  for (const auto& m : samples) run.time.push_back(m.time);
  const auto fill = [&](Channel channel, auto&& value) {
    auto column = run.fill(channel);
    for (std::size_t i = 0; i < samples.size(); ++i) column[i] = value(samples[i]);
  };
  fill_motion(run, samples, acting.surroundings.current);
  fill(Channel::delta, [](const Sample& m) { return m.shown; });
  const bool by_thrust = !samples.empty() && samples.front().controls.by_thrust;
  if (!by_thrust && takes_shaft_speed(ship)) fill(Channel::rev, [](const Sample& m) { return m.controls.rev; });
  fill(Channel::thrust,
       [&](const Sample& m) { return thrust(ship, m.state.motion, driven(acting.added, m.state.motion, m.controls)); });
  for_each_acting(acting.added, [&](auto i, const auto&) {
    for (std::size_t k = hidden_place[i.value]; k < hidden_place[i.value + 1]; ++k)
      if (const auto channel = hidden_quantities[k].channel)
        fill(*channel, [k](const Sample& m) { return m.hidden[k]; });
  });
  return as_recorded(std::move(run), acting.instruments, begin);
}

template Plan plan(const MmgShip<double>&, const ManoeuvreOptions&, double);
template Plan plan(const ActingShip<MmgShip<double>>&, const ManoeuvreOptions&, double);
template Plan plan(const PiShip<double>&, const ManoeuvreOptions&, double);
template Plan plan(const ActingShip<PiShip<double>>&, const ManoeuvreOptions&, double);
template Plan plan(const PuShip<double>&, const ManoeuvreOptions&, double);
template Plan plan(const ActingShip<PuShip<double>>&, const ManoeuvreOptions&, double);
template Plan plan(const AbkowitzShip<double>&, const ManoeuvreOptions&, double);
template Plan plan(const ActingShip<AbkowitzShip<double>>&, const ManoeuvreOptions&, double);
template Recording recording_of(const std::vector<Sample>&, const ActingShip<MmgShip<double>>&, std::optional<double>);
template Recording recording_of(const std::vector<Sample>&, const ActingShip<PiShip<double>>&, std::optional<double>);
template Recording recording_of(const std::vector<Sample>&, const ActingShip<PuShip<double>>&, std::optional<double>);
template Recording recording_of(const std::vector<Sample>&, const ActingShip<AbkowitzShip<double>>&,
                                std::optional<double>);

}  // namespace swayaw::nonlinear::detail
