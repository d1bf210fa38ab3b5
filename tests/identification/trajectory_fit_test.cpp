#include <catch.hpp>
#include <cmath>
#include <limits>

#include "trajectory_recordings.hpp"

namespace swayaw {
namespace {

constexpr double single_shooting = std::numeric_limits<double>::infinity();

/// Largest relative error of the fitted parameters.
double worst_error(const TrajectoryFit& fit, const std::vector<double>& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    worst = std::max(worst, std::abs(fit.parameters[i].estimate.value / truth[i] - 1.0));
  return worst;
}

/// Largest difference of the parameters of two fits, in standard errors.
double apart(const TrajectoryFit& a, const TrajectoryFit& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.parameters.size(); ++i)
    worst = std::max(worst, std::abs(a.parameters[i].estimate.value - b.parameters[i].estimate.value) /
                                a.parameters[i].estimate.standard_error);
  return worst;
}

/// The tanker in two zigzags, with noise.
struct Tanker {
  Ship ship = test::kvlcc2_l7();
  std::vector<std::string> names = test::told_parameters<MmgShip<double>>();
  std::vector<double> truth = test::values_of(ship, names);
  Ship start = test::a_tenth_off(ship, names);
  std::vector<Recording> clean = test::zigzags(ship, {20.0, -10.0}, 15.0, 0.05);
  std::vector<Recording> noisy = clean;
  TrajectoryFitOptions options{.parameters = names, .channels = test::usual_channels};

  Tanker() {
    unsigned seed = 1;
    for (auto& run : noisy) test::add_noise(run, ship, seed++);
  }
};

}  // namespace

TEMPLATE_TEST_CASE("without noise the numbers of seeded ships come back from a tenth off",
                   "[identification][round-trip]", MmgShip<double>, PiShip<double>, PuShip<double>,
                   AbkowitzShip<double>) {
  test::RandomModels random(20261201);
  const auto names = test::told_parameters<TestType>();
  for (int i = 0; i < 10; ++i) {
    const auto [ship, runs] = test::steerable<TestType>(random, {20.0, -10.0}, 12.0, 0.02);
    const auto fit = fit_trajectories(test::a_tenth_off(ship, names), runs,
                                      {.parameters = names, .channels = test::usual_channels, .step = 0.005});
    INFO("ship " << i << ", iterations " << fit.iterations);
    CHECK(fit.status == TrajectoryFitStatus::converged);
    CHECK(worst_error(fit, test::values_of(ship, names)) < 1e-6);
  }
}

TEST_CASE("multiple and single shooting find the same numbers, errors and likelihood",
          "[identification][second-route]") {
  const Tanker tanker;
  auto options = tanker.options;
  const auto multiple = fit_trajectories(tanker.start, tanker.noisy, options);
  options.segment = single_shooting;
  const auto single = fit_trajectories(tanker.start, tanker.noisy, options);
  REQUIRE(multiple.status == TrajectoryFitStatus::converged);
  REQUIRE(single.status == TrajectoryFitStatus::converged);
  CHECK(apart(multiple, single) < 1e-2);
  CHECK(multiple.log_likelihood == Approx(single.log_likelihood).margin(1e-3));
  for (std::size_t i = 0; i < tanker.names.size(); ++i)
    CHECK(multiple.parameters[i].estimate.standard_error ==
          Approx(single.parameters[i].estimate.standard_error).epsilon(1e-2));
}

TEST_CASE("residuals of a fit are the noise", "[identification][second-route]") {
  const Tanker tanker;
  const auto fit = fit_trajectories(tanker.start, tanker.noisy, tanker.options);
  CHECK(*fit.noise[index_of(Channel::psi)] == Approx(radians(0.1)).epsilon(0.08));
  CHECK(*fit.noise[index_of(Channel::x)] == Approx(1e-3 * length(tanker.ship)).epsilon(0.08));
  CHECK_FALSE(fit.noise[index_of(Channel::v)]);
  REQUIRE(fit.runs.size() == 2);
  for (const auto& run : fit.runs) {
    REQUIRE(run.channels.size() == 5);
    for (const auto& c : run.channels) {
      CHECK(c.after < c.before);
      CHECK(std::abs(c.autocorrelation) < 0.2);
      CHECK(c.effective_count > 0.6 * static_cast<double>(c.count));
    }
  }
}

TEST_CASE("known noise gives the fit that finds the same noise itself", "[identification][second-route]") {
  const Tanker tanker;
  const auto found = fit_trajectories(tanker.start, tanker.noisy, tanker.options);
  auto options = tanker.options;
  options.noise = found.noise;
  CHECK(apart(found, fit_trajectories(tanker.start, tanker.noisy, options)) < 1e-2);
}

