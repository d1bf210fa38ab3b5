#include <catch.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <string>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

/// `swayaw diagnose --report` from the outside.
namespace swayaw {
namespace {

using nlohmann::json;
using test::refusal;
using test::run;
using test::Scratch;

const std::string ship_path = test::ship_file("kvlcc2_l7.toml");

/// The text of an element of a page that begins with these words.
std::string element(const std::string& page, const std::string& opening) {
  const auto start = page.find(opening) + opening.size();
  return page.substr(start, page.find("</script>", start) - start);
}

/// Three runs of a thousand samples and one to be held out, of a ship whose rudder stands two degrees off.
std::string write_runs(const Scratch& scratch) {
  const Ship ship = with_effect(test::kvlcc2_l7(), RudderOffset<double>{.offset = radians(2)});
  const ManoeuvreOptions options{.duration = 200.0, .step = 0.2};
  write_recording(zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, options).run, scratch / "zz10.csv");
  write_recording(zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, options).run, scratch / "zz20.csv");
  write_recording(zigzag(ship, {.rudder = radians(15), .heading = radians(10), .first = Side::port}, options).run,
                  scratch / "zz15_10_port.csv");
  write_recording(zigzag(ship, {.rudder = radians(20), .heading = radians(10)}, options).run, scratch / "held.csv");
  return (scratch / "zz10.csv").string() + " " + (scratch / "zz20.csv").string() + " " +
         (scratch / "zz15_10_port.csv").string() + " --holdout " + (scratch / "held.csv").string();
}

/// Parameters of a list, none of them missing.
bool all_numbers(const json& list) {
  return !list.empty() && std::ranges::all_of(list, [](const json& value) { return value.is_number(); });
}

TEST_CASE("diagnose writes a page with what its plots show: numbers of the document, the missing force and the replays",
          "[app]") {
  const Scratch scratch;
  const auto file = (scratch / "page.html").string();
  const auto outcome = run(scratch, "diagnose " + ship_path + " " + write_runs(scratch) + " --json --report " + file);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto printed = test::json_of(outcome.out);
  auto page = read_text(file);
  CHECK(page.size() < 3'000'000);

  const auto library = element(page, "<script id=\"plotly\" type=\"text/plain\">");
  const auto text = element(page, "<script id=\"data\" type=\"application/json\">");
  page.erase(page.find(library), library.size());
  CHECK_THAT(page, !ContainsSubstring("http://") && !ContainsSubstring("https://"));
  CHECK(!std::regex_search(page, std::regex("src=\"(?!data:)")));
  CHECK_THAT(text, !ContainsSubstring("NaN") && !ContainsSubstring("nan") && !ContainsSubstring("inf,"));

  const auto shown = test::json_of(text);
  for (const char* key : {"verdict", "location", "candidates", "budget", "fit", "next_manoeuvre", "detectable"})
    CHECK(shown.at(key) == printed.at(key));
  REQUIRE(printed.at("effects").size() > 0);
  for (std::size_t i = 0; i < printed.at("effects").size(); ++i)
    CHECK(shown.at("effects")[i].at("parameters") == printed.at("effects")[i].at("parameters"));
  CHECK_FALSE(printed.contains("runs"));

  REQUIRE(shown.at("runs").size() == 4);
  for (const auto& r : shown.at("runs")) {
    CHECK(r.at("held_out") == (r.at("run") == "held.csv"));
    const auto& series = r.at("series");
    const auto points = series.at("time_s").size();
    CHECK((points > 400 && points <= 500));
    for (const char* stage : {"missing_before", "missing_after"})
      for (const auto& [key, list] : series.at(stage).items()) CHECK((list.size() == points && all_numbers(list)));
    for (const char* replayed : {"given", "refitted", "after"})
      for (const char* channel : {"x_m", "y_m", "psi_rad", "r_rad_s"})
        CHECK(series.at(replayed).at(channel).size() == points);
    CHECK(all_numbers(series.at("motion").at("drift_rad")));
  }
}

