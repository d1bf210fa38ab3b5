#include "swayaw/identification/map_fit.hpp"

#include <catch.hpp>
#include <cmath>
#include <random>

#include "trajectory_recordings.hpp"

/// Coefficients of a ship under the filter, beside a fit to her trajectories.
namespace swayaw {
namespace {

/// Coefficients as c in value (1 + c), known to a whole before.
struct Coefficients {
  Ship ship;
  std::vector<Parameter> parameters;

  Coefficients(const Ship& given, const std::vector<std::string>& names)
      : ship(given), parameters(parameters_of(given, names)) {}

  Ship at(const Point& c) const {
    std::vector<double> values;
    for (const auto& p : parameters) values.push_back(p.value * (1.0 + c[std::ssize(values)]));
    return with_values(ship, parameters, values);
  }

  EstimationProblem problem(std::span<const PreparedRun> runs) const {
    std::vector<Unknown> unknowns;
    for (const auto& p : parameters) unknowns.push_back({.name = p.name, .step = 0.02});
    const auto size = std::ssize(parameters);
    return {.unknowns = std::move(unknowns),
            .precision = Eigen::MatrixXd::Identity(size, size),
            .runs = runs,
            .ship_in = [this](const Point& c, std::size_t) { return at(c); },
            .scale = ship};
  }
};

/// The run with white random accelerations of this size, kick by kick between the samples.
Recording disturbed(const Ship& ship, const Recording& run, const PlanarAcceleration<double>& size, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const RecordedControls controls(ship, run);
  auto result = run;
  auto state = recorded_state(ship, run, 0.0);
  const auto record = [&](Channel channel, std::size_t k, double value) { result.fill(channel)[k] = value; };
  for (std::size_t k = 0; k < run.samples(); ++k) {
    if (k > 0) {
      const double times[] = {run.time[k - 1], run.time[k]}, root = std::sqrt(times[1] - times[0]);
      const auto after = replay_from(ship, controls, state, times);
      const auto end = [&](Channel c) { return after[c][1]; };
      state = {
          end(Channel::x), end(Channel::y), end(Channel::psi), {end(Channel::u), end(Channel::v), end(Channel::r)}};
      state.motion.u += size.u * root * normal(engine);
      state.motion.v += size.v * root * normal(engine);
      state.motion.r += size.r * root * normal(engine);
    }
    record(Channel::x, k, state.x);
    record(Channel::y, k, state.y);
    record(Channel::psi, k, state.psi);
    record(Channel::u, k, state.motion.u);
    record(Channel::v, k, state.motion.v);
    record(Channel::r, k, state.motion.r);
  }
  return result;
}

/// The tanker in two zigzags to either side.
struct Tanker {
  Ship ship = test::kvlcc2_l7();
  std::vector<std::string> names = test::told_parameters<MmgShip<double>>();
  std::vector<double> truth = test::values_of(ship, names);
  Ship start = test::a_tenth_off(ship, names);
  Coefficients coefficients{start, names};
  std::vector<Recording> clean = test::zigzags(ship, {20.0, -10.0}, 15.0, 0.05);

  /// As instruments with white noise record them.
  std::vector<Recording> noisy() const {
    auto runs = clean;
    unsigned seed = 1;
    for (auto& run : runs) test::add_noise(run, ship, seed++);
    return runs;
  }

  struct Found {
    std::vector<Estimate> estimates;
    Noise noise;
  };

