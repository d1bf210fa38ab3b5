#include "swayaw/mismatch/diagnose.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "symmetric_ship.hpp"
#include "tank_instruments.hpp"

/// What a ship hides from her model is named, with its size, wherever the runs come from.
namespace swayaw {
namespace {

using test::symmetric_ship;

/// White noise of a tank's instruments.
Recording measured(Recording run, std::string name, unsigned seed) {
  run.name = std::move(name);
  std::mt19937_64 engine(seed);
  test::measure(run, engine);
  return run;
}

const ManoeuvreOptions sampled{.duration = 110.0, .step = 0.3};

/// A zigzag and a turn; a further zigzag is held out.
std::vector<Recording> trials(const Ship& ship, unsigned seed = 1) {
  return {
      measured(zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, sampled).run, "zigzag.csv", seed),
      measured(turning_circle(ship, {.rudder = radians(30), .side = Side::port}, sampled).run, "turn.csv", seed + 1)};
}

std::vector<Recording> held_out(const Ship& ship, unsigned seed = 11) {
  return {measured(zigzag(ship, {.rudder = radians(15), .heading = radians(10), .first = Side::port}, sampled).run,
                   "unused.csv", seed)};
}

DiagnosisOptions quick() { return {.most_effects = 1, .confirmed = 4}; }

Diagnosis of(const Ship& ship, const Effect& hidden, unsigned seed = 1) {
  const auto real = with_effect(ship, hidden);
  return diagnose(ship, trials(real, seed), {}, held_out(real, seed + 10), quick());
}

void finds(const Diagnosis& d, const Effect& hidden) {
  INFO(id_of(hidden) << ": " << d.words);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == id_of(hidden));
  CHECK(d.verdict == DiagnosisVerdict::missing_physics);
  CHECK(d.effects.front().probability > 0.8);
}

/// Whether a number is a direction on the earth.
bool is_of_earth(std::string_view key) { return key.ends_with("from_rad") || key.ends_with("to_rad"); }

/// Value of a number less the truth, in standard errors.
double error_of(const Diagnosis& d, std::string_view key, double truth) {
  const auto& list = d.effects.front().parameters;
  const auto p = std::ranges::find(list, key, &ParameterEstimate::key);
  REQUIRE(p != list.end());
  const double error = is_of_earth(key) ? wrapped(p->value - truth) : p->value - truth;
  return error / p->standard_error;
}

TEST_CASE("an effect that is hidden is named, with its size", "[mismatch][round-trip]") {
  const Ship ship = symmetric_ship();
  SECTION("an offset of the rudder") {
    const auto d = of(ship, RudderOffset<double>{radians(1.5)});
    finds(d, RudderOffset<double>{});
    CHECK(std::abs(error_of(d, "offset_rad", radians(1.5))) < 3.5);
  }
  SECTION("a current") {
    const auto d = of(ship, SteadyCurrent<double>{0.1, 1.0});
    finds(d, SteadyCurrent<double>{});
    CHECK(std::abs(error_of(d, "current_speed_m_s", 0.1)) < 3.5);
    CHECK(std::abs(error_of(d, "current_to_rad", 1.0)) < 3.5);
  }
  SECTION("a log mounted askew") {
    const auto d = of(ship, VelocityAxes<double>{radians(-2.0)});
    finds(d, VelocityAxes<double>{});
    CHECK(std::abs(error_of(d, "angle_rad", radians(-2.0))) < 3.5);
  }
  SECTION("a zero error of the gyro") {
    const double bias = 0.05 * service_speed(ship) / length(ship);
    const auto d = of(ship, GyroBias<double>{bias});
    finds(d, GyroBias<double>{});
    CHECK(std::abs(error_of(d, "bias_rad_s", bias)) < 3.5);
    REQUIRE(d.instruments.size() == 1);
    CHECK(d.instruments.front().channel == "r");
    CHECK(d.instruments.front().error == "zero");
    CHECK(d.instruments.front().value == d.effects.front().parameters.front().value);
    CHECK(d.instruments.front().is_effect);
    CHECK(d.location.front().quantity == "yaw_rate");
  }
  SECTION("a rudder that stalls") {
    const auto d = of(ship, RudderStall<double>{.angle = 0.28, .depth = 0.5, .width = 0.04});
    finds(d, RudderStall<double>{});
    CHECK(std::abs(error_of(d, "stall_angle_rad", 0.28)) < 3.5);
  }
}

