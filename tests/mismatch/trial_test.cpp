#include "trial/trial.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <string_view>

#include "files.hpp"
#include "found_effects.hpp"
#include "missing_force/location.hpp"
#include "random_ships.hpp"
#include "search/significance.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"
#include "tank_instruments.hpp"

/// Fits of a ship's parameters and of effects, from inside.
namespace swayaw {
using namespace mismatch::detail;

namespace {

/// With parameters that are known to 2 %.
using test::well_known_ship;

/// Two zigzags and a turn with the white noise of a tank's instruments.
std::vector<Recording> runs_of(const Ship& ship, unsigned seed) {
  const ManoeuvreOptions sampled{.duration = 90.0, .step = 0.3};
  std::vector<Recording> runs{
      zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, sampled).run,
      zigzag(ship, {.rudder = radians(10), .heading = radians(10), .first = Side::port}, sampled).run,
      turning_circle(ship, {.rudder = radians(35), .side = Side::starboard}, sampled).run};
  std::mt19937_64 engine(seed);
  for (auto& run : runs) test::measure(run, engine);
  return runs;
}

/// A trial, its fitted baseline and the forms of all effects.
struct Fitted {
  std::vector<Recording> runs;
  Trial trial;
  MapFit null;
  std::vector<EffectForm> forms;

  Fitted(const Ship& ship, std::vector<Recording> recorded)
      : runs(std::move(recorded)),
        trial(trial_of(ship, runs, recorded_channels(runs, motion_channels()))),
        null(fit(trial, {}, trial.mean, Noise{})),
        forms(effect_forms(ship, recorded_channels(runs, motion_channels()), 90.0)) {}

  const EffectForm& form(std::string_view id) const { return *std::ranges::find(forms, id, &EffectForm::id); }
};

}  // namespace

TEST_CASE("each term of another form is moved by one coordinate, and by no other", "[mismatch][limit]") {
  const auto ship = well_known_ship();
  const auto runs = runs_of(ship, 5);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = as_on_board(trial_of(ship, runs, channels), runs, channels);
  const auto form = std::ranges::find(trial.ordinary, form_id, &EffectForm::id);
  REQUIRE(form != trial.ordinary.end());
  const auto size = form->coordinates.size();
  std::vector<int> moved(parameters_of(ship, form->at(std::vector<double>(size, 0.0))).size(), 0);
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<double> c(size, 0.0);
    c[i] = 1.0;
    const auto parameters = parameters_of(ship, form->at(c));
    for (std::size_t k = 0; k < parameters.size(); ++k) moved[k] += parameters[k].value != 0.0;
  }
  CHECK(std::ranges::all_of(moved, [](int times) { return times == 1; }));
  CHECK(size == moved.size());
}

// A baseline that took in a hidden effect as far as its prior let it is relieved by the effect itself: a predicted gain
// that forgets this sees nothing.
TEST_CASE("a screening promises what the converged fit gains", "[mismatch][second-route]") {
  const Ship ship = well_known_ship();
  for (const Effect& hidden :
       {Effect(RudderEffectiveness<double>{.factor = 0.7}), Effect(AddedResistance<double>{.relative_increase = 0.5}),
        Effect(RudderOffset<double>{.offset = radians(2)})}) {
    CAPTURE(id_of(hidden));
    const Fitted f(ship, runs_of(with_effect(ship, hidden), 3));
    const auto& form = f.form(id_of(hidden));
    const auto predicted = predicted_gain(f.trial, {}, linearized(f.trial, {}, f.null), form, form.starts.front());
    const Hypothesis hypothesis{&form};
    const auto converged = fit(f.trial, hypothesis, with_start(f.null.point, predicted.values), f.null.noise);
    const double gain = converged.log_evidence - f.null.log_evidence;
    CHECK(gain > 15.0);
    CHECK(predicted.gain > 0.2 * gain);  // beside the process noise that the baseline alone needs
  }
}

TEST_CASE("a fit that has converged stays where it is", "[mismatch][limit]") {
  const Ship ship = well_known_ship();
  for (const Effect& hidden :
       {Effect(RudderEffectiveness<double>{.factor = 0.7}), Effect(CrossFlowDrag<double>{.C_D = 0.5})}) {
    CAPTURE(id_of(hidden));
    const Fitted f(ship, runs_of(with_effect(ship, hidden), 5));
    const auto again = fit(f.trial, {}, f.null.point, f.null.noise);
    CHECK(std::abs(again.log_evidence - f.null.log_evidence) < 1.0);
    CHECK(again.noise == f.null.noise);
  }
}

