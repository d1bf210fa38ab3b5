#include <fmt/format.h>

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "froude_scaled.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "symmetric_ship.hpp"
#include "tank_instruments.hpp"

/// What `diagnose` answers does not hang on how a recording was written down: its name, its place among others, where
/// north, starboard and the origin are, the clock, the rate, the units.
namespace swayaw {
namespace {

// ---------------------------------------------------------------- questions, and the same put otherwise

struct Question {
  Ship ship;
  std::vector<Recording> runs, held_out;
  DiagnosisOptions options;
};

Diagnosis answer(const Question& q) { return diagnose(q.ship, q.runs, {}, q.held_out, q.options); }

template <class Change>
Question with_each(Question q, Change&& change) {
  for (auto* runs : {&q.runs, &q.held_out})
    for (auto& run : *runs) change(run);
  return q;
}

/// Changes every sample of those channels that were recorded.
template <class Change>
void change(Recording& run, std::initializer_list<Channel> channels, Change&& to) {
  for (const auto channel : channels)
    if (run.has(channel))
      for (double& value : run.fill(channel)) value = to(value);
}

Question renamed(const Question& q) {
  int number = 9;
  return with_each(q, [&](Recording& run) { run.name = fmt::format("Messung {}.csv", number--); });
}

Question in_another_order(Question q) {
  std::ranges::reverse(q.runs), std::ranges::reverse(q.held_out);
  return q;
}

/// North lies that angle further round.
Question turned(const Question& q, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return with_each(q, [&](Recording& run) {
    const auto x = run.fill(Channel::x), y = run.fill(Channel::y);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double north = c * x[i] - s * y[i], east = s * x[i] + c * y[i];
      x[i] = north, y[i] = east;
    }
    change(run, {Channel::psi}, [=](double psi) { return psi + angle; });
  });
}

Question mirrored(const Question& q) {
  return with_each(q, [](Recording& run) {
    change(run, {Channel::y, Channel::psi, Channel::r, Channel::delta}, std::negate{});
  });
}

/// The origin of the chart elsewhere [m].
Question moved(const Question& q, double north, double east) {
  return with_each(q, [=](Recording& run) {
    change(run, {Channel::x}, [=](double x) { return x + north; });
    change(run, {Channel::y}, [=](double y) { return y + east; });
  });
}

/// All clocks ahead by the same time [s].
Question later(const Question& q, double by) {
  return with_each(q, [=](Recording& run) {
    for (double& t : run.time) t += by;
    if (run.facts.execute) *run.facts.execute += by;
  });
}

/// Every n-th sample alone.
Question every(const Question& q, std::size_t n) {
  return with_each(q, [=](Recording& run) {
    const auto thin = [&](std::vector<double>& values) {
      std::vector<double> some;
      for (std::size_t i = 0; i < values.size(); i += n) some.push_back(values[i]);
      values = std::move(some);
    };
    thin(run.time);
    for (auto& values : run.channels) thin(values);
  });
}

Ship scaled(Ship ship, double n) {
  ship.model = test::froude_scaled(test::mmg(ship), n);
  ship.surroundings.windage = test::windage_of(length(ship));
  return ship;
}

/// A ship n times as long that did the same, by Froude.
Question scaled(const Question& q, double n) {
  const double root = std::sqrt(n);
  auto large = with_each(q, [=](Recording& run) {
    for (double& t : run.time) t *= root;
    change(run, {Channel::x, Channel::y}, [=](double x) { return n * x; });
    change(run, {Channel::u}, [=](double u) { return root * u; });
    change(run, {Channel::r, Channel::rev}, [=](double r) { return r / root; });
    if (run.facts.execute) *run.facts.execute *= root;
  });
  large.ship = scaled(q.ship, n);
  return large;
}

/// The files in degrees, knots and revolutions a minute, the rudder positive to starboard, headings from 0 to 360 deg.
Question in_units_of_the_bridge(const Question& q) {
  return with_each(q, [](Recording& run) {
    std::string text = "# rudder_positive = \"starboard\"\ntime_s,x_m,y_m,psi_deg,u_kn,r_deg_min,delta_deg,rev_rpm\n";
    const auto at = [&](Channel channel, std::size_t i) { return run[channel][i]; };
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const double psi = std::fmod(std::fmod(degrees(at(Channel::psi, i)), 360.0) + 360.0, 360.0);
      text += fmt::format("{},{},{},{},{},{},{},{}\n", run.time[i], at(Channel::x, i), at(Channel::y, i), psi,
                          at(Channel::u, i) * 3600.0 / 1852.0, degrees(at(Channel::r, i)) * 60.0,
                          -degrees(at(Channel::delta, i)), at(Channel::rev, i) * 60.0);
    }
    run = parse_recording(text, run.name).recording;
  });
}

