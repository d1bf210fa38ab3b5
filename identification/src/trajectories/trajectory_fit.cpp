#include "swayaw/identification/trajectory_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"
#include "trajectory_errors.hpp"
#include "trajectory_search.hpp"

namespace swayaw::inline identification {
using namespace detail;

namespace {

// ---------------------------------------------------------------- report

/// Residuals of a channel in one run, in the order of time.
std::vector<double> residuals_of(std::size_t run, Channel channel, const std::vector<ShootingSegment>& segments,
                                 const std::vector<SegmentResponse>& responses) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& measurements = segments[i].part.measurements;
    for (std::size_t k = 0; k < measurements.size() && segments[i].run == run; ++k)
      if (measurements[k].channel == channel) residuals.push_back(responses[i].residual[static_cast<Eigen::Index>(k)]);
  }
  return residuals;
}

double rms(const std::vector<double>& e) {
  return std::sqrt(std::inner_product(e.begin(), e.end(), e.begin(), 0.0) / static_cast<double>(e.size()));
}

/// Σ e_k e_{k+1} / Σ e_k²
double autocorrelation(const std::vector<double>& e) {
  const double squares = std::inner_product(e.begin(), e.end(), e.begin(), 0.0);
  return e.size() < 2 || squares == 0.0 ? 0.0 : std::inner_product(e.begin() + 1, e.end(), e.begin(), 0.0) / squares;
}

ChannelResiduals channel_residuals(Channel channel, const std::vector<double>& before,
                                   const std::vector<double>& after) {
  const double rho = autocorrelation(after), count = static_cast<double>(after.size()), positive = std::max(rho, 0.0);
  return {.channel = channel,
          .count = after.size(),
          .before = rms(before),
          .after = rms(after),
          .autocorrelation = rho,
          .effective_count = std::max(1.0, count * (1.0 - positive) / (1.0 + positive))};
}

std::vector<FittedRun> fitted_runs(const TrajectoryProblem& problem, std::span<const Recording> runs,
                                   const std::vector<ShootingSegment>& segments,
                                   const std::vector<SegmentResponse>& before,
                                   const std::vector<SegmentResponse>& after) {
  std::vector<FittedRun> result;
  for (std::size_t j = 0; j < runs.size(); ++j) {
    FittedRun run{.name = runs[j].name, .start = {}, .channels = {}};
    for (const Channel channel : problem.channels) {
      const auto left = residuals_of(j, channel, segments, after);
      if (!left.empty())
        run.channels.push_back(channel_residuals(channel, residuals_of(j, channel, segments, before), left));
    }
    result.push_back(std::move(run));
  }
  return result;
}

std::vector<FittedParameter> fitted_parameters(const TrajectoryProblem& problem, std::span<const double> values,
                                               const Eigen::MatrixXd& covariance) {
  std::vector<FittedParameter> parameters;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    parameters.push_back({.name = problem.parameters[i].name,
                          .before = problem.parameters[i].value,
                          .estimate = {values[i], std::sqrt(covariance(j, j))},
                          .at_bound = values[i] == problem.low[i] || values[i] == problem.high[i]});
  }
  return parameters;
}

void tell_parameters(const TrajectoryProblem& problem, const Found& found, const ParameterErrors& errors,
                     TrajectoryFit& fit) {
  const auto& C = errors.covariance;
  const bool ended =
      found.status == TrajectoryFitStatus::converged || found.status == TrajectoryFitStatus::iteration_limit;
  fit.status = ended && !errors.full_rank ? TrajectoryFitStatus::rank_deficient : found.status;
  fit.parameters = fitted_parameters(problem, found.iterate.values, C);
  fit.covariance = core::detail::rows_of(C);
  const Eigen::VectorXd over = C.diagonal().cwiseSqrt().cwiseInverse();
  fit.correlation = core::detail::rows_of(over.asDiagonal() * C * over.asDiagonal());
  const auto combinations = combinations_of(problem.parameters, found.iterate.values, errors);
  fit.condition_number = combinations.condition_number;
  fit.best_combination = combinations.best;
  fit.undetermined = combinations.undetermined;
}

// ---------------------------------------------------------------- the fit

/// Weight of the parameters as given: 1/deviation² of those that have one.
Eigen::VectorXd prior_of(const std::vector<Parameter>& parameters, bool wanted) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size() && wanted; ++i)
    if (const double s = parameters[i].deviation; s > 0.0) weight[static_cast<Eigen::Index>(i)] = 1.0 / (s * s);
  return weight;
}

/// Sizes of large changes: the number itself, or a fiftieth of the largest in its table where it is smaller; 1 where
/// all are 0.
Eigen::VectorXd units_of(const std::vector<Parameter>& parameters) {
  Eigen::VectorXd unit(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    double largest = 0.0;
    for (const auto& other : parameters)
      if (other.table == parameters[i].table) largest = std::max(largest, std::abs(other.value));
    unit[static_cast<Eigen::Index>(i)] = largest > 0.0 ? std::max(std::abs(parameters[i].value), 0.02 * largest) : 1.0;
  }
  return unit;
}

