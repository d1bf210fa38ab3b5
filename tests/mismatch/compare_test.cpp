#include "swayaw/mismatch/compare.hpp"

#include <catch.hpp>
#include <cmath>

#include "../nonlinear/random_effects.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

namespace swayaw {
namespace {

Recording zigzag_run(const Ship& ship) {
  auto run = zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.duration = 150.0, .step = 0.1}).run;
  run.name = "zz20.csv";
  return run;
}

const QuantityError& error_in(const Comparison& c, Quantity quantity) {
  for (const auto& e : c.errors)
    if (e.quantity == quantity) return e;
  throw std::runtime_error("not compared");
}

Ship with_rudder_force(Ship ship, double factor) {
  std::get<MmgShip<double>>(ship.model).rudder.f_alpha *= factor;
  return ship;
}

TEST_CASE("a simulation does not differ from itself", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto c = compare(ship, zigzag_run(ship));
  CHECK(c.errors.size() == all_quantities.size());
  for (const auto& e : c.errors) CHECK(e.normalised() < 0.01);
}

TEST_CASE("windows cover the run and each makes two ship lengths of way", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto c = compare(ship, zigzag_run(ship));
  REQUIRE(c.restarted.time == c.recorded.time);
  REQUIRE(c.window_starts.front() == 0);
  for (std::size_t k = 0; k + 2 < c.window_starts.size(); ++k) {
    double way = 0.0;
    for (std::size_t i = c.window_starts[k]; i < c.window_starts[k + 1]; ++i)
      way += std::hypot(c.recorded[Channel::x][i + 1] - c.recorded[Channel::x][i],
                        c.recorded[Channel::y][i + 1] - c.recorded[Channel::y][i]);
    CHECK_THAT(way, WithinRel(2.0 * length(ship), 0.03));
  }
}

TEST_CASE("a longer window shows a larger error", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run = zigzag_run(with_rudder_force(ship, 0.8));
  double previous = 0.0;
  for (const double lengths : {0.5, 1.0, 2.0, 4.0}) {
    const double error =
        error_in(compare(ship, run, {.window_lengths = lengths, .replay = {}}), Quantity::heading).window_rms;
    CHECK(error > previous);
    previous = error;
  }
}

TEST_CASE("a disturbance is located in time", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship);
  // between 60 and 80 s the recorded rudder is not what turned the ship
  for (std::size_t i = 0; i < run.samples(); ++i)
    if (run.time[i] > 60.0 && run.time[i] < 80.0) run.fill(Channel::delta)[i] += radians(8);
  const auto c = compare(ship, run);
  for (const auto quantity : {Quantity::heading, Quantity::yaw_rate, Quantity::drift}) {
    const auto& worst = error_in(c, quantity).worst;
    REQUIRE(worst.has_value());
    CHECK(worst->from > 60.0 - 25.0);
    CHECK(worst->from < 80.0);
    CHECK(worst->to > 60.0);
    CHECK(worst->to < 80.0 + 25.0);
    CHECK(worst->share > 0.9);
  }
}

TEST_CASE("a mismatch on one side is found on that side", "[mismatch][symmetry]") {
  const Ship ship = test::kvlcc2_l7();
  Ship truth = ship;
  auto& model = std::get<MmgShip<double>>(truth.model);
  model.rudder.gamma_R_positive *= 0.5;  // beta_R > 0: turning to starboard
  const auto c = compare(ship, zigzag_run(truth));
  const auto& region = error_in(c, Quantity::yaw_rate).region;
  REQUIRE(region.has_value());
  CHECK_THAT(words_for(*region), ContainsSubstring("starboard"));
}

TEST_CASE("heading errors are measured the short way round", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship);
  for (double& psi : run.fill(Channel::psi)) psi += 6.0 * pi;
  CHECK(error_in(compare(ship, run), Quantity::heading).normalised() < 0.01);
}

TEST_CASE("what was not recorded is not compared", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship);
  for (const Channel channel : {Channel::v, Channel::r}) run.channels[index_of(channel)].clear();
  const auto c = compare(ship, run);
  REQUIRE(c.errors.size() == 3);
  CHECK(c.errors[0].quantity == Quantity::heading);
  CHECK(c.errors[1].quantity == Quantity::speed);
  CHECK(c.errors[2].quantity == Quantity::position);
}

