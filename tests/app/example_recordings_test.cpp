#include <catch.hpp>
#include <cmath>
#include <cstdlib>

#include "files.hpp"
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

}  // namespace
}  // namespace swayaw
