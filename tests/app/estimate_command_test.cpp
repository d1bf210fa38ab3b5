#include <catch.hpp>
#include <nlohmann/json.hpp>

#include "program.hpp"

/// swayaw estimate from the outside.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

const std::string kcs = "--length 230 --beam 32.2 --draught 10.8 --block 0.651 --speed 12.35";

std::string estimate_words(const Scratch& scratch, const std::string& options = kcs) {
  return "estimate " + options + " --out " + (scratch / "ship.toml").string();
}

TEST_CASE("estimate names everything that is missing at once", "[app][refusal]") {
  const auto nothing = refusal("estimate", 2);
  for (const char* option : {"--length", "--beam", "--draught", "--block", "--out"})
    CHECK_THAT(nothing, ContainsSubstring(option));
  CHECK_THAT(nothing, ContainsSubstring("missing: "));
  const auto one = refusal("estimate --length 100 --beam 15 --draught 6 --out x.toml", 2);
  CHECK_THAT(one, ContainsSubstring("missing: --block"));
  CHECK_FALSE(one.find("--beam") != std::string::npos);
}

TEST_CASE("estimate refuses craft that no model here is for by name, before anything else", "[app][refusal]") {
  CHECK_THAT(refusal("estimate --azimuth"),
             ContainsSubstring("--azimuth: an azimuth drive steers by turning its thrust"));
  CHECK_THAT(refusal("estimate --ship-type 'podded ferry'"), ContainsSubstring("--ship-type podded ferry"));
  const Scratch scratch;
  for (const char* type : {"catamaran", "speed_boat", "sailing yacht"})
    CHECK_THAT(refusal(estimate_words(scratch, kcs + " --ship-type '" + type + "'")), ContainsSubstring(type));
  CHECK_THAT(refusal(estimate_words(scratch, kcs + " --ship-type liner")),
             ContainsSubstring("\"liner\" is not known; known are tanker, "));
  CHECK_THAT(refusal(estimate_words(scratch, kcs + " --screws 2")), ContainsSubstring("outside their races"));
  CHECK_THAT(refusal(estimate_words(scratch, "--length 30 --beam 180 --draught 10 --block 0.7")),
             ContainsSubstring("the length must be more than the beam"));
  CHECK_THAT(refusal(estimate_words(scratch, kcs + " --depth 9")), ContainsSubstring("--depth 9 m"));
  CHECK_FALSE(std::filesystem::exists(scratch / "ship.toml"));
}

TEST_CASE("the file that estimate writes has its assumptions and spread and is taken by other commands",
          "[app][round-trip]") {
  const Scratch scratch;
  const auto json = document(estimate_words(scratch));
  const auto text = read_text(scratch / "ship.toml");
  for (const auto& line : json["assumptions"]) CHECK_THAT(text, ContainsSubstring("#   " + line.get<std::string>()));
  CHECK_THAT(text, ContainsSubstring("[confidence]\n"));
  for (const auto& c : json["coefficients"])
    if (c["relative_deviation"] > 0.1) CHECK_THAT(text, ContainsSubstring("\n" + c["key"].get<std::string>() + " = "));
  const auto ship = (scratch / "ship.toml").string();
  const auto linear = document("linearize " + ship);
  CHECK(linear["Kw"] == json["indices"]["Kw"]);
  CHECK(document("indices " + ship)["to_starboard"] == json["indices"]["to_starboard"]);
  CHECK(document("simulate " + ship + " --imo")["criteria"].size() == 2 * json["criteria"].size());
  CHECK(document("forces " + ship + " --state u=10,v=1,r=0.01,delta=0.1").contains("parts"));
  CHECK(document("loop " + ship + " --zigzag 10/10").contains("area"));
}

TEST_CASE("estimate says in its text what was assumed, how the ship steers, and what to do next", "[app]") {
  const Scratch scratch;
  const auto outcome = run(scratch, estimate_words(scratch, "--length 230 --beam 32.2 --draught 10.8 --block 0.651"));
  CHECK(outcome.code == 0);
  for (const char* words : {"service speed 8.074 m/s: Froude number 0.17", "wake fraction w_P0 = 0.2755",
                            "K' = ", "MSC.137(76)", "2 formulas; ", "swayaw trial RUN.csv", "swayaw identify RUN.csv"})
    CHECK_THAT(outcome.out, ContainsSubstring(words));
}

TEST_CASE("estimate makes a twin-screw ship with windage and says so in the file", "[app]") {
  const Scratch scratch;
  const auto json = document(estimate_words(
      scratch, kcs + " --screws 2 --rudders 2 --ship-type container --depth 19 --superstructure-length 30 "
                     "--superstructure-height 25 --superstructure-x -60 --length-over-all 240"));
  const auto text = read_text(scratch / "ship.toml");
  CHECK_THAT(text, ContainsSubstring("two screws that turn together stand as one propeller"));
  CHECK_THAT(text, ContainsSubstring("two rudders that turn together stand as one"));
  CHECK_THAT(text, ContainsSubstring("\n[windage]\n"));
  CHECK_THAT(text, ContainsSubstring("lateral_area_m2 = 2718"));  // 240 · 8.2 + 30 · 25
  CHECK_THAT(text, ContainsSubstring("transverse_drag = 0.9\n"));
  write_text(scratch / "windy.toml",
             text + "\n[[effect]]\nkind = \"steady_wind\"\nwind_speed_m_s = 10.0\nwind_from_rad = 1.5\n");
  CHECK(document("simulate " + (scratch / "windy.toml").string() + " --straight 0").contains("helm_rad"));
}

TEST_CASE("estimate warns of what lies outside the formulas and makes the ship all the same", "[app]") {
  const Scratch scratch;
  const auto outcome =
      run(scratch, estimate_words(scratch, "--length 100 --beam 30 --draught 6 --block 0.7 --speed 12"));
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.err, ContainsSubstring("L/B = 3.333 lies outside 4.5 to 8"));
  CHECK_THAT(outcome.err, ContainsSubstring("Froude number 0.383 lies outside"));
  CHECK_THAT(read_text(scratch / "ship.toml"), ContainsSubstring("# Outside what the formulas are for: L/B = 3.333"));
  const auto model =
      run(scratch, estimate_words(scratch, "--length 7 --beam 1.27 --draught 0.46 --block 0.8 --speed 1.18"));
  CHECK_THAT(model.err, ContainsSubstring("rate_deg_s in [rudder]"));
  const auto in_kN = run(scratch, estimate_words(scratch, kcs + " --resistance 1500"));
  CHECK(in_kN.code == 0);
  CHECK_THAT(in_kN.err, ContainsSubstring("times the estimate without waves; newtons are meant"));
}

}  // namespace
}  // namespace swayaw