TEST_CASE("diagnose says which runs tell no shaft speed, and what is taken in its place", "[app]") {
  const Scratch scratch;
  Recording bare = zigzag(with_effect(test::kvlcc2_l7(), RudderOffset<double>{.offset = radians(2)}),
                          {.rudder = radians(10), .heading = radians(10)}, {.duration = 100.0, .step = 0.5})
                       .run;
  write_recording(bare, scratch / "told.csv");
  for (const auto channel : {Channel::rev, Channel::thrust}) bare.channels[index_of(channel)].clear();
  write_recording(bare, scratch / "bare.csv");
  const auto page_with = [&](const std::string& name) {
    const auto file = (scratch / "page.html").string();
    const auto outcome =
        run(scratch, "diagnose " + ship_path + " " + (scratch / name).string() + " --json --report " + file);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const auto page = read_text(file);
    return std::tuple(test::json_of(outcome.out).at("assumed"), outcome.err,
                      page.substr(page.find("<div class=\"first\">"), 200'000));
  };
  const auto [assumed, err, page] = page_with("bare.csv");
  REQUIRE(assumed.size() == 1);
  for (const auto& words : {assumed[0].get<std::string>(), err, page})
    CHECK_THAT(words, ContainsSubstring("o shaft speed recorded in bare.csv: the run is taken to begin settled"));
  CHECK_THAT(page, ContainsSubstring("the shaft speed that carries her settled at the start"));
  const auto [nothing, silent, told] = page_with("told.csv");
  CHECK(nothing.empty());
  CHECK_THAT(silent + told, !ContainsSubstring("o shaft speed recorded"));
  CHECK_THAT(told, ContainsSubstring("with the recorded rudder and shaft speed"));
}

TEST_CASE("a report to a folder that does not exist is refused before the work begins", "[app][refusal]") {
  const Scratch scratch;
  const auto file = (scratch / "no/such.html").string();
  CHECK_THAT(refusal("diagnose " + ship_path + " " + (test::example_recordings / "weak_rudder_zz10_10.csv").string() +
                     " --report " + file),
             ContainsSubstring(file));
}

/// White noise of a tank's optical tracking on a run of a 7 m model.
void track_optically(Recording& run, std::mt19937_64& engine) {
  for (const auto& [channel, deviation] : {std::pair{Channel::x, 2e-3},
                                           {Channel::y, 2e-3},
                                           {Channel::psi, 5e-4},
                                           {Channel::r, 5e-4},
                                           {Channel::u, 2e-3},
                                           {Channel::v, 2e-3}}) {
    std::normal_distribution error(0.0, deviation);
    for (double& sample : run.fill(channel)) sample += error(engine);
  }
}

TEST_CASE("a wind that differs from day to day has a rose for each", "[app]") {
  const Scratch scratch;
  std::mt19937_64 engine(7);
  std::string runs;
  for (const auto& [day, speed, from] : {std::tuple{"a", 4.0, 0.3}, std::tuple{"b", 5.0, 3.5}})
    for (const Side side : {Side::starboard, Side::port}) {
      const Ship ship = with_effect(test::kvlcc2_l7(), SteadyWind<double>{speed, from});
      auto run = turning_circle(ship, {.rudder = radians(25), .side = side}, {.duration = 120.0, .step = 0.3}).run;
      track_optically(run, engine);  // without errors each turn tells a wind of its own
      run.facts.remarks.push_back({"group", "\"" + std::string(day) + "\""});
      const auto file = scratch / (std::string(day) + std::string(name_of(side)) + ".csv");
      write_recording(run, file);
      runs += " " + file.string();
    }
  const auto file = (scratch / "page.html").string();
  const auto outcome = run(scratch, "diagnose " + ship_path + runs + " --report " + file);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto page = read_text(file);
  const auto has = [&](const char* words) { return page.find(words) != std::string::npos; };
  CHECK(has("Direction of the steady wind, a</h2>\n<p>Wind from 017"));
  CHECK(has("Direction of the steady wind, b</h2>\n<p>Wind from 201"));
}

}  // namespace
}  // namespace swayaw
