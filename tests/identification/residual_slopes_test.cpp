#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <optional>

#include "../nonlinear/random_effects.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "trajectory_recordings.hpp"

/// Slopes of the residuals of a fit, beside differences of the residuals themselves.
namespace swayaw {
namespace {

using Catch::Matchers::WithinAbs;

/// A seeded ship with effects on her and with instruments that err, as a function of her coefficients and of the
/// parameters of the effects, each in its deviation.
struct Neighbourhood {
  Ship ship;
  std::vector<Parameter> coefficients;
  struct OfEffect {
    std::size_t effect;
    Parameter parameter;
  };
  std::vector<OfEffect> of_effects{};

  Eigen::Index size() const { return std::ssize(coefficients) + std::ssize(of_effects); }

  std::string name(Eigen::Index i) const {
    const auto k = static_cast<std::size_t>(i);
    if (k < coefficients.size()) return coefficients[k].name;
    const auto& p = of_effects[k - coefficients.size()].parameter;
    return std::string(p.table) + "." + p.name;
  }

  Ship at(const Point& c) const {
    std::vector<double> values;
    for (const auto& p : coefficients) values.push_back(p.value + p.deviation * c[std::ssize(values)]);
    Ship result = with_values(ship, coefficients, values);
    Eigen::Index next = std::ssize(coefficients);
    for (const auto& [i, p] : of_effects)
      parameter_value(result.effects[i], p.index) = p.value + p.deviation * c[next++];
    return result;
  }

