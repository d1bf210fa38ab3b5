#include <catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

/// swayaw check from the outside, and what other commands do with it.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

Recording zigzag_run() {
  const auto kvlcc2 = published_ship("kvlcc2_l7");
  return zigzag(kvlcc2, {radians(20), radians(20), Side::port}, {.step = 0.2}).run;
}

std::string written(const Recording& run, const Scratch& scratch, const std::string& name) {
  write_recording(run, scratch / name);
  return (scratch / name).string();
}

const std::string kvlcc2_l7 = test::ship_file("kvlcc2_l7.toml");

}  // namespace

TEST_CASE("check tells a gyro's zero, and the repaired recording has none", "[app][round-trip]") {
  const Scratch scratch;
  auto recorded = zigzag_run();
  for (double& r : recorded.fill(Channel::r)) r += radians(0.05);
  const auto file = written(recorded, scratch, "run.csv");
  const auto zero_of = [](const nlohmann::json& check) {
    for (const auto& e : check.at("runs").at(0).at("instruments"))
      if (e.at("channel") == "r" && e.at("error") == "zero") return e;
    return nlohmann::json();
  };
  const auto zero = zero_of(document("check " + file + " --json --out " + (scratch / "mended.csv").string()));
  CHECK(zero.at("told") == true);
  CHECK(std::abs(zero.at("value").get<double>() - radians(0.05)) < radians(0.001));
  CHECK(zero.at("unit") == "rad/s");
  CHECK(zero_of(document("check " + (scratch / "mended.csv").string() + " --json")).at("told") == false);
}

TEST_CASE("a reversed rudder is refused with its remedy before any number is shown", "[app][refusal]") {
  const Scratch scratch;
  auto reversed = zigzag_run();
  for (double& delta : reversed.fill(Channel::delta)) delta = -delta;
  const auto file = written(reversed, scratch, "reversed.csv");
  for (const std::string& command :
       {"compare " + kvlcc2_l7 + " " + file, "diagnose " + kvlcc2_l7 + " " + file,
        "identify " + file + " --ship " + kvlcc2_l7 + " --model mmg --out " + (scratch / "new.toml").string()}) {
    INFO(command);
    CHECK(refusal(command).find("--rudder-positive") != std::string::npos);
  }
  CHECK(!std::filesystem::exists(scratch / "new.toml"));
  CHECK(run(scratch, "compare " + kvlcc2_l7 + " " + file + " --rudder-positive starboard").code == 0);
  CHECK(run(scratch, "compare " + kvlcc2_l7 + " " + file + " --no-check").code == 0);
}

TEST_CASE("units that are not those of the column are refused with their names", "[app][refusal]") {
  const Scratch scratch;
  auto in_knots = zigzag_run();
  for (const Channel c : {Channel::u, Channel::v})
    for (double& value : in_knots.fill(c)) value *= 3600.0 / 1852.0;
  CHECK(refusal("compare " + kvlcc2_l7 + " " + written(in_knots, scratch, "knots.csv")).find("in kn") !=
        std::string::npos);
  auto to_port = zigzag_run();
  for (double& y : to_port.fill(Channel::y)) y = -y;
  CHECK(refusal("compare " + kvlcc2_l7 + " " + written(to_port, scratch, "port.csv")).find("to port") !=
        std::string::npos);
}

TEST_CASE("the page of a check is written, and --out asks for one recording", "[app]") {
  const Scratch scratch;
  const auto file = written(zigzag_run(), scratch, "run.csv");
  const auto page = (scratch / "page.html").string();
  CHECK(run(scratch, "check " + file + " --report " + page).code == 0);
  CHECK(std::filesystem::file_size(page) > 100000);
  CHECK(run(scratch, "check " + file + " " + file + " --out " + page).code == 2);
}

}  // namespace swayaw
