#include <fmt/format.h>

#include <catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "program.hpp"

/// swayaw trial from the outside.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

const std::string kvlcc2_l7 = test::ship_file("kvlcc2_l7.toml");
const std::string zigzag = (test::example_recordings / "weak_rudder_zz10_10.csv").string();
const std::string turn = (test::example_recordings / "weak_rudder_turn35.csv").string();

double value(const nlohmann::json& told) { return told["value"].get<double>(); }

TEST_CASE("trial tells a simulated zigzag the numbers that simulate told", "[app][round-trip]") {
  const Scratch scratch;
  const auto file = (scratch / "zz.csv").string();
  const auto said = document("simulate " + kvlcc2_l7 + " --zigzag 10/10 --out " + file);
  const auto json = document("trial " + file + " --ship " + kvlcc2_l7);
  CHECK(json["schema"] == "swayaw.trial/1");
  const auto& told = json["runs"][0];
  CHECK(told["manoeuvre"] == "zigzag 10/10");
  REQUIRE(told["overshoot_deg"].size() >= 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK_THAT(value(told["overshoot_deg"][k]), WithinAbs(said["overshoot_deg"][k].get<double>(), 2e-3));
    CHECK_THAT(value(told["execute_s"][k]), WithinAbs(said["execute_s"][k].get<double>(), 5e-3));
  }
  CHECK_THAT(value(told["initial_turning_m"]), WithinRel(said["initial_turning_m"].get<double>(), 1e-3));
  // the same ship at the same speed, simulated beside
  CHECK_THAT(told["simulated"]["overshoot_deg"][0].get<double>(),
             WithinAbs(said["overshoot_deg"][0].get<double>(), 1e-2));
  CHECK(told["imo"].size() == 3);
  CHECK(told["nomoto"]["least_squares"]["K_1_s"]["value"] > 0.0);
  CHECK(told["turns_against_rudder"] == false);
}

TEST_CASE("an Abkowitz ship is simulated at her own speed beside a recording, and that is said", "[app]") {
  const Scratch scratch;
  const auto mariner = test::ship_file("mariner.toml"), file = (scratch / "zz.csv").string();
  const auto said = document("simulate " + mariner + " --zigzag 20/20 --out " + file);
  const double first = said["overshoot_deg"][0];
  const auto of_others = run(scratch, "trial " + zigzag + " --ship " + mariner + " --json");
  CHECK_THAT(of_others.err, ContainsSubstring("simulated at 7.72 m/s, the only speed of an abkowitz ship, not at the "
                                              "recorded 1.18 m/s"));
  CHECK(nlohmann::json::parse(of_others.out)["runs"][0]["simulated"]["overshoot_deg"].size() >= 2);
  // what a recording tells of its speed is never that of the file to the last digit
  const auto own = run(scratch, "trial " + file + " --ship " + mariner + " --json");
  CHECK(own.err.empty());
  CHECK_THAT(nlohmann::json::parse(own.out)["runs"][0]["simulated"]["overshoot_deg"][0].get<double>(),
             WithinAbs(first, 1e-6));
}

TEST_CASE("a run that is no manoeuvre is left out with the reason, and the others are judged", "[app]") {
  const Scratch scratch;
  const auto passage = (scratch / "passage.csv").string(), page = (scratch / "page.html").string();
  std::string rows = "# manoeuvre = \"passage\"\ntime_s,psi_rad,delta_rad\n";
  for (int i = 0; i < 400; ++i) rows += fmt::format("{},{},0.1\n", i, i / 100 % 2 ? 0.3 : 0.0);
  std::ofstream(passage) << rows;
  const auto both = run(scratch, "trial " + zigzag + " " + passage + " --json --report " + page);
  CHECK(both.code == 0);
  CHECK_THAT(both.err, ContainsSubstring("passage.csv"));
  CHECK_THAT(both.err, ContainsSubstring("the other runs are judged without it"));
  const auto told = nlohmann::json::parse(both.out);
  CHECK(told["runs"].size() == 1);
  CHECK(told["not_judged"].size() == 1);
  CHECK_THAT(read_text(page), ContainsSubstring("Not judged: "));
  CHECK_THAT(refusal("trial " + passage), ContainsSubstring("which manoeuvre this is cannot be told"));
}

TEST_CASE("trial tells a simulated turn the numbers that simulate told", "[app][round-trip]") {
  const Scratch scratch;
  const auto file = (scratch / "turn.csv").string();
  const auto said = document("simulate " + kvlcc2_l7 + " --turn 35 --duration 260 --first port --out " + file);
  const auto json = document("trial " + file + " --length 7");
  const auto& told = json["runs"][0];
  CHECK(told["first"] == "port");
  CHECK(told["lengths"] == "corrected");
  for (const char* key : {"advance_m", "transfer_m", "tactical_diameter_m", "final_diameter_m", "time_90_s",
                          "time_180_s", "final_speed_m_s"}) {
    INFO(key);
    CHECK_THAT(value(told[key]), WithinRel(said[key].get<double>(), 3e-3));
  }
  CHECK(value(told["current"]["speed_m_s"]) < 2e-3);
  CHECK(told["simulated"].is_null());
}

TEST_CASE("a file with the wrong sign of the rudder is told so, with the line to add", "[app]") {
  const Scratch scratch;
  auto text = read_text(zigzag);
  text = std::regex_replace(text, std::regex("rudder_positive = \"port\""), "rudder_positive = \"starboard\"");
  write_text(scratch / "wrong.csv", text);
  const auto outcome = run(scratch, "trial " + (scratch / "wrong.csv").string());
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("the ship turns against her rudder: rudder_positive may be wrong"));
}

TEST_CASE("several runs give a table each, one verdict and one page", "[app]") {
  const Scratch scratch;
  const auto page = scratch / "page.html";
  const auto outcome =
      run(scratch, "trial " + zigzag + " " + turn + " --ship " + kvlcc2_l7 + " --report " + page.string());
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("overshoot 1, starboard"));
  CHECK_THAT(outcome.out, ContainsSubstring("tactical diameter"));
  CHECK_THAT(outcome.out,
             ContainsSubstring("MSC.137(76): no criterion is failed; not told by these runs: first_overshoot_20_20"));
  const auto html = read_text(page);
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK_THAT(html, ContainsSubstring("showTrial"));
}

TEST_CASE("trial refuses in one line what is no manoeuvre", "[app][refusal]") {
  const Scratch scratch;
  write_text(scratch / "short.csv", "time_s,psi_deg,delta_deg\n0,0,0\n1,0,0\n");
  CHECK_THAT(refusal("trial " + (scratch / "short.csv").string()), ContainsSubstring("too short: 2 headings"));
  std::string still = "# manoeuvre = \"zigzag 10/10\"\ntime_s,psi_deg,delta_deg\n";
  for (int i = 0; i < 50; ++i) still += std::to_string(i) + ",0." + std::to_string(i % 3) + ",0\n";
  write_text(scratch / "still.csv", still);
  CHECK_THAT(refusal("trial " + (scratch / "still.csv").string()),
             ContainsSubstring("the rudder moves by no more than"));
  CHECK_THAT(refusal("trial " + (scratch / "none.csv").string()), ContainsSubstring("none.csv"));
  refusal("trial " + zigzag + " --length -3", 2);
}

}  // namespace
}  // namespace swayaw