  EstimationProblem problem(std::span<const PreparedRun> runs) const {
    return {.unknowns = std::vector<Unknown>(static_cast<std::size_t>(size())),
            .precision = Eigen::MatrixXd::Identity(size(), size()),
            .runs = runs,
            .ship_in = [this](const Point& c, std::size_t) { return at(c); },
            .scale = ship};
  }
};

/// Of all places.
const std::vector kinds{SteadyWind<>::id,      Gust<>::id,         SteadyCurrent<>::id,   WaveDrift<>::id,
                        AddedResistance<>::id, AddedMass<>::id,    CrossFlowDrag<>::id,   RudderOffset<>::id,
                        SteeringGearLag<>::id, HeadingBias<>::id,  GyroBias<>::id,        GyroScale<>::id,
                        LogScale<>::id,        VelocityAxes<>::id, AntennaLeverArm<>::id, ModelForm<>::id};

/// With states of their own.
const std::vector hidden_kinds{RollCoupling<>::id, FluidMemory<>::id};

/// Effects of these kinds, and channels that are late.
std::vector<Effect> effects_on(const Ship& ship, std::span<const std::string_view> wanted, unsigned seed) {
  test::RandomEffects random(seed);
  std::vector<Effect> effects;
  for (const auto id : wanted)
    if (const auto effect = random.of_kind(id, ship)) effects.push_back(*effect);
  const double unit = time_unit_of(ship);
  for (const auto channel : {Channel::r, Channel::x, Channel::delta})
    effects.push_back(ChannelDelay<>{channel, random.uniform(0.02, 0.1) * unit});
  effects.push_back(ClockDrift<>{.channel = Channel::psi, .rate = random.uniform(1e-3, 3e-3)});
  effects.push_back(ChannelFilter<>{.channel = Channel::u, .time = random.uniform(0.02, 0.05) * unit});
  effects.push_back(ChannelFilter<>{.channel = Channel::r, .time = random.uniform(0.02, 0.05) * unit, .causal = 0.0});
  return effects;
}

Neighbourhood neighbourhood_of(Ship ship, std::span<const std::string_view> wanted, unsigned seed) {
  for (const auto& effect : effects_on(ship, wanted, seed)) ship.effects.push_back(effect);
  Neighbourhood result{.ship = ship, .coefficients = {}};
  for (const auto& p : parameters_of(ship))
    if (p.role == Role::coefficient && p.deviation > 0.0 && p.value != 0.0) result.coefficients.push_back(p);
  for (std::size_t i = 0; i < ship.effects.size(); ++i)
    if (!acting_time(ship.effects[i]))
      for (const auto& p : parameters_of(ship, ship.effects[i]))
        // the kinks of a rudder at its largest rate pass samples as the rate changes: residuals have kinks there too
        if (std::isfinite(p.deviation) && std::isfinite(p.value) && p.key != "rate_rad_s")
          result.of_effects.push_back({i, p});
  return result;
}

/// Differences of the residuals with the gains of a linearization, to the side of the sign of the step.
Eigen::MatrixXd differences(const EstimationProblem& problem, const LinearizedFit& fit, double step) {
  LinearizedFit none;
  none.passes = fit.passes, none.residuals = fit.residuals;
  const std::vector<double> here(fit.point.begin(), fit.point.end());
  return further_slopes(problem, none, here, step);
}

Eigen::MatrixXd central_differences(const EstimationProblem& problem, const LinearizedFit& fit, double step) {
  return 0.5 * (differences(problem, fit, step) + differences(problem, fit, -step));
}

enum class ShaftSpeed { recorded, untold };

/// Checks slopes beside differences, on recorded zigzags of seeded ships with such effects.
template <class Model>
void check_slopes(std::span<const std::string_view> wanted, std::span<const Channel> channels,
                  ShaftSpeed shaft = ShaftSpeed::recorded) {
  test::RandomModels models(29);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    auto [bare, runs] = test::steerable<Model>(models, {20.0, -10.0}, 15.0, 0.1, 1e-8);
    bare.surroundings.windage = test::with_areas(bare.model).surroundings.windage;
    const auto neighbourhood = neighbourhood_of(bare, wanted, seed);
    for (auto& run : runs) {
      run = replay_from(neighbourhood.ship, RecordedControls(neighbourhood.ship, run), recorded_state(bare, run, 0.0),
                        run.time);
      test::add_noise(run, bare, seed);
      if (shaft == ShaftSpeed::untold)
        for (const Channel channel : {Channel::rev, Channel::thrust}) run.channels[index_of(channel)].clear();
    }
    const auto prepared = prepared_runs(bare, runs, channels);
    REQUIRE(std::ranges::equal(prepared.front().channels, channels));
    const auto problem = neighbourhood.problem(prepared);
    const auto fit = linearized(problem, {.point = Point::Zero(problem.size()), .noise = Noise{}, .covariance = {}});
    const auto expected = central_differences(problem, fit, 1e-4);
    std::optional<Eigen::MatrixXd> nearer;
    CHECK(4 * (expected.colwise().norm().array() > 0.0).count() > 3 * problem.size());
    for (Eigen::Index i = 0; i < problem.size(); ++i) {
      INFO(neighbourhood.name(i) << ", seed " << seed);
      // 0 for what she has not, as the torque of an engine that is not limited; differences are rounded at 1e-7, and
      // those of a shaft speed that a coefficient tells are to one side
      const double relative = shaft == ShaftSpeed::recorded ? 1e-5 : 5e-4;
      const auto agree = [&](const Eigen::MatrixXd& by, double rounding) {
        return (fit.slopes.col(i) - by.col(i)).norm() <= relative * by.col(i).norm() + rounding;
      };
      // differences that reach over where a load has an edge, as of wind from abeam, are no slopes
      const bool agrees = agree(expected, 1e-6);
      if (!agrees && !nearer) nearer = central_differences(problem, fit, 1e-5);
      // beside an edge, as of a sample that is about to be an outlier, the difference to the other side is one
      const auto beside_edge = [&](double step) {
        const auto one_sided = differences(problem, fit, step);
        return (fit.slopes.col(i) - one_sided.col(i)).norm() <= 5e-5 * one_sided.col(i).norm() + 1e-5;
      };
      CHECK((agrees || agree(*nearer, 1e-5) || beside_edge(1e-5) || beside_edge(-1e-5)));
    }
  }
}

TEMPLATE_TEST_CASE("slopes of the residuals of a fit are the limit of their differences",
                   "[identification][second-route]", MmgShip<double>, PiShip<double>, PuShip<double>,
                   AbkowitzShip<double>) {
  check_slopes<TestType>(kinds, test::usual_channels);
}

TEMPLATE_TEST_CASE("so they are where she goes at the speed with which she starts", "[identification][second-route]",
                   MmgShip<double>, PuShip<double>, AbkowitzShip<double>) {
  check_slopes<TestType>(kinds, test::usual_channels, ShaftSpeed::untold);
}

TEST_CASE("so they are where effects have states of their own, as a heel that is recorded",
          "[identification][second-route]") {
  auto channels = test::usual_channels;
  channels.push_back(Channel::phi);
  check_slopes<MmgShip<double>>(hidden_kinds, channels);
  check_slopes<AbkowitzShip<double>>(hidden_kinds, test::usual_channels);  // without a beam she does not roll
}

// The same motion at another time: what channels share against the rudder is as likely put on it. Where samples stood
// at the recorded times, a fit put −0.3 s on five channels of the KVLCC2 models rather than 0.3 s on the rudder.
TEST_CASE("channels that are all as late as the rudder are as likely as channels that are not late",
          "[identification][symmetry]") {
  test::RandomModels models(31);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    auto [ship, runs] = test::steerable<MmgShip<double>>(models, {20.0, -10.0}, 15.0, 0.1, 1e-8);
    for (auto& run : runs) test::add_noise(run, ship, seed);
    const auto prepared = prepared_runs(ship, runs, test::usual_channels);
    const double interval = runs.front().time[1] - runs.front().time[0];
    const auto likelihood_by = [&ship = ship, &prepared](double delay) {
      auto late = ship;
      for (const auto channel : {Channel::x, Channel::psi, Channel::r, Channel::u, Channel::delta})
        late.effects.push_back(ChannelDelay<>{channel, delay});
      const EstimationProblem problem{.unknowns = {},
                                      .precision = {},
                                      .runs = prepared,
                                      .ship_in = [&late](const Point&, std::size_t) { return late; },
                                      .scale = ship};
      return log_likelihood(problem, Point(), Noise{});
    };
    const double exact = likelihood_by(0.0);  // but for the thrust, which is recorded as it is
    for (const double share : {-0.4, -0.1, 0.2, 0.45}) {
      CAPTURE(seed, share);
      CHECK_THAT(likelihood_by(share * interval), WithinAbs(exact, 1.0));
    }
  }
}