Iterate first_iterate(const TrajectoryProblem& problem, const std::vector<ShootingSegment>& segments) {
  Iterate iterate;
  for (std::size_t i = 0; i < problem.parameters.size(); ++i)
    iterate.values.push_back(std::clamp(problem.parameters[i].value, problem.low[i], problem.high[i]));
  for (const auto& segment : segments) iterate.starts.push_back(segment.start);
  return iterate;
}

/// The ship that was given, in segments.
struct FirstTry {
  std::vector<ShootingSegment> segments;
  std::vector<SegmentResponse> responses;

  bool lost(std::size_t i) const { return !finite({&responses[i], 1}); }

  /// Whether a segment ends far from where the next begins, in ship units.
  bool strays(std::size_t i, const Eigen::VectorXd& unit) const {
    constexpr double far = 0.3;
    if (lost(i) || !segments[i].joined) return lost(i);
    return (responses[i].end - segments[i + 1].start).cwiseQuotient(unit).cwiseAbs().maxCoeff() > far;
  }
};

constexpr double shortest_segment = 0.1;  ///< ship lengths

/// Segments as long as `lengths`, or shorter, and then `lengths` too, where the ship that was given does not stay near
/// the recording so long.
std::vector<ShootingSegment> feasible_segments(const TrajectoryProblem& problem, const Ship& ship,
                                               std::span<const Recording> runs, double& lengths) {
  FirstTry first;
  for (bool again = true; again;) {
    first.segments = segments_of(problem, ship, runs, lengths);
    first.responses = simulated(problem, first.segments, first_iterate(problem, first.segments), false);
    again = false;
    for (std::size_t i = 0; i < first.segments.size(); ++i) again |= first.strays(i, state_units(problem));
    again &= std::isfinite(lengths) && lengths > shortest_segment;
    if (again) lengths *= 0.5;
  }
  for (std::size_t i = 0; i < first.segments.size(); ++i)
    if (first.lost(i))
      throw Refusal(fmt::format("{}: {} cannot be simulated from the recorded state at {:.6g} s",
                                runs[first.segments[i].run].name, ship.name,
                                first.segments[i].part.run->time[first.segments[i].part.from]));
  return first.segments;
}

ShipState<double> state_of(const Eigen::VectorXd& s) { return {s[0], s[1], s[2], {s[3], s[4], s[5]}}; }

/// Starts of the whole runs in place of those of their segments.
Iterate of_whole_runs(const Iterate& iterate, const std::vector<ShootingSegment>& segments,
                      const std::vector<ShootingSegment>& whole) {
  Iterate result{.values = iterate.values, .starts = {}};
  for (const auto& run : whole)
    result.starts.push_back(iterate.starts[static_cast<std::size_t>(
        std::ranges::find(segments, run.run, &ShootingSegment::run) - segments.begin())]);
  return result;
}

}  // namespace

TrajectoryFit fit_trajectories(const Ship& ship, std::span<const Recording> runs, const TrajectoryFitOptions& options) {
  const auto problem = problem_of(ship, runs, options);
  double lengths = options.segment;
  auto segments = feasible_segments(problem, ship, runs, lengths);
  const SearchTask task{problem, segments, options, prior_of(problem.parameters, options.priors),
                        units_of(problem.parameters)};
  std::optional<Found> search(search_from(task, first_iterate(problem, segments)));
  while (search->stuck && std::isfinite(lengths) && lengths > shortest_segment) {
    lengths *= 0.5;
    segments = feasible_segments(problem, ship, runs, lengths);
    search.emplace(search_from(task, first_iterate(problem, segments)));
  }
  const auto& found = *search;
  // what is left is that of whole runs
  const auto whole = segments_of(problem, ship, runs, std::numeric_limits<double>::infinity());
  const auto before = simulated(problem, whole, first_iterate(problem, whole), false);
  const auto end = of_whole_runs(found.iterate, segments, whole);
  const auto after = simulated(problem, whole, end, false);
  TrajectoryFit fit{};
  fit.ship = with_values(ship, problem.parameters, found.iterate.values);
  tell_parameters(problem, found, parameter_errors(problem, found.at, task.prior), fit);
  for (const Channel channel : problem.channels) fit.noise[index_of(channel)] = found.weights.noise[index_of(channel)];
  fit.log_likelihood = log_likelihood(whole, after, found.weights);
  fit.runs = fitted_runs(problem, runs, whole, before, after);
  for (std::size_t j = 0; j < runs.size(); ++j) fit.runs[j].start = state_of(end.starts[j]);
  fit.iterations = found.iterations;
  fit.sensitivities = found.sensitivities;
  return fit;
}

TrajectoryFit fit_trajectories(const Ship& ship, const Recording& run, const TrajectoryFitOptions& options) {
  return fit_trajectories(ship, std::span(&run, 1), options);
}

}  // namespace swayaw::identification
