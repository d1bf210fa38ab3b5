#include "filtered_runs.hpp"

#include <algorithm>

#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

/// Variances of the channels of a run and of the process noise.
FilterNoise variances(const Ship& scale, const PreparedRun& run, const Noise& noise) {
  FilterNoise variance = FilterNoise::Zero();
  for (const Channel channel : run.channels)
    variance[place_of(channel)] = std::pow(run.deviation[index_of(channel)] * noise.factor[index_of(channel)], 2);
  const auto a = process_noise(scale, noise);
  variance[place_of_walk] = position_walk(scale, noise);
  variance.tail<3>() << a.u * a.u, a.v * a.v, a.r * a.r;
  return variance;
}

/// Calls f(run, filter) for each run with the ship that sailed it, on all cores.
/// @param passes  whose controls are used again where they serve
template <class F>
void for_each_run(const EstimationProblem& problem, const Point& point, const Noise& noise, const FilteredRuns* passes,
                  F&& f) {
  const double tau = noise.memory * time_unit_of(problem.scale);
  in_parallel(problem.runs.size(), 0, [&](std::size_t i) {
    const auto& run = problem.runs[i];
    f(i, *run_filter<9>(problem.ship_in(point, i), *run.run, run.channels, run.start, tau, SampleTimes::shown,
                        run.longest_step, passes ? passes->runs[i].controls : nullptr, run.finer_controls.get()));
  });
}

/// Standard deviations beyond which a measurement of real instruments is an outlier: of normal ones 1 in 370 is.
constexpr double outlying = 3.0;

/// The first row of each run, and the number of all.
std::vector<Eigen::Index> first_rows(const EstimationProblem& problem) {
  std::vector<Eigen::Index> first{0};
  for (const auto& run : problem.runs) first.push_back(first.back() + run.rows());
  return first;
}

}  // namespace

double FilteredRuns::log_likelihood() const {
  double sum = 0.0;
  for (const auto& run : runs) sum += run.log_likelihood();
  return sum;
}

FilterNoise log_likelihood_slope(const EstimationProblem& problem, const Point& point, const Noise& noise,
                                 const FilteredRuns& passes) {
  std::vector<FilterNoise> slopes(problem.runs.size());
  for_each_run(problem, point, noise, &passes, [&](std::size_t i, RunFilter<9>& filter) {
    slopes[i] = filter.backward(variances(problem.scale, problem.runs[i], noise), passes.runs[i]);
  });
  FilterNoise sum = FilterNoise::Zero();
  for (const auto& slope : slopes) sum += slope;
  return sum;
}

FilterNoise noises_seen(const EstimationProblem& problem, const Noise& noise, const FilteredRuns& passes) {
  FilterNoise seen = FilterNoise::Zero();
  const double time_unit = time_unit_of(problem.scale);
  for (std::size_t i = 0; i < problem.runs.size(); ++i) {
    const auto& run = problem.runs[i];
    const auto R = variances(problem.scale, run, noise);
    const auto& pass = passes.runs[i];
    for (std::size_t row = 0; row < pass.innovations.size(); ++row) {
      const auto& now = pass.innovations[row];
      const int place = place_of(pass.readings[row].channel);
      seen[place] += std::pow(R[place] * widening_of(now, pass.outlying) / now.variance, 2);
    }
    const double ship_times = (run.run->time.back() - run.run->time.front()) / time_unit;
    seen[place_of_walk] += ship_times;
    seen.tail<3>().array() += ship_times;
  }
  return seen;
}

std::shared_ptr<const FilteredRuns> filtered(const EstimationProblem& problem, const Point& point, const Noise& noise,
                                             const FilteredRuns* before) {
  auto result = std::make_shared<FilteredRuns>();
  result->runs.resize(problem.runs.size());
  for_each_run(problem, point, noise, before, [&](std::size_t i, RunFilter<9>& filter) {
    if (noise.with_memory) result->runs[i].outlying = outlying;
    filter.forward(variances(problem.scale, problem.runs[i], noise), result->runs[i]);
  });
  return result;
}

