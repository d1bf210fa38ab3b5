/// The descent of a MAP fit beside that of Ceres Solver: the same residuals, differences, prior, bounds and least gain.
/// docs/decisions/007_descent.md
#include <ceres/ceres.h>
#include <fmt/format.h>

#include <chrono>
#include <numeric>
#include <random>

#include "../identification/src/estimation/descent.hpp"
#include "../identification/src/estimation/filtered_runs.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::bench {
namespace {

using namespace identification::detail;

constexpr double worth = 0.05, bound = 8.0;  // least gain in the cost; of unknowns in tenths of their values

/// A 15-minute zigzag of the KVLCC2 model with noise on place, heading, yaw rate and log.
Recording noisy_zigzag(const Ship& ship, double angle, unsigned seed) {
  auto run = zigzag(ship, {radians(angle), radians(angle)}, {.duration = 100.0, .step = 0.3}).run;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const double L = length(ship), U = service_speed(ship);
  const auto shake = [&](Channel channel, double size) {
    for (double& x : run.fill(channel)) x += size * normal(engine);
  };
  shake(Channel::x, 1e-3 * L), shake(Channel::y, 1e-3 * L), shake(Channel::psi, radians(0.1));
  shake(Channel::r, 0.01 * U / L), shake(Channel::u, 0.01 * U);
  return run;
}

/// Residuals of the runs, then those of the prior. Counts how often the runs are filtered.
struct Counted : ceres::CostFunction {
  const EstimationProblem& problem;
  const FilteredRuns& passes;
  int& count;

  Counted(const EstimationProblem& p, const FilteredRuns& f, int& c) : problem(p), passes(f), count(c) {
    set_num_residuals(static_cast<int>(p.rows() + p.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(p.size()));
  }

  bool Evaluate(double const* const* x, double* residual, double** jacobian) const override {
    const Point point = Eigen::Map<const Eigen::VectorXd>(x[0], problem.size());
    const Eigen::VectorXd e = residuals_if_any(problem, point, passes);
    Eigen::Map<Eigen::VectorXd>(residual, num_residuals()) << e, point;
    ++count;
    if (!jacobian || !jacobian[0]) return true;
    Eigen::MatrixXd slopes(problem.rows(), problem.size());
    difference(problem, point, passes, e, 0, slopes);
    count += static_cast<int>(problem.size());
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(jacobian[0], num_residuals(),
                                                                                       problem.size())
        << slopes,
        Eigen::MatrixXd::Identity(problem.size(), problem.size());
    return true;
  }
};

struct Outcome {
  double cost;
  int filtered;
  double seconds;
};

template <class F>
Outcome timed(F&& f) {
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome = f();
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

Outcome by_trust_region(const EstimationProblem& problem, const FilteredRuns& passes) {
  int count = 1;
  const auto cost = [&](const Point& p, const Eigen::VectorXd& e) { return e.squaredNorm() + problem.prior(p); };
  Descent here{problem.mean(), residuals(problem, problem.mean(), passes), 0.0, problem.low(), problem.high()};
  here.cost = cost(here.point, here.residuals);
  Eigen::MatrixXd J(problem.rows(), problem.size());
  const auto renew = [&](const Descent& at, int) {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(problem.size()));
    std::iota(all.begin(), all.end(), 0);
    difference(problem, at.point, passes, at.residuals, all, J);
    count += static_cast<int>(problem.size());
    return NormalEquations{J.transpose() * J + problem.precision, -J.transpose() * at.residuals - at.point};
  };
  const auto at = [&](const Point& p) { return ++count, residuals_if_any(problem, p, passes); };
  descend(here, {.iterations = 50, .attempts = 20, .worth = worth, .radius = 10.0}, renew, at, cost);
  return {here.cost, count, 0.0};
}

Outcome by_ceres(const EstimationProblem& problem, const FilteredRuns& passes, double start,
                 ceres::TrustRegionStrategyType strategy) {
  int count = 0;
  Eigen::VectorXd x = problem.mean();
  ceres::Problem task;
  task.AddResidualBlock(new Counted(problem, passes, count), nullptr, x.data());
  for (int i = 0; i < x.size(); ++i) {
    task.SetParameterLowerBound(x.data(), i, -bound);
    task.SetParameterUpperBound(x.data(), i, bound);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.trust_region_strategy_type = strategy;
  options.function_tolerance = worth / start;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &task, &summary);
  return {2.0 * summary.final_cost, count, 0.0};
}

void compare(const Ship& truth, std::span<const Recording> runs, double tenths) {
  const std::vector<std::string> names{"Y_v", "Y_r", "N_v", "N_r", "Y_vvv", "N_vvv", "N_rrr", "R_0", "f_alpha", "a_H"};
  std::vector<double> off;
  for (const auto& p : parameters_of(truth, names))
    off.push_back(p.value * (1.0 + (off.size() % 2 == 0 ? 0.1 : -0.1) * tenths));
  const auto start = with_values(truth, parameters_of(truth, names), off);
  const auto parameters = parameters_of(start, names);
  const auto prepared =
      prepared_runs(start, runs, std::array{Channel::x, Channel::y, Channel::psi, Channel::r, Channel::u});
  std::vector<Unknown> unknowns;
  for (const auto& p : parameters) unknowns.push_back({.name = p.name, .low = -bound, .high = bound});
  const auto size = std::ssize(parameters);
  const auto ship_in = [&](const Point& c, std::size_t) {
    std::vector<double> values;
    for (const auto& p : parameters) values.push_back(p.value * (1.0 + 0.1 * c[std::ssize(values)]));
    return with_values(start, parameters, values);
  };
  const EstimationProblem problem{unknowns, Eigen::MatrixXd::Identity(size, size), prepared, ship_in, start};
  const auto passes = filtered(problem, problem.mean(), Noise{});
  const double first = residuals(problem, problem.mean(), *passes).squaredNorm();
  const auto tell = [&](std::string_view name, const Outcome& o) {
    fmt::print("| {:.0f} % | {} | {:.2f} | {} | {:.0f} ms |\n", 10.0 * tenths, name, o.cost, o.filtered,
               1e3 * o.seconds);
  };
  tell("trust region of swayaw", timed([&] { return by_trust_region(problem, *passes); }));
  tell("Ceres, Levenberg–Marquardt",
       timed([&] { return by_ceres(problem, *passes, first, ceres::LEVENBERG_MARQUARDT); }));
  tell("Ceres, dogleg", timed([&] { return by_ceres(problem, *passes, first, ceres::DOGLEG); }));
}

}  // namespace
}  // namespace swayaw::bench

int main() {
  using namespace swayaw;
  const auto ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml");
  std::vector<Recording> runs;
  for (const double angle : {20.0, 10.0, 15.0})
    runs.push_back(bench::noisy_zigzag(ship, angle, static_cast<unsigned>(runs.size() + 1)));
  fmt::print(
      "| coefficients off by | descent | cost at its end | runs filtered | time |\n| ---: | --- | ---: | ---: | ---: "
      "|\n");
  for (const double tenths : {0.5, 1.0, 2.0, 4.0}) bench::compare(ship, runs, tenths);
}