TEST_CASE("the noise of a channel is told from its third differences", "[mismatch][second-route]") {
  const auto run = read_recording(test::example_recordings / "weak_rudder_zz10_10.csv").recording;
  const auto c = compare(test::kvlcc2_l7(), run);
  CHECK_THAT(error_in(c, Quantity::yaw_rate).noise, WithinRel(radians(0.04), 0.1));
  CHECK_THAT(error_in(c, Quantity::heading).noise, WithinRel(radians(0.03), 0.1));
  CHECK_THAT(error_in(c, Quantity::speed).noise, WithinRel(0.003, 0.1));
}

TEST_CASE("the example recording shows the weak rudder that was hidden in it", "[mismatch][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run = read_recording(test::example_recordings / "weak_rudder_turn35.csv").recording;
  const auto given = compare(ship, run), mended = compare(with_rudder_force(ship, 0.82), run);
  // the simulated ship turns more to port than the recorded one
  CHECK(error_in(given, Quantity::yaw_rate).bias < 0.0);
  CHECK(error_in(mended, Quantity::yaw_rate).window_rms < 0.3 * error_in(given, Quantity::yaw_rate).window_rms);
}

TEST_CASE("regions are told in words", "[mismatch][limit]") {
  const auto words = [](Variable variable, std::optional<double> from, std::optional<double> to) {
    return words_for({.variable = variable, .from = from, .to = to, .samples = 1, .rms = 0, .bias = 0, .share = 0});
  };
  CHECK(words(Variable::rudder, radians(15), radians(25)) == "rudder 15 to 25 deg to port");
  CHECK(words(Variable::rudder, std::nullopt, radians(-25)) == "rudder beyond 25 deg to starboard");
  CHECK(words(Variable::drift, radians(-1.5), radians(1.5)) == "drift angle within 1.5 deg of zero");
  CHECK(words(Variable::yaw_rate, 0.6, std::nullopt) == "yaw rate r' beyond 0.6 to starboard");
  CHECK(words(Variable::yaw_rate, -0.25, -0.1) == "yaw rate r' 0.1 to 0.25 to port");
}

TEST_CASE("shares of the regions of one variable add up to one", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto c = compare(ship, zigzag_run(with_rudder_force(ship, 0.8)));
  for (const auto& e : c.errors) {
    double share[3] = {};
    for (const auto& region : e.regions) share[static_cast<int>(region.variable)] += region.share;
    for (const double s : share) CHECK_THAT(s, WithinAbs(1.0, 1e-9));
  }
}

TEST_CASE("one run pooled is that run, and twice the run is no worse", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto c = compare(ship, zigzag_run(with_rudder_force(ship, 0.8)));
  for (const auto& all : {pooled({c}), pooled({c, c})}) {
    REQUIRE(all.size() == c.errors.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      CHECK_THAT(all[i].window_rms, WithinRel(c.errors[i].window_rms, 1e-12));
      CHECK_THAT(all[i].bias, WithinAbs(c.errors[i].bias, 1e-12));
      CHECK_THAT(all[i].variation, WithinRel(c.errors[i].variation, 1e-12));
      REQUIRE(all[i].regions.size() == c.errors[i].regions.size());
      for (std::size_t k = 0; k < all[i].regions.size(); ++k)
        CHECK_THAT(all[i].regions[k].share, WithinAbs(c.errors[i].regions[k].share, 1e-9));
    }
  }
}