TEST_CASE("the improved ship predicts runs that were not used better than the refitted one",
          "[mismatch][second-route]") {
  const Ship ship = symmetric_ship();
  const auto d = of(ship, RudderStall<double>{.angle = 0.2, .depth = 0.6, .width = 0.04});
  const auto error = [&](const std::vector<QuantityError>& list, Quantity q) {
    return std::ranges::find(list, q, &QuantityError::quantity)->window_rms;
  };
  const auto& run = d.holdout.front();
  INFO(d.words);
  for (std::size_t i = 0; i < run.before.size(); ++i)
    UNSCOPED_INFO(name_of(run.before[i].quantity) << " " << run.before[i].window_rms << " "
                                                  << run.refitted[i].window_rms << " " << run.after[i].window_rms);
  CHECK(error(run.after, Quantity::heading) < 0.7 * error(run.refitted, Quantity::heading));
  CHECK(error(run.refitted, Quantity::heading) <= 1.01 * error(run.before, Quantity::heading));
}

TEST_CASE("nothing is missing in runs of the ship herself", "[mismatch][limit]") {
  const Ship ship = symmetric_ship();
  for (const unsigned seed : {21u, 22u, 23u}) {
    const auto d = diagnose(ship, trials(ship, seed), {}, held_out(ship, seed + 10), quick());
    INFO(d.words);
    CHECK(d.verdict == DiagnosisVerdict::nothing_missing);
    CHECK(d.effects.empty());
    // a rudder offset of half a degree would have been seen
    const auto offset = std::ranges::find(d.detectable, "rudder_offset", &DetectableSize::effect);
    REQUIRE(offset != d.detectable.end());
    CHECK(offset->value < radians(0.5));
    CHECK(offset->value > 0.0);
  }
}

TEST_CASE("numbers that are less well known than the ship file says are no missing physics", "[mismatch][limit]") {
  Ship ship = symmetric_ship();
  for (const unsigned seed : {31u, 32u, 33u}) {
    std::mt19937_64 engine(seed);
    std::normal_distribution normal;
    auto parameters = parameters_of(ship);
    std::erase_if(parameters, [](const Parameter& n) { return n.role != Role::coefficient || !(n.deviation > 0.0); });
    std::vector<double> values;
    for (const auto& n : parameters) values.push_back(n.value + 3.0 * n.deviation * normal(engine));
    const auto real = with_values(ship, parameters, values);
    const auto d = diagnose(ship, trials(real, seed), {}, held_out(real, seed + 10), quick());
    INFO(d.words);
    CHECK(d.verdict == DiagnosisVerdict::nothing_missing);
    CHECK((d.prior_inflation == 1.0 || d.words.find("less well") != std::string::npos));
  }
}

// At one shaft speed a side force of the propeller is the twin of a rudder offset, and noise decides which of both
// gains more; where the shaft is slowed they differ.
TEST_CASE("held-out runs tell twins apart that the runs used cannot", "[mismatch][second-route]") {
  const Ship ship = symmetric_ship();
  int misled = 0;
  for (const Effect& hidden :
       {Effect(RudderOffset<double>{radians(1.5)}), Effect(PropellerSideForce<double>{.share = 0.1})}) {
    const auto real = with_effect(ship, hidden);
    auto brief = sampled;
    brief.duration = 30.0;
    const auto gentle = zigzag(real, {.rudder = radians(5), .heading = radians(5)}, brief);
    auto slowed = sampled;
    slowed.rev = 0.3 * gentle.propulsion.rev;
    const auto other = zigzag(real, {.rudder = radians(5), .heading = radians(5)}, slowed);
    for (unsigned seed = 1; seed <= 6; ++seed) {
      CAPTURE(id_of(hidden), seed);
      const std::vector used{measured(gentle.run, "used.csv", seed)},
          unused{measured(other.run, "slowed.csv", 100 + seed)};
      const auto d = diagnose(ship, used, {}, unused, quick());
      finds(d, hidden);
      const auto gain = [&](std::string_view id) {
        return std::ranges::find(d.candidates, id, &Candidate::effect)->log_evidence_gain;
      };
      CHECK(std::abs(gain("rudder_offset") - gain("propeller_side_force")) < 10.0);
      const bool offset_leads = gain("rudder_offset") > gain("propeller_side_force");
      misled += offset_leads != std::holds_alternative<RudderOffset<double>>(hidden);
    }
  }
  CHECK(misled > 0);  // else it would have shown nothing
}

