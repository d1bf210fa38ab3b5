#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"

/// `swayaw simulate` with spirals, pull-outs, the Williamson turn and the IMO criteria, from the outside.
namespace swayaw {
namespace {

using nlohmann::json;
using test::lines;
using test::run;
using test::Scratch;

const std::string simulate_kvlcc2 = "simulate " + (test::ships / "kvlcc2.toml").string();

json document(const Scratch& scratch, const std::string& manoeuvre) {
  const auto outcome = run(scratch, simulate_kvlcc2 + " " + manoeuvre + " --json");
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  return test::json_of(outcome.out);
}

/// Whether each list of the object is as long as the first.
bool same_length(const json& lists) {
  for (const auto& list : lists)
    if (list.size() != lists.front().size()) return false;
  return true;
}

TEST_CASE("a spiral is printed as columns for both ways, with the curve of steady turns", "[app]") {
  const Scratch scratch;
  const auto out = (scratch / "spiral.csv").string();
  const auto spiral = document(scratch, "--spiral --first port --out " + out);
  CHECK(spiral.at("manoeuvre") == "spiral 25");
  CHECK(spiral.at("first") == "port");
  for (const char* way : {"down", "up"}) {
    CHECK(spiral.at(way).at("delta_rad").size() == 11);
    CHECK(same_length(spiral.at(way)));
    CHECK(spiral.at(way).at("settled").front().is_boolean());
  }
  CHECK(spiral.at("down").at("r_rad_s").front().get<double>() < 0.0);
  CHECK(same_length(spiral.at("curve")));
  CHECK(spiral.at("instability_loop").at("width_rad").get<double>() > 0.0);
  CHECK(spiral.at("loop").at("height_rad_s").get<double>() > 0.0);
  CHECK(read_recording(out).recording.facts.manoeuvre == "spiral 25 first port");
  CHECK(document(scratch, "--spiral --rudder 10 --rudder-step 2").at("up").at("delta_rad").size() == 11);
}

TEST_CASE("a reverse spiral is printed as columns over the yaw rate", "[app]") {
  const Scratch scratch;
  const auto spiral = document(scratch, "--reverse-spiral");
  CHECK(spiral.at("r_rad_s").size() == 21);
  CHECK(spiral.at("delta_rad").size() == 21);
  CHECK(spiral.at("stable").size() == 21);
  CHECK(std::abs(spiral.at("delta_rad")[10].get<double>()) < 1e-9);
}

TEST_CASE("a pull-out is printed for both sides, and one of them written", "[app]") {
  const Scratch scratch;
  const auto out = (scratch / "pullout.csv").string();
  const auto pullout = document(scratch, "--pullout 20 --first port --out " + out);
  CHECK(pullout.at("manoeuvre") == "pullout 20");
  CHECK(pullout.at("port").at("turning_yaw_rate_rad_s").get<double>() < 0.0);
  CHECK(pullout.at("starboard").at("turning_yaw_rate_rad_s").get<double>() > 0.0);
  for (const char* side : {"port", "starboard"}) CHECK(pullout.at(side).at("residual_yaw_rate_rad_s").is_number());
  CHECK(read_recording(out).recording.facts.manoeuvre == "pullout 20 from port");
}

TEST_CASE("a Williamson turn is printed with the places of its orders", "[app]") {
  const Scratch scratch;
  const auto turn = document(scratch, "--williamson --first port");
  double before = 0.0;
  for (const char* place : {"shifted", "amidships", "reciprocal"}) {
    CHECK(turn.at(place).at("time_s").get<double>() > before);
    before = turn.at(place).at("time_s").get<double>();
    CHECK(turn.at(place).at("offset_m").is_number());
  }
  CHECK(turn.at("way_m").get<double>() > 0.0);
  CHECK(document(scratch, "--williamson --duration 300").at("reciprocal").is_null());
}

TEST_CASE("the IMO criteria are printed with value, limit and verdict for both sides", "[app]") {
  const Scratch scratch;
  const auto imo = document(scratch, "--imo");
  REQUIRE(imo.at("criteria").size() == 12);
  for (const auto& c : imo.at("criteria")) {
    CHECK(c.at("name").is_string());
    CHECK((c.at("unit") == "L" || c.at("unit") == "deg"));
    CHECK(c.at("pass").get<bool>() == (c.at("value").get<double>() <= c.at("limit").get<double>()));
  }
  CHECK(imo.at("not_simulated")[0] == "stopping");
  const auto text = run(scratch, simulate_kvlcc2 + " --imo");
  CHECK_THAT(text.out, ContainsSubstring("stopping is not simulated"));
  const auto model = run(scratch, "simulate " + (test::ships / "kvlcc2_l7.toml").string() + " --imo");
  CHECK_THAT(model.out, ContainsSubstring("ships of 100 m and more"));
}

TEST_CASE("zigzag and turning circle judge themselves by the criteria they concern", "[app]") {
  const Scratch scratch;
  const auto names = [&](const std::string& manoeuvre) {
    std::string all;
    const json criteria = document(scratch, manoeuvre).at("criteria");
    for (const auto& c : criteria) all += c.at("name").get<std::string>() + " ";
    return all;
  };
  CHECK(names("--zigzag 10/10") == "initial_turning first_overshoot_10_10 second_overshoot_10_10 ");
  CHECK(names("--zigzag 20/20") == "first_overshoot_20_20 ");
  CHECK(names("--zigzag 20/10").empty());
  CHECK(names("--turn 35") == "advance tactical_diameter ");
  CHECK(names("--turn 10") == "initial_turning ");
  const auto linear = test::json_of(
      run(scratch, "simulate " + (test::ships / "tanker97.toml").string() + " --zigzag 10/10 --json").out);
  REQUIRE(linear.at("criteria").size() == 3);
  CHECK(linear.at("criteria")[1].at("value") == linear.at("overshoot_deg")[0]);
}

TEST_CASE("a straight run tells the drift and the helm that keep a course in the wind of the ship file",
          "[app][symmetry]") {
  const Scratch scratch;
  const auto windy = [&](const std::string& name, double from) {
    const auto file = scratch / name;
    write_text(file, read_text(test::ships / "kvlcc2.toml") +
                         "\n[windage]\nfrontal_area_m2 = 1200\nlateral_area_m2 = 3700\nlength_over_all_m = 333\n" +
                         "\n[[effect]]\nkind = \"steady_wind\"\nwind_speed_m_s = 20\nwind_from_rad = " +
                         std::to_string(from) + "\n");
    return test::json_of(run(scratch, "simulate " + file.string() + " --straight 0 --json").out);
  };
  const auto starboard = windy("s.toml", 1.0), port = windy("p.toml", -1.0);
  CHECK(starboard.at("wind_force").at("Y") < 0.0);
  CHECK(starboard.at("holds") == true);
  CHECK(starboard.at("heading_rad") > 0.0);
  CHECK(std::abs(starboard.at("course_rad").get<double>()) < 1e-9);
  CHECK(std::abs(starboard.at("helm_rad").get<double>()) > 1e-3);
  CHECK(std::signbit(starboard.at("helm_rad").get<double>()) != std::signbit(port.at("helm_rad").get<double>()));
  const auto calm = test::json_of(run(scratch, simulate_kvlcc2 + " --straight 30 --json").out);
  CHECK(std::abs(calm.at("helm_rad").get<double>()) < 1e-9);
  CHECK(calm.at("heading_rad").get<double>() == Approx(radians(30)));
}

TEST_CASE("options that do not go together are wrong usage, told in one line", "[app][refusal]") {
  const Scratch scratch;
  const std::pair<std::string, std::string> cases[] = {
      {"--spiral --turn 35", "[--zigzag,--turn,"},
      {"--spiral --duration 100", "--duration excludes --spiral"},
      {"--reverse-spiral --out f.csv", "--out excludes --reverse-spiral"},
      {"--imo --first port", "--first excludes --imo"},
      {"--straight 10 --duration 100", "--duration excludes --straight"},
      {"--pullout 20 --duration 60", "--duration excludes --pullout"},
      {"--pullout 0", "--pullout"},
      {"--turn 35 --rudder 20", "--rudder: goes with --spiral"},
      {"--williamson --rudder-step 2", "--rudder-step: goes with --spiral"},
  };
  for (const auto& [arguments, hint] : cases) {
    INFO(arguments);
    const auto outcome = run(scratch, simulate_kvlcc2 + " " + arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(lines(outcome.err) == 1);
    CHECK_THAT(outcome.err, ContainsSubstring(hint));
  }
}

TEST_CASE("orders that a ship cannot follow end with code 1", "[app][refusal]") {
  const Scratch scratch;
  CHECK_THAT(run(scratch, simulate_kvlcc2 + " --pullout 36").err, ContainsSubstring("beyond the ship's largest"));
  CHECK(run(scratch, simulate_kvlcc2 + " --spiral --rudder 36").code == 1);
  CHECK(run(scratch, simulate_kvlcc2 + " --spiral --rudder-step 30").code == 1);
  const auto linear = run(scratch, "simulate " + (test::ships / "tanker97.toml").string() + " --spiral");
  CHECK(linear.code == 1);
  CHECK(lines(linear.err) == 1);
  CHECK_THAT(linear.err, ContainsSubstring("need a nonlinear ship"));
}

}  // namespace
}  // namespace swayaw