// ---------------------------------------------------------------- the same answer

bool is_of_earth(std::string_view key) { return key.ends_with("from_rad") || key.ends_with("to_rad"); }
bool is_time(std::string_view key) { return key == "onset_s" || key == "end_s"; }

/// Whether a number changes its sign in the mirror.
bool is_of_a_side(std::string_view key) {
  return is_of_earth(key) || key.starts_with("offset") || key.starts_with("bias") || key == "Y_0" || key == "N_0";
}

using Seen = std::function<double(std::string_view key, double value)>;

double stays(std::string_view, double value) { return value; }

/// How far two answers may differ.
struct Allowed {
  double numbers;   ///< in standard errors
  double evidence;  ///< in log evidence, over what an effect gains
  double probability = 0.05;
};

constexpr Allowed rounding{.numbers = 0.01, .evidence = 1e-3, .probability = 1e-3};

void has_the_same_numbers(const FoundEffect& b, const FoundEffect& a, const Seen& seen, double allowed) {
  REQUIRE(b.parameters.size() == a.parameters.size());
  for (std::size_t k = 0; k < a.parameters.size(); ++k) {
    const auto &p = a.parameters[k], &q = b.parameters[k];
    CAPTURE(p.key, p.value, q.value, p.standard_error);
    REQUIRE(q.key == p.key);
    const double change = q.value - seen(p.key, p.value);
    CHECK(std::abs(is_of_earth(p.key) ? wrapped(change) : change) < allowed * q.standard_error);
  }
}

double gain_of(const Diagnosis& d, std::string_view id) {
  return std::ranges::find(d.candidates, id, &Candidate::effect)->log_evidence_gain;
}

/// @param evidence  whether as much was recorded, so that evidence compares
void is_same(const Diagnosis& b, const Diagnosis& a, const Seen& seen, const Allowed& allowed, bool evidence = true) {
  INFO(a.words << "\n" << b.words);
  CHECK(b.verdict == a.verdict);
  REQUIRE(b.effects.size() == a.effects.size());
  for (std::size_t i = 0; i < a.effects.size(); ++i) {
    INFO(id_of(a.effects[i].effect));
    REQUIRE(id_of(b.effects[i].effect) == id_of(a.effects[i].effect));
    has_the_same_numbers(b.effects[i], a.effects[i], seen, allowed.numbers);
    CHECK(b.effects[i].probability == Approx(a.effects[i].probability).margin(allowed.probability));
    CHECK(b.effects[i].onset.has_value() == a.effects[i].onset.has_value());
  }
  if (!evidence) return;
  const auto first = id_of(a.effects.front().effect);
  REQUIRE(b.candidates.front().effect == a.candidates.front().effect);
  CHECK(std::abs(gain_of(b, first) - gain_of(a, first)) < allowed.evidence * gain_of(a, first));
}

// ---------------------------------------------------------------- with the instruments of a tank

Recording in_the_tank(Recording run, std::string name, unsigned seed) {
  run.name = std::move(name);
  std::mt19937_64 engine(seed);
  test::measure(run, engine);
  return run;
}

/// A ship with two effects, recorded at twice the rate at which she is asked about.
Question recorded_in_the_tank(const Effect& a, const Effect& b) {
  const ManoeuvreOptions sampled{.duration = 90.0, .step = 0.15};
  const Ship ship = test::symmetric_ship(), real = with_effect(with_effect(ship, a), b);
  const auto run = [&](const ZigzagOrder& order) { return zigzag(real, order, sampled).run; };
  return {ship,
          {in_the_tank(run({.rudder = radians(20), .heading = radians(20)}), "zigzag.csv", 1),
           in_the_tank(turning_circle(real, {.rudder = radians(30), .side = Side::port}, sampled).run, "turn.csv", 2)},
          {in_the_tank(run({.rudder = radians(15), .heading = radians(10), .first = Side::port}), "unused.csv", 3)},
          {.most_effects = 2, .confirmed = 4}};
}

/// A question with its answer.
struct Asked {
  Question fine, question;  ///< at twice the rate, and at the rate
  Diagnosis answer;
};

Asked asked(Question fine) {
  auto q = every(fine, 2);
  auto d = answer(q);
  return {std::move(fine), std::move(q), std::move(d)};
}

const Asked& stream_and_offset() {
  static const Asked once =
      asked(recorded_in_the_tank(SteadyCurrent<double>{0.1, 1.0}, RudderOffset<double>{radians(1.5)}));
  return once;
}