TEST_CASE("irregular sampling, gaps and channels that come and go do no harm to a fit",
          "[identification][round-trip]") {
  const Tanker tanker;
  auto run = tanker.clean.front();
  test::RandomModels random(7);
  std::vector<double> time{0.0};
  while (time.back() < 0.95 * run.time.back()) time.push_back(time.back() + random.uniform(0.05, 1.5));
  const RecordedControls controls(tanker.ship, run);
  auto irregular =
      replay_from(tanker.ship, controls, recorded_state(tanker.ship, run, 0.0), time, {.tolerance = 1e-12});
  for (std::size_t i = 0; i < time.size(); ++i) irregular.fill(Channel::delta)[i] = controls.rudder(time[i]);
  // straight lines between these samples are the controls of another simulation
  irregular = replay_from(tanker.ship, RecordedControls(tanker.ship, irregular), recorded_state(tanker.ship, run, 0.0),
                          time, {.tolerance = 1e-12});
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (i % 3 == 0) irregular.fill(Channel::x)[i] = missing;
    if (i % 4 == 1 || (i > 20 && i < 30)) irregular.fill(Channel::psi)[i] = missing;
    if (i > 30 && i < 40) irregular.fill(Channel::r)[i] = missing;
  }
  auto options = tanker.options;
  options.step = 0.01;
  const auto fit = fit_trajectories(tanker.start, irregular, options);
  CHECK(fit.status == TrajectoryFitStatus::converged);
  CHECK(worst_error(fit, tanker.truth) < 1e-5);
}

TEST_CASE("speed and course over ground and velocities over ground do as well, in wind and current",
          "[identification][round-trip]") {
  Tanker tanker;
  tanker.ship.surroundings.current = {0.1, 0.7};
  tanker.ship.surroundings.windy = true;
  tanker.ship.surroundings.wind = {3.0, -1.0};
  tanker.ship.surroundings.windage = {.rho = 1.2,
                                      .A_F = 0.3,
                                      .A_L = 1.0,
                                      .L_OA = 7.0,
                                      .x_A = 0.1,
                                      .C_Dt = 0.8,
                                      .C_Dl_bow = 0.5,
                                      .C_Dl_stern = 0.6,
                                      .delta = 0.6};
  auto run = test::zigzags(tanker.ship, {20.0}, 15.0, 0.05).front();
  const auto columns = {run.fill(Channel::u_ground), run.fill(Channel::v_ground), run.fill(Channel::speed_over_ground),
                        run.fill(Channel::course_over_ground)};
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const ShipState<double> s{
        0.0, 0.0, run[Channel::psi][i], {run[Channel::u][i], run[Channel::v][i], run[Channel::r][i]}};
    const auto ground = over_ground(tanker.ship.surroundings.current, s);
    const double values[] = {ground.u, ground.v, speed(ground), s.psi + std::atan2(ground.v, ground.u)};
    for (std::size_t k = 0; k < 4; ++k) columns.begin()[k][i] = values[k];
  }
  Ship start = test::a_tenth_off(tanker.ship, tanker.names);
  for (const auto& channels : {std::vector{Channel::u_ground, Channel::v_ground, Channel::r},
                               std::vector{Channel::speed_over_ground, Channel::course_over_ground, Channel::psi}}) {
    const auto fit = fit_trajectories(start, run, {.parameters = tanker.names, .channels = channels, .step = 0.01});
    CHECK(worst_error(fit, tanker.truth) < 1e-5);
  }
}

TEST_CASE("a fit that is stopped keeps the best so far", "[identification][limit]") {
  const Tanker tanker;
  auto options = tanker.options;
  int calls = 0;
  std::vector<double> seen;
  options.progress = [&](const TrajectoryProgress& now) {
    seen.assign(now.values.begin(), now.values.end());
    return ++calls < 2;
  };
  const auto fit = fit_trajectories(tanker.start, tanker.noisy, options);
  CHECK(fit.status == TrajectoryFitStatus::stopped);
  CHECK(calls == 2);
  CHECK(worst_error(fit, seen) < 1e-12);
  CHECK(worst_error(fit, tanker.truth) < 0.1);
  options.progress = {};
  options.most_iterations = 1;
  CHECK(fit_trajectories(tanker.start, tanker.noisy, options).status == TrajectoryFitStatus::iteration_limit);
}

TEST_CASE("what the runs do not tell is said, and does not spoil the rest", "[identification][limit]") {
  Tanker tanker;
  // where the thrust was recorded nothing depends on the open-water curve
  tanker.options.parameters.push_back("kt[2]");
  for (auto& run : tanker.noisy) run.channels[index_of(Channel::rev)].clear();
  const auto fit = fit_trajectories(tanker.start, tanker.noisy, tanker.options);
  CHECK(fit.status == TrajectoryFitStatus::rank_deficient);
  REQUIRE(fit.undetermined.size() == 1);
  CHECK(fit.undetermined.front() == "|kt[2]|^1.00 not at all");
  CHECK(std::isinf(fit.parameters.back().estimate.standard_error));
  CHECK(fit.parameters.back().estimate.value == Approx(fit.parameters.back().before));
  for (std::size_t i = 0; i + 1 < fit.parameters.size(); ++i)
    CHECK(fit.parameters[i].estimate.verdict() != Verdict::not_determined);
}

