#include <algorithm>
#include <catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// What long works do with runs they cannot use, with findings no file holds and with findings that do not hold.
namespace swayaw {
namespace {

using test::run;
using test::Scratch;

/// A zigzag of the 7 m model without noise, changed, in a file. @return its name and a blank
template <class Change>
std::string recorded(const Scratch& scratch, const std::string& name, double rudder, const Change& change) {
  const auto ship = published_ship("kvlcc2_l7");
  auto recording = zigzag(ship, {radians(rudder), radians(rudder)}, {.step = 0.03 * time_unit_of(ship)}).run;
  change(recording);
  write_recording(recording, scratch / name);
  return (scratch / name).string() + " ";
}

void as_it_is(Recording&) {}

void with_astern_shaft(Recording& recording) {
  for (double& n : recording.fill(Channel::rev)) n = -5.0;
}

/// Her rudder angle on the wrong side.
void with_wrong_rudder(Recording& recording) {
  for (double& delta : recording.channels[index_of(Channel::delta)]) delta = -delta;
}

void without_speed(Recording& recording) {
  for (const Channel c : {Channel::u, Channel::v, Channel::x, Channel::y, Channel::u_ground, Channel::v_ground,
                          Channel::speed_through_water, Channel::speed_over_ground, Channel::course_over_ground})
    recording.channels[index_of(c)].clear();
}

std::string identify_words(const Scratch& scratch, const std::string& runs) {
  return "identify " + runs + "--ship " + test::ship_file("kvlcc2_l7.toml") +
         " --model mmg --fit forces --find N_v,N_r --out " + (scratch / "new.toml").string();
}

TEST_CASE("identify says first what was found and whether held-out runs improve", "[app]") {
  const Scratch scratch;
  const auto runs = recorded(scratch, "zz10.csv", 10, as_it_is), held = recorded(scratch, "zz20.csv", 20, as_it_is);
  auto wrong = published_ship("kvlcc2_l7");
  const auto N_r = parameters_of(wrong, std::array{std::string("N_r")});
  write_ship(scratch / "wrong.toml", with_values(wrong, N_r, std::array{1.3 * N_r[0].value}));
  const auto outcome = run(scratch, "identify " + runs + "--ship " + (scratch / "wrong.toml").string() +
                                        " --model mmg --fit forces --find N_v,N_r --holdout " + held + "--out " +
                                        (scratch / "new.toml").string());
  INFO(outcome.out << outcome.err);
  CHECK(outcome.code == 0);
  const auto second = outcome.out.substr(outcome.out.find('\n') + 1);
  CHECK_THAT(second, Catch::Matchers::StartsWith("2 of 2 coefficients determined by 1 run. Held-out runs improve: "));
}

TEST_CASE("identify fails when held-out runs worsen, with everything printed and written", "[app]") {
  const Scratch scratch;
  const auto runs = recorded(scratch, "zz10.csv", 10, with_wrong_rudder),
             held = recorded(scratch, "zz20.csv", 20, as_it_is);
  const auto outcome = run(scratch, identify_words(scratch, runs) + " --json --no-check --holdout " + held);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.err, ContainsSubstring("held-out runs are predicted worse"));
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["verdict"]["holdout"]["worse"] == true);
  CHECK_THAT(json["verdict"]["words"].get<std::string>(), ContainsSubstring("WORSEN"));
  CHECK(json["coefficients"].size() == 2);
  CHECK(std::filesystem::exists(scratch / "new.toml"));
}

TEST_CASE("a run that the ship cannot sail is set aside by name and the others go on", "[app]") {
  const Scratch scratch;
  const auto good = recorded(scratch, "good.csv", 10, as_it_is),
             astern = recorded(scratch, "astern.csv", 20, with_astern_shaft);
  const auto outcome = run(scratch, identify_words(scratch, good + astern) + " --json");
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.err, ContainsSubstring("astern.csv: set aside: the ship cannot sail it: "));
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["runs"].size() == 1);
  CHECK(json["verdict"]["set_aside"][0]["run"] == "astern.csv");
}