const Asked& push_and_offset() {
  static const Asked once =
      asked(recorded_in_the_tank(UnknownForce<double>{.Y_0 = 1.5e-3, .N_0 = 4e-4, .onset = 40.0, .end = 70.0},
                                 RudderOffset<double>{radians(1.5)}));
  return once;
}

/// Names, order and origin are not physics: the same but for rounding.
TEST_CASE("names and order of the runs and the origin of their positions change nothing", "[mismatch][symmetry]") {
  const auto& [fine, q, d] = stream_and_offset();
  REQUIRE(d.effects.size() == 2);
  is_same(answer(renamed(q)), d, stays, rounding);
  const auto reversed = answer(in_another_order(q));
  is_same(reversed, d, stays, rounding);
  CHECK(reversed.symmetry == d.symmetry);
  is_same(answer(moved(q, 6e6, 4e5)), d, stays, rounding);  // as of UTM
}

TEST_CASE("the clock of the files may begin anywhere, before 0 or in the seconds since 1970", "[mismatch][symmetry]") {
  const auto& [fine, q, d] = push_and_offset();
  REQUIRE(d.effects.size() == 2);
  for (const double by : {1000.0, -1000.0, 1.7e9}) {
    CAPTURE(by);
    const auto there = answer(later(q, by));
    is_same(
        there, d, [=](std::string_view key, double value) { return is_time(key) ? value + by : value; }, rounding);
    REQUIRE(there.location.size() == d.location.size());
    for (std::size_t i = 0; i < d.location.size(); ++i)
      CHECK(there.location[i].from == Approx(d.location[i].from + by));
  }
}

// The noise of either coordinate is told from its own samples, which are others on another course.
TEST_CASE("a push is the same on any course", "[mismatch][symmetry]") {
  const auto& [fine, q, d] = push_and_offset();
  is_same(answer(turned(q, 2.1)), d, stays, {.numbers = 0.1, .evidence = 0.02});
}

TEST_CASE("in the mirror everything is on the other side", "[mismatch][symmetry]") {
  const auto other_side = [](std::string_view key, double value) { return is_of_a_side(key) ? -value : value; };
  for (const auto* asked : {&stream_and_offset(), &push_and_offset()})
    is_same(answer(mirrored(asked->question)), asked->answer, other_side, rounding);
}

TEST_CASE("half or twice the samples tell the same, less or more exactly", "[mismatch][limit]") {
  // probability follows evidence, which more samples change
  constexpr Allowed one{.numbers = 1.0, .evidence = HUGE_VAL, .probability = 1.0};
  for (const auto* asked : {&stream_and_offset(), &push_and_offset()}) {
    is_same(answer(asked->fine), asked->answer, stays, one, false);
    is_same(answer(every(asked->fine, 4)), asked->answer, stays, one, false);
  }
}

TEST_CASE("a ship of another size, by Froude, has the same answer", "[mismatch][symmetry]") {
  constexpr double n = 45.7;
  for (const auto* asked : {&stream_and_offset(), &push_and_offset()})
    is_same(
        answer(scaled(asked->question, n)), asked->answer,
        [](std::string_view key, double value) {
          return key.ends_with("_s") ? value * std::sqrt(n) : value;  // times and speeds alike
        },
        rounding);
}

// No wind: the density of the air stays.
TEST_CASE("in salt water the answer is that in fresh water", "[mismatch][symmetry]") {
  auto fresh = stream_and_offset().question;
  fresh.ship.surroundings.windage = {};
  auto salt = fresh;
  std::get<MmgShip<double>>(salt.ship.model).water.rho *= 1.025;
  is_same(answer(salt), answer(fresh), stays, rounding);
}

TEST_CASE("degrees, knots and revolutions a minute are radians, metres and seconds", "[mismatch][round-trip]") {
  const auto& [fine, q, d] = stream_and_offset();
  is_same(answer(in_units_of_the_bridge(q)), d, stays, rounding);
  const auto in_si = [](Recording& run) { run = parse_recording(recording_text(run), run.name).recording; };
  is_same(answer(with_each(q, in_si)), d, stays, rounding);
}

// A rudder offset and a side force of the propeller are twins at one shaft speed.
TEST_CASE("what to sail next does not hang on which run comes first", "[mismatch][symmetry]") {
  const Ship ship = test::symmetric_ship(), real = with_effect(ship, RudderOffset<double>{radians(1.5)});
  const ManoeuvreOptions brief{.duration = 30.0, .step = 0.3};
  const auto gentle = zigzag(real, {.rudder = radians(5), .heading = radians(5)}, brief).run;
  Question q{ship,
             {in_the_tank(gentle, "one.csv", 1), in_the_tank(gentle, "two.csv", 2)},
             {},
             {.most_effects = 1, .confirmed = 4}};
  q.runs[1].channels[index_of(Channel::r)].clear();
  const auto d = answer(q), reversed = answer(in_another_order(q));
  REQUIRE(d.next);
  REQUIRE(reversed.next);
  CHECK(reversed.next->advice == d.next->advice);
}

