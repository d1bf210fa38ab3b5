#include "swayaw/identification/measured_indices.hpp"

#include <catch.hpp>
#include <string>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"

namespace swayaw {
namespace {

constexpr double L = 100.0;

const std::string turn = "[[turn]]\nrudder_deg = 35\n";
const std::string zigzag = "[[zigzag]]\nrudder_deg = 10\nheading_deg = 20\n";

std::string trouble(const std::string& text) {
  try {
    parse_indices(text, "indices.toml", L);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

TEST_CASE("an index is the same in every unit that the file may use", "[identification][round-trip]") {
  const std::pair<std::string, std::string> same[] = {
      {"advance_m = 310", "advance_L = 3.1"},
      {"final_speed_m_s = 5.144444444444445", "final_speed_kn = 10"},
      {"final_yaw_rate_rad_s = 0.017453292519943295", "final_yaw_rate_deg_s = 1"},
      {"final_drift_deg = 10", "final_drift_rad = 0.17453292519943295"},
  };
  for (const auto& [a, b] : same) {
    const auto x = parse_indices(turn + a, "a", L).trials[0].indices[0],
               y = parse_indices(turn + b, "b", L).trials[0].indices[0];
    INFO(a);
    CHECK(x.place == y.place);
    CHECK_THAT(x.value, WithinRel(y.value, 1e-14));
    CHECK_THAT(x.deviation, WithinRel(y.deviation, 1e-14));
  }
}

TEST_CASE("tolerances are taken from the index, the manoeuvre, the file, or are one in twenty",
          "[identification][limit]") {
  const auto deviation = [](const std::string& text) {
    return parse_indices(text, "a", L).trials[0].indices[0].deviation;
  };
  CHECK_THAT(deviation(turn + "advance_m = 200"), WithinRel(10.0, 1e-14));
  CHECK_THAT(deviation("tolerance = 0.1\n" + turn + "advance_m = 200"), WithinRel(20.0, 1e-14));
  CHECK_THAT(deviation("tolerance = 0.1\n" + turn + "tolerance = 0.2\nadvance_m = 200"), WithinRel(40.0, 1e-14));
  CHECK_THAT(deviation(turn + "tolerance = 0.2\nadvance_L = { value = 2, sd = 0.03 }"), WithinRel(3.0, 1e-14));
  CHECK_THAT(deviation(turn + "final_v_m_s = -2"), WithinRel(0.1, 1e-14));
}

TEST_CASE("overshoots are counted from the first peak, or from the one that the file names",
          "[identification][limit]") {
  const auto from_first =
      parse_indices(zigzag + "overshoot_deg = [5, { value = 7, sd = 1 }]", "a", L).trials[0].indices;
  CHECK(ZigzagIndices<>::parameters()[from_first[0].place].key == "overshoot[0]");
  CHECK(from_first[1].name == "overshoot_deg 2");
  CHECK_THAT(from_first[1].deviation, WithinRel(radians(1.0), 1e-14));
  const auto from_second =
      parse_indices(zigzag + "first_peak = 2\novershoot_deg = [5, 7]\nperiod_s = 100", "a", L).trials[0].indices;
  CHECK(ZigzagIndices<>::parameters()[from_second[1].place].key == "overshoot[2]");
  CHECK(ZigzagIndices<>::parameters()[from_second[2].place].key == "period");
}

TEST_CASE("the measured indices of MV Nawigator XXI are those of the paper", "[identification][published]") {
  const auto measured =
      read_indices(std::filesystem::path(SWAYAW_TEST_EXAMPLES).parent_path() / "indices" / "nawigator.toml", 56.85);
  CHECK(measured.speed == 5.91);
  CHECK(measured.rev == 3.7);
  REQUIRE(measured.trials.size() == 4);
  CHECK(name_of(measured.trials[0].manoeuvre) == "turn 35 to starboard");
  CHECK(name_of(measured.trials[3].manoeuvre) == "zigzag 10/20 first starboard");
  for (int t = 0; t < 3; ++t) CHECK(measured.trials[static_cast<std::size_t>(t)].indices.size() == 6);
}

TEST_CASE("a bad file of indices is refused with its place", "[identification][refusal]") {
  const std::pair<std::string, std::string> cases[] = {
      {"", "indices.toml:1:1: there is neither a [[turn]] nor a [[zigzag]]"},
      {"tolerance = = 1\n" + turn, "indices.toml:1:"},
      {"tolerance = 0\n" + turn + "advance_m = 200\n", "indices.toml:1:13: tolerance must be positive, got 0"},
      {"speed_m_s = \"5\"\n" + turn + "advance_m = 200\n", "indices.toml:1:13: speed_m_s must be a number"},
      {"rev_s = 1\nthrust_N = 2\n" + turn + "advance_m = 200\n", "indices.toml:2:12: thrust_N is given beside rev_s"},
      {"knots = 5\n" + turn + "advance_m = 200\n", "indices.toml:1:1: knots is not known"},
      {"[turn]\nrudder_deg = 35\nadvance_m = 2\n", "indices.toml:1:1: turns are written as [[turn]] tables"},
      {"[[turn]]\nadvance_m = 200\n", "indices.toml:1:1: rudder_deg is missing in [[turn]]"},
      {turn + "side = \"left\"\nadvance_m = 200\n", "indices.toml:3:8: side must be \"port\" or \"starboard\""},
      {turn + "advance_ft = 200\n", "indices.toml:3:1: advance_ft in [[turn]] is not known"},
      {turn, "indices.toml:1:1: [[turn]] has no index"},
      {turn + "advance_m = 0\n", "indices.toml:3:13: advance_m must not be 0, got 0"},
      {turn + "final_yaw_rate_rad_s = -0.01\n", "indices.toml:3:24: final_yaw_rate_rad_s must be positive, got -0.01"},
      {turn + "advance_m = 200\nadvance_L = 2\n", "is given twice, in two units"},
      {turn + "advance_m = [200]\n", "indices.toml:3:13: advance_m must be a number"},
      {turn + "advance_m = { value = 200, sd = 0 }\n", "indices.toml:3:33: sd must be positive, got 0"},
      {turn + "advance_m = { sd = 2 }\n", "indices.toml:3:13: value is missing in advance_m"},
      {turn + "advance_m = { value = 200, weight = 2 }\n", "indices.toml:3:28: weight in advance_m is not known"},
      {"[[zigzag]]\nrudder_deg = 10\novershoot_deg = [5]\n", "heading_deg is missing in [[zigzag]]"},
      {zigzag + "overshoot_deg = 5\n", "indices.toml:4:17: overshoot_deg must be a list of numbers"},
      {zigzag + "overshoot_deg = []\n", "overshoot_deg must be a list of numbers"},
      {zigzag + "overshoot_deg = [5, -1]\n", "indices.toml:4:21: overshoot_deg must be positive, got -1"},
      {zigzag + "overshoot_deg = [1, 2, 3, 4, 5]\n", "goes beyond the 4 heading peaks"},
      {zigzag + "first_peak = 4\novershoot_deg = [1, 2]\n", "goes beyond the 4 heading peaks"},
      {zigzag + "first_peak = 1.5\novershoot_deg = [1]\n",
       "indices.toml:4:14: first_peak must be a whole number from 1 to 4"},
  };
  for (const auto& [text, what] : cases) {
    INFO(text);
    CHECK_THAT(trouble(text), ContainsSubstring(what));
  }
  CHECK_THROWS_AS(read_indices("no_such_file.toml", L), FileError);
}

}  // namespace
}  // namespace swayaw
