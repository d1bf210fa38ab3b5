#include <catch.hpp>
#include <map>

#include "recorded_trials.hpp"
#include "swayaw/identification/trial.hpp"

/// Whether the standard errors of judged trials hold: over simulated ships of every model, whose indices are known.
namespace swayaw {
namespace {

constexpr int ships_of_each_model = 40;

/// How often the truth lies within two standard errors.
class Coverage {
 public:
  void add(const std::string& name, const MaybeTold& told, const std::optional<double>& truth) {
    if (!truth) return;
    auto& count = counts_[name];
    ++count.all;
    if (!told) return;
    ++count.told;
    const double off = std::abs(told->value - *truth);
    count.inside += off <= 2.0 * told->standard_error;
  }

  struct Count {
    int all = 0, told = 0, inside = 0;
    double share() const { return static_cast<double>(inside) / told; }
  };
  int trials = 0;  ///< recorded

  const std::map<std::string, Count>& counts() const { return counts_; }

  Count total() const {
    Count sum;
    for (const auto& [name, c] : counts_) sum.all += c.all, sum.told += c.told, sum.inside += c.inside;
    return sum;
  }

 private:
  std::map<std::string, Count> counts_;
};

/// What the ship sails, or nothing where a wild seeded ship runs away.
template <class F>
auto sailed(F&& sail) -> std::optional<decltype(sail())> {
  try {
    return sail();
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

bool is_ordinary(const Zigzag& z) {
  return z.reversals.size() >= 4 && z.reversals.back().overshoot && test::is_zigzag(z.run);
}

bool is_ordinary(const TurningCircle& c, Side side, double U) {
  return c.steady && !c.way_lost && std::abs(c.run[Channel::psi].back()) > radians(530.0) && c.steady->u > 0.2 * U &&
         c.steady->r * yaw_sign(side) > 0.0;
}

void add_zigzag(Coverage& coverage, const Ship& ship, const ZigzagOrder& order, test::TrialInstruments wish,
                unsigned seed, bool said) {
  const double L = length(ship), U = service_speed(ship);
  const auto sailing = sailed([&] { return zigzag(ship, order, {.step = wish.step * L / U}); });
  if (!sailing || !is_ordinary(*sailing)) return;
  const auto& z = *sailing;
  auto run = test::as_trial(z.run, L, U, wish, seed);
  if (said) run.facts.manoeuvre = z.run.facts.manoeuvre;
  if (said) run.facts.execute = 100.0;
  const auto trial = judge_trial(run, {.L = L});
  ++coverage.trials;
  REQUIRE(trial.zigzag);
  REQUIRE_THAT(trial.manoeuvre.rudder, WithinAbs(order.rudder, 1e-9));
  REQUIRE_THAT(trial.manoeuvre.heading, WithinAbs(order.heading, 1e-9));
  const auto& told = *trial.zigzag;
  REQUIRE(told.first == order.first);
  REQUIRE_FALSE(trial.against_rudder);
  REQUIRE(told.reversals.size() >= 3);
  if (!said) coverage.add("execute", trial.approach.execute, 100.0);
  coverage.add("approach speed", trial.approach.speed, U);
  for (std::size_t k = 0; k < std::min<std::size_t>(told.reversals.size(), 3); ++k) {
    const auto& r = told.reversals[k];
    const auto& truth = z.reversals[k];
    coverage.add("overshoot", r.overshoot, truth.overshoot);
    coverage.add("switch", r.execute, truth.time + 100.0);
    coverage.add("rudder start", r.rudder_start, truth.time + 100.0);
    coverage.add("peak", r.peak_time, truth.peak_time ? std::optional(*truth.peak_time + 100.0) : std::nullopt);
  }
  if (told.reversals.size() == z.reversals.size()) coverage.add("period", told.period, z.period);
  coverage.add("zigzag way", told.initial_turning, z.initial_turning);
}

void add_turn(Coverage& coverage, const Ship& ship, const TurnOrder& order, test::TrialInstruments wish, unsigned seed,
              bool said, double longer_by) {
  const double L = length(ship), U = service_speed(ship);
  const auto sailing = sailed([&] { return turning_circle(ship, order, {.step = wish.step * L / U}); });
  if (!sailing || !is_ordinary(*sailing, order.side, U)) return;
  const auto& circle = *sailing;
  const auto further = sailed([&] {
    return turning_circle(ship, order, {.duration = longer_by * circle.run.time.back(), .step = wish.step * L / U});
  });
  if (!further) return;
  const auto& longer = *further;
  auto run = test::as_trial(longer.run, L, U, wish, seed);
  if (said) run.facts.manoeuvre = longer.run.facts.manoeuvre;
  if (said) run.facts.execute = 100.0;
  const auto trial = judge_trial(run, {.L = L});
  ++coverage.trials;
  REQUIRE(trial.turn);
  const auto& told = *trial.turn;
  REQUIRE(told.side == order.side);
  REQUIRE(told.corrected);
  coverage.add("advance", told.corrected->advance, circle.advance);
  coverage.add("transfer", told.corrected->transfer, circle.transfer);
  coverage.add("tactical diameter", told.corrected->tactical_diameter, circle.tactical_diameter);
  coverage.add("final diameter", told.corrected->final_diameter, circle.final_diameter);
  coverage.add("way to 10 deg", told.corrected->initial_turning, circle.initial_turning);
  coverage.add("time to 90 deg", told.time_90, circle.time_90);
  coverage.add("time to 180 deg", told.time_180, circle.time_180);
  coverage.add("current", told.drift->north, wish.north * U);
  coverage.add("current", told.drift->east, wish.east * U);
  coverage.add("final yaw rate", told.final_yaw_rate, circle.steady->r);
  coverage.add("final speed", told.final_speed, speed(*circle.steady));
  coverage.add("final drift angle", told.final_drift, drift_angle(*circle.steady));
}

/// @param smoothing  of headings and speeds by the instruments [L/U]
template <class Model>
void add_ships(Coverage& coverage, unsigned seed, double smoothing) {
  test::RandomModels random(seed);
  for (int n = 0; n < ships_of_each_model;) {
    const auto ship = test::trial_ship<Model>(random);
    if (!ship) continue;
    const auto before = coverage.total().all;
    const double angle = radians(random.uniform(0.0, 1.0) < 0.5 ? 10.0 : 20.0);
    const Side side = random.uniform(0.0, 1.0) < 0.5 ? Side::port : Side::starboard;
    const bool said = random.uniform(0.0, 1.0) < 0.5;
    auto wish = test::random_instruments(random);
    wish.smoothing = smoothing;
    add_zigzag(coverage, *ship, {angle, angle, side}, wish, seed + 1000U * static_cast<unsigned>(n), said);
    wish = test::random_instruments(random);
    wish.smoothing = smoothing;
    wish.north = random.uniform(-0.15, 0.15), wish.east = random.uniform(-0.15, 0.15);
    add_turn(coverage, *ship, {radians(35.0), side}, wish, seed + 1000U * static_cast<unsigned>(n) + 1U, said,
             random.uniform(1.03, 1.6));
    if (coverage.total().all > before) ++n;
  }
}

Coverage coverage_with(double smoothing) {
  Coverage coverage;
  add_ships<MmgShip<double>>(coverage, 11, smoothing);
  add_ships<PiShip<double>>(coverage, 12, smoothing);
  add_ships<PuShip<double>>(coverage, 13, smoothing);
  add_ships<AbkowitzShip<double>>(coverage, 14, smoothing);
  return coverage;
}

void require_honest(const Coverage& coverage) {
  for (const auto& [name, c] : coverage.counts()) {
    INFO(name << ": " << c.inside << " of " << c.told << " told, of " << c.all);
    CHECK(c.told == c.all);
    CHECK(c.share() >= 0.90);
  }
  CHECK(coverage.trials >= 200);
  CHECK(coverage.total().share() >= 0.90);
  CHECK(coverage.total().share() <= 0.99);
}

TEST_CASE("the true index lies within two standard errors in 90 to 99 of 100 trials",
          "[identification][second-route]") {
  require_honest(coverage_with(0.0));
}

TEST_CASE("it does where instruments smooth what they record", "[identification][second-route]") {
  for (const double smoothing : {0.01, 0.03}) {
    INFO("by a bell of " << smoothing << " L/U");
    require_honest(coverage_with(smoothing));
  }
}

}  // namespace
}  // namespace swayaw
