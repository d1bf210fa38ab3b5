#include <catch.hpp>
#include <cmath>
#include <cstdlib>

#include "program.hpp"
#include "swayaw/core/recording_csv.hpp"

namespace swayaw {
namespace {

TEST_CASE("the shipped recordings are those that examples/make_recordings makes", "[app][round-trip]") {
  const test::Scratch scratch;
  std::filesystem::create_directories(scratch / "made");
  const auto ship = test::ships / "kvlcc2_l7.toml";
  const std::string command =
      std::string(SWAYAW_MAKE_RECORDINGS) + " " + ship.string() + " " + (scratch / "made").string();
  REQUIRE(std::system(command.c_str()) == 0);
  for (const char* name : {"weak_rudder_zz10_10.csv", "weak_rudder_turn35.csv"}) {
    INFO(name);
    const auto shipped = read_recording(test::example_recordings / name).recording,
               made = read_recording(scratch / "made" / name).recording;
    REQUIRE(made.time == shipped.time);
    for (std::size_t c = 0; c < channel_count; ++c) {
      const auto channel = static_cast<Channel>(c);
      REQUIRE(made[channel].size() == shipped[channel].size());
      // another processor may round the last recorded digit the other way
      for (std::size_t i = 0; i < made[channel].size(); ++i)
        REQUIRE_THAT(made[channel][i], WithinAbs(shipped[channel][i], 1.1e-4));
    }
  }
}

/// "18 % less rudder force" as a number.
double less_rudder_force(const std::string& words) {
  const auto end = words.find(" % less rudder force");
  if (end == std::string::npos) return missing;
  return std::stod(words.substr(words.rfind(' ', end - 1) + 1));
}

/// What the ship file says of her rudder is 18 % too much in these recordings; examples/make_recordings.cpp.
constexpr double weaker = 18.0;

/// The two recordings, as a command is told them.
std::string both_runs() {
  return (test::example_recordings / "weak_rudder_zz10_10.csv").string() + " " +
         (test::example_recordings / "weak_rudder_turn35.csv").string();
}

TEST_CASE("diagnose tells the truth on the shipped recordings, first how far off the model is", "[app][published]") {
  const auto words =
      test::document("diagnose " + test::ship_file("kvlcc2_l7.toml") + " " + both_runs())["words"].get<std::string>();
  INFO(words);
  CHECK(words.starts_with("The yaw rate is off by 27 % of its variation as given"));
  CHECK_THAT(words, Catch::Contains("those of the rudder alone"));
  CHECK_THAT(words, Catch::Contains("No physics is missing"));
  CHECK(std::abs(less_rudder_force(words) - weaker) < 3.0);
}

TEST_CASE("runs in which the rudder was right leave no doubt that it is her rudder", "[app][published]") {
  const test::Scratch scratch;
  const auto ship = test::ship_file("kvlcc2_l7.toml"), reference = (scratch / "right20_20.csv").string(),
             turn = (scratch / "right35.csv").string();
  REQUIRE(test::run(scratch, "simulate " + ship + " --zigzag 20/20 --out " + reference).code == 0);
  REQUIRE(test::run(scratch, "simulate " + ship + " --turn 35 --out " + turn).code == 0);
  const auto answer = test::document("diagnose " + ship + " " + both_runs() + " --reference " + reference + " " + turn);
  const auto words = answer["words"].get<std::string>();
  INFO(words);
  CHECK(words.starts_with("The yaw rate is off by 27 % of its variation as given"));
  CHECK_THAT(words, Catch::Contains("numbers of the rudder are further off than was said"));
  CHECK(answer["baseline_shift"].size() > 0);
}

}  // namespace
}  // namespace swayaw
