#include <array>
#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "program.hpp"

/// `swayaw forces`, `swayaw linearize` and forces along a run, from the outside.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

const std::string tanker = test::ship_file("kvlcc2_l7.toml");
const std::string wpcc = (test::ships / "wpcc_pi.toml").string();
const std::string mariner = test::ship_file("mariner.toml");

// ---------------------------------------------------------------- forces

TEST_CASE("forces by part add up to the total", "[app]") {
  const auto found = document("forces " + tanker + " --state u=1.0,v=0.1,r=-0.02,delta=0.1,rev=11");
  for (const char* axis : {"X", "Y", "N"}) {
    double sum = 0.0;
    for (const auto& [name, part] : found.at("parts").items()) sum += part.at(axis).get<double>();
    CHECK(sum == Approx(found.at("total").at(axis).get<double>()).epsilon(1e-13));
  }
  CHECK(found.at("parts").size() == 4);
  CHECK(found.at("parts").contains("rudder_hull_interaction"));
  CHECK(found.at("acceleration").at("r") != 0.0);
}

TEST_CASE("the same thrust is the same force, whether by shaft speed or given", "[app][second-route]") {
  const auto by_rev = document("forces " + tanker + " --state u=1.0,v=0.1,delta=0.1,rev=11");
  const double thrust = by_rev.at("parts").at("propeller").at("X").get<double>() / (1.0 - 0.22);
  const auto given = document("forces " + tanker + " --state u=1.0,v=0.1,delta=0.1,thrust=" + std::to_string(thrust));
  const auto sides =
      document("forces " + tanker + " --state u=1.0,v=0.1,delta=0.1,thrust_port=" + std::to_string(thrust) +
               ",thrust_starboard=0");
  for (const auto* other : {&given, &sides})
    CHECK(other->at("total").at("N").get<double>() == Approx(by_rev.at("total").at("N").get<double>()).epsilon(1e-6));
}

TEST_CASE("a state that makes no sense is refused in words", "[app][refusal]") {
  const auto forces = [](const std::string& state) { return refusal("forces " + tanker + " --state " + state); };
  CHECK_THAT(forces("v=0.1"), ContainsSubstring("--state: u is missing"));
  CHECK_THAT(forces("u=1,w=2"), ContainsSubstring("w is not known (known: u, v, r"));
  CHECK_THAT(forces("u=1,v"), ContainsSubstring("\"v\" is not of the form key=number"));
  CHECK_THAT(forces("u=1,v=fast"), ContainsSubstring("v must be a number, got \"fast\""));
  CHECK_THAT(forces("u=1,u=2"), ContainsSubstring("u is given twice"));
  CHECK_THAT(forces("u=1,rev=3,thrust=4"), ContainsSubstring("give one of rev, thrust"));
  CHECK_THAT(forces("u=1,thrust_port=3"), ContainsSubstring("thrust_port and thrust_starboard go together"));
  CHECK_THAT(forces("u=-1"), ContainsSubstring("way ahead, not for u = -1 m/s"));
}

TEST_CASE("forces stand beside the samples of a simulation and a replay", "[app]") {
  const Scratch scratch;
  const auto file = (scratch / "z.csv").string(), again = (scratch / "r.csv").string();
  REQUIRE(run(scratch, "simulate " + tanker + " --zigzag 10/10 --forces --out " + file).code == 0);
  REQUIRE(run(scratch, "replay " + tanker + " " + file + " --forces --out " + again).code == 0);
  for (const auto& path : {file, again}) {
    const auto text = read_text(path);
    CHECK_THAT(text, ContainsSubstring("X_hull_N,Y_hull_N,N_hull_N_m,X_propeller_N"));
    CHECK_THAT(text, ContainsSubstring("N_rudder_N_m"));
  }
}

// ---------------------------------------------------------------- linearize

TEST_CASE("linearize gives the keys of indices, and parts that add up to the whole", "[app]") {
  for (const auto& ship : {tanker, mariner}) {
    const auto found = document("linearize " + ship);
    for (const char* key : {"a1", "b1", "c1", "a2", "b2", "c2"}) {
      double sum = 0.0;
      for (const auto& [name, part] : found.at("parts").items()) sum += part.at(key).get<double>();
      CHECK(sum == Approx(found.at(key).get<double>()).epsilon(1e-12));
    }
    for (const char* key : {"T1", "T2", "T3b", "T3w", "Kb", "Kw", "T_b", "T_w", "stable", "complex_poles",
                            "dimensional", "sname", "operating_point"})
      CHECK(found.contains(key));
  }
}

TEST_CASE("linearize tells both sides where they differ, and their mean", "[app]") {
  const auto found = document("linearize " + tanker);
  CHECK(found.at("a1").get<double>() ==
        Approx(0.5 * (found.at("port").at("a1").get<double>() + found.at("starboard").at("a1").get<double>())));
  CHECK(found.at("port").at("stable") == false);
  CHECK(found.at("starboard").at("stable") == true);
  CHECK_FALSE(document("linearize " + tanker + " --side port").contains("port"));
  for (const auto& ship : {mariner, wpcc}) CHECK_FALSE(document("linearize " + ship).contains("port"));
}

TEST_CASE("a ship is linearized in a steady turn, and refused where she has none or cannot be driven so", "[app]") {
  const auto turn = document("linearize " + tanker + " --rudder -20");
  CHECK(turn.at("operating_point").at("r_rad_s") > 0.0);
  CHECK(turn.at("operating_point").at("delta_rad").get<double>() == Approx(-0.34906585));
  CHECK_THAT(refusal("linearize " + mariner + " --rev 2"), ContainsSubstring("neither shaft speed nor thrust"));
  CHECK_THAT(refusal("simulate " + mariner + " --turn 20 --thrust 1e6"),
             ContainsSubstring("neither shaft speed nor thrust"));
  CHECK_THAT(refusal("forces " + wpcc + " --state u=1,rev=2"), ContainsSubstring("give a thrust"));
  CHECK_THAT(refusal("linearize " + mariner + " --speed 2"), ContainsSubstring("and at no other"));
  CHECK_THAT(refusal("linearize " + test::ship_file("tanker97.toml")), ContainsSubstring("this ship is linear"));
}

}  // namespace
}  // namespace swayaw
