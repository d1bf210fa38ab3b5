#include <catch.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// swayaw identify from the outside.
namespace swayaw {
namespace {

using test::document;
using test::refusal;
using test::run;
using test::Scratch;

/// Zigzags of a published ship with noisy instruments, written to files; their names in one line.
std::string recordings_of(const Ship& ship, const Scratch& scratch, double noise = 1.0) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  const double L = length(ship), U = service_speed(ship);
  std::string names;
  for (const auto& [rudder, side] : {std::pair{10.0, Side::starboard}, {20.0, Side::port}}) {
    auto recording = zigzag(ship, {radians(rudder), radians(rudder), side}, {.step = 0.03 * L / U}).run;
    const auto add = [&](Channel c, double deviation) {
      std::vector<double> truth(recording[c].begin(), recording[c].end());
      auto column = recording.fill(c);
      for (std::size_t i = 0; i < column.size(); ++i) column[i] = truth[i] + noise * deviation * normal(engine);
    };
    add(Channel::x, 1e-3 * L), add(Channel::y, 1e-3 * L), add(Channel::psi, 1e-3), add(Channel::r, 3e-3 * U / L);
    add(Channel::u, 5e-3 * U), add(Channel::v, 5e-3 * U);
    const auto file = scratch / ("zz" + std::to_string(static_cast<int>(rudder)) + ".csv");
    write_recording(recording, file);
    names += file.string() + " ";
  }
  return names;
}

/// Her file with hull derivatives that are a fifth off.
std::string start_file(const Ship& ship, const Scratch& scratch, const std::vector<std::string>& names) {
  const auto parameters = parameters_of(ship, names);
  std::vector<double> values;
  for (const auto& n : parameters) values.push_back(1.2 * n.value);
  write_ship(scratch / "start.toml", with_values(ship, parameters, values));
  return (scratch / "start.toml").string();
}

const std::vector<std::string> linear_hull{"Y_v", "Y_r", "N_v", "N_r"};

}  // namespace

TEST_CASE("identify finds the hull of a simulated ship from noisy zigzags and writes her file", "[app][round-trip]") {
  const Scratch scratch;
  const auto truth = published_ship("kvlcc2_l7");
  const auto out = (scratch / "new.toml").string();
  const auto json =
      document("identify " + recordings_of(truth, scratch) + "--ship " + start_file(truth, scratch, linear_hull) +
               " --model mmg --find Y_v,Y_r,N_v,N_r --out " + out);
  CHECK(json["schema"] == "swayaw.identification/1");
  CHECK(json["method"] == "trajectories");
  const auto found = parameters_of(read_ship(out), linear_hull), known = parameters_of(truth, linear_hull);
  REQUIRE(json["coefficients"].size() == linear_hull.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    INFO(known[i].name);
    const auto& c = json["coefficients"][i];
    CHECK(c["value"] == found[i].value);
    CHECK(std::abs(found[i].value - known[i].value) < 4.0 * c["standard_error"].get<double>());
    CHECK(std::abs(found[i].value - known[i].value) < 0.01 * std::abs(known[i].value));
    CHECK(found[i].deviation == Approx(c["standard_error"].get<double>()).epsilon(1e-6));
  }
  for (const auto& run : json["errors"]["train"]) CHECK(run["after"]["yaw_rate"] < run["before"]["yaw_rate"]);
  CHECK(read_text(out).starts_with("# Coefficients identified by swayaw "));
}

TEST_CASE("identify takes a PI ship for the physics-uninformed model and says that it is ill-conditioned", "[app]") {
  const Scratch scratch;
  const auto truth = published_ship("kvlcc2_pi");
  const auto out = (scratch / "pu.toml").string();
  const auto words =
      "identify " + recordings_of(truth, scratch) + "--ship kvlcc2_pi --model pu --fit forces --resample --out " + out;
  const auto outcome = run(scratch, words);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK_THAT(outcome.out, Catch::Contains("ill-conditioned"));
  CHECK_THAT(outcome.out, Catch::Contains("all but zz20.csv"));
  CHECK(model_of(read_text(out), out) == "pu");
}

