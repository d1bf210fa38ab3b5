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
template <class F>
void for_each_run(const EstimationProblem& problem, const Point& point, const Noise& noise, F&& f) {
  const double tau = noise.memory * length(problem.scale) / service_speed(problem.scale);
  in_parallel(problem.runs.size(), 0, [&](std::size_t i) {
    const auto& run = problem.runs[i];
    f(i, *run_filter<9>(problem.ship_in(point, i), *run.run, run.channels, run.start, tau, run.longest_step));
  });
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
  for_each_run(problem, point, noise, [&](std::size_t i, RunFilter<9>& filter) {
    slopes[i] = filter.backward(variances(problem.scale, problem.runs[i], noise), passes.runs[i]);
  });
  FilterNoise sum = FilterNoise::Zero();
  for (const auto& slope : slopes) sum += slope;
  return sum;
}

std::shared_ptr<const FilteredRuns> filtered(const EstimationProblem& problem, const Point& point, const Noise& noise) {
  auto result = std::make_shared<FilteredRuns>();
  result->runs.resize(problem.runs.size());
  for_each_run(problem, point, noise, [&](std::size_t i, RunFilter<9>& filter) {
    filter.forward(variances(problem.scale, problem.runs[i], noise), result->runs[i]);
  });
  return result;
}

Eigen::VectorXd residuals(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes) {
  std::vector<Eigen::Index> first{0};
  for (const auto& run : problem.runs) first.push_back(first.back() + run.rows());
  Eigen::VectorXd e(first.back());
  for_each_run(problem, point, Noise{}, [&](std::size_t i, RunFilter<9>& filter) {
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

void difference(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes,
                const Eigen::VectorXd& here, Eigen::Index first, Eigen::MatrixXd& slopes) {
  in_parallel(static_cast<std::size_t>(point.size() - first), 0, [&](std::size_t k) {
    const auto i = first + static_cast<Eigen::Index>(k);
    const auto& unknown = problem.unknowns[static_cast<std::size_t>(i)];
    const double step = point[i] + unknown.step > unknown.high ? -unknown.step : unknown.step;
    Point moved = point;
    moved[i] += step;
    slopes.col(i) = (residuals_if_any(problem, moved, passes) - here) / step;
  });
}

}  // namespace swayaw::identification
