#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/recording_csv.hpp"

/// The program from the outside: what it prints, where, and how it ends.
namespace swayaw {
namespace {

using nlohmann::json;
using test::document;
using test::refusal;
using test::run;
using test::Scratch;

const std::string ship = test::ship_file("kvlcc2_l7.toml");
const std::string example_zigzag = (test::example_recordings / "weak_rudder_zz10_10.csv").string();
const std::string example_turn = (test::example_recordings / "weak_rudder_turn35.csv").string();

TEST_CASE("the program tells its version and its commands", "[app]") {
  const Scratch scratch;
  const auto version = run(scratch, "--version");
  CHECK(version.code == 0);
  CHECK(std::regex_match(version.out, std::regex("swayaw \\d+\\.\\d+\\.\\d+\n")));
  const auto help = run(scratch, "--help");
  CHECK(help.code == 0);
  for (const char* command :
       {"simulate", "replay", "compare", "forces", "indices", "invert", "linearize", "loop", "trial", "tune"}) {
    CHECK_THAT(help.out, ContainsSubstring(command));
    CHECK(run(scratch, std::string(command) + " --help").code == 0);
  }
}

TEST_CASE("wrong usage ends with code 2 and one line that helps", "[app][refusal]") {
  const std::pair<std::string, std::string> cases[] = {
      {"", "subcommand"},
      {"simulat " + ship, "did you mean \"simulate\"?"},
      {"fly", "no command \"fly\""},
      {"simulate " + ship, "[--zigzag,--turn,"},
      {"simulate " + ship + " --zigzag 20", "D/H"},
      {"simulate " + ship + " --zigzag 20/20 --turn 35", "[--zigzag,--turn,"},
      {"simulate " + ship + " --turn -5", "--turn"},
      {"simulate " + ship + " --turn 35 --first left", "--first"},
      {"simulate " + ship + " --turn 35 --sped 3", "--sped"},
      {"replay " + ship + " " + example_zigzag, "--out"},
      {"compare " + ship, "RUN"},
      {"compare " + ship + " " + example_zigzag + " --window 0", "--window"},
      {"indices", "SHIP"},
      {"indices " + ship + " --speed 0", "--speed"},
      {"invert " + ship + " --known a_H", "--known"},
      {"loop " + ship, "--zigzag"},
      {"loop " + ship + " --zigzag ten", "D/H"},
      {"tune " + ship + " --out new.toml", "--indices"},
      {"tune " + ship + " --indices f.toml", "--out"},
      {"tune " + ship + " --indices f.toml --out new.toml --prior 0", "--prior"},
  };
  for (const auto& [arguments, hint] : cases) CHECK_THAT(refusal(arguments, 2), ContainsSubstring(hint));
}

TEST_CASE("bad data ends with code 1, names the place, and writes nothing", "[app][refusal]") {
  const Scratch scratch;
  write_text(scratch / "bad.csv", "time_s,psi_rad,delta_rad,u_m_s\n0,0,0,1\n1,0,x,1\n");
  auto ship_text = read_text(ship);
  const auto line = std::ranges::count(ship_text.substr(0, ship_text.find("density_kg_m3")), '\n') + 1;
  ship_text.replace(ship_text.find("density_kg_m3 = 1000"), 20, "density_kg_m3 = -1");
  write_text(scratch / "bad.toml", ship_text);
  const auto bad_run =
      refusal("replay " + ship + " " + (scratch / "bad.csv").string() + " --out " + (scratch / "out.csv").string());
  CHECK_THAT(bad_run, ContainsSubstring((scratch / "bad.csv").string() + ":3:5: "));
  CHECK_FALSE(std::filesystem::exists(scratch / "out.csv"));
  CHECK_THAT(refusal("simulate " + (scratch / "bad.toml").string() + " --turn 35"),
             ContainsSubstring((scratch / "bad.toml").string() + ":" + std::to_string(line) +
                               ":17: density_kg_m3 in [water] must be positive, got -1"));
  CHECK_THAT(refusal("simulate no_such_ship.toml --turn 35"), ContainsSubstring("no_such_ship.toml"));
  CHECK_THAT(refusal("simulate " + ship + " --turn 36"), ContainsSubstring("beyond the ship's largest"));
  CHECK_THAT(refusal("simulate " + ship + " --turn 35 --out /no/such/folder/f.csv"),
             ContainsSubstring("/no/such/folder/f.csv"));
}

TEST_CASE("simulate prints the indices of a zigzag as JSON", "[app]") {
  const Scratch scratch;
  const auto outcome = run(scratch, "simulate " + ship + " --zigzag 20/10 --first port --json");
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  const auto document = test::json_of(outcome.out);
  CHECK(document.at("manoeuvre") == "zigzag 20/10");
  CHECK(document.at("first") == "port");
  CHECK(document.at("execute_s").front() == 0.0);
  CHECK(document.at("execute_s").size() >= 3);
  CHECK(document.at("overshoot_deg").front().get<double>() > 0.0);
  CHECK(document.at("period_s").get<double>() > 0.0);
}

TEST_CASE("simulate prints the indices of a turning circle as JSON, null for what was not reached", "[app]") {
  const auto whole = document("simulate " + ship + " --turn 35");
  for (const char* key : {"advance_m", "transfer_m", "tactical_diameter_m", "final_diameter_m", "time_90_s",
                          "time_180_s", "final_speed_m_s", "final_drift_rad", "final_yaw_rate_rad_s"})
    CHECK(whole.at(key).is_number());
  CHECK(whole.at("final_yaw_rate_rad_s").get<double>() > 0.0);
  const auto part = document("simulate " + ship + " --turn 35 --duration 30");
  CHECK(part.at("time_90_s").is_number());
  CHECK(part.at("time_180_s").is_null());
}

TEST_CASE("a simulated run can be read back and replayed", "[app][round-trip]") {
  const Scratch scratch;
  const auto made = (scratch / "run.csv").string(), again = (scratch / "again.csv").string();
  REQUIRE(run(scratch, "simulate " + ship + " --zigzag 10/10 --duration 60 --step 0.05 --out " + made).code == 0);
  REQUIRE(run(scratch, "replay " + ship + " " + made + " --out " + again).code == 0);
  const auto first = read_recording(made).recording, second = read_recording(again).recording;
  CHECK(first.facts.manoeuvre == "zigzag 10/10 first starboard");
  REQUIRE(first.time == second.time);
  for (std::size_t i = 0; i < first.samples(); ++i)
    CHECK_THAT(second[Channel::psi][i], WithinAbs(first[Channel::psi][i], 1e-4));
}

TEST_CASE("compare prints a document without NaN, a table, and a page", "[app]") {
  const Scratch scratch;
  const auto page = (scratch / "page.html").string();
  const auto outcome =
      run(scratch, "compare " + ship + " " + example_zigzag + " " + example_turn + " --json --report " + page);
  REQUIRE(outcome.code == 0);
  const auto document = test::json_of(outcome.out);
  CHECK(document.at("schema") == "swayaw.comparison/1");
  REQUIRE(document.at("runs").size() == 2);
  CHECK(document.at("runs")[0].at("run") == "weak_rudder_zz10_10.csv");
  CHECK(document.at("runs")[0].at("quantities").size() == 5);
  const auto text = read_text(page);
  CHECK(text.size() < 3'000'000);
  CHECK_THAT(text, ContainsSubstring(document.at("verdict").get<std::string>()));
  const auto table = run(scratch, "compare " + ship + " " + example_zigzag);
  CHECK(table.code == 0);
  CHECK_THAT(table.out, ContainsSubstring("yaw_rate worst: "));
  const auto markdown = run(scratch, "compare " + ship + " " + example_zigzag + " --markdown");
  CHECK_THAT(markdown.out, ContainsSubstring("| weak_rudder_zz10_10 | yaw_rate |"));
  CHECK_THAT(markdown.out, ContainsSubstring("| rudder 8 to 15 deg to port |"));
}

TEST_CASE("unknown columns are named on stderr, not on stdout", "[app]") {
  const Scratch scratch;
  auto text = read_text(example_zigzag);
  text.replace(text.find(",rev_s"), 6, ",shaft_turns");
  write_text(scratch / "run.csv", text);
  const auto outcome = run(scratch, "compare " + ship + " " + (scratch / "run.csv").string() + " --json");
  REQUIRE(outcome.code == 0);
  CHECK(json::accept(outcome.out));
  CHECK_THAT(outcome.err, ContainsSubstring("shaft_turns"));
  CHECK_THAT(outcome.err, ContainsSubstring("no shaft speed recorded"));
}

// ---------------------------------------------------------------- published ships

TEST_CASE("a bare name stands for the published ship, which is told on stderr", "[app]") {
  const test::Scratch scratch;
  const auto by_name = test::run(scratch, "simulate nawigator_ym --turn 35 --rev 3.7 --json");
  const auto by_file =
      test::run(scratch, "simulate " + test::ship_file("nawigator_ym.toml") + " --turn 35 --rev 3.7 --json");
  CHECK(by_name.code == 0);
  CHECK(by_name.out == by_file.out);
  CHECK(by_name.err == "swayaw: nawigator_ym: no such file here; the published ship of that name is used\n");
  CHECK(by_file.err.empty());
  CHECK(test::run(scratch, "indices tanker97 --json").code == 0);
}

TEST_CASE("a name that is no published ship is refused with the one that was probably meant", "[app][refusal]") {
  CHECK(test::refusal("simulate nawigator_n8 --turn 35") ==
        "swayaw: there is no file and no published ship \"nawigator_n8\"; did you mean \"nawigator_n7\"?\n");
  CHECK_THAT(test::refusal("replay titanic run.csv --out o.csv"),
             ContainsSubstring("no published ship \"titanic\"; published are esso_osaka_3m, kcs, kvlcc2, kvlcc2_l7"));
  CHECK_THAT(test::refusal("compare nawigator_n7.toml run.csv"),
             ContainsSubstring("nawigator_n7.toml:1:1: cannot be read"));
}

TEST_CASE("a turn in which the ship loses her way says so and keeps the indices reached", "[app]") {
  const test::Scratch scratch;
  const auto turn = test::run(scratch, "simulate nawigator_n7 --turn 35 --rev 3.7");
  CHECK(turn.code == 0);
  CHECK_THAT(turn.out, ContainsSubstring("1.714 L") &&
                           ContainsSubstring("no steady turn: the ship no longer moves ahead at 99.3 s"));
}

TEST_CASE("a file that is too large is refused in one line, and read where its size is allowed", "[app][refusal]") {
  const auto size = std::to_string(std::filesystem::file_size(example_zigzag));
  for (const std::string& command :
       {"check " + example_zigzag, "compare " + ship + " " + example_zigzag, "trial " + example_zigzag})
    CHECK_THAT(test::refusal(command + " --max-file-size 10kB"),
               ContainsSubstring(example_zigzag + ": has " + size +
                                 " bytes, and files of up to 10000 bytes are read here; "
                                 "--max-file-size 1MB reads it"));
  CHECK_THAT(test::refusal("ship " + ship + " --max-file-size 100B"), ContainsSubstring("up to 100 bytes"));
  const Scratch scratch;
  CHECK(run(scratch, "check " + example_zigzag + " --max-file-size 1MB").code == 0);
  for (const std::string size_of_none : {"x", "0", "-1GB", "4XB", "1e30", "nan"})
    CHECK_THAT(test::refusal("check " + example_zigzag + " --max-file-size=" + size_of_none, 2),
               ContainsSubstring("\"" + size_of_none + "\" is not a size like 4GB, in B, kB, MB, GB or TB"));
}

}  // namespace
}  // namespace swayaw