TEST_CASE("an imperfection whose axes and memory are apart is never the less likely", "[mismatch][limit]") {
  const Ship ship = well_known_ship();
  const Fitted f(ship,
                 runs_of(with_effect(ship, AddedResistance<double>{.relative_increase = 1.0}), 7));  // surge alone
  const auto given = ship_at(f.trial, {}, f.trial.mean);
  const auto one = best_noise(problem_of(f.trial, given), {}, Noise{}, true);
  Noise start;
  start.apart = true;
  const auto apart = best_noise(problem_of(f.trial, given), {}, start, true);
  CHECK(one.noise.axes == Noise{}.axes);
  CHECK(apart.log_likelihood >= one.log_likelihood);
  CHECK(apart.noise.axes[0] > apart.noise.axes[1]);
  CHECK(apart.noise.axes[0] > apart.noise.axes[2]);
}

TEST_CASE("the time in which a force is missing in all runs is told, and only there", "[mismatch][limit]") {
  const auto ship = well_known_ship();
  const auto pushed = [&](double onset, double end) {
    auto other = ship;
    other.effects.push_back(UnknownForce<>{.N_0 = 1.5e-3, .onset = onset, .end = end});
    return other;
  };
  const auto common_in = [&](std::vector<Recording> runs) {
    const Fitted f(ship, std::move(runs));
    return located(f.trial, ship_at(f.trial, {}, f.null.point), f.null.noise).common;
  };
  constexpr double onset = 40.0, end = 60.0;
  const auto together = common_in(runs_of(pushed(onset, end), 11));
  REQUIRE(together.has_value());
  const double lengths = time_unit_of(ship);  // 6 s
  CHECK(std::abs(together->first - onset) < lengths);
  CHECK(std::abs(together->second - end) < lengths);
  CHECK_FALSE(common_in(runs_of(ship, 12)).has_value());
  auto apart = runs_of(pushed(onset, end), 13);  // each run at another time
  apart[1] = runs_of(pushed(5.0, 25.0), 14)[1];
  apart[2] = runs_of(pushed(65.0, 85.0), 15)[2];
  CHECK_FALSE(common_in(apart).has_value());
}

TEST_CASE("a rudder that has a gap of her own keeps it in the baseline", "[mismatch][limit]") {
  const Ship own = read_ship(test::ships / "wpcc_pi.toml"), none = well_known_ship();
  CHECK(ordinary_lift_loss(none));
  CHECK_FALSE(ordinary_lift_loss(own));
  const auto runs =
      std::vector{zigzag(own, {.rudder = radians(20), .heading = radians(20)}, {.duration = 60.0, .step = 0.3}).run};
  const auto trial = trial_of(own, runs, recorded_channels(runs, motion_channels()));
  const auto pick = [](const Ship& ship) { return std::get<PiShip<double>>(ship.model).rudder; };
  CHECK(pick(ship_at(trial, {}, trial.mean)).s == pick(own).s);
  // her own gap is no effect, no gap at all is one
  CHECK_FALSE(is_finding(own, RudderGap<double>{pick(own).delta_lim, pick(own).s}));
  CHECK(is_finding(own, RudderGap<double>{0.0, 0.0}));
  CHECK(is_finding(none, RudderGap<double>{0.1, -2.0}));
}

TEST_CASE("a baseline that is known less well keeps resistance and propeller, and added mass and rudder to a fifth",
          "[mismatch][law]") {
  for (const auto& name : {"kvlcc2_l7.toml", "wpcc_pi.toml", "mariner.toml"}) {
    const Ship ship = read_ship(test::ships / name);
    INFO(name);
    const std::vector<Recording> runs{
        turning_circle(ship, {.rudder = radians(5)}, {.duration = 10.0, .step = 0.5}).run};
    const auto trial = trial_of(ship, runs, recorded_channels(runs, motion_channels()));
    const auto wider = with_inflated_prior(trial, 9.0);
    std::set<std::string_view> kept;
    for (std::size_t i = 0; i < trial.parameters.size(); ++i) {
      const auto& p = trial.parameters[i];
      const auto k = static_cast<Eigen::Index>(i);
      INFO(p.name);
      const double factor = std::sqrt(trial.precision(k, k) / wider.precision(k, k));
      if (is_resistance(p) || p.table == "propeller") {
        CHECK_THAT(factor, WithinAbs(1.0, 1e-9));
        kept.insert(p.table);
      } else if (p.null != 0.0 && (p.table == "added_mass" || p.table == "rudder"))
        CHECK(p.deviation * factor <= std::max(0.2 * std::abs(p.null), p.deviation) * (1.0 + 1e-9));
      else CHECK_THAT(factor, WithinAbs(9.0, 1e-9));
    }
    CHECK(kept.contains("hull"));
  }
}