TEST_CASE("what held-out runs do not have is not a finding", "[mismatch][second-route]") {
  const Ship ship = symmetric_ship(), real = with_effect(ship, RudderOffset<double>{radians(1.5)});
  const auto d = diagnose(ship, trials(real), {}, held_out(ship), quick());
  CHECK(std::ranges::none_of(
      d.effects, [](const FoundEffect& e) { return std::holds_alternative<RudderOffset<double>>(e.effect); }));
}

// ---------------------------------------------------------------- where the runs come from

Recording turned(Recording run, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const auto x = run.fill(Channel::x), y = run.fill(Channel::y), psi = run.fill(Channel::psi);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double north = c * x[i] - s * y[i], east = s * x[i] + c * y[i];
    x[i] = north, y[i] = east, psi[i] += angle;
  }
  return run;
}

Recording mirrored(Recording run) {
  for (const auto channel : {Channel::y, Channel::psi, Channel::r, Channel::delta, Channel::v})
    if (run.has(channel))
      for (double& value : run.fill(channel)) value = -value;
  return run;
}

template <class F>
std::vector<Recording> each(std::vector<Recording> runs, F&& change) {
  for (auto& run : runs) run = change(std::move(run));
  return runs;
}

/// What is hidden in a ship, and how it must look where all headings are turned by an angle, and in the mirror.
struct Hidden {
  Effect effect;
  std::function<double(std::string_view key, double value, double angle)> turned;
  std::function<double(std::string_view key, double value)> mirrored;
};

void is_same_wherever_it_comes_from(const Ship& ship, const Hidden& hidden) {
  const auto real = with_effect(ship, hidden.effect);
  const auto runs = trials(real), unused = held_out(real);
  const auto d = diagnose(ship, runs, {}, unused, quick());
  finds(d, hidden.effect);
  const auto is_same = [&](const Diagnosis& other, auto&& seen) {
    finds(other, hidden.effect);
    CHECK(other.verdict == d.verdict);
    for (const auto& p : d.effects.front().parameters) {
      INFO(p.key);
      CHECK(std::abs(error_of(other, p.key, seen(p.key, p.value))) < 0.3);
    }
  };
  auto renamed = runs;
  std::swap(renamed[0].name, renamed[1].name);
  std::swap(renamed[0], renamed[1]);
  is_same(diagnose(ship, renamed, {}, unused, quick()), [](std::string_view, double value) { return value; });
  constexpr double angle = 2.1;
  const auto turn = [](Recording run) { return turned(std::move(run), angle); };
  is_same(diagnose(ship, each(runs, turn), {}, each(unused, turn), quick()),
          [&](std::string_view key, double value) { return hidden.turned(key, value, angle); });
  is_same(diagnose(ship, each(runs, mirrored), {}, each(unused, mirrored), quick()), hidden.mirrored);
}

