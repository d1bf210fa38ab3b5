#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <random>

#include "found_effects.hpp"
#include "missing_force/budget.hpp"
#include "random_ships.hpp"
#include "search/search.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "tank_instruments.hpp"
#include "trial/trial.hpp"

/// Surroundings that differ from run to run, and what the missing force follows.
namespace swayaw {
using namespace mismatch::detail;

namespace {

using test::well_known_ship;

Recording turn(const Ship& ship, Side side, std::string_view name, std::string_view group, std::mt19937_64& engine) {
  const ManoeuvreOptions sampled{.duration = 120.0, .step = 0.3};
  auto run = turning_circle(ship, {.rudder = radians(25), .side = side}, sampled).run;
  run.name = name;
  if (!group.empty()) run.facts.remarks.push_back({"group", std::string(group)});
  test::measure(run, engine);
  return run;
}

/// Wind from there in each of four turns, two a day [m/s, rad].
struct WindOfRun {
  double speed, from;
};

std::vector<Recording> turns_in(const Ship& ship, const std::array<WindOfRun, 4>& winds, std::mt19937_64& engine) {
  std::vector<Recording> runs;
  for (std::size_t i = 0; i < winds.size(); ++i)
    runs.push_back(turn(with_effect(ship, SteadyWind<double>{winds[i].speed, winds[i].from}),
                        i % 2 ? Side::port : Side::starboard, "turn" + std::to_string(i), i < 2 ? "first" : "second",
                        engine));
  return runs;
}

const EffectForm& form_of(const std::vector<EffectForm>& forms, std::string_view id) {
  return *std::ranges::find(forms, id, &EffectForm::id);
}

/// The best fit of an effect from all its starts.
MapFit likeliest(const Trial& trial, const EffectForm& form, const MapFit& null) {
  MapFit best;
  for (const auto& start : form.starts)
    if (auto found = fit(trial, {&form}, with_start(null.point, start), null.noise);
        found.log_evidence > best.log_evidence)
      best = std::move(found);
  return best;
}

}  // namespace

TEST_CASE("a part of the runs has what all have in common and what is its own, and their mean is the mean of the parts",
          "[mismatch][property]") {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  const Ship ship = well_known_ship();
  const auto runs = turns_in(ship, {{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}, {1.0, 3.0}}}, engine);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = trial_of(ship, runs, channels);
  const auto forms = effect_forms(ship, channels, 120.0);
  const auto differing = differing_surroundings(forms, trial.runs);
  REQUIRE(differing.size() == 4);  // wind and stream, by group and by run
  for (const auto& form : differing) {
    INFO(form.id << " " << form.parts.size());
    CHECK(form.parts.size() == (form.scope == Scope::group ? 2 : 4));
    CHECK(form.coordinates.size() == 2 * (form.parts.size() + 1));
    Eigen::VectorXd c(std::ssize(form.coordinates));
    for (double& x : c) x = normal(engine);
    const std::span all{c.data(), form.coordinates.size()};
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(2);
    for (std::size_t part = 0; part < form.parts.size(); ++part) {
      const auto there = form.in_part(all, part);
      const Eigen::VectorXd by_map = part_map(form, part) * c;
      CHECK(std::ranges::equal(there, by_map));
      sum += by_map;
    }
    const auto mean = mean_of_parts(form, all);
    CHECK((Eigen::Map<const Eigen::VectorXd>(mean.data(), 2) - sum / std::ssize(form.parts)).norm() < 1e-12);
    CHECK(form.part_of(runs.front()) == 0);
    Recording other = runs.front();
    other.name = "another", other.facts.remarks = {{"group", "third"}};
    CHECK(form.part_of(other) == form.parts.size());
    CHECK(std::ranges::equal(form.in_part(all, form.part_of(other)), all.first(2)));
  }
}