TEST_CASE("what another prior brings is what a fit beside it brings", "[mismatch][second-route]") {
  const Ship ship = well_known_ship();
  const Fitted f(ship, runs_of(with_effect(ship, AddedResistance<double>{.relative_increase = 0.2}), 9));
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(f.trial.baseline_size());
  factors.head(4).setConstant(0.7), factors.tail(3).setConstant(1.4);
  auto other = f.trial;
  other.precision = with_wider_prior(f.trial.precision, factors);
  const auto again = fit(other, {}, f.null.point, f.null.noise);
  REQUIRE(again.noise == f.null.noise);
  const double predicted = gain_by_prior(problem_of(f.trial, Hypothesis{}), f.null, other.precision);
  CHECK(std::abs(predicted) > 0.1);
  CHECK(std::abs(again.log_evidence - f.null.log_evidence - predicted) < 0.2 + 0.05 * std::abs(predicted));
}

TEST_CASE("what another prior brings leaves what stands at an end of its range there", "[mismatch][second-route]") {
  const Ship ship = well_known_ship();
  const Fitted f(ship, runs_of(with_effect(ship, AddedResistance<double>{.relative_increase = 0.2}), 9));
  auto problem = problem_of(f.trial, Hypothesis{});
  // the coefficient that moved farthest may go a quarter of that way
  Eigen::Index i = 0;
  const Eigen::VectorXd moved = f.null.point - problem.mean();
  moved.cwiseAbs().maxCoeff(&i);
  auto& unknown = problem.unknowns[static_cast<std::size_t>(i)];
  (moved[i] > 0.0 ? unknown.high : unknown.low) = unknown.mean + 0.25 * moved[i];
  const auto held = fit(problem, problem.within_bounds(f.null.point), f.null.noise, problem.size());
  REQUIRE((held.point[i] == unknown.low || held.point[i] == unknown.high));
  Eigen::VectorXd factors = Eigen::VectorXd::Constant(problem.size(), 1.4);
  const Eigen::MatrixXd wider = with_wider_prior(problem.precision, factors);
  const double predicted = gain_by_prior(problem, held, wider);
  problem.precision = wider;
  const auto again = fit(problem, held.point, held.noise, problem.size());
  REQUIRE(again.noise == held.noise);
  CHECK(std::abs(predicted) > 0.1);
  CHECK(std::abs(again.log_evidence - held.log_evidence - predicted) < 0.2 + 0.05 * std::abs(predicted));
}

TEST_CASE("sizes of noise with a memory are the likeliest", "[mismatch][limit]") {
  const Ship ship = well_known_ship();
  const Fitted f(ship, runs_of(ship, 13));
  const auto given = ship_at(f.trial, {}, f.trial.mean);
  const auto problem = problem_of(f.trial, given);
  const auto found = best_noise(problem, {}, Noise::on_board(), true);
  // with the prior of sizes: 1, a factor of 2 either way, for the process noise; 1e-3, a factor of e², for the walk
  const auto penalised = [&](const Noise& noise) {
    double sum = std::pow(std::log(noise.walk / 1e-3) / 2.0, 2);
    for (const double axis : noise.axes) sum += std::pow(std::log(noise.scale * axis) / std::log(2.0), 2);
    return log_likelihood(problem, {}, noise) - 0.5 * sum;
  };
  const double best = penalised(found.noise);
  for (double Noise::*size : {&Noise::walk, &Noise::scale})
    for (const double factor : {0.4, 2.5}) {
      auto other = found.noise;
      other.*size *= factor;
      CHECK(penalised(other) < best + 0.1);
    }
  CHECK(found.noise.walk < 1e-3);  // instruments of a tank: errors of positions have no memory
}

