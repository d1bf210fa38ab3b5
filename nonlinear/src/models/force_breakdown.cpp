#include "swayaw/nonlinear/models/force_breakdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "force_parts.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/models/validity.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline nonlinear {
namespace {

template <class Model>
ForceBreakdown break_down(const ActingShip<Model>& acting, const Surroundings<double>& around,
                          const ShipState<double>& state, const Controls<double>& controls) {
  const auto& model = acting.model;
  const auto split = forces(model, state.motion, driven(acting.added, state.motion, controls));
  const auto parts = detail::force_parts(model, split);
  ForceBreakdown result{.parts = {parts.begin(), parts.end()}, .total = split.total(), .acceleration = {}};
  if (around.windy) {
    result.parts.push_back({"wind", wind_load(around, state)});
    result.total = result.total + result.parts.back().force;
  }
  for_each_added(model, acting.added, state, steady_hidden(model, acting.added, state.motion, controls), controls,
                 [&](std::string_view name, const PlanarForce<double>& force) {
                   result.parts.push_back({name, force});
                   result.total = result.total + force;
                 });
  result.acceleration = acceleration(model, state.motion, result.total);
  return result;
}

// ---------------------------------------------------------------- along a run

/// State and controls of one sample.
struct Sample {
  ShipState<double> state;
  Controls<double> controls;
};

/// Samples of a run as far as forces need them.
class Samples {
 public:
  Samples(const Recording& run, const Ship& ship)
      : run_(run), length_(length(ship)), by_rev_(run.has(Channel::rev) && takes_shaft_speed(ship)) {
    for (const auto& [channel, name] :
         {std::pair{Channel::u, "u"}, {Channel::v, "v"}, {Channel::r, "yaw rate"}, {Channel::delta, "rudder angle"}})
      if (!run.has(channel)) throw Refusal(fmt::format("{}: forces need {}", run.name, name));
    if (!by_rev_ && takes_shaft_speed(ship) && !run.has(Channel::thrust))
      throw Refusal(fmt::format("{}: forces need shaft speed or thrust", run.name));
  }

  /// Nothing where a number is missing, or forces are not known.
  std::optional<Sample> operator[](std::size_t i) const {
    const auto at = [&](Channel channel) { return run_.has(channel) ? run_[channel][i] : 0.0; };
    const double half = 0.5 * at(Channel::thrust);
    const Sample sample{
        .state = {at(Channel::x), at(Channel::y), at(Channel::psi), {at(Channel::u), at(Channel::v), at(Channel::r)}},
        .controls = {.delta = at(Channel::delta),
                     .rev = by_rev_ ? at(Channel::rev) : 0.0,
                     .thrust = {half, half},
                     .by_thrust = !by_rev_ && run_.has(Channel::thrust)}};
    if (!std::isfinite(sample.state.psi)) return std::nullopt;
    if (validity_of(sample.state.motion, sample.controls, length_) != Validity::valid) return std::nullopt;
    return sample;
  }

 private:
  const Recording& run_;
  double length_;
  bool by_rev_;
};

std::string cell(double value) { return fmt::format("{}", value); }

}  // namespace

ForceBreakdown force_breakdown(const Ship& ship, const ShipState<double>& state, const Controls<double>& controls) {
  require_valid(ship, state.motion, controls);
  return visit_acting(ship,
                      [&](const auto& acting) { return break_down(acting, acting.surroundings, state, controls); });
}

namespace {

/// The run as it was, with the angle of the rudder itself.
Recording true_run(const Recording& run, const Ship& ship) {
  auto truth = as_it_was(run, instruments_of(ship));
  if (!run.has(Channel::delta) || !rudder_actuator(ship).any()) return truth;
  const RecordedControls controls(ship, run);
  auto& rudder = truth.channels[index_of(Channel::delta)];
  for (std::size_t i = 0; i < rudder.size(); ++i)
    if (std::isfinite(rudder[i])) rudder[i] = controls.rudder(run.time[i]);
  return truth;
}

/// With what acts at that time.
ForceBreakdown breakdown_at(const Ship& ship, std::span<const WindPiece> wind, double time, const Sample& sample) {
  return visit_acting(ship, [&](const auto& acting) {
    const auto now = in_wind(acting, wind_between(wind, time, time)).at(time);
    return break_down(now, now.surroundings, sample.state, sample.controls);
  });
}

/// A column by its name, empty at first: wind may begin later than the run.
ExtraColumn& column_named(std::vector<ExtraColumn>& columns, const std::string& name, std::size_t samples) {
  const auto found = std::ranges::find(columns, name, &ExtraColumn::name);
  if (found != columns.end()) return *found;
  return columns.emplace_back(ExtraColumn{name, std::vector<std::string>(samples)});
}

}  // namespace

void add_forces(Recording& run, const Ship& deep) {
  const auto shallow = in_depth(deep, recorded_depth(run));
  const auto& ship = shallow ? *shallow : deep;
  const auto wind = recorded_wind(ship, run);
  const auto truth = true_run(run, ship);
  const Samples samples(truth, ship);
  std::vector<ExtraColumn> columns;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const auto sample = samples[i];
    if (!sample) continue;
    const auto split = breakdown_at(ship, wind, run.time[i], *sample);
    for (const auto& [name, force] : split.parts)
      for (const auto& [column, value] : {std::pair{fmt::format("X_{}_N", name), force.X},
                                          {fmt::format("Y_{}_N", name), force.Y},
                                          {fmt::format("N_{}_N_m", name), force.N}})
        column_named(columns, column, run.samples()).cells[i] = cell(value);
  }
  run.extra.insert(run.extra.end(), columns.begin(), columns.end());
}

}  // namespace swayaw::nonlinear