TEST_CASE("diagnose sets aside what the ship cannot sail, goes on, and saves what it found", "[app]") {
  const Scratch scratch;
  const auto good = recorded(scratch, "good.csv", 10, as_it_is),
             astern = recorded(scratch, "astern.csv", 20, with_astern_shaft);
  const auto saved = scratch / "found.toml";
  const auto outcome = run(scratch, "diagnose kvlcc2_l7 " + good + astern + "--json --save-model " + saved.string());
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["set_aside"][0]["run"] == "astern.csv");
  CHECK(json["fit"]["train"].size() == 1);
  CHECK(json["not_written"].empty());
  CHECK(json["troubles"].empty());
  CHECK(read_ship(saved).name == published_ship("kvlcc2_l7").name);
}

TEST_CASE("identify prints what it found though its file cannot be written", "[app]") {
  const Scratch scratch;
  const auto outcome = run(scratch, "identify " + recorded(scratch, "zz10.csv", 10, as_it_is) + "--ship kvlcc2_l7 " +
                                        "--model mmg --fit forces --find N_v,N_r --json --out " +
                                        (scratch / "no" / "such.toml").string());
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.err, ContainsSubstring("the ship file was not written"));
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["coefficients"].size() == 2);
  CHECK(json["troubles"].size() == 1);
}

TEST_CASE("where no run is left that the ship can sail, identify and diagnose are refused", "[app][refusal]") {
  const Scratch scratch;
  const auto astern = recorded(scratch, "astern.csv", 20, with_astern_shaft);
  for (const auto& words : {identify_words(scratch, astern), "diagnose kvlcc2_l7 " + astern}) {
    const auto outcome = run(scratch, words);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, ContainsSubstring("no run is left to work on: astern.csv: "));
  }
  CHECK_FALSE(std::filesystem::exists(scratch / "new.toml"));
}

TEST_CASE("a run without any speed begins at the service speed, which is said", "[app]") {
  const Scratch scratch;
  const auto outcome =
      run(scratch, identify_words(scratch, recorded(scratch, "blind.csv", 10, without_speed)) + " --json");
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.err, ContainsSubstring("blind.csv: no channel tells her speed; the service speed of 1.179 m/s"));
  CHECK(nlohmann::json::parse(outcome.out)["coefficients"].size() == 2);
}

// ---------------------------------------------------------------- parts of runs

/// The samples of a run with so many seconds before, and after, in which the ship drifts astern where she is.
Recording adrift(const Recording& run, double before, double after) {
  const double h = run.time[1] - run.time[0];
  const auto first = static_cast<std::size_t>(before / h), last = static_cast<std::size_t>(after / h),
             all = first + run.samples() + last;
  Recording result{run.name, run.facts, {}, {}, {}};
  for (std::size_t i = 0; i < all; ++i) result.time.push_back(static_cast<double>(i) * h);
  for (std::size_t c = 0; c < channel_count; ++c) {
    if (run.channels[c].empty()) continue;
    for (std::size_t i = 0; i < all; ++i)
      result.channels[c].push_back(run.channels[c][std::clamp(i, first, first + run.samples() - 1) - first]);
  }
  for (const auto& [channel, value] : {std::pair{Channel::u, -0.02}, {Channel::v, 0.0}, {Channel::r, 0.0}})
    for (std::size_t i = 0; i < all; ++i)
      if (i < first || i >= first + run.samples()) result.channels[index_of(channel)][i] = value;
  return result;
}

/// What compare says of one run, and how long the part is that it used.
struct Used {
  std::string err;
  double duration;
};

Used used_of(const Scratch& scratch, const std::string& file) {
  const auto outcome = run(scratch, "compare kvlcc2_l7 " + file + "--json --no-check");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return {outcome.err, nlohmann::json::parse(outcome.out)["runs"][0]["duration_s"]};
}