TEST_CASE("an effect that stands in the place of what is ordinary begins where that was", "[mismatch][limit]") {
  const Ship ship = well_known_ship();
  const auto runs = runs_of(ship, 15);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = as_on_board(trial_of(ship, runs, channels), runs, channels);
  Point point = Point::Constant(trial.baseline_size(), 0.7);
  int standing = 0;
  for (const auto& form : effect_forms(ship, channels, 90.0)) {
    const auto ordinary = in_whose_place(trial, form, point);
    if (!ordinary) continue;
    const auto there = coordinates_of(ship, form, *ordinary);
    if (!there) continue;
    INFO(form.id);
    const auto a = parameters_of(ship, *ordinary), b = parameters_of(ship, form.at(*there));
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::isfinite(a[i].value))
        CHECK(std::abs(a[i].value - b[i].value) < 1e-9 * std::max(1.0, std::abs(a[i].value)));
    CHECK(replaced_by(trial, form).size() == there->size());
    ++standing;
  }
  CHECK(standing >= 6);
}

TEST_CASE("a lag as small as an ordinary one is ordinary, unless it does what that cannot", "[mismatch][limit]") {
  const Ship ship = well_known_ship();
  const auto runs = runs_of(ship, 16);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = as_on_board(trial_of(ship, runs, channels), runs, channels);
  const auto forms = effect_forms(ship, channels, 90.0);
  const auto& lag = *std::ranges::find(forms, SteeringGearLag<>::id, &EffectForm::id);
  const double ordinary = ordinary_size(trial, lag);
  REQUIRE(ordinary > 0.0);
  const double one = std::get<SteeringGearLag<>>(lag.at(std::vector{1.0, 0.0})).lag;
  const auto deviations_of = [&](double size, double slowness) {
    return ordinary_deviations(trial, lag, std::vector{size / one, slowness});
  };
  CHECK(deviations_of(1.5 * ordinary, 0.0) == Approx(1.5));
  CHECK(deviations_of(4.0 * ordinary, 0.0) == Approx(4.0));
  CHECK(deviations_of(1.5 * ordinary, 2.0) == HUGE_VAL);
}

TEST_CASE(
    "what is smoothed is as late as a filter makes it before that is a finding, and a heading as late as is usual",
    "[mismatch][limit]") {
  const Ship ship = well_known_ship();
  const double time_unit = time_unit_of(ship);
  const auto runs = runs_of(ship, 17);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = as_on_board(trial_of(ship, runs, channels), runs, channels);
  const auto forms = effect_forms(ship, channels, 90.0);
  const auto is_ordinary = [&](Channel channel, double delay) {
    const auto form = std::ranges::find_if(forms, [&](const EffectForm& f) { return channel_of(f) == channel; });
    const auto at = coordinates_of(ship, *form, ChannelDelay<>{channel, delay});
    return is_as_ordinary(trial, *form, Eigen::Map<const Point>(at->data(), std::ssize(*at)), 0);
  };
  const double of_filter = std::min(2.0, 0.125 * time_unit), usual = 0.02 * time_unit;
  REQUIRE(of_filter > 2.5 * usual);
  const double of_receiver = 0.4;
  for (const auto& [smoothed, widest] :
       {std::pair{Channel::r, of_filter}, std::pair{Channel::u, std::max(of_filter, 2.5 * of_receiver)}}) {
    CAPTURE(widest);
    CHECK(is_ordinary(smoothed, 0.99 * widest));
    CHECK_FALSE(is_ordinary(smoothed, 1.01 * widest));
  }
  CHECK(is_ordinary(Channel::psi, 2.45 * usual));
  CHECK_FALSE(is_ordinary(Channel::psi, 2.55 * usual));
  CHECK(is_ordinary(Channel::psi, -2.95 * usual));  // a search goes no further that way
}

TEST_CASE("numbers of an effect change with its coordinates as their slopes say", "[mismatch][second-route]") {
  const Ship ship = well_known_ship();
  const std::vector<Channel> channels{Channel::psi};
  for (const auto& form : effect_forms(ship, channels, 90.0)) {
    CAPTURE(form.id);
    Point c(std::ssize(form.coordinates));
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      const auto& k = form.coordinates[static_cast<std::size_t>(i)];
      c[i] = std::clamp(k.centre + 0.3 * k.deviation, k.low, k.high);
    }
    const auto at = [&](const Point& p) { return parameters_of(ship, form.at({p.data(), form.coordinates.size()})); };
    const auto slopes = parameter_slopes(ship, form, c);
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      Point moved = c;
      moved[i] += 1e-6;
      const auto before = at(c), after = at(moved);
      for (std::size_t n = 0; n < before.size(); ++n) {
        const double slope = (after[n].value - before[n].value) / 1e-6;
        if (std::isfinite(slope))
          CHECK(slopes(static_cast<Eigen::Index>(n), i) ==
                Approx(slope).epsilon(1e-3).margin(1e-4 * std::abs(before[n].value) + 1e-6));
      }
    }
  }
}

