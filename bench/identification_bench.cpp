#include <benchmark/benchmark.h>

#include <ctime>
#include <numeric>
#include <random>

#include "../identification/src/estimation/filtered_runs.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::bench {
namespace {

const std::vector<std::string> ten{"Y_v", "Y_r", "N_v", "N_r", "Y_vvv", "N_vvv", "N_rrr", "R_0", "f_alpha", "a_H"};

/// KVLCC2 model, 888 samples of a 20/20 zigzag with noise on place, heading, yaw rate and log.
Recording noisy_zigzag(const Ship& ship) {
  Recording run = zigzag(ship, {radians(20.0), radians(20.0)}, {.duration = 99.8, .step = 0.1125}).run;
  std::mt19937_64 engine(888);
  std::normal_distribution<double> normal;
  const double L = length(ship), U = service_speed(ship);
  const auto shake = [&](std::span<double> column, double size) {
    for (double& x : column) x += size * normal(engine);
  };
  shake(run.fill(Channel::x), 1e-3 * L);
  shake(run.fill(Channel::y), 1e-3 * L);
  shake(run.fill(Channel::psi), radians(0.1));
  shake(run.fill(Channel::r), 0.01 * U / L);
  shake(run.fill(Channel::u), 0.01 * U);
  return run;
}

/// Ten parameters, each 10 % off at the beginning; noise estimated. The argument tells the threads, 0 for all cores.
void trajectory_fit_10_numbers_888_samples(benchmark::State& state) {
  const Ship ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml");
  const auto run = noisy_zigzag(ship);
  const auto parameters = parameters_of(ship, ten);
  std::vector<double> off;
  for (const auto& n : parameters) off.push_back(n.value * (off.size() % 2 == 0 ? 1.1 : 0.9));
  const Ship start = with_values(ship, parameters, off);
  const TrajectoryFitOptions options{.parameters = ten,
                                     .channels = {Channel::x, Channel::y, Channel::psi, Channel::r, Channel::u},
                                     .threads = static_cast<unsigned>(state.range(0))};
  TrajectoryFit fit{};
  for (auto _ : state) fit = fit_trajectories(start, run, options);
  state.counters["samples"] = static_cast<double>(run.samples());
  state.counters["sensitivities"] = fit.sensitivities;
  state.counters["converged"] = fit.status == TrajectoryFitStatus::converged;
  tell_ratio(state);
}
BENCHMARK(trajectory_fit_10_numbers_888_samples)->Arg(1)->Arg(0)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Processor time that f takes, of all threads.
template <class F>
double processor_time(F&& f) {
  const auto begin = std::clock();
  f();
  return static_cast<double>(std::clock() - begin);
}

/// Slopes of the residuals of the zigzag by every coefficient of the ship, and how much more processor time differences
/// take.
void slopes_of_residuals_888_samples(benchmark::State& state) {
  const Ship ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml");
  const std::vector runs{noisy_zigzag(ship)};
  auto parameters = parameters_of(ship);
  std::erase_if(parameters, [](const Parameter& p) { return p.role != Role::coefficient || !(p.deviation > 0.0); });
  const auto prepared = prepared_runs(ship, runs, motion_channels());
  const auto size = std::ssize(parameters);
  const EstimationProblem problem{.unknowns = std::vector<Unknown>(parameters.size()),
                                  .precision = Eigen::MatrixXd::Identity(size, size),
                                  .runs = prepared,
                                  .ship_in =
                                      [&](const Point& c, std::size_t) {
                                        std::vector<double> values;
                                        for (const auto& p : parameters)
                                          values.push_back(p.value + p.deviation * c[std::ssize(values)]);
                                        return with_values(ship, parameters, values);
                                      },
                                  .scale = ship};
  const Point here = Point::Zero(size);
  const auto passes = filtered(problem, here, Noise{});
  const auto e = residuals(problem, here, *passes);
  Eigen::MatrixXd slopes(problem.rows(), size);
  std::vector<Eigen::Index> all(parameters.size());
  std::iota(all.begin(), all.end(), 0);
  double tangent = 0.0, differences = 0.0;
  for (auto _ : state) {
    tangent += processor_time([&] { renew_slopes(problem, here, *passes, e, 0, slopes); });
    state.PauseTiming();
    differences += processor_time([&] { difference(problem, here, *passes, e, all, slopes); });
    state.ResumeTiming();
  }
  state.counters["unknowns"] = static_cast<double>(size);
  state.counters["differences_more"] = differences / tangent;
  tell_ratio(state);
}
BENCHMARK(slopes_of_residuals_888_samples)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace swayaw::bench