TEST_CASE("of a run that begins or ends adrift the part with way ahead is used, which is said", "[app]") {
  const Scratch scratch;
  const double grid = 0.25 * 7.0 / 1.179;  // L/U: between these times the speed is not asked for
  double sailed = 0.0;
  const auto with = [&](const std::string& name, double before, double after) {
    return recorded(scratch, name, 10, [&](Recording& r) {
      sailed = r.time.back();
      r = adrift(r, before, after);
    });
  };
  const auto late = used_of(scratch, with("late.csv", 30.0, 0.0));
  CHECK_THAT(late.err, ContainsSubstring("late.csv: used from 3"));
  CHECK_THAT(late.err, ContainsSubstring("before, she has no way ahead\n"));
  CHECK_THAT(late.duration, WithinAbs(sailed, 2.0 * grid));
  const auto stopped = used_of(scratch, with("stopped.csv", 0.0, 30.0));
  CHECK_THAT(stopped.err, ContainsSubstring("stopped.csv: used up to "));
  CHECK_THAT(stopped.duration, WithinAbs(sailed, 2.0 * grid));
  const auto both = used_of(scratch, with("both.csv", 30.0, 30.0));
  CHECK_THAT(both.err, ContainsSubstring("before and after, she has no way ahead"));
  CHECK_THAT(both.duration, WithinAbs(sailed, 3.0 * grid));
  const auto whole = used_of(scratch, with("whole.csv", 0.0, 0.0));
  CHECK_THAT(whole.err, !ContainsSubstring("no way ahead"));
  CHECK(whole.duration == sailed);
}

TEST_CASE("identify finds from the part with way ahead what it finds from a run that has no other", "[app]") {
  const Scratch scratch;
  const auto found = [&](const std::string& file) {
    const auto outcome = run(scratch, identify_words(scratch, file) + " --json --no-check");
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["verdict"]["set_aside"].empty());
    return json["coefficients"][0]["value"].get<double>();
  };
  const double whole = found(recorded(scratch, "whole.csv", 10, as_it_is)),
               part = found(recorded(scratch, "late.csv", 10, [](Recording&r) { r = adrift(r, 30.0, 30.0); }));
  CHECK_THAT(part, WithinRel(whole, 0.02));
}

TEST_CASE("a run that is astern throughout, or makes too little way ahead, is set aside", "[app]") {
  const Scratch scratch;
  const auto good = recorded(scratch, "good.csv", 10, as_it_is);
  const auto astern = recorded(scratch, "adrift.csv", 10, [](Recording& r) {
    for (double& u : r.channels[index_of(Channel::u)]) u = -0.02;
  });
  const auto brief = recorded(scratch, "brief.csv", 10, [](Recording& r) {
    for (std::size_t i = 0; i < r.samples(); ++i)
      if (r.time[i] < 20.0 || r.time[i] > 26.0) r.channels[index_of(Channel::u)][i] = -0.02;
  });
  const auto outcome = run(scratch, identify_words(scratch, good + astern + brief) + " --json --no-check");
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  for (const auto* name : {"adrift", "brief"})
    CHECK_THAT(outcome.err,
               ContainsSubstring(std::string(name) + ".csv: set aside: the ship cannot sail it: forces are known"));
  CHECK(nlohmann::json::parse(outcome.out)["verdict"]["set_aside"].size() == 2);
}

// ---------------------------------------------------------------- wind and depth as measured

/// A wind from starboard that was measured, and water of 1.5 draughts.
void with_surroundings(Recording& recording) {
  std::ranges::fill(recording.fill(Channel::wind_speed), 4.0);
  std::ranges::fill(recording.fill(Channel::wind_from), radians(90));
  recording.facts.water_depth = 1.5 * 0.46;
}