TEST_CASE("speed and direction of a wind change with its parts as a point does on the plane, across south too",
          "[mismatch][second-route]") {
  Ship ship = well_known_ship();
  ship.surroundings.windage = *windage_from({.frontal = 1.0, .lateral = 4.0, .length = length(ship)});
  const std::vector<Channel> channels{Channel::psi};
  const auto forms = effect_forms(ship, channels, 90.0);
  const auto& wind = *std::ranges::find(forms, "steady_wind", &EffectForm::id);
  const double unit = parameters_of(ship, make_effect("steady_wind")).front().deviation;
  for (const double from : {0.0, 0.5 * pi, 2.0, -pi, pi}) {
    const double size = 0.7, n = std::cos(from), e = std::sin(from);
    const auto slopes = parameter_slopes(ship, wind, Eigen::Vector2d(size * n, size * e));
    CHECK(slopes(0, 0) == Approx(unit * n).margin(1e-6 * unit));
    CHECK(slopes(0, 1) == Approx(unit * e).margin(1e-6 * unit));
    CHECK(slopes(1, 0) == Approx(-e / size).margin(1e-6));
    CHECK(slopes(1, 1) == Approx(n / size).margin(1e-6));
  }
}

TEST_CASE("on board the loads of the wind are each known to a fifth, of a ship that has a windage",
          "[mismatch][limit]") {
  Ship bare = well_known_ship();
  bare.surroundings.windage = {};
  Ship ship = bare;
  ship.surroundings.windage = *windage_from({.frontal = 1.0, .lateral = 4.0, .length = length(ship)});
  const auto runs = runs_of(bare, 1);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = as_on_board(trial_of(ship, runs, channels), runs, channels);
  const auto of_bare = as_on_board(trial_of(bare, runs, channels), runs, channels);
  REQUIRE(trial.parameters.size() == of_bare.parameters.size() + 3);
  const auto first = std::ssize(of_bare.parameters);
  const ApparentWind<double> air{.u = -6.0, .v = -5.0};
  const auto load_at = [&](const Point& p) { return wind_force(ship_at(trial, {}, p).surroundings.windage, air); };
  const auto given = load_at(trial.mean);
  CHECK(given.Y == wind_force(ship.surroundings.windage, air).Y);
  const auto one_up = [&](Eigen::Index i) {
    Point p = trial.mean;
    p[first + i] += 1.0;
    return load_at(p);
  };
  CHECK_THAT(one_up(0).X, WithinRel(1.2 * given.X, 0.03));  // the cross force hangs on the ratio of both areas
  CHECK_THAT(one_up(1).Y, WithinRel(1.2 * given.Y, 0.03));
  CHECK_THAT(one_up(2).Y, WithinRel(given.Y, 1e-12));
  CHECK_THAT(one_up(2).N, WithinRel(1.2 * given.N, 1e-12));
}

TEST_CASE("an effect is told from nothing where its size is, whatever is known of the rest", "[mismatch][limit]") {
  Ship ship = well_known_ship();
  ship.surroundings.windage = *windage_from({.frontal = 1.0, .lateral = 4.0, .length = length(ship)});
  const std::vector<Channel> channels{Channel::psi};
  const auto forms = effect_forms(ship, channels, 90.0);
  const auto told = [&](std::string_view id, std::vector<double> point, std::vector<double> deviations) {
    const auto& form = *std::ranges::find(forms, id, &EffectForm::id);
    REQUIRE(form.coordinates.size() == point.size());
    const Eigen::VectorXd variances =
        Eigen::Map<const Eigen::VectorXd>(deviations.data(), std::ssize(deviations)).array().square();
    return is_told(ship, form,
                   {.point = Eigen::Map<const Eigen::VectorXd>(point.data(), std::ssize(point)),
                    .log_evidence = 0.0,
                    .noise = {},
                    .covariance = variances.asDiagonal()});
  };
  CHECK(told("gust", {0.5, 0.0, 4.0, 6.0}, {0.05, 0.05, 1.0, 1.0}));
  CHECK_FALSE(told("gust", {0.5, 0.0, 4.0, 6.0}, {0.5, 0.05, 0.001, 0.001}));
  CHECK(told("gust", {0.0, 0.5, 4.0, 6.0}, {0.5, 0.05, 1.0, 1.0}));  // across the wind nothing needs to be known
  CHECK(told("rudder_offset", {0.5}, {0.05}));
  CHECK_FALSE(told("rudder_offset", {0.5}, {0.5}));
}

}  // namespace swayaw