TEST_CASE("the true current makes a ship agree with her own recording, from log and track alone",
          "[mismatch][second-route][regression]") {
  // 2026-11-22: the start was taken over ground; with the true current the yaw rate was off by 33 %
  test::RandomShips random(16);
  for (int i = 0; i < 4; ++i) {
    const Ship calm{.name = "calm", .model = random.ship(), .confidence = {}, .surroundings = {}};
    const double U = service_speed(calm), time_unit = length(calm) / U;
    auto ship = calm;
    ship.effects.push_back(SteadyCurrent<>{.speed = random.uniform(0.1, 0.3) * U, .to = random.uniform(-pi, pi)});
    const auto simulated =
        zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.duration = 40 * time_unit}).run;
    Recording run = simulated;
    run.channels[index_of(Channel::speed_through_water)] = run.channels[index_of(Channel::u)];
    for (const auto channel : {Channel::u, Channel::v}) run.channels[index_of(channel)].clear();
    const auto with = compare(ship, run), without = compare(calm, run);
    INFO("ship " << i);
    for (const auto quantity : {Quantity::position, Quantity::heading, Quantity::yaw_rate}) {
      const auto &a = error_in(with, quantity), &b = error_in(without, quantity);
      CHECK(a.window_rms < 0.2 * b.window_rms);
      CHECK(a.open_loop_rms < 0.2 * b.open_loop_rms);
    }
    CHECK(error_in(with, Quantity::yaw_rate).normalised() < 0.01);
    CHECK(error_in(with, Quantity::yaw_rate).open_loop_normalised() < 0.01);
  }
}

/// An effect, and of one that is of a channel the same for others.
std::vector<Effect> of_several_channels(const Effect& effect) {
  return std::visit(
      []<class Kind>(const Kind& one) {
        std::vector<Effect> all{one};
        if constexpr (requires { one.channel; })
          for (const auto channel : {Channel::x, Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta}) {
            if (channel == one.channel) continue;
            auto other = one;
            other.channel = channel;
            all.emplace_back(other);
          }
        return all;
      },
      effect);
}

TEST_CASE("a ship with any effect agrees with her own recording in windows taken up anew", "[mismatch][round-trip]") {
  test::RandomModels models(31);
  test::RandomEffects effects(31);
  const Ship calm = test::with_areas(models.ship<MmgShip<double>>());
  const double time_unit = time_unit_of(calm);
  int tried = 0;
  for (const auto id : effect_ids()) {
    const auto drawn = effects.of_kind(id, calm);
    if (!drawn) continue;
    for (const auto& effect : of_several_channels(*drawn)) {
      Ship ship = calm;
      ship.effects.push_back(effect);
      const auto run = zigzag(ship, {.rudder = radians(20), .heading = radians(20)},
                              {.duration = 30 * time_unit, .step = 0.01 * time_unit})
                           .run;
      INFO(phrase_of(effect));
      ++tried;
      for (const auto& e : compare(ship, run).errors) {
        INFO(name_of(e.quantity));
        CHECK(e.normalised() < 2e-3);  // most are 4e-4, as without an effect
      }
    }
  }
  CHECK(tried > 40);
}

TEST_CASE("gaps of any channel or of all leave errors that are those without them", "[mismatch][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const double unit = time_unit_of(ship);
  const auto whole = zigzag_run(with_rudder_force(ship, 0.9));
  const auto without_gaps = compare(ship, whole);
  const std::vector<Channel> of_receiver{Channel::x, Channel::y}, of_log{Channel::u, Channel::v}, of_gyro{Channel::r},
      all{Channel::x, Channel::y, Channel::u, Channel::v, Channel::r, Channel::psi};
  for (const auto& channels : {of_receiver, of_log, of_gyro, all}) {
    auto run = whole;
    for (std::size_t i = 0; i < run.samples(); ++i)  // a length of way in each five
      if (std::fmod(run.time[i], 5.0 * unit) > 4.0 * unit)
        for (const auto channel : channels) run.channels[index_of(channel)][i] = missing;
    const auto c = compare(ship, run);
    REQUIRE(c.errors.size() == without_gaps.errors.size());
    for (std::size_t i = 0; i < c.errors.size(); ++i)
      CHECK_THAT(c.errors[i].window_rms, WithinRel(without_gaps.errors[i].window_rms, 0.25));
  }
}

TEST_CASE("senseless comparisons are refused in words", "[mismatch][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  Recording run;
  run.name = "short.csv";
  run.time = {0.0, 1.0};
  CHECK_THROWS_WITH(compare(ship, run), "short.csv: 2 samples are too few to compare");
  CHECK_THROWS_WITH(compare(ship, zigzag_run(ship), {.window_lengths = 0.0, .replay = {}}),
                    "window [ship lengths] must be positive, got 0");
  CHECK(verdict({}) == "The runs hold nothing to compare.");
}

}  // namespace
}  // namespace swayaw
