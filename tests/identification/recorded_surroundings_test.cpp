#include <Eigen/LU>
#include <catch.hpp>
#include <cmath>
#include <numeric>

#include "gusty_run.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Measured wind and depth in filter and fits.
namespace swayaw {
namespace {

using test::without_wind;

const Ship& pond_model() {
  static const Ship ship = published_ship("esso_osaka_3m");
  return ship;
}

/// Motion with noise of an instrument, wind as it was.
Recording noisy(Recording run, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (const auto& [channel, size] : {std::pair{Channel::x, 0.01},
                                      {Channel::y, 0.01},
                                      {Channel::psi, 1e-3},
                                      {Channel::u, 2e-3},
                                      {Channel::v, 2e-3},
                                      {Channel::r, 5e-4}})
    for (double& value : run.channels[index_of(channel)]) value += size * normal(engine);
  return run;
}

Recording gusty_run(unsigned seed, double lengths = 30.0) {
  const double unit = length(pond_model()) / service_speed(pond_model());
  return noisy(test::run_in_wind(pond_model(), {{-1.2, -0.9}, 0.5, unit, seed}, lengths), seed);
}

constexpr std::array seen{Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r};

/// What the runs tell of a ship of which nothing is unknown but the noise.
Likelihood likelihood_of(const Ship& ship, const std::vector<PreparedRun>& runs) {
  const EstimationProblem problem{.unknowns = {},
                                  .precision = Eigen::MatrixXd(0, 0),
                                  .runs = runs,
                                  .ship_in = [&](const Point&, std::size_t) { return ship; },
                                  .scale = ship};
  return best_noise(problem, Point(0), Noise{}, false);
}

double rms_unmodelled_sway(const Recording& run) {
  double sum = 0.0;
  const auto estimate = estimate_states(pond_model(), run);
  for (const auto& s : estimate.states) sum += s.unmodelled.v * s.unmodelled.v;
  return std::sqrt(sum / static_cast<double>(estimate.states.size()));
}

}  // namespace

TEST_CASE("with the recorded wind the filter has less to call random", "[identification][second-route]") {
  for (const unsigned seed : {1u, 2u}) {
    const auto run = gusty_run(seed);
    const std::vector with{run}, without{without_wind(run)};
    for (const auto prepared : {&prepared_runs, &lean_runs}) {
      const auto told = likelihood_of(pond_model(), prepared(pond_model(), with, seen)),
                 untold = likelihood_of(pond_model(), prepared(pond_model(), without, seen));
      INFO(seed);
      CHECK(told.log_likelihood > untold.log_likelihood + 100.0);
      CHECK(told.noise.scale < 0.3 * untold.noise.scale);
    }
    CHECK(rms_unmodelled_sway(run) < 0.3 * rms_unmodelled_sway(without_wind(run)));
  }
}

TEST_CASE("the filter takes a constant recorded wind for a steady wind", "[identification][second-route]") {
  auto run = without_wind(gusty_run(3, 10.0));
  auto steady = pond_model();
  steady.effects.push_back(SteadyWind<>{1.5, 0.8});
  const auto as_effect = estimate_states(steady, run);
  std::ranges::fill(run.fill(Channel::wind_speed), 1.5), std::ranges::fill(run.fill(Channel::wind_from), 0.8);
  const auto as_column = estimate_states(pond_model(), run);
  CHECK_THAT(as_column.noise.log_likelihood, WithinRel(as_effect.noise.log_likelihood, 1e-8));
  for (std::size_t i = 0; i < run.samples(); i += 50)
    CHECK_THAT(as_column.states[i].state.motion.v, WithinAbs(as_effect.states[i].state.motion.v, 1e-8));
}

TEST_CASE("lean runs keep the mean of the wind, not every so many samples of it", "[identification][limit]") {
  const std::vector runs{gusty_run(4)};
  const auto lean = lean_runs(pond_model(), runs, seen).front();
  REQUIRE(2 * lean.run->samples() < runs[0].samples());
  const auto full = recorded_wind(pond_model(), runs[0]), few = recorded_wind(pond_model(), *lean.run);
  const auto mean = [](const std::vector<WindPiece>& wind, double from) {
    double sum = 0.0, time = 0.0;
    for (std::size_t k = 1; k + 1 < wind.size(); ++k) {
      const double h = wind[k + 1].time - wind[k].time;
      if (wind[k].time >= from && wind[k].time < from + 17.0) sum += h * wind[k].north, time += h;
    }
    return sum / time;
  };
  for (const double from : {20.0, 80.0, 140.0, 200.0}) CHECK_THAT(mean(few, from), WithinAbs(mean(full, from), 0.05));
}

TEST_CASE("of a run without wind nothing is averaged or asked", "[identification][limit]") {
  const std::vector runs{without_wind(gusty_run(4, 10.0))};
  const auto lean = lean_runs(pond_model(), runs, seen).front();
  CHECK_FALSE(lean.run->has(Channel::wind_speed));
  CHECK(RecordedControls(pond_model(), *lean.run).wind().empty());
}

TEST_CASE("a fit to trajectories finds the true coefficients in gusty wind that was recorded",
          "[identification][second-route]") {
  const std::vector runs{gusty_run(5), gusty_run(6)};
  const std::vector blind{without_wind(runs[0]), without_wind(runs[1])};
  const auto truth = parameters_of(pond_model(), std::array{std::string("Y_v"), std::string("N_r")});
  const auto given = with_values(pond_model(), truth, std::array{1.2 * truth[0].value, 0.85 * truth[1].value});
  const TrajectoryFitOptions options{.parameters = {"Y_v", "N_r"}, .segment = 2.0};
  const auto told = fit_trajectories(given, runs, options), untold = fit_trajectories(given, blind, options);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    INFO(truth[i].name);
    const auto error = [&](const TrajectoryFit& fit) {
      return std::abs(fit.parameters[i].estimate.value / truth[i].value - 1.0);
    };
    CHECK(error(told) < 0.03);
    CHECK(error(told) < 0.3 * error(untold));
  }
}