// ---------------------------------------------------------------- with the instruments of a ship

void shake(Recording& run, Channel channel, double size, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  for (double& x : run.fill(channel)) x += size * normal(engine);
}

/// An error that wanders by so much from sample to sample.
void wander(Recording& run, Channel channel, double step, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  double error = 0.0;
  for (double& x : run.fill(channel)) error += step * normal(engine), x += error;
}

/// As a ship of 320 m has them: the error of a position has a memory; no sway, no thrust.
Recording on_board(const Ship& ship, Recording run, std::string name, unsigned seed) {
  constexpr double walk = 3e-3;  // of L in L/U
  const double L = length(ship), time_unit = L / service_speed(ship), h = run.time[1] - run.time[0];
  run.name = std::move(name);
  std::mt19937_64 engine(seed);
  for (const auto channel : {Channel::x, Channel::y})
    wander(run, channel, walk * L * std::sqrt(h / time_unit), engine), shake(run, channel, 0.3, engine);
  shake(run, Channel::psi, radians(0.1), engine);
  shake(run, Channel::r, 1e-4, engine);
  shake(run, Channel::u, 0.05, engine);
  for (const auto channel : {Channel::v, Channel::thrust}) run.channels[index_of(channel)].clear();
  return run;
}

/// A ship of another form than her file's, in a stream, her gyro off.
const Asked& ship_on_board() {
  static const Asked once = [] {
    const Ship ship = scaled(test::symmetric_ship(), 45.7);
    Ship real = with_effect(ship, SteadyCurrent<double>{0.8, 1.0});
    real = with_effect(real, GyroBias<double>{-0.003});
    real = with_effect(real, ModelForm<double>{.Y_vr = 4e-3, .Y_rv = -4e-3, .N_v = -2e-3, .N_rr = -8e-4});
    const ManoeuvreOptions sampled{.duration = 480.0, .step = 0.5};
    const auto a = zigzag(real, {.rudder = radians(20), .heading = radians(20)}, sampled).run,
               b = turning_circle(real, {.rudder = radians(30), .side = Side::port}, sampled).run;
    return asked({ship,
                  {on_board(ship, a, "zigzag.csv", 1), on_board(ship, b, "turn.csv", 2)},
                  {},
                  {.most_effects = 2, .confirmed = 2}});
  }();
  return once;
}

// Sizes of noise are climbed to, and end within 5e-3 of log likelihood: what is rounding in a tank is a little more.
constexpr Allowed climbed{.numbers = 0.05, .evidence = 0.01};

TEST_CASE("on board names, order, origin and clock change nothing", "[mismatch][symmetry]") {
  const auto& [fine, q, d] = ship_on_board();
  REQUIRE(d.effects.size() == 2);
  const auto gyro =
      std::ranges::find(d.effects, "bias_rad_s", [](const FoundEffect& e) { return e.parameters.front().key; });
  REQUIRE(gyro != d.effects.end());
  // the ordinary error of a gyro is in it, which none in a tank has
  CHECK(gyro->parameters.front().standard_error > 2.9e-4);
  is_same(answer(in_another_order(renamed(q))), d, stays, climbed);
  is_same(answer(later(moved(q, 6e6, 4e5), -1000.0)), d, stays, climbed);
}

TEST_CASE("on board everything is on the other side in the mirror", "[mismatch][symmetry]") {
  const auto& [fine, q, d] = ship_on_board();
  is_same(
      answer(mirrored(q)), d, [](std::string_view key, double value) { return is_of_a_side(key) ? -value : value; },
      climbed);
}

TEST_CASE("on board what is fixed to the earth turns with it, and nothing else", "[mismatch][symmetry]") {
  const auto& [fine, q, d] = ship_on_board();
  constexpr double angle = 2.1;
  is_same(answer(turned(q, angle)), d,
          [](std::string_view key, double value) { return is_of_earth(key) ? value + angle : value; },
          {.numbers = 0.1, .evidence = 0.02});
}

TEST_CASE("on board twice the samples tell the same", "[mismatch][limit]") {
  constexpr Allowed one{.numbers = 1.0, .evidence = HUGE_VAL, .probability = 0.1};
  const auto& [fine, q, d] = ship_on_board();
  is_same(answer(fine), d, stays, one, false);
}

}  // namespace
}  // namespace swayaw