TEST_CASE("names and order of the runs, the heading they were sailed on and a mirror do not change the answer",
          "[mismatch][symmetry]") {
  const Ship ship = symmetric_ship();
  const auto with_the_earth = [](std::string_view key, double value, double angle) {
    return is_of_earth(key) ? value + angle : value;
  };
  const auto to_the_other_side = [](std::string_view key, double value) { return is_of_earth(key) ? -value : value; };
  const auto stays = [](std::string_view, double value, double) { return value; };
  SECTION("a wind") {
    is_same_wherever_it_comes_from(
        ship, {SteadyWind<double>{1.2 * std::sqrt(0.1 * 9.81 * length(ship)), 0.9}, with_the_earth, to_the_other_side});
  }
  SECTION("a current") {
    is_same_wherever_it_comes_from(ship, {SteadyCurrent<double>{0.1, 1.0}, with_the_earth, to_the_other_side});
  }
  SECTION("an offset of the rudder") {
    is_same_wherever_it_comes_from(
        ship, {RudderOffset<double>{radians(1.5)}, stays, [](std::string_view, double value) { return -value; }});
  }
  SECTION("a rudder that stalls") {
    is_same_wherever_it_comes_from(ship, {RudderStall<double>{.angle = 0.28, .depth = 0.5, .width = 0.04}, stays,
                                          [](std::string_view, double value) { return value; }});
  }
}

// ---------------------------------------------------------------- what has no name, and when

// A force of the map alone, which no effect with a name explains.
TEST_CASE("a force without a name is said to be unknown, and its map predicts runs that were not used",
          "[mismatch][second-route]") {
  const Ship ship = symmetric_ship();
  UnknownForce<double> strange;
  strange.N_cos = 6e-4, strange.Y_cos = -3e-3;
  const auto real = with_effect(ship, strange);
  const auto d = diagnose(ship, trials(real), {}, held_out(real), quick());
  INFO(d.words);
  REQUIRE(d.verdict == DiagnosisVerdict::unexplained);
  const auto map = std::ranges::find_if(
      d.effects, [](const FoundEffect& e) { return std::holds_alternative<UnknownForce<double>>(e.effect); });
  REQUIRE(map != d.effects.end());
  const auto heading = [](const std::vector<QuantityError>& list) {
    return std::ranges::find(list, Quantity::heading, &QuantityError::quantity)->window_rms;
  };
  CHECK(heading(d.holdout.front().after) < 0.5 * heading(d.holdout.front().refitted));
}

TEST_CASE("a force that may be the wind is said to be one where the file tells no windage", "[mismatch][limit]") {
  const Ship ship = symmetric_ship();
  const auto real = with_effect(ship, SteadyWind<double>{3.0 * service_speed(ship), 0.7});
  const auto said = [&](const Ship& file) {
    const auto d = diagnose(file, trials(real), {}, held_out(real), quick());
    REQUIRE(!d.effects.empty());
    return d;
  };
  const auto is_one_of_two = [](const FoundEffect& e) {
    return std::ranges::count(e.indistinguishable_from, "steady_wind") == 1 && e.probability <= 0.5;
  };
  Ship blind = ship;
  blind.surroundings.windage = {};
  const auto untried = said(blind);
  CHECK(id_of(untried.effects.front().effect) == "wave_drift");
  CHECK(is_one_of_two(untried.effects.front()));
  CHECK(std::ranges::find(untried.candidates, "wave_drift", &Candidate::effect)->probability <= 0.5);
  CHECK_THAT(untried.words, ContainsSubstring("may be that of a wind, which was not tried"));
  const auto told = said(ship);
  CHECK(id_of(told.effects.front().effect) == "steady_wind");
  CHECK(!is_one_of_two(told.effects.front()));
  CHECK_THAT(told.words, !ContainsSubstring("not tried"));
}

TEST_CASE("a push that comes and goes is told by its time, and is no gust", "[mismatch][round-trip]") {
  const Ship ship = symmetric_ship();
  const auto real = with_effect(ship, UnknownForce<double>{.Y_0 = 1.5e-3, .N_0 = 4e-4, .onset = 40.0, .end = 75.0});
  const auto d = diagnose(ship, trials(real), {}, held_out(real), quick());
  INFO(d.words);
  CHECK(d.verdict == DiagnosisVerdict::unexplained);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == "unknown");
  CHECK(std::abs(error_of(d, "onset_s", 40.0)) < 3.5);
  CHECK(std::abs(error_of(d, "end_s", 75.0)) < 3.5);
  CHECK(std::abs(error_of(d, "Y_0", 1.5e-3)) < 3.5);
  CHECK_THAT(d.words, ContainsSubstring("a constant push to starboard"));
  CHECK_THAT(d.words, ContainsSubstring("lengths before midship"));
  CHECK(d.effects.front().onset.value() == std::get<UnknownForce<double>>(d.effects.front().effect).onset);
}