TEST_CASE("in recorded wind a fit of many coefficients leaves right ones within its errors",
          "[identification][limit]") {
  const auto all = parameters_of(pond_model());
  std::vector<Parameter> unknown;
  std::ranges::copy_if(all, std::back_inserter(unknown), [](const Parameter& p) {
    return p.role == Role::coefficient && p.deviation > 0.0 && p.value != 0.0;
  });
  REQUIRE(unknown.size() > 12);
  const auto found_in = [&](const Recording& run) {
    const auto runs = lean_runs(pond_model(), std::vector{run}, seen);
    const auto ship_at = [&](const Point& c, std::size_t) {
      std::vector<double> values;
      for (const auto& p : unknown) values.push_back(p.value + p.deviation * c[std::ssize(values)]);
      return with_values(pond_model(), unknown, values);
    };
    const auto size = std::ssize(unknown);
    const EstimationProblem problem{.unknowns = std::vector<Unknown>(unknown.size()),
                                    .precision = Eigen::MatrixXd::Identity(size, size),
                                    .runs = runs,
                                    .ship_in = ship_at,
                                    .scale = pond_model()};
    return fit(problem, Point::Zero(size), Noise{}, size);
  };
  const auto run = gusty_run(8);
  const auto told = found_in(run), untold = found_in(without_wind(run));
  const double n = static_cast<double>(unknown.size()), square = told.point.dot(told.covariance.inverse() * told.point);
  CHECK(square < n + 4.0 * std::sqrt(2.0 * n));  // chi-squared of n unknowns
  CHECK(told.log_evidence > untold.log_evidence + 100.0);
  CHECK(told.noise.scale < 0.5 * untold.noise.scale);
}

TEST_CASE("the filter sails a run of known depth as in shallow water of that depth", "[identification][second-route]") {
  auto run = without_wind(gusty_run(7, 10.0));
  const double draught = std::get<MmgShip<double>>(pond_model().model).particulars.d;
  auto shallow = pond_model();
  shallow.effects.push_back(ShallowWater<>{1.4});
  const double as_effect = estimate_states(shallow, run).noise.log_likelihood;
  const double deep = estimate_states(pond_model(), run).noise.log_likelihood;
  run.facts.water_depth = 1.4 * draught;
  CHECK(estimate_states(pond_model(), run).noise.log_likelihood == as_effect);
  CHECK(as_effect < deep);
}

}  // namespace swayaw
