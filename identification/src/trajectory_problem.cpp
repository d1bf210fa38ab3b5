#include "trajectory_problem.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bare_ship.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::trajectory {
namespace {

// ---------------------------------------------------------------- runs

bool wanted(const TrajectoryFitOptions& options, Channel channel) {
  return options.channels.empty() || std::ranges::count(options.channels, channel) > 0;
}

std::vector<Reading> readings_of(const Recording& run, const TrajectoryFitOptions& options) {
  std::vector<Reading> readings;
  for (std::size_t k = 0; k < run.samples(); ++k)
    for (const Channel channel : measured_channels())
      if (wanted(options, channel) && !run[channel].empty() && !std::isnan(run[channel][k]))
        readings.push_back({k, channel, run[channel][k]});
  return readings;
}

/// Steps no longer than `longest` [s] between the samples.
std::vector<int> steps_between(std::span<const double> time, double longest) {
  std::vector<int> steps;
  for (std::size_t k = 1; k < time.size(); ++k)
    steps.push_back(std::max(1, static_cast<int>(std::ceil((time[k] - time[k - 1]) / longest - 1e-6))));
  return steps;
}

CourseRun course_run(const Recording& run, const RecordedControls& controls, const TrajectoryFitOptions& options,
                     double unit) {
  CourseRun result{.time = run.time,
                   .controls = {},
                   .steps = steps_between(run.time, options.step * unit),
                   .readings = readings_of(run, options)};
  for (const double time : run.time) result.controls.push_back(controls.at(time));
  if (result.readings.empty()) throw Refusal(fmt::format("{}: none of the channels to fit to was recorded", run.name));
  return result;
}

/// L/U at the recorded start, or at a third of the service speed if the ship is slower.
double time_unit(const Ship& ship, const Recording& run) {
  const double U = speed(recorded_state(ship, run, run.time.front()).motion);
  return length(ship) / std::max(U, service_speed(ship) / 3.0);
}

std::vector<Channel> channels_of(const std::vector<CourseRun>& runs) {
  std::vector<Channel> used;
  const auto measures = [](const CourseRun& run, Channel c) {
    return std::ranges::count(run.readings, c, &Reading::channel) > 0;
  };
  std::ranges::copy_if(measured_channels(), std::back_inserter(used), [&](Channel c) {
    return std::ranges::any_of(runs, [&](const auto& run) { return measures(run, c); });
  });
  return used;
}

// ---------------------------------------------------------------- numbers

NumberList numbers_of(const Ship& ship, const TrajectoryFitOptions& options) {
  if (options.numbers.empty()) throw Refusal(fmt::format("{}: no number to fit", ship.name));
  const auto numbers = parameters_of(ship, options.numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (numbers[i].index == numbers[k].index)
        throw Refusal(fmt::format("{}: {} is to be fitted twice", ship.name, numbers[i].name));
  return numbers;
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
  require_known_effects(ship, "trajectory fit", false);
  if (runs.empty()) throw Refusal("no recording to fit to");
  TrajectoryProblem problem{
      .numbers = numbers_of(ship, options), .L = length(ship), .U = service_speed(ship), .threads = options.threads};
  for (const auto& run : runs) {
    if (run.samples() < 3) throw Refusal(fmt::format("{}: fewer than 3 samples to fit to", run.name));
    const RecordedControls controls(ship, run);
    problem.unit.push_back(time_unit(ship, run));
    problem.runs.push_back(course_run(run, controls, options, problem.unit.back()));
  }
  problem.channels = channels_of(problem.runs);
  for (const auto& number : problem.numbers) add_bounds(problem, number);
  problem.sailor = std::visit(
      [&](const auto& model) { return sailor_of(model, surroundings_at(ship, 0.0), problem.numbers); }, ship.model);
  return problem;
}

// ---------------------------------------------------------------- legs

namespace {

/// The first and last sample of each of `count` legs of about equal duration.
std::vector<std::size_t> cuts(const CourseRun& run, int count) {
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

/// Readings from a sample up to another, which counts if it is the last of the run.
std::span<const Reading> readings_between(const CourseRun& run, std::size_t from, std::size_t to) {
  const std::size_t beyond = to + 1 == run.time.size() ? to + 1 : to;
  const auto first = std::ranges::lower_bound(run.readings, from, {}, &Reading::sample),
             last = std::ranges::lower_bound(run.readings, beyond, {}, &Reading::sample);
  return {first, last};
}

}  // namespace

std::vector<Leg> legs_of(const TrajectoryProblem& problem, const Ship& ship, std::span<const Recording> runs,
                         double lengths) {
  std::vector<Leg> legs;
  for (std::size_t j = 0; j < runs.size(); ++j) {
    const auto& run = problem.runs[j];
    const double whole = (run.time.back() - run.time.front()) / problem.unit[j];
    const auto cut = cuts(run, std::max(1, static_cast<int>(std::lround(whole / lengths))));
    for (std::size_t i = 0; i + 1 < cut.size(); ++i) {
      const auto start = vector_of(recorded_state(ship, runs[j], run.time[cut[i]]));
      legs.push_back(
          {{&run, cut[i], cut[i + 1], readings_between(run, cut[i], cut[i + 1])}, j, start, i + 2 < cut.size()});
    }
  }
  return legs;
}

// ---------------------------------------------------------------- weights

Weighted weighted(const Course& course, const Stretch& stretch, const Weights& weights) {
  Weighted result{course.residual, course.residual_slope};
  const double k = weights.robust.value_or(std::numeric_limits<double>::infinity());
  for (Eigen::Index i = 0; i < result.residual.size(); ++i) {
    double& r = result.residual[i];
    double factor = 1.0 / weights.noise[index_of(stretch.readings[static_cast<std::size_t>(i)].channel)];
    r *= factor;
    if (const double size = std::abs(r); size > k) {
      r = std::copysign(std::sqrt(2.0 * k * size - k * k), r);
      factor *= k / std::abs(r);
    }
    if (result.slope.rows() > 0) result.slope.row(i) *= factor;
  }
  return result;
}

Eigen::Vector<double, 6> state_units(const TrajectoryProblem& problem) {
  return {problem.L, problem.L, 1.0, problem.U, problem.U, problem.U / problem.L};
}

Matrix6 disturbance_factor(const TrajectoryProblem& problem, const Leg& leg, std::span<const double> values,
                           const PlanarAcceleration<double>& size) {
  const auto& run = *leg.stretch.run;
  const Eigen::Vector<double, 6> q(0.0, 0.0, 0.0, size.u * size.u, size.v * size.v, size.r * size.r);
  Matrix6 P = Matrix6::Zero();
  auto state = leg.start;
  for (std::size_t k = leg.stretch.from; k < leg.stretch.to; ++k) {
    const auto course = problem.sailor->sail({&run, k, k + 1, {}}, state, values, true);
    const Matrix6 Phi = course.end_slope.leftCols<6>(), half = (0.5 * (run.time[k + 1] - run.time[k]) * q).asDiagonal();
    P = (Phi * (P + half) * Phi.transpose() + half).eval();
    state = course.end;
  }
  const Eigen::Vector<double, 6> unit = state_units(problem), over = unit.cwiseInverse();
  const Matrix6 scaled = over.asDiagonal() * P * over.asDiagonal();
  return unit.asDiagonal() * Matrix6((scaled + 1e-16 * Matrix6::Identity()).llt().matrixL());
}

}  // namespace swayaw::trajectory