TEST_CASE("what drags at one side is told by its place, and is not more resistance", "[mismatch][round-trip]") {
  const Ship ship = symmetric_ship();
  const double y = 0.06 * length(ship);
  const auto real = with_effect(ship, UnknownForce<double>{.drag = 8e-4, .drag_y = y});
  const auto d = diagnose(ship, trials(real), {}, held_out(real), quick());
  INFO(d.words);
  CHECK(d.verdict == DiagnosisVerdict::unexplained);
  REQUIRE(d.effects.size() == 1);
  CHECK(id_of(d.effects.front().effect) == "unknown");
  CHECK(std::abs(error_of(d, "drag", 8e-4)) < 3.5);
  CHECK(std::abs(error_of(d, "drag_y_m", y)) < 3.5);
  CHECK_THAT(d.words, ContainsSubstring("as a drag that grows with the square of the speed"));
  CHECK_THAT(d.words,
             ContainsSubstring("m to starboard of the centreline: look for weed, a line or damage on that side"));
}

TEST_CASE("what acts like an effect and is larger than that can be has no name, and is not called small",
          "[mismatch][limit]") {
  const auto d = of(symmetric_ship(), ShaftSpeedDrop<double>{1.0});  // no engine loses more than 0.7
  INFO(d.words);
  CHECK(std::ranges::none_of(d.effects, [](const FoundEffect& e) { return id_of(e.effect) == ShaftSpeedDrop<>::id; }));
  const auto shaft = std::ranges::find(d.candidates, std::string(ShaftSpeedDrop<>::id), &Candidate::effect);
  REQUIRE(shaft != d.candidates.end());
  CHECK(shaft->log_evidence_gain > 15.0);
  CHECK(shaft->too_large);
  CHECK_FALSE(shaft->trace);
  CHECK(shaft->probability == 0.0);
  CHECK(d.too_large == std::vector{phrase_of(ShaftSpeedDrop<double>{})});
  CHECK_THAT(d.words, ContainsSubstring("acts like " + phrase_of(ShaftSpeedDrop<double>{})));
  CHECK_THAT(d.words, !ContainsSubstring("No physics is missing"));
}

TEST_CASE("an effect that begins during a run has an onset", "[mismatch][second-route]") {
  const Ship ship = symmetric_ship();
  const auto steady = zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, sampled).run;
  auto late = measured(steady, "zigzag.csv", 5);
  constexpr double begins = 60.0;
  const double bias = 0.06 * service_speed(ship) / length(ship);
  for (std::size_t i = 0; i < late.samples(); ++i)
    if (late.time[i] >= begins) late.fill(Channel::r)[i] += bias;
  const auto d = diagnose(ship, std::vector{late}, {}, {}, quick());
  finds(d, GyroBias<double>{});
  REQUIRE(d.effects.front().onset);
  CHECK(std::abs(*d.effects.front().onset - begins) < 0.5 * time_unit_of(ship));
  CHECK_FALSE(d.effects.front().end);
  const auto whole = of(ship, GyroBias<double>{bias});
  CHECK_FALSE(whole.effects.front().onset);
}

// ---------------------------------------------------------------- questions that have no answer

TEST_CASE("a diagnosis needs a run", "[mismatch][refusal]") {
  CHECK_THROWS_WITH(diagnose(symmetric_ship(), {}, {}, {}), ContainsSubstring("there is no run to diagnose"));
}

TEST_CASE("a diagnosis that is stopped tells what is known", "[mismatch][refusal]") {
  const Ship ship = symmetric_ship(), real = with_effect(ship, RudderOffset<double>{radians(1.5)});
  auto options = quick();
  options.progress = [](std::string_view what) { return what.find("trying") == std::string_view::npos; };
  const auto d = diagnose(ship, trials(real), {}, held_out(real), options);
  CHECK(d.holdout.size() == 1);
}

}  // namespace
}  // namespace swayaw