TEST_CASE("identify fits the linear equations to recorded drift", "[app]") {
  const Scratch scratch;
  const auto out = (scratch / "linear.toml").string();
  const auto json = document("identify " + recordings_of(published_ship("kvlcc2_l7"), scratch) +
                             "--ship kvlcc2_l7 --model linear --out " + out);
  CHECK(json["model"] == "linear");
  CHECK(json["coefficients"].size() == 12);
  CHECK(model_of(read_text(out), out) == "linear");
  CHECK(run(scratch, "indices " + out).code == 0);
}

TEST_CASE("identify fits the same linear equations to the rudder that was ordered", "[app][second-route]") {
  const Scratch scratch;
  const auto truth = published_ship("kvlcc2_l7");
  auto sailed = zigzag(truth, {.rudder = radians(10), .heading = radians(10)}, {.duration = 150.0, .step = 0.1}).run;
  const auto yaw = [&](const Recording& recording) {
    write_recording(recording, scratch / "run.csv");
    const auto json = document("identify " + (scratch / "run.csv").string() +
                               " --ship kvlcc2_l7 --model linear --out " + (scratch / "linear.toml").string());
    return json["coefficients"];
  };
  const auto by_angle = yaw(sailed);
  const auto delta = sailed[Channel::delta];
  auto order = sailed.fill(Channel::delta_order);
  for (std::size_t i = 1; i < order.size(); ++i)  // where it goes, and where it went last once it is there
    order[i] =
        std::abs(delta[i] - delta[i - 1]) < 1e-9 ? order[i - 1] : std::copysign(radians(10), delta[i] - delta[i - 1]);
  sailed.channels[index_of(Channel::delta)].clear();
  const auto by_order = yaw(sailed);
  for (std::size_t i = 0; i < 6; ++i) {
    INFO(by_angle[i].dump());
    CHECK(std::abs(by_order[i]["value"].get<double>() - by_angle[i]["value"].get<double>()) <
          by_angle[i]["standard_error"].get<double>());
  }
}

// The rudder of the example recordings has 0.82 of its lift, and their hull 1.05 of its resistance.
TEST_CASE("identify finds on trajectories what no force equation tells", "[app]") {
  const Scratch scratch;
  const auto runs = (test::example_recordings / "weak_rudder_zz10_10.csv").string() + " " +
                    (test::example_recordings / "weak_rudder_turn35.csv").string();
  const auto base = "identify " + runs + " --ship " + test::ship_file("kvlcc2_l7.toml") + " --model mmg --out " +
                    (scratch / "new.toml").string() + " --find f_alpha";
  CHECK_THAT(refusal(base), Catch::Contains("--fit trajectories"));
  const auto json = document(base + " --fit trajectories");
  const auto& found = json["coefficients"][0];
  CHECK(json["method"] == "trajectories");
  CHECK(json["equations"].empty());
  CHECK(found["value"].get<double>() / found["before"].get<double>() == Approx(0.82).epsilon(0.01));
}

TEST_CASE("identify refuses what cannot be found in one line and writes nothing", "[app][refusal]") {
  const Scratch scratch;
  const auto truth = published_ship("kvlcc2_l7");
  const auto out = (scratch / "new.toml").string();
  const auto base =
      "identify " + recordings_of(truth, scratch) + "--ship " + test::ship_file("kvlcc2_l7.toml") + " --out " + out;
  CHECK_THAT(refusal(base + " --model mmg --find N_x"), Catch::Contains("her model has no number N_x"));
  CHECK_THAT(refusal(base + " --model mmg --find kappa --fit forces"), Catch::Contains("not linear in kappa"));
  CHECK_THAT(refusal(base + " --model pi"), Catch::Contains("does not tell what model \"pi\" needs"));
  CHECK_THAT(refusal(base + " --model mmg --channels depth"), Catch::Contains("depth is not among the channels"));
  CHECK_FALSE(std::filesystem::exists(out));
}

}  // namespace swayaw