TEST_CASE("a wind that differs from run to run is found in each of them", "[mismatch][second-route]") {
  std::mt19937_64 engine(11);
  const Ship ship = well_known_ship();
  const std::array<WindOfRun, 4> winds{{{4.0, 0.3}, {3.0, 2.0}, {5.0, -1.5}, {3.5, 1.0}}};
  const auto runs = turns_in(ship, winds, engine);
  const auto channels = recorded_channels(runs, motion_channels());
  const auto trial = trial_of(ship, runs, channels);
  const auto null = fit(trial, {}, trial.mean, Noise{});
  const auto forms = effect_forms(ship, channels, 120.0);
  const auto differing = differing_surroundings(forms, trial.runs);
  const auto& same = form_of(forms, "steady_wind");
  const auto by_run = std::ranges::find_if(
      differing, [](const EffectForm& f) { return f.id == "steady_wind" && f.scope == Scope::run; });
  const auto one = likeliest(trial, same, null), each = likeliest(trial, *by_run, null);
  CHECK(each.log_evidence > one.log_evidence + 20.0);
  const auto size = std::ssize(by_run->coordinates);
  for (std::size_t i = 0; i < winds.size(); ++i) {
    INFO(runs[i].name);
    const Eigen::MatrixXd part = part_map(*by_run, by_run->part_of(runs[i]));
    const Eigen::VectorXd c = part * each.point.tail(size);
    const auto effect = std::get<SteadyWind<double>>(by_run->at({c.data(), 2}));
    CHECK(std::abs(effect.speed - winds[i].speed) < 0.1 * winds[i].speed);
    CHECK(std::abs(wrapped(effect.from - winds[i].from)) < 0.1);
  }
  const auto ship_there = ship_at(trial, {&*by_run}, each.point, &runs[2]);
  CHECK(std::abs(wrapped(std::get<SteadyWind<double>>(ship_there.effects.back()).from - winds[2].from)) < 0.1);
}

TEST_CASE("every effect follows one thing", "[mismatch][property]") {
  CHECK(follows(SteadyWind<double>{}) == Follows::earth);
  CHECK(follows(SteadyCurrent<double>{}) == Follows::earth);
  CHECK(follows(WaveDrift<double>{}) == Follows::earth);
  CHECK(follows(HullNonlinearDamping<double>{}) == Follows::form);
  CHECK(follows(ModelForm<double>{}) == Follows::form);
  CHECK(follows(PropellerSideForce<double>{}) == Follows::side);
  CHECK(follows(RudderOffset<double>{}) == Follows::side);
  CHECK(follows(SteeringGearLag<double>{}) == Follows::past);
  CHECK(follows(RollCoupling<double>{}) == Follows::past);
  CHECK(follows(ChannelDelay<double>{Channel::delta, 0.0}) == Follows::past);
  CHECK(follows(ChannelDelay<double>{Channel::x, 0.0}) == Follows::instruments);
  CHECK(follows(GyroBias<double>{}) == Follows::instruments);
  CHECK(follows(UnknownForce<double>{}) == Follows::nothing);
}

TEST_CASE("the shares of the missing force add up to one, and most of it falls to what was left out",
          "[mismatch][second-route]") {
  std::mt19937_64 engine(3);
  const Ship ship = well_known_ship();
  struct Hidden {
    Effect effect;
    std::size_t axis;
  };
  for (const auto& [hidden, axis] :
       {Hidden{SteadyWind<double>{5.0, 0.7}, 1}, Hidden{RudderEffectiveness<double>{.factor = 0.7}, 2},
        Hidden{RudderOffset<double>{.offset = radians(3)}, 2}}) {
    INFO(id_of(hidden));
    const Ship true_ship = with_effect(ship, hidden);
    std::vector<Recording> runs{turn(true_ship, Side::port, "port", "", engine),
                                turn(true_ship, Side::starboard, "starboard", "", engine)};
    const auto channels = recorded_channels(runs, motion_channels());
    const auto trial = trial_of(ship, runs, channels);
    const auto forms = effect_forms(ship, channels, 120.0);
    const auto& form = form_of(forms, id_of(hidden));
    const auto null = fit(trial, {}, trial.mean, Noise{});
    const auto best = likeliest(trial, form, null);
    const auto budget = budget_of(trial, {&form}, best);
    REQUIRE(budget.size() == 3);
    for (const auto& b : budget) {
      double sum = 0.0;
      for (const double share : b.share) sum += share;
      CHECK(std::abs(sum - 1.0) < 1e-9);
      CHECK(b.size > 0.0);
    }
    const auto place = static_cast<std::size_t>(follows(hidden));
    CAPTURE(budget[axis].share, budget[axis].standard_error);
    CHECK(budget[axis].share[place] > 0.8);
    CHECK(budget[axis].share[static_cast<std::size_t>(Follows::nothing)] < 0.15);
  }
}

}  // namespace swayaw
