#include <catch.hpp>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

/// Small motions as the program tells them: sides that differ, motions too large for them, motions that are not steady.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

TEST_CASE("indices of a ship whose sides differ give both, and the mean of their equations", "[app]") {
  const auto json = document("indices kvlcc2");
  for (const char* key : {"a1", "b1", "c1", "a2", "b2", "c2"}) {
    INFO(key);
    const double port = json["port"][key], starboard = json["starboard"][key];
    CHECK_THAT(json[key].get<double>(), WithinRel(0.5 * (port + starboard), 1e-9) || WithinAbs(0.0, 1e-12));
  }
  CHECK(json["port"]["a2"] != json["starboard"]["a2"]);
  CHECK(json["to_starboard"]["K"].get<double>() == -json["Kw"].get<double>());
  CHECK(json["to_starboard"]["T"] == json["T_w"]);
  const Scratch scratch;
  const auto text = run(scratch, "indices kvlcc2").out;
  for (const char* words :
       {"a kink straight ahead", "turning to port", "turning to starboard", "yaw rate by rudder to starboard"})
    CHECK_THAT(text, ContainsSubstring(words));
  CHECK_FALSE(document("indices " + test::ship_file("tanker97.toml")).contains("port"));
}

TEST_CASE("a linear ship that is asked for a large turn warns with the drift angle she reaches", "[app]") {
  const Scratch scratch;
  const auto tanker = test::ship_file("tanker97.toml");
  const auto large = run(scratch, "simulate " + tanker + " --turn 35");
  CHECK(large.code == 0);
  CHECK_THAT(large.err, ContainsSubstring("beyond 15 deg linear equations mean nothing"));
  CHECK(run(scratch, "simulate " + tanker + " --turn 2").err.empty());
}

std::string linearize_words(const std::string& ship, double thrust) {
  std::ostringstream words;
  words << "linearize " << ship << " --speed 0.8 --thrust " << std::setprecision(17) << thrust;
  return words.str();
}

TEST_CASE("linearize takes a speed and a thrust together, which need not balance", "[app][second-route]") {
  const auto ship = test::ship_file("wpcc_pi.toml");
  const auto steady = document("linearize " + ship + " --speed 0.8");
  const double thrust = steady["operating_point"]["thrust_N"];
  const auto same = document(linearize_words(ship, thrust));
  CHECK_THAT(same["a2"].get<double>(), WithinRel(steady["a2"].get<double>(), 1e-9));
  const auto racing = document(linearize_words(ship, 2.0 * thrust));
  CHECK(racing["operating_point"]["u_m_s"] == 0.8);
  CHECK(std::abs(racing["c2"].get<double>()) >
        std::abs(steady["c2"].get<double>()));  // the rudder works in a faster race
  CHECK_THAT(refusal(linearize_words(ship, thrust) + " --rudder 10"), ContainsSubstring("leave out --speed"));
}

}  // namespace
}  // namespace swayaw
