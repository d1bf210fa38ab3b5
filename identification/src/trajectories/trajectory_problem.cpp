#include "trajectory_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline identification::detail {
namespace {

// ---------------------------------------------------------------- runs

std::vector<Measurement> measurements_of(const Recording& run, std::span<const Channel> channels) {
  std::vector<Measurement> measurements;
  for (std::size_t k = 0; k < run.samples(); ++k)
    for (const Channel channel : channels)
      if (!run[channel].empty() && !std::isnan(run[channel][k])) measurements.push_back({k, channel, run[channel][k]});
  return measurements;
}

/// Steps no longer than `longest` [s] between the samples.
std::vector<int> steps_between(std::span<const double> time, double longest) {
  std::vector<int> steps;
  for (std::size_t k = 1; k < time.size(); ++k)
    steps.push_back(std::max(1, static_cast<int>(std::ceil((time[k] - time[k - 1]) / longest - 1e-6))));
  return steps;
}

SampledRun sampled_run(const Ship& ship, const Recording& run, const RecordedControls& controls,
                       std::span<const Channel> channels, double longest_step) {
  SampledRun result{.time = run.time,
                    .controls = controls.at(run.time),
                    .steps = steps_between(run.time, longest_step),
                    .measurements = measurements_of(run, channels),
                    .changes = all_changes(ship, controls.wind())};
  if (result.measurements.empty())
    throw Refusal(fmt::format("{}: none of the channels to fit to was recorded", run.name));
  return result;
}

/// L/U at the recorded start, or at a third of the service speed if the ship is slower.
double time_unit(const Ship& ship, const Recording& run) {
  const double U = speed(recorded_state(ship, run, run.time.front()).motion);
  return length(ship) / std::max(U, service_speed(ship) / 3.0);
}

// ---------------------------------------------------------------- parameters

std::vector<Parameter> parameters_to_fit(const Ship& ship, const TrajectoryFitOptions& options) {
  if (options.parameters.empty()) throw Refusal(fmt::format("{}: no number to fit", ship.name));
  const auto parameters = parameters_of(ship, options.parameters);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (parameters[i].index == parameters[k].index)
        throw Refusal(fmt::format("{}: {} is to be fitted twice", ship.name, parameters[i].name));
  return parameters;
}

/// The accepted range; an end that is itself refused is kept clear of.
void add_bounds(TrajectoryProblem& problem, const Parameter& number) {
  const double clear = number.range.above_low ? 1e-6 * std::max(std::abs(number.value), 1e-6) : 0.0;
  problem.low.push_back(number.range.low + clear);
  problem.high.push_back(number.range.high);
}

void check(const TrajectoryFitOptions& options) {
  require_positive(options.segment, "segment [ship lengths]");
  require_positive(options.step, "step [ship lengths]");
  if (options.robust) require_positive(*options.robust, "robust [standard deviations]");
  for (const Channel channel : measured_channels())
    if (const auto& noise = options.noise[index_of(channel)])
      require_positive(*noise, fmt::format("noise of {}", column_name(channel)));
}

}  // namespace

TrajectoryProblem problem_of(const Ship& ship, std::span<const Recording> runs, const TrajectoryFitOptions& options) {
  check(options);
  if (runs.empty()) throw Refusal("no recording to fit to");
  TrajectoryProblem problem{.parameters = parameters_to_fit(ship, options),
                            .L = length(ship),
                            .U = service_speed(ship),
                            .threads = options.threads};
  problem.channels = recorded_channels(runs, measured_channels(), options.channels);
  for (const auto& run : runs) {
    if (run.samples() < 3) throw Refusal(fmt::format("{}: fewer than 3 samples to fit to", run.name));
    const RecordedControls controls(ship, run);
    problem.unit.push_back(time_unit(ship, run));
    problem.runs.push_back(sampled_run(ship, run, controls, problem.channels, options.step * problem.unit.back()));
  }
  for (const auto& number : problem.parameters) add_bounds(problem, number);
  problem.simulator = segment_simulator(ship, problem.parameters);
  return problem;
}

// ---------------------------------------------------------------- segments

namespace {

/// The first and last sample of each of `count` segments of about equal duration.
std::vector<std::size_t> cuts(const SampledRun& run, int count) {
  std::vector<std::size_t> cut{0};
  const double from = run.time.front(), duration = run.time.back() - from;
  for (int i = 1; i < count; ++i) {
    const auto there = std::ranges::lower_bound(run.time, from + duration * i / count) - run.time.begin();
    if (static_cast<std::size_t>(there) > cut.back() && static_cast<std::size_t>(there) + 1 < run.time.size())
      cut.push_back(static_cast<std::size_t>(there));
  }
  cut.push_back(run.time.size() - 1);
  return cut;
}

/// Measurements from a sample up to another, which counts if it is the last of the run.
std::span<const Measurement> measurements_between(const SampledRun& run, std::size_t from, std::size_t to) {
  const std::size_t beyond = to + 1 == run.time.size() ? to + 1 : to;
  const auto first = std::ranges::lower_bound(run.measurements, from, {}, &Measurement::sample),
             last = std::ranges::lower_bound(run.measurements, beyond, {}, &Measurement::sample);
  return {first, last};
}

}  // namespace

std::vector<ShootingSegment> segments_of(const TrajectoryProblem& problem, const Ship& ship,
                                         std::span<const Recording> runs, double lengths) {
  std::vector<ShootingSegment> segments;
  for (std::size_t j = 0; j < runs.size(); ++j) {
    const auto& run = problem.runs[j];
    const double whole = (run.time.back() - run.time.front()) / problem.unit[j];
    const auto cut = cuts(run, std::max(1, static_cast<int>(std::lround(whole / lengths))));
    for (std::size_t i = 0; i + 1 < cut.size(); ++i) {
      const auto s = vector_of(recorded_state(ship, runs[j], run.time[cut[i]]));
      const Eigen::VectorXd start = Eigen::Map<const Eigen::Vector<double, 6>>(s.data());
      segments.push_back({{&run, cut[i], cut[i + 1], measurements_between(run, cut[i], cut[i + 1])},
                          j,
                          i == 0 ? start : problem.simulator->steady(start, run.controls[cut[i]]),
                          i + 2 < cut.size()});
    }
  }
  return segments;
}

// ---------------------------------------------------------------- weights

Weighted weighted(const SegmentResponse& response, const RunSegment& segment, const Weights& weights) {
  Weighted result{response.residual, response.residual_slope};
  const double k = weights.robust.value_or(std::numeric_limits<double>::infinity());
  for (Eigen::Index i = 0; i < result.residual.size(); ++i) {
    double& r = result.residual[i];
    double factor = 1.0 / weights.noise[index_of(segment.measurements[static_cast<std::size_t>(i)].channel)];
    r *= factor;
    if (const double size = std::abs(r); size > k) {
      r = std::copysign(std::sqrt(2.0 * k * size - k * k), r);
      factor *= k / std::abs(r);
    }
    if (result.slope.rows() > 0) result.slope.row(i) *= factor;
  }
  return result;
}

Eigen::VectorXd state_units(const TrajectoryProblem& problem) {
  const double L = problem.L, U = problem.U;
  Eigen::VectorXd units(problem.simulator->states());
  units.head<6>() << L, L, 1.0, U, U, U / L;
  for (Eigen::Index i = 6; i < units.size(); ++i)
    units[i] = hidden_quantities[static_cast<std::size_t>(i - 6)].one(L, U);
  return units;
}

}  // namespace swayaw::identification::detail
