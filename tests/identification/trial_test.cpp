#include "swayaw/identification/trial.hpp"

#include <catch.hpp>
#include <iostream>

#include "files.hpp"
#include "json.hpp"
#include "linear_recordings.hpp"
#include "recorded_trials.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/linear_recording.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"
#include "swayaw/nonlinear/manoeuvres/spiral.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"

namespace swayaw {
namespace {

using test::ship_time;

Ship tanker() { return read_ship(test::ships / "kvlcc2_l7.toml"); }

Recording tanker_zigzag() { return zigzag(tanker(), {radians(10.0), radians(10.0)}, {.step = 0.2}).run; }

Recording reversed(Recording run, Channel channel) {
  for (double& x : run.fill(channel)) x = -x;
  return run;
}

// ---------------------------------------------------------------- K and T

TEST_CASE("K and T of a first-order ship come back, positive, from her zigzag", "[identification][round-trip]") {
  test::RandomLinearShips random(81);
  for (int k = 0; k < 30; ++k) {
    const double K = random.uniform(-3.0, -0.8), T = random.uniform(0.5, 4.0);
    const auto run = test::recorded(first_order_ship(K, T), {.lengths = 60.0, .rudder_offset = 0.01});
    const auto trial = judge_trial(run, {.L = test::ship_length});
    REQUIRE(trial.steering.least_squares);
    REQUIRE(trial.steering.worked);
    const auto& fit = *trial.steering.least_squares;
    INFO("K' " << K << " T' " << T);
    CHECK_THAT(fit.K.value * ship_time, WithinRel(-K, 1e-6));
    CHECK_THAT(fit.T.value / ship_time, WithinRel(T, 1e-6));
    CHECK_THAT(fit.offset.value, WithinAbs(-0.01, 1e-7));
    CHECK_THAT(trial.steering.worked->K.value, WithinRel(fit.K.value, 1e-5));
    CHECK_THAT(trial.steering.worked->T.value, WithinRel(fit.T.value, 1e-5));
    CHECK_THAT(*trial.steering.P_of_fit, WithinRel(-K * (1.0 - T + T * std::exp(-1.0 / T)), 1e-6));
    CHECK_FALSE(trial.against_rudder);
  }
}

TEST_CASE("K and T of noisy headings lie within their standard errors", "[identification][second-route]") {
  test::RandomLinearShips random(82);
  int inside_K = 0, inside_T = 0;
  constexpr int runs = 100;
  for (int k = 0; k < runs; ++k) {
    const double K = random.uniform(-2.5, -0.8), T = random.uniform(0.5, 3.0);
    const auto trial =
        judge_trial(test::recorded(first_order_ship(K, T),
                                   {.lengths = 40.0, .noise = 2e-3, .seed = 500U + static_cast<unsigned>(k)}),
                    {.L = test::ship_length});
    REQUIRE(trial.steering.least_squares);
    const auto& fit = *trial.steering.least_squares;
    inside_K += std::abs(fit.K.value * ship_time + K) <= 2.0 * fit.K.standard_error * ship_time;
    inside_T += std::abs(fit.T.value / ship_time - T) <= 2.0 * fit.T.standard_error / ship_time;
  }
  CHECK(inside_K >= 88);
  CHECK(inside_T >= 88);
}

TEST_CASE("an exact linear second-order zigzag tells T3, or says that it cannot", "[identification][round-trip]") {
  const auto ship = coefficients_from(SteeringIndices<double>{1.2, 4.3, 0.15, 0.9, -1.8, -2.5});
  const auto trial =
      judge_trial(test::recorded(ship, {.lengths = 40.0, .noise = 2e-4, .drift = false}), {.L = test::ship_length});
  REQUIRE(trial.steering.second);
  const auto& second = *trial.steering.second;
  CHECK(std::abs(second.T3.value / ship_time - 0.9) < 4.0 * second.T3.standard_error / ship_time);
  CHECK(std::abs(second.K.value * ship_time - 2.5) < 4.0 * second.K.standard_error * ship_time);
  CHECK(second.T3_told == (std::abs(second.T3.value) > 2.0 * second.T3.standard_error));
}

// ---------------------------------------------------------------- signs

TEST_CASE("a wrong sign of the rudder leaves the overshoots, turns K and is said", "[identification][symmetry]") {
  const auto run = tanker_zigzag();
  const auto right = judge_trial(run, {.L = 7.0}), wrong = judge_trial(reversed(run, Channel::delta), {.L = 7.0});
  REQUIRE(right.zigzag->reversals.size() == wrong.zigzag->reversals.size());
  for (std::size_t k = 0; k < right.zigzag->reversals.size(); ++k) {
    CHECK(right.zigzag->reversals[k].overshoot->value == wrong.zigzag->reversals[k].overshoot->value);
    CHECK(right.zigzag->reversals[k].side == wrong.zigzag->reversals[k].side);
  }
  CHECK_FALSE(right.against_rudder);
  CHECK(wrong.against_rudder);
  CHECK(right.steering.least_squares->K.value > 0.0);
  CHECK_THAT(wrong.steering.least_squares->K.value, WithinRel(-right.steering.least_squares->K.value, 1e-6));
  CHECK_THAT(wrong.notes.front(), ContainsSubstring("rudder_positive = \"starboard\""));
  const auto turn = turning_circle(tanker(), {radians(35.0)}, {.step = 0.2}).run;
  CHECK_FALSE(judge_trial(turn, {.L = 7.0}).against_rudder);
  CHECK(judge_trial(reversed(turn, Channel::delta), {.L = 7.0}).against_rudder);
}

/// A zigzag 10/10 of so many reversals, after which the helmsman brings her back to her course with another rudder.
Recording zigzag_and_back(Side first, std::size_t reversals, double back) {
  const auto ship = tanker();
  const double dt = 0.1, degree = radians(1.0);
  Simulator sim(ship);
  Recording run;
  run.facts.execute = 6.0;
  std::vector<double> heading, rudder;
  double side = yaw_sign(first);
  std::size_t reversed = 0;
  bool home = false;
  while (sim.time() < 400.0) {
    const auto& state = sim.state();
    if (!home && sim.time() >= *run.facts.execute && side * state.psi >= 10.0 * degree) {
      if (reversed < reversals) ++reversed, side = -side;
      else if (sim.state().motion.r * side > 0.0) home = true, side = -side;
    }
    if (sim.time() >= *run.facts.execute) sim.order_rudder(-side * (home ? back : 10.0) * degree);
    if (home && std::abs(state.psi) < 3.0 * degree) sim.order_rudder(0.0), side = 0.0;
    run.time.push_back(sim.time()), heading.push_back(state.psi), rudder.push_back(sim.rudder());
    sim.step(dt);
  }
  std::ranges::copy(heading, run.fill(Channel::psi).begin());
  std::ranges::copy(rudder, run.fill(Channel::delta).begin());
  return run;
}

TEST_CASE("a zigzag is read alike whatever rudder brings the ship back to her course",
          "[identification][second-route]") {
  for (const Side first : {Side::port, Side::starboard})
    for (const std::string said : {"zigzag 10/10", ""}) {
      const auto exact = zigzag(tanker(), {radians(10.0), radians(10.0), first});
      for (const double back : {10.0, 20.0, 35.0}) {
        INFO(name_of(first) << ", back with " << back << " deg, said \"" << said << '"');
        auto run = zigzag_and_back(first, 2, back);
        run.facts.manoeuvre = said;
        const auto trial = judge_trial(run, {.L = 7.0});
        REQUIRE(trial.zigzag);
        CHECK(trial.zigzag->first == first);
        REQUIRE(trial.zigzag->reversals.size() >= 2);
        for (std::size_t k = 0; k < 2; ++k) {
          REQUIRE(trial.zigzag->reversals[k].overshoot);
          CHECK_THAT(degrees(trial.zigzag->reversals[k].overshoot->value),
                     WithinAbs(degrees(*exact.reversals[k].overshoot), 0.4));  // he reverses up to 0.1 s late
        }
      }
    }
}

TEST_CASE("the mirrored run has the same indices to the other side", "[identification][symmetry]") {
  auto run = turning_circle(tanker(), {radians(35.0)}, {.duration = 250.0, .step = 0.5}).run;
  const auto here = judge_trial(run, {.L = 7.0});
  for (const Channel channel : {Channel::y, Channel::psi, Channel::v, Channel::r, Channel::delta})
    run = reversed(std::move(run), channel);
  const auto there = judge_trial(run, {.L = 7.0});
  CHECK(here.turn->side == Side::starboard);
  CHECK(there.turn->side == Side::port);
  CHECK_THAT(there.turn->recorded.tactical_diameter->value,
             WithinRel(here.turn->recorded.tactical_diameter->value, 1e-9));
  CHECK_THAT(there.turn->final_yaw_rate->value, WithinRel(-here.turn->final_yaw_rate->value, 1e-9));
}

// ---------------------------------------------------------------- current

TEST_CASE("a turn in a current has the indices of still water once its drift is taken off",
          "[identification][round-trip]") {
  const auto still = turning_circle(tanker(), {radians(35.0)}, {.step = 0.5});
  auto run = turning_circle(tanker(), {radians(35.0)}, {.duration = 300.0, .step = 0.5}).run;
  const double north = 0.05, east = -0.08;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    run.fill(Channel::x)[i] += north * run.time[i];
    run.fill(Channel::y)[i] += east * run.time[i];
  }
  const auto trial = judge_trial(run, {.L = 7.0});
  REQUIRE(trial.turn->drift);
  CHECK_THAT(trial.turn->drift->north.value, WithinAbs(north, 2e-3));
  CHECK_THAT(trial.turn->drift->east.value, WithinAbs(east, 2e-3));
  CHECK_THAT(trial.turn->drift->direction.value, WithinAbs(std::atan2(east, north) + 2.0 * pi, 0.03));
  CHECK_THAT(trial.turn->corrected->tactical_diameter->value, WithinRel(*still.tactical_diameter, 5e-3));
  CHECK(std::abs(trial.turn->recorded.tactical_diameter->value - *still.tactical_diameter) > 2.0);
}

TEST_CASE("a turn of less than 540 deg does not tell its drift, and says so", "[identification][refusal]") {
  const auto run = turning_circle(tanker(), {radians(35.0)}, {.duration = 120.0, .step = 0.5}).run;
  const auto trial = judge_trial(run, {.L = 7.0});
  REQUIRE(trial.turn->heading_change < radians(540.0));
  CHECK_FALSE(trial.turn->drift);
  CHECK(trial.turn->recorded.tactical_diameter);
  CHECK_THAT(trial.notes.front(), ContainsSubstring("540 are needed"));
}

// ---------------------------------------------------------------- criteria

TEST_CASE("a criterion is open exactly where two standard errors reach over its limit", "[identification]") {
  CHECK(judged({9.9, 0.04}, 10.0) == true);
  CHECK(judged({10.1, 0.04}, 10.0) == false);
  CHECK_FALSE(judged({9.9, 0.06}, 10.0));
  CHECK_FALSE(judged({10.1, 0.06}, 10.0));
}

TEST_CASE("recorded criteria are those of the simulated manoeuvre", "[identification][second-route]") {
  const Ship ship = tanker();
  const ZigzagOrder order{radians(10.0), radians(10.0)};
  const auto z = zigzag(ship, order, {.step = 0.1});
  const auto expected = criteria_of(z, order, length(ship));
  const auto told = judge_trial(z.run, {.L = length(ship)}).imo;
  REQUIRE(told.size() == expected.size());
  for (std::size_t k = 0; k < told.size(); ++k) {
    CHECK(told[k].name == expected[k].name);
    CHECK_THAT(told[k].limit, WithinRel(expected[k].limit, 1e-6));
    CHECK_THAT(told[k].value->value, WithinRel(*expected[k].value, 1e-3));
    CHECK(told[k].pass == expected[k].pass);
  }
}

// ---------------------------------------------------------------- other manoeuvres

TEST_CASE("a spiral shows the yaw rates that the simulation settled at", "[identification][second-route]") {
  const auto s = spiral(tanker());
  const auto trial = judge_trial(s.run, {.L = 7.0});
  REQUIRE(trial.manoeuvre.kind == TrialKind::spiral);
  std::size_t found = 0;
  for (const auto& point : s.down)
    for (const auto& step : trial.spiral->steps)
      if (std::abs(step.delta - point.delta) < 1e-4 && std::abs(step.yaw_rate.value - point.motion.r) < 1e-4) {
        ++found;
        break;
      }
  CHECK(found == s.down.size());
}

TEST_CASE("a straight run tells its helm and its speed", "[identification][round-trip]") {
  Recording run;
  run.name = "straight.csv";
  for (int i = 0; i < 200; ++i) run.time.push_back(i);
  for (int i = 0; i < 200; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double wiggle = std::sin(0.1 * i);
    run.fill(Channel::psi)[k] = 1.0 + 0.002 * wiggle;
    run.fill(Channel::delta)[k] = radians(1.5) + 0.004 * wiggle;
    run.fill(Channel::u)[k] = 7.0;
  }
  const auto trial = judge_trial(run);
  REQUIRE(trial.manoeuvre.kind == TrialKind::steady);
  CHECK(std::abs(trial.steady->helm.value - radians(1.5)) < 2.0 * trial.steady->helm.standard_error);
  CHECK_THAT(trial.steady->speed->value, WithinAbs(7.0, 1e-9));
}

// ---------------------------------------------------------------- refusals

TEST_CASE("a run that is no manoeuvre is refused in one line", "[identification][refusal]") {
  auto still = tanker_zigzag();
  still.name = "run.csv";
  for (double& x : still.fill(Channel::delta)) x = 0.01;
  CHECK_THROWS_WITH(judge_trial(still), ContainsSubstring("run.csv: the rudder moves by no more than"));

  auto brief = tanker_zigzag();
  brief.facts.manoeuvre = "zigzag 10/10";
  brief.time.resize(20);
  for (auto& channel : brief.channels)
    if (!channel.empty()) channel.resize(20);
  CHECK_THROWS_WITH(judge_trial(brief), ContainsSubstring("too short for a zigzag 10/10"));

  auto bare = tanker_zigzag();
  bare.channels[index_of(Channel::psi)].clear();
  CHECK_THROWS_WITH(judge_trial(bare), ContainsSubstring("no heading recorded"));
  CHECK_THROWS_AS(judge_trial(tanker_zigzag(), {.L = -1.0}), std::domain_error);
}

TEST_CASE("heading and rudder alone tell overshoots and K and T, and what is missing is said", "[identification]") {
  auto run = tanker_zigzag();
  for (const Channel channel : {Channel::x, Channel::y, Channel::u, Channel::v, Channel::r})
    run.channels[index_of(channel)].clear();
  const auto trial = judge_trial(run, {.L = 7.0});
  CHECK(trial.zigzag->reversals.size() >= 3);
  CHECK(trial.steering.least_squares);
  CHECK_FALSE(trial.approach.speed);
  CHECK(trial.imo.empty());
  CHECK_THAT(trial.notes.back(), ContainsSubstring("--speed"));
  CHECK_FALSE(judge_trial(run, {.L = 7.0, .U = 1.18}).imo.empty());
}

// ---------------------------------------------------------------- recordings of models

TEST_CASE("overshoots of the KVLCC2 models are those that the benchmark's files list", "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  int compared = 0;
  const auto about = test::json_in(*folder / "recordings.json");
  for (const auto& listed : about["recordings"]) {
    const auto file = *folder / (listed["id"].get<std::string>() + ".csv");
    if (!std::filesystem::exists(file) || listed["manoeuvre"] != "zigzag") continue;
    const auto trial = judge_trial(read_recording(file).recording, {.L = 7.0});
    REQUIRE(trial.zigzag);
    for (const auto& peak : listed["overshoots"]) {
      const auto k = peak["n"].get<std::size_t>() - 1;
      if (k >= trial.zigzag->reversals.size() || !peak["complete"].get<bool>()) continue;
      const auto& told = trial.zigzag->reversals[k].overshoot;
      INFO(file << " peak " << k + 1);
      REQUIRE(told);
      // the list counts from heading 0, the trial from that of the approach
      const double zero = yaw_sign(trial.zigzag->reversals[k].side) * degrees(trial.approach.heading.value);
      CHECK_THAT(degrees(told->value) + zero, WithinAbs(peak["overshoot_vs_nominal_deg"].get<double>(), 0.12));
      ++compared;
    }
  }
  CHECK(compared > 20);
}

TEST_CASE("rudder starts and heading peaks of the KVLCC2 models are those of the benchmark's files",
          "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  int compared = 0;
  const auto about = test::json_in(*folder / "recordings.json");
  for (const auto& listed : about["recordings"]) {
    const auto file = *folder / (listed["id"].get<std::string>() + ".csv");
    if (!std::filesystem::exists(file) || listed["manoeuvre"] != "zigzag") continue;
    const auto trial = judge_trial(read_recording(file).recording, {.L = 7.0});
    REQUIRE(trial.zigzag);
    const auto& reversals = trial.zigzag->reversals;
    for (std::size_t k = 0; k < std::min(reversals.size(), listed["switches"].size()); ++k) {
      const auto& told = reversals[k];
      const auto& rudder = listed["switches"][k];
      INFO(file << " reversal " << k + 1);
      // the list has the first sample at which the rudder has moved, the trial the start of its straight way
      CHECK_THAT(told.rudder_start->value, WithinAbs(rudder["t_start_s"].get<double>(), 0.3));
      if (k >= listed["overshoots"].size() || !listed["overshoots"][k]["complete"].get<bool>()) continue;
      const auto& peak = listed["overshoots"][k];
      CHECK_THAT(told.peak_time->value, WithinAbs(peak["t_peak_s"].get<double>(), 0.6));
      // heading then and overshoot from there make the peak; the list counts from heading 0
      const double zero = yaw_sign(told.side) * degrees(trial.approach.heading.value);
      CHECK_THAT(
          degrees(told.heading_then->value + told.beyond_start->value) + zero,
          WithinAbs(std::abs(rudder["psi_at_start_deg"].get<double>()) + peak["overshoot_vs_switch_deg"].get<double>(),
                    0.12));
      ++compared;
    }
  }
  CHECK(compared > 20);
}

TEST_CASE("simulated manoeuvres of the KVLCC2 are judged as two independent programs compute them",
          "[identification][published]") {
  const auto golden = test::json_in(test::golden / "mmg_manoeuvres.json");
  for (const auto& reference : golden.at("cases")) {
    const auto ship = read_ship(test::ships / (reference.at("ship").get<std::string>() + ".toml"));
    const double L = length(ship), U = reference.at("approach_speed_m_s");
    const ManoeuvreOptions options{
        .speed = U, .duration = reference.at("states").back().at("time_s"), .step = 0.02 * L / U};
    const std::string name = reference.at("manoeuvre");
    INFO(reference.at("ship") << " " << name);
    const Side side = reference.at("first") == "port" ? Side::port : Side::starboard;
    if (name == "turn 35") {
      const auto trial = judge_trial(turning_circle(ship, {radians(35.0), side}, options).run, {.L = L});
      const auto is = [&](const MaybeTold& told, const char* key, double unit) {
        CHECK_THAT(told->value / unit, WithinRel(reference.at(key).get<double>(), 1e-3));
      };
      is(trial.turn->recorded.advance, "advance_L", L);
      is(trial.turn->recorded.transfer, "transfer_L", L);
      is(trial.turn->recorded.tactical_diameter, "tactical_diameter_L", L);
      is(trial.turn->recorded.final_diameter, "final_turning_diameter_L", L);
      is(trial.turn->time_90, "time_90_s", 1.0);
      is(trial.turn->time_180, "time_180_s", 1.0);
      continue;
    }
    const double angle = radians(name == "zigzag 20/20" ? 20.0 : 10.0);
    const auto trial = judge_trial(zigzag(ship, {angle, angle, side}, options).run, {.L = L});
    const auto& overshoots = reference.at("overshoots");
    REQUIRE(trial.zigzag->reversals.size() >= overshoots.size());
    for (std::size_t k = 0; k < overshoots.size(); ++k) {
      const auto& told = trial.zigzag->reversals[k];
      CHECK_THAT(degrees(told.overshoot->value), WithinAbs(overshoots[k].at("overshoot_deg").get<double>(), 0.01));
      CHECK_THAT(told.execute->value, WithinAbs(overshoots[k].at("execute_s").get<double>(), 0.002 * L / U));
      CHECK_THAT(told.peak_time->value, WithinAbs(overshoots[k].at("peak_s").get<double>(), 0.02 * L / U));
    }
  }
}

TEST_CASE("the angles of a manoeuvre are read from its name, not the number or the date of the run",
          "[identification][regression]") {
  const auto ship = read_ship(test::ships / "kvlcc2.toml");
  const auto named = [](Recording run, const char* name) {
    run.facts.manoeuvre = name;
    return judge_trial(run, {}).manoeuvre;
  };
  const auto turn = turning_circle(ship, {radians(35.0), Side::starboard}, {}).run;
  for (const auto* name : {"turn 35", "2_turn35_s", "35 deg turning circle", "Run 12: turn 35"}) {
    INFO(name);
    CHECK(named(turn, name).name == "turn 35");
    CHECK(named(turn, name).said);
  }
  for (const auto* name : {"turn_14-Sep-2020_13_39", "3 turn", "turning circle"}) {  // none of these is an angle
    INFO(name);
    CHECK(named(turn, name).name == "turn 35");
    CHECK(!named(turn, name).said);
  }
  // a pair is no number of a run, and a helmsman may put the rudder further over when it is done
  auto hard_over = zigzag(ship, {radians(10.0), radians(10.0), Side::starboard}, {}).run;
  hard_over.channels[index_of(Channel::delta)].back() = radians(35.0);
  CHECK(named(hard_over, "zigzag 10/10").said);
  const auto zigzag_run = zigzag(ship, {radians(10.0), radians(10.0), Side::starboard}, {}).run;
  for (const auto* name : {"zigzag 10/10", "10/10 zigzag", "4_zigzag10_10_p"}) {
    INFO(name);
    CHECK(named(zigzag_run, name).name == "zigzag 10/10");
    CHECK(named(zigzag_run, name).said);
  }
}

TEST_CASE("the KCS model turns and yaws as SIMMAN's runs do, without drift", "[identification][published]") {
  const auto folder = test::benchmark_recordings("kcs");
  if (!folder) return;
  const auto turn = judge_trial(read_recording(*folder / "kcs_turning_port_35.csv").recording, {.L = 230.0});
  REQUIRE(turn.turn);
  CHECK(turn.manoeuvre.name == "turn 35");
  REQUIRE(turn.turn->drift);
  // a basin has no current
  CHECK(turn.turn->drift->speed.value < 2.0 * turn.turn->drift->speed.standard_error);
  const auto diameter = [](const MaybeTold& x) { return x->value / 230.0; };
  CHECK_THAT(diameter(turn.turn->corrected->tactical_diameter),
             WithinAbs(diameter(turn.turn->recorded.tactical_diameter), 0.02));
  const auto zigzag = judge_trial(read_recording(*folder / "kcs_zigzag_port_20.csv").recording, {.L = 230.0});
  CHECK(zigzag.manoeuvre.name == "zigzag 20/20");
  CHECK(zigzag.zigzag->first == Side::port);
  CHECK(zigzag.steering.least_squares->K.value > 0.0);
}

}  // namespace
}  // namespace swayaw