Eigen::VectorXd residuals(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes) {
  const auto first = first_rows(problem);
  Eigen::VectorXd e(first.back());
  for_each_run(problem, point, Noise{}, &passes, [&](std::size_t i, RunFilter<9>& filter) {
    filter.residuals(passes.runs[i], e.segment(first[i], problem.runs[i].rows()));
  });
  return e;
}

Eigen::VectorXd residuals_if_any(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes) {
  constexpr double huge = 1e6;  // standard deviations: no step is taken there
  try {
    return residuals(problem, point, passes);
  } catch (const std::exception&) {
    return Eigen::VectorXd::Constant(problem.rows(), huge);
  }
}

namespace {

/// The point with one unknown moved, towards its far bound where the near one is in the way.
Point moved(const EstimationProblem& problem, Point point, Eigen::Index i, double step) {
  point[i] += point[i] + step > problem.unknowns[static_cast<std::size_t>(i)].high ? -step : step;
  return point;
}

/// The point a little off, where no effect is exactly null and no speed exactly 0.
Point stirred(const EstimationProblem& problem, const Point& point) {
  constexpr double little = 1e-9;
  Point result = point;
  for (Eigen::Index i = 0; i < point.size(); ++i) result[i] = moved(problem, point, i, little)[i];
  return result;
}

std::optional<Ship> ship_if_any(const EstimationProblem& problem, const Point& point, std::size_t run) {
  try {
    return problem.ship_in(point, run);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// Columns from `first` on by the tangent of the filter. @return  which were found in every run
std::vector<bool> tangents(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes,
                           Eigen::Index first, Eigen::MatrixXd& slopes) {
  constexpr double step = 1e-6;  // over which numbers of the ship are differenced
  const auto columns = point.size() - first;
  const Point at = stirred(problem, point);
  const auto rows = first_rows(problem);
  std::vector<std::vector<bool>> found(problem.runs.size(), std::vector<bool>(static_cast<std::size_t>(columns)));
  in_parallel(problem.runs.size(), 0, [&](std::size_t run) {
    const auto ship = ship_if_any(problem, at, run);
    if (!ship) return;
    std::vector<Neighbour> neighbours;
    for (Eigen::Index i = first; i < point.size(); ++i) {
      const Point there = moved(problem, at, i, step);
      neighbours.push_back({ship_if_any(problem, there, run), there[i] - at[i]});
    }
    try {
      const auto& prepared = problem.runs[run];
      found[run] =
          run_filter<9>(*ship, *prepared.run, prepared.channels, prepared.start, 0.0, SampleTimes::shown,
                        prepared.longest_step, passes.runs[run].controls, prepared.finer_controls.get())
              ->slopes(passes.runs[run], *ship, neighbours, slopes.block(rows[run], first, prepared.rows(), columns));
    } catch (const std::exception&) {  // her motion runs away
    }
  });
  std::vector<bool> all(static_cast<std::size_t>(columns), true);
  for (const auto& in_run : found)
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] && in_run[i];
  return all;
}

}  // namespace

void difference(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes,
                const Eigen::VectorXd& here, std::span<const Eigen::Index> columns, Eigen::MatrixXd& slopes) {
  in_parallel(columns.size(), 0, [&](std::size_t k) {
    const auto i = columns[k];
    const Point there = moved(problem, point, i, problem.unknowns[static_cast<std::size_t>(i)].step);
    slopes.col(i) = (residuals_if_any(problem, there, passes) - here) / (there[i] - point[i]);
  });
}

void renew_slopes(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes,
                  const Eigen::VectorXd& here, Eigen::Index first, Eigen::MatrixXd& slopes) {
  // a diagnosis of 82 unknowns takes 34 s of processor time so; 39 s with 3, 48 s with 1
  constexpr Eigen::Index few = 8;
  const auto columns = point.size() - first;
  const auto found = columns > few ? tangents(problem, point, passes, first, slopes)
                                   : std::vector<bool>(static_cast<std::size_t>(columns), false);
  std::vector<Eigen::Index> rest;
  for (Eigen::Index i = first; i < point.size(); ++i)
    if (!found[static_cast<std::size_t>(i - first)]) rest.push_back(i);
  difference(problem, point, passes, here, rest, slopes);
}

}  // namespace swayaw::identification