/// The 7 m model without anything for the wind to take hold of.
std::string without_windage(const Scratch& scratch) {
  std::istringstream whole(read_text(test::ship_file("kvlcc2_l7.toml")));
  std::string text;
  for (std::string line; std::getline(whole, line);)
    if (!line.starts_with("frontal_area") && !line.starts_with("lateral_area")) text += line + "\n";
  write_text(scratch / "bare.toml", text);
  return (scratch / "bare.toml").string() + " ";
}

TEST_CASE("with --ignore-wind and --ignore-depth the answer is that of a file without them, bit for bit", "[app]") {
  const Scratch scratch, bare;
  const std::string ship = "kvlcc2_l7 ";
  const auto run_with = recorded(scratch, "run.csv", 10, with_surroundings),
             run_without = recorded(bare, "run.csv", 10, as_it_is);
  const auto told = run(scratch, "compare " + ship + run_with + "--json"),
             ignored = run(scratch, "compare " + ship + run_with + "--json --ignore-wind --ignore-depth"),
             never = run(scratch, "compare " + ship + run_without + "--json");
  CHECK(never.code == 0);
  CHECK(ignored.out == never.out);
  CHECK(told.out != never.out);
  for (const auto* one : {" --ignore-wind", " --ignore-depth"})
    CHECK(run(scratch, "compare " + ship + run_with + "--json" + one).out != never.out);
}

TEST_CASE("identify and diagnose forget what they are told to ignore", "[app]") {
  const Scratch scratch, bare;
  const std::string ship = "kvlcc2_l7 ";
  const auto run_with = recorded(scratch, "run.csv", 10, with_surroundings),
             run_without = recorded(bare, "run.csv", 10, as_it_is);
  const auto identified = [&](const std::string& file, const std::string& more) {
    return run(scratch, "identify " + file + "--ship " + ship +
                            "--model mmg --fit forces --find N_v,N_r --json --out " + (scratch / "new.toml").string() +
                            more)
        .out;
  };
  CHECK(identified(run_with, " --ignore-wind --ignore-depth") == identified(run_without, ""));
  CHECK(identified(run_with, "") != identified(run_without, ""));
}

TEST_CASE("wind and depth that cannot act are named in one line, and nothing fails", "[app]") {
  const Scratch scratch;
  const auto file = recorded(scratch, "run.csv", 10, with_surroundings), bare = without_windage(scratch);
  const auto told = run(scratch, "compare " + bare + file);
  CHECK(told.code == 0);
  CHECK_THAT(told.err, ContainsSubstring("run.csv: the measured wind is not used: the ship file has no [windage]"));
  CHECK(told.err.find("measured wind") == told.err.rfind("measured wind"));
  CHECK_THAT(run(scratch, "compare " + bare + file + "--ignore-wind").err, !ContainsSubstring("measured wind"));
  const auto replayed = run(scratch, "replay mariner " + file + "--out " + (scratch / "out.csv").string());
  CHECK_THAT(replayed.err, ContainsSubstring("is not used: shallow_water cannot act on a ship of model \"abkowitz\""));
}

TEST_CASE("a replay writes the wind that acted, and its forces by part have it", "[app][round-trip]") {
  const Scratch scratch;
  const std::string ship = "kvlcc2_l7 ";
  const auto file = recorded(scratch, "run.csv", 10, with_surroundings);
  const auto out = scratch / "out.csv";
  REQUIRE(run(scratch, "replay " + ship + file + "--forces --out " + out.string()).code == 0);
  const auto replayed = read_recording(out).recording;
  CHECK(replayed[Channel::wind_speed][10] == 4.0);
  const auto wind = std::ranges::find(replayed.extra, "Y_wind_N", &ExtraColumn::name);
  REQUIRE(wind != replayed.extra.end());
  CHECK(std::stod(wind->cells[10]) < 0.0);
  REQUIRE(run(scratch, "replay " + ship + file + "--ignore-wind --out " + out.string()).code == 0);
  CHECK_FALSE(read_recording(out).recording.has(Channel::wind_speed));
}

}  // namespace
}  // namespace swayaw
