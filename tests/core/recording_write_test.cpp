#include <catch.hpp>
#include <cmath>
#include <fstream>
#include <random>

#include "files.hpp"
#include "recording_text.hpp"
#include "swayaw/core/atomic_file.hpp"

/// What is written reads back the same.
namespace swayaw {
namespace {

using test::file_of;
using test::recording_of;

/// Numbers of every size, some missing.
double any_number(std::mt19937& random) {
  const int kind = static_cast<int>(random() % 8);
  if (kind == 0) return missing;
  if (kind == 1) return static_cast<double>(random() % 1000);
  const double mantissa = std::uniform_real_distribution(-1.0, 1.0)(random);
  return std::ldexp(mantissa, kind < 6 ? kind : static_cast<int>(random() % 2000) - 1000);
}

Recording random_recording(unsigned seed) {
  std::mt19937 random(seed);
  Recording run;
  run.name = "run.csv";
  for (double t = -5.0; run.time.size() < 40; t += std::uniform_real_distribution(1e-3, 1.0)(random))
    run.time.push_back(t);
  for (std::size_t i = 0; i < channel_count; ++i)
    for (double& value : run.fill(static_cast<Channel>(i))) value = any_number(random);
  for (double& psi : run.fill(Channel::psi)) psi = std::uniform_real_distribution(-1.5, 1.5)(random);
  run.fill(Channel::x)[0] = std::numeric_limits<double>::denorm_min();
  run.fill(Channel::x)[1] = std::numeric_limits<double>::max();
  run.fill(Channel::x)[2] = -0.0;
  return run;
}

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

void check_same(const Recording& a, const Recording& b) {
  CHECK(a.time == b.time);
  for (std::size_t i = 0; i < channel_count; ++i) {
    INFO(column_name(static_cast<Channel>(i)));
    CHECK(std::ranges::equal(a.channels[i], b.channels[i], same_bits));
  }
}

TEST_CASE("a written recording reads back bit for bit", "[core][round-trip]") {
  const test::Scratch scratch;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto run = random_recording(seed);
    const std::string file = seed % 2 == 0 ? "run.csv" : "run.mat";
    write_recording(run, scratch / file);
    const auto back = read_recording(scratch / file);
    CHECK(back.warnings.empty());
    CHECK(back.recording.name == file);
    check_same(run, back.recording);
  }
}

TEST_CASE("a recording in other units reads back bit for bit once it is SI", "[core][round-trip]") {
  const auto run = recording_of(
      "# rudder_positive = \"starboard\"\n# reference_x_m = 3.3\n"
      "time_s,lat_deg,lon_deg,psi_deg,ug_kn,vg_kn,sog_kn,cog_deg,r_deg_min,delta_deg,rev_rpm\n"
      "0,54.1,10.2,350,7.1,0.3,7.2,352,11,5,61\n"
      "2.5,54.10003,10.20001,10,7.1,0.3,7.2,11,12,-5,\n"
      "7.25,54.1001,10.20007,,7,0.2,7.1,33,12,-5,62\n"
      "9,54.1002,10.2001,190,7,0.2,7.1,33,12,-5,62\n");
  check_same(run, recording_of(recording_text(run)));
}

TEST_CASE("facts of the run survive writing", "[core][round-trip]") {
  Recording run = recording_of("time_s,psi_rad,delta_rad\n0,0,0\n");
  run.facts = {.manoeuvre = "turn \"35\" \\ in\nthe 'bay', 20° \t\x01", .execute = 1.0 / 3.0, .water_depth = 12.0};
  const auto facts = recording_of(recording_text(run)).facts;
  CHECK(facts.manoeuvre == run.facts.manoeuvre);
  CHECK(facts.execute == run.facts.execute);
  CHECK(facts.water_depth == run.facts.water_depth);
}

TEST_CASE("run keys of other programs survive writing", "[core][round-trip]") {
  std::string long_list = "[ 1";
  for (int i = 2; i < 60; ++i) long_list += ", " + std::to_string(i);
  const std::string keys =
      "# rudder_positive = \"port\"\n"
      "# facility = 'tank \"B\" \\ east'\n"
      "# draughts_m = " +
      long_list +
      " ]\n"
      "# \"sea state\" = { wave_m = 0.5, from = \"NE\" }\n"
      "# trial.date = 2020-07-31\n"
      "# trial.number = 4\n";
  const std::string text = keys + "time_s,psi_rad,delta_rad\n0,0,0\n";
  CHECK(recording_text(recording_of(text)).starts_with(keys));
}

TEST_CASE("columns that are not understood are written as they were", "[core][round-trip]") {
  const std::string text =
      "# rudder_positive = \"port\"\n"
      "time_s,psi_rad,delta_rad,utc,\"mast, \"\"top\"\"\",Größe\n"
      "0,0,0,13:04:24,1.50,\"a, b\"\n"
      "1,0,0,,nan,-\n";
  CHECK(recording_text(recording_of(text)) == text);
}

TEST_CASE("a recording that cannot be written leaves the old file", "[core][refusal]") {
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch / "run.csv");
  CHECK_THROWS_AS(write_recording(recording_of("time_s,psi_rad,delta_rad\n0,0,0\n"), scratch / "run.csv"), FileError);
  CHECK(std::filesystem::is_directory(scratch / "run.csv"));
}

}  // namespace
}  // namespace swayaw