TEST_CASE("priors decide where the runs tell little and hardly matter where they tell much",
          "[identification][limit]") {
  const Tanker tanker;
  auto options = tanker.options;
  options.priors = true;
  auto trusted = tanker.start;
  trusted.confidence = {.coefficients = 1e-6, .named = {}};
  const auto kept = fit_trajectories(trusted, tanker.noisy, options);
  CHECK(worst_error(kept, test::values_of(tanker.start, tanker.names)) < 1e-4);
  auto with_inflated_prior = tanker.start;
  with_inflated_prior.confidence = {.coefficients = 10.0, .named = {}};
  const auto free = fit_trajectories(tanker.start, tanker.noisy, tanker.options);
  CHECK(apart(free, fit_trajectories(with_inflated_prior, tanker.noisy, options)) < 0.05);
}

TEST_CASE("a number that would leave its range ends at the end of it", "[identification][limit]") {
  Tanker tanker;
  auto shallow = tanker.ship;
  std::get<MmgShip<double>>(shallow.model).propeller.C_1 = 0.0;
  auto runs = test::zigzags(shallow, {20.0, -20.0}, 15.0, 0.05);
  unsigned seed = 3;
  int at_bound = 0;
  for (int i = 0; i < 6; ++i) {
    auto noisy = runs;
    for (auto& run : noisy) test::add_noise(run, shallow, seed++);
    const auto fit =
        fit_trajectories(tanker.ship, noisy, {.parameters = {"N_v", "wake_C1"}, .channels = test::usual_channels});
    CHECK(fit.status == TrajectoryFitStatus::converged);
    CHECK(fit.parameters[1].estimate.value >= 0.0);
    at_bound += fit.parameters[1].at_bound;
  }
  CHECK(at_bound >= 1);
}

TEST_CASE("a robust fit forgives wild measurements", "[identification][limit]") {
  const Tanker tanker;
  auto runs = tanker.noisy;
  for (auto& run : runs)
    for (std::size_t i = 5; i < run.samples(); i += 17) run.fill(Channel::y)[i] += 0.2 * length(tanker.ship);
  auto options = tanker.options;
  const auto plain = fit_trajectories(tanker.start, runs, options);
  options.robust = 1.345;
  const auto robust = fit_trajectories(tanker.start, runs, options);
  CHECK(robust.status == TrajectoryFitStatus::converged);
  CHECK(*robust.noise[index_of(Channel::y)] < 0.3 * *plain.noise[index_of(Channel::y)]);
  for (std::size_t i = 0; i < tanker.truth.size(); ++i)
    CHECK(std::abs(robust.parameters[i].estimate.value - tanker.truth[i]) <
          4.0 * robust.parameters[i].estimate.standard_error);
  // without wild ones it is nearly the plain fit
  CHECK(apart(fit_trajectories(tanker.start, tanker.noisy, options),
              fit_trajectories(tanker.start, tanker.noisy, tanker.options)) < 1.0);
}

TEST_CASE("a fit that cannot be made is refused in one line", "[identification][refusal]") {
  const Tanker tanker;
  const auto& run = tanker.noisy.front();
  const auto with = [&](auto change) {
    auto options = tanker.options;
    change(options);
    return options;
  };
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, run, with([](auto& o) { o.parameters = {}; })),
                    Catch::Matchers::Contains("no number to fit"));
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, run, with([](auto& o) { o.parameters = {"N_w"}; })),
                    Catch::Matchers::Contains("her model has no number N_w"));
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, run, with([](auto& o) {
                                       o.parameters = {"N_v", "hull.N_v"};
                                     })),
                    Catch::Matchers::Contains("N_v is to be fitted twice"));
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, run, with([](auto& o) { o.channels = {Channel::u_ground}; })),
                    Catch::Matchers::Contains("none of the channels to fit to was recorded"));
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, std::span<const Recording>{}, tanker.options),
                    "no recording to fit to");
  CHECK_THROWS_AS(fit_trajectories(tanker.start, run, with([](auto& o) { o.segment = 0.0; })), std::domain_error);
  CHECK_THROWS_AS(fit_trajectories(tanker.start, run, with([](auto& o) { o.noise[index_of(Channel::psi)] = -1.0; })),
                  std::domain_error);
  auto no_rudder = run;
  for (const Channel c : {Channel::delta, Channel::delta_order}) no_rudder.channels[index_of(c)].clear();
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, no_rudder, tanker.options), "zigzag: no rudder angle");
  auto no_speed = run;
  for (const Channel c : {Channel::u, Channel::v, Channel::x, Channel::y}) no_speed.channels[index_of(c)].clear();
  CHECK_THROWS_WITH(fit_trajectories(tanker.start, no_speed, tanker.options),
                    Catch::Matchers::Contains("no channel tells the speed of the ship"));
}

}  // namespace swayaw