// The sum of squares of a simulated case jumped by a third where one channel was as late as another was early: their
// accelerations, and the samples they were seen from, went by whichever was further.
TEST_CASE("residuals have no jump and no edge where a channel becomes as late as another is early",
          "[identification][limit]") {
  test::RandomModels models(37);
  const auto [ship, runs] = test::steerable<MmgShip<double>>(models, {20.0, -10.0}, 15.0, 0.1, 1e-8);
  const double apart = 0.3 * (runs.front().time[1] - runs.front().time[0]);
  using Delays = std::vector<std::pair<Channel, double>>;
  const Delays odd{{Channel::psi, -apart}, {Channel::u, 0.0}, {Channel::x, 0.0}},
      even{{Channel::psi, -apart}, {Channel::u, -2.0 * apart}, {Channel::v, 2.0 * apart}};
  for (const auto& delays : {odd, even})
    for (const double place : {-apart, 0.0, apart}) {
      std::vector channels{Channel::r};
      for (const auto& [channel, _] : delays) channels.push_back(channel);
      if (std::ranges::count(channels, Channel::x) > 0) channels.push_back(Channel::y);
      const auto prepared = prepared_runs(ship, runs, channels);
      REQUIRE(prepared.front().channels.size() == channels.size());
      const EstimationProblem problem{.unknowns = std::vector<Unknown>(1),
                                      .precision = Eigen::MatrixXd::Identity(1, 1),
                                      .runs = prepared,
                                      .ship_in =
                                          [&, &ship = ship](const Point& c, std::size_t) {
                                            auto late = ship;
                                            for (const auto& [channel, delay] : delays)
                                              late.effects.push_back(ChannelDelay<>{channel, delay});
                                            late.effects.push_back(ChannelDelay<>{Channel::r, c[0]});
                                            return late;
                                          },
                                      .scale = ship};
      const double step = 1e-7 * apart;
      const Point before = Point::Constant(1, place - 0.5 * step);
      const auto fit = linearized(problem, {.point = before, .noise = Noise{}, .covariance = {}});
      LinearizedFit none;
      none.passes = fit.passes, none.residuals = fit.residuals;
      const Eigen::VectorXd moved = step * further_slopes(problem, none, std::vector{before[0]}, step);
      CAPTURE(channels.size(), place / apart);
      CHECK(moved.norm() < 1e-3);
      CHECK(moved.norm() > 0.0);
      // nor have they an edge there, at which a descent would stop: samples, and the times towards which the ship
      // accelerates, stay those of the pass
      const double wide = 1e-3 * apart;
      const Eigen::VectorXd after = further_slopes(problem, none, std::vector{place}, wide),
                            ahead = further_slopes(problem, none, std::vector{place - wide}, wide);
      CHECK((after - ahead).norm() < 0.01 * after.norm());
    }
}

}  // namespace
}  // namespace swayaw