  Found filtered(std::span<const Recording> runs, const Noise& noise) const {
    const auto prepared = prepared_runs(start, runs, test::usual_channels);
    const auto problem = coefficients.problem(prepared);
    const auto found = fit(problem, problem.mean(), noise, 0);
    Found result{{}, found.noise};
    for (Eigen::Index i = 0; i < problem.size(); ++i) {
      const double given = coefficients.parameters[static_cast<std::size_t>(i)].value;
      result.estimates.push_back({given * (1.0 + found.point[i]), std::abs(given) * std::sqrt(found.covariance(i, i))});
    }
    return result;
  }
};

}  // namespace

TEST_CASE("under the filter coefficients come out as on trajectories where no random force acts",
          "[identification][second-route]") {
  const Tanker tanker;
  const auto runs = tanker.noisy();
  const auto filtered = tanker.filtered(runs, {});
  const auto simulated =
      fit_trajectories(tanker.start, runs, {.parameters = tanker.names, .channels = test::usual_channels});
  CHECK(filtered.noise.scale < ordinary_scale);
  for (std::size_t i = 0; i < tanker.truth.size(); ++i) {
    const auto &a = filtered.estimates[i], &b = simulated.parameters[i].estimate;
    INFO(tanker.names[i] << " " << a.value << " " << b.value << " +- " << a.standard_error);
    CHECK(std::abs(a.value - b.value) < 2.0 * a.standard_error);
  }
}

TEST_CASE("the likelihood of a sample of real instruments falls with its error, and not with the square of it",
          "[identification][law]") {
  const Tanker tanker;
  const auto runs = tanker.noisy();
  const auto prepared = prepared_runs(tanker.ship, runs, test::usual_channels);
  const Coefficients truth{tanker.ship, tanker.names};
  // how much less likely the runs are with one heading that many standard deviations off
  const auto loss = [&](double deviations, const Noise& noise) {
    auto moved = prepared;
    auto run = *moved.front().run;
    run.fill(Channel::psi)[run.samples() / 2] += deviations * moved.front().deviation[index_of(Channel::psi)];
    moved.front().run = std::make_shared<const Recording>(std::move(run));
    const auto as_is = truth.problem(prepared), off = truth.problem(moved);
    return log_likelihood(as_is, as_is.mean(), noise) - log_likelihood(off, off.mean(), noise);
  };
  const auto real = Noise::on_board();
  CHECK(loss(0.5, real) == Approx(loss(0.5, {})).margin(0.5));
  CHECK(loss(80.0, {}) > 3.5 * loss(40.0, {}));
  CHECK(loss(80.0, real) < 2.3 * loss(40.0, real));
  CHECK(loss(80.0, real) > loss(40.0, real));
}

TEST_CASE("at the noise that suits real instruments best the likelihood is level, however many outliers they have",
          "[identification][law]") {
  const Tanker tanker;
  auto runs = tanker.noisy();
  const double deviation =
      prepared_runs(tanker.ship, runs, test::usual_channels).front().deviation[index_of(Channel::psi)];
  for (auto& run : runs) {
    auto psi = run.fill(Channel::psi);
    for (std::size_t i = 5; i < psi.size(); i += 20) psi[i] += (i % 40 < 20 ? 8.0 : -8.0) * deviation;
  }
  const auto prepared = prepared_runs(tanker.ship, runs, test::usual_channels);
  const Coefficients truth{tanker.ship, tanker.names};
  const auto problem = truth.problem(prepared);
  const auto best = best_noise(problem, problem.mean(), Noise::on_board(), true);
  for (const Channel channel : test::usual_channels) {
    const auto at = [&](double factor) {
      auto noise = best.noise;
      noise.factor[index_of(channel)] *= factor;
      return log_likelihood(problem, problem.mean(), noise);
    };
    constexpr double step = 1.02;
    const double slope = (at(step) - at(1.0 / step)) / (2.0 * std::log(step));
    INFO(index_of(channel) << " " << best.noise.factor[index_of(channel)] << " " << slope);
    CHECK(std::abs(slope) < 2.0);
  }
}

TEST_CASE("process noise makes coefficients from runs with random forces better, and their intervals hold",
          "[identification][second-route]") {
  const Tanker tanker;
  const double L = length(tanker.ship), U = service_speed(tanker.ship), root = std::sqrt(L / U);
  const PlanarAcceleration<double> size{0.003 * U / root, 0.003 * U / root, 0.01 * U / L / root};
  Noise noise;
  noise.apart = true;
  int inside = 0, all = 0;
  double with = 0.0, without = 0.0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::vector<Recording> runs;
    for (const auto& run : tanker.clean) {
      runs.push_back(disturbed(tanker.ship, run, size, 100 * seed + static_cast<unsigned>(runs.size())));
      test::add_noise(runs.back(), tanker.ship, seed);
    }
    const auto filtered = tanker.filtered(runs, noise);
    const auto simulated =
        fit_trajectories(tanker.start, runs, {.parameters = tanker.names, .channels = test::usual_channels});
    for (std::size_t i = 0; i < tanker.truth.size(); ++i) {
      const auto& found = filtered.estimates[i];
      inside += std::abs(found.value - tanker.truth[i]) < 1.96 * found.standard_error;
      ++all;
      with += std::pow(found.value / tanker.truth[i] - 1.0, 2);
      without += std::pow(simulated.parameters[i].estimate.value / tanker.truth[i] - 1.0, 2);
    }
  }
  INFO(inside << " of " << all << " inside; squared errors " << with << " and " << without);
  CHECK(inside >= 0.85 * all);
  CHECK(with < 0.5 * without);
}

// Regression, 2026-11-22: of KVLCC2 with a stiff roll the slopes were no numbers, and so was the evidence.
TEST_CASE("a fit whose evidence is no number is no fit", "[identification][regression]") {
  const Tanker tanker;
  const auto runs = tanker.noisy();
  const auto prepared = prepared_runs(tanker.start, runs, test::usual_channels);
  auto problem = tanker.coefficients.problem(prepared);
  CHECK(fit(problem, problem.mean(), {}, 0, {.rounds = 1}).point.size() == problem.size());
  problem.precision(0, 0) = std::nan("");
  const auto found = fit(problem, problem.mean(), {}, 0, {.rounds = 1});
  CHECK(found.point.size() == 0);
  CHECK(found.log_evidence == -HUGE_VAL);
}

}  // namespace swayaw
