#include <catch.hpp>
#include <nlohmann/json.hpp>

#include "program.hpp"

/// swayaw tune from the outside.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

const std::string nawigator = test::ship_file("nawigator_ym.toml");
const std::string turns = (test::example_recordings.parent_path() / "indices" / "nawigator_turns.toml").string();

std::string tune_words(const Scratch& scratch, const std::string& more = "") {
  return "tune " + nawigator + " --indices " + turns + " --out " + (scratch / "new.toml").string() + more;
}

TEST_CASE("tune tells errors, numbers, indices, combinations and sensitivities as JSON", "[app]") {
  const Scratch scratch;
  const auto json = document(tune_words(scratch, " --prior 1 --bound 1"));
  CHECK(json["status"] == "converged");
  CHECK_THAT(json["error"]["turns"]["before"].get<double>(), WithinRel(0.338377, 1e-5));
  CHECK(json["error"]["turns"]["after"] < 0.15);
  CHECK(json["error"]["zigzags"]["after"] == 0.0);
  CHECK(json["voyages"]["turns"] <= 300);
  CHECK(json["numbers"].size() == 16);
  CHECK(json["indices"].size() == 18);
  CHECK(json["determined_combinations"] == 7);
  CHECK(json["combinations"].size() == 16);
  CHECK(json["sensitivity"]["numbers"].size() == 16);
  CHECK(json["sensitivity"]["exact"].size() == 18);
  CHECK(json["sensitivity"]["ten_per_cent"][0].size() == 16);
}

TEST_CASE("the ship file that tune writes does what tune says", "[app][round-trip]") {
  const Scratch scratch;
  const auto json = document(tune_words(scratch));
  const auto text = read_text(scratch / "new.toml");
  CHECK(text.starts_with("# Made by swayaw "));
  CHECK_THAT(text, ContainsSubstring("nawigator_ym.toml and the indices of nawigator_turns.toml"));
  const auto circle = document("simulate " + (scratch / "new.toml").string() + " --turn 35 --rev 3.7 --speed 5.91");
  CHECK_THAT(circle["advance_m"].get<double>() / 56.85, WithinRel(json["indices"][4]["after"].get<double>(), 1e-8));
  CHECK_THAT(circle["final_diameter_m"].get<double>() / 56.85,
             WithinRel(json["indices"][3]["after"].get<double>(), 1e-8));
}

TEST_CASE("tune changes the numbers it is told and no other", "[app]") {
  const Scratch scratch;
  const auto json = document(tune_words(scratch, " --numbers N_v,rudder.a_H"));
  REQUIRE(json["numbers"].size() == 2);
  CHECK(json["numbers"][1]["name"] == "a_H");
  CHECK_THAT(read_text(scratch / "new.toml"), ContainsSubstring("N_r = -0.0457\n"));
}

TEST_CASE("tune tells its tables in words", "[app]") {
  const Scratch scratch;
  const auto outcome = run(scratch, tune_words(scratch));
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  for (const char* words : {"turn 35 to starboard", "Y_vrr", "undetermined", "determine 7 of 16 combinations",
                            "sum of squared relative errors: turns 0.3384 before"})
    CHECK_THAT(outcome.out, ContainsSubstring(words));
}

TEST_CASE("tune refuses bad indices with their place, and writes nothing", "[app][refusal]") {
  const Scratch scratch;
  const auto file = (scratch / "bad.toml").string(), out = (scratch / "new.toml").string();
  write_text(scratch / "bad.toml", "[[turn]]\nrudder_deg = 35\nadvance_L = \"three\"\n");
  CHECK_THAT(refusal("tune " + nawigator + " --indices " + file + " --out " + out),
             ContainsSubstring(file + ":3:13: advance_L must be a number"));
  write_text(scratch / "bad.toml", "[[turn]]\nrudder_deg = 50\nadvance_L = 3\n");
  CHECK_THAT(refusal("tune " + nawigator + " --indices " + file + " --out " + out),
             ContainsSubstring("beyond the ship's largest"));
  CHECK_THAT(refusal("tune " + nawigator + " --indices " + turns + " --numbers N_q --out " + out),
             ContainsSubstring("N_q"));
  CHECK_THAT(refusal("tune " + test::ship_file("nawigator_n7.toml") + " --indices " + turns + " --out " + out),
             ContainsSubstring("no steady turn was found"));
  CHECK_THAT(refusal("tune " + test::ship_file("tanker97.toml") + " --indices " + turns + " --out " + out),
             ContainsSubstring("linear"));
  CHECK_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace swayaw
