#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "files.hpp"
#include "random_source.hpp"
#include "score.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

using namespace swayaw;
using namespace swayaw::concealed;

namespace {

const TrialOptions still{.noise = 0.0, .disturbance = 0.0};

double largest_difference(const Recording& a, const Recording& b, Channel channel, double sign = 1.0) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.samples(); ++i) most = std::max(most, std::abs(a[channel][i] - sign * b[channel][i]));
  return most;
}

std::string table_named(const std::vector<Json>& lines, const std::string& name) {
  for (const auto& [key, text] : tables_of(lines))
    if (key == name) return text;
  return {};
}

/// A line of answers with one hidden effect, or none, and the name that was given.
Json line_of(const std::string& hidden, const std::string& found) {
  Json line{{"effects", Json::array()}, {"ship", "tanker"},      {"noise", 1.0},       {"set", "A"},
            {"reference", false},       {"baseline_error", 0.0}, {"time_unit_s", 40.0}};
  if (!hidden.empty())
    line["effects"].push_back({{"effect", hidden}, {"level", "strong"}, {"parameters", {{"offset_rad", 0.02}}}});
  Json effects = Json::array();
  if (!found.empty())
    effects.push_back({{"effect", found},
                       {"probability", 0.9},
                       {"onset_s", nullptr},
                       {"parameters", {{"offset_rad", {0.022, 0.002}}}},
                       {"indistinguishable_from", {"propeller_side_force"}}});
  line["answer"] = {{"verdict", found.empty() ? "nothing_missing" : "missing_physics"},
                    {"effects", effects},
                    {"candidates", Json::array()},
                    {"holdout_ratio", 0.5}};
  line["rivals"] = {
      {"nothing", Json::array()}, {"random", {"gust"}}, {"ols_bic", Json::array()}, {"sparse", Json::array()}};
  return line;
}

}  // namespace

TEST_CASE("a ship with two like sides sails to starboard as she sails to port", "[bench][symmetry]") {
  for (const auto kind : ship_kinds()) {
    const auto ship = symmetric(true_ship(kind, 5));
    const auto port = simulate(ship, {}, zigzag(20, 10, true, 0.0), still),
               starboard = simulate(ship, {}, zigzag(20, 10, false, 0.0), still);
    CHECK(largest_difference(port, starboard, Channel::x) < 1e-6 * ship.L);
    CHECK(largest_difference(port, starboard, Channel::speed_through_water) < 1e-6 * ship.U_0);
    for (const auto channel : {Channel::y, Channel::psi, Channel::r, Channel::delta})
      CHECK(largest_difference(port, starboard, channel, -1.0) < 1e-5 * (channel == Channel::y ? ship.L : 1.0));
  }
}

TEST_CASE("a ship sails the same on every heading while nothing comes from a direction", "[bench][symmetry]") {
  const auto ship = true_ship("container", 5);
  const auto north = simulate(ship, {}, turn(35, true, 0.0), still),
             east = simulate(ship, {}, turn(35, true, 0.5 * pi), still);
  CHECK(largest_difference(north, east, Channel::r) < 1e-8);
  double most = 0.0;
  for (std::size_t i = 0; i < north.samples(); ++i)
    most = std::max(most, std::abs(north[Channel::x][i] - east[Channel::y][i]));
  CHECK(most < 1e-5 * ship.L);
}

TEST_CASE("what is hidden with the size 0 changes no digit", "[bench][limit]") {
  const auto ship = true_ship("tanker", 2);
  const Concealment nothing{.wind_from = 1.0,
                            .gust_from = 2.0,
                            .gust_onset = 100.0,
                            .gust_end = 300.0,
                            .current_to = 0.7,
                            .wave_from = 3.0,
                            .gap_angle = 0.2,
                            .GM = 2.0,
                            .memory_tau = 20.0,
                            .late = Channel::x,
                            .tow_onset = 50.0};
  for (const auto& manoeuvre : {zigzag(10, 10, true, 1.0), turn(35, false, 2.0)})
    CHECK(recording_text(simulate(ship, nothing, manoeuvre, {.seed = 3})) ==
          recording_text(simulate(ship, {}, manoeuvre, {.seed = 3})));
}

TEST_CASE("positions that are late show where she was", "[bench][limit]") {
  const auto ship = true_ship("tanker", 2);
  const auto manoeuvre = turn(35, false, 2.0);
  const double step = simulate(ship, {}, manoeuvre, still).time[1];
  const auto prompt = simulate(ship, {}, manoeuvre, still),
             late = simulate(ship, {.delay = 4.0 * step, .late = Channel::x}, manoeuvre, still);
  for (std::size_t i = 4; i < prompt.samples(); ++i) {
    CHECK(std::abs(late[Channel::x][i] - prompt[Channel::x][i - 4]) < 1e-5 * ship.L);
    CHECK(std::abs(late[Channel::y][i] - prompt[Channel::y][i - 4]) < 1e-5 * ship.L);
  }
  CHECK(std::hypot(late[Channel::x][0] + 4.0 * step * ship.U_0 * std::cos(2.0),
                   late[Channel::y][0] + 4.0 * step * ship.U_0 * std::sin(2.0)) < 0.01 * ship.L);
}

TEST_CASE("every kind of hidden effect shows in the recording, under the keys of its numbers", "[bench][limit]") {
  const auto ship = true_ship("training", 4);
  const auto file = fair_ship(ship, 0.02).ship;
  const auto clean = recording_text(simulate(ship, {}, zigzag(20, 20, true, 0.3), still));
  const auto kinds = {known_kinds(), unknown_kinds()};
  for (const auto list : kinds)
    for (const auto kind : list) {
      INFO(kind);
      Concealment hidden;
      RandomSource random(9);
      const auto label = conceal(hidden, kind, Severity::strong, ship, std::get<MmgShip<double>>(file.model), random);
      CHECK(recording_text(simulate(ship, hidden, zigzag(20, 20, true, 0.3), still)) != clean);
      if (kind.starts_with("unknown")) continue;
      const auto parameters = parameters_of(file, make_effect(kind));
      for (const auto& n : label.parameters) {
        INFO(n.key);
        CHECK(std::isfinite(n.value));
        CHECK(std::ranges::count(parameters, n.key, &Parameter::key) == 1);
      }
    }
}

TEST_CASE("a longer step of the integration leaves the track where it is", "[bench][second-route]") {
  const auto ship = true_ship("tanker", 1);
  auto fine = still;
  fine.steps = 16;
  const auto manoeuvre = turn(35, true, 0.0);
  CHECK(largest_difference(simulate(ship, {}, manoeuvre, still), simulate(ship, {}, manoeuvre, fine), Channel::x) <
        2e-3 * ship.L);
}

TEST_CASE("true ships sail like ships, and their files are near them", "[bench][limit]") {
  for (const auto kind : ship_kinds())
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      INFO(kind << " " << seed);
      const auto ship = true_ship(kind, seed);
      const auto c = character_of(ship);
      CHECK(degrees(c.overshoot_10) > 3.0);
      CHECK(degrees(c.overshoot_10) < 20.0);
      CHECK(degrees(c.overshoot_20) < 30.0);
      CHECK(c.tactical_diameter > 2.0);
      CHECK(c.tactical_diameter < 5.0);
      CHECK(c.speed_in_turn > 0.4);
      CHECK(c.speed_in_turn < 0.7);
      const auto residue = fair_ship(ship, 0.02).residue;
      CHECK(residue.X < 0.03);
      CHECK(residue.Y < 0.03);
      CHECK(residue.N < 0.08);
    }
}

TEST_CASE("a seed makes the same files again", "[bench][regression]") {
  const auto plan = plan_named("all", 3, 7).back(), other = plan_named("all", 3, 8).back();
  const test::Scratch scratch;
  for (const auto* name : {"a", "b"}) write_case(made(plan), scratch / name);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch / "a")) {
    if (!entry.is_regular_file()) continue;
    const auto twin = scratch / "b" / std::filesystem::relative(entry.path(), scratch / "a");
    CHECK(read_text(entry.path()) == read_text(twin));
  }
  CHECK(recording_text(made(plan).train.front()) != recording_text(made(other).train.front()));
}

TEST_CASE("marks count names, classes and false alarms", "[bench][limit]") {
  const std::vector<Json> lines{line_of("rudder_offset", "rudder_offset"),
                                line_of("propeller_side_force", "rudder_offset"),
                                line_of("gust", ""),
                                line_of("", ""),
                                line_of("", "rudder_offset"),
                                line_of("unknown_kelp", "rudder_offset")};
  const auto overview = table_named(lines, "overview");
  CHECK_THAT(overview, ContainsSubstring("| false alarms | 1/2 (50 %)"));
  CHECK_THAT(overview, ContainsSubstring("| one effect: detected | 2/3 (67 %)"));
  CHECK_THAT(overview, ContainsSubstring("| one effect: named first | 1/3 (33 %)"));
  CHECK_THAT(overview, ContainsSubstring("| one effect: in the class of the first | 2/3 (67 %)"));
  CHECK_THAT(overview, ContainsSubstring("| unknown, not misnamed with more than 0.8 | 0/1 (0 %)"));
  CHECK_THAT(overview, ContainsSubstring("| median error of numbers | 10 % |"));
  CHECK_THAT(overview, ContainsSubstring("| numbers in their 95 % interval | 1/1 (100 %)"));
  CHECK_THAT(table_named(lines, "rivals"), ContainsSubstring("| nothing | 0/2 (0 %) | 0/3 (0 %)"));
}

TEST_CASE("a plan or an effect that is not there is refused in words", "[bench][refusal]") {
  CHECK_THROWS_WITH(plan_named("many", 3, 1), ContainsSubstring("no plan \"many\""));
  CHECK_THROWS_WITH(true_ship("barge", 1), ContainsSubstring("\"barge\""));
  Concealment hidden;
  RandomSource random(1);
  CHECK_THROWS_WITH(conceal(hidden, "kraken", Severity::weak, true_ship("tanker", 1), {}, random),
                    ContainsSubstring("\"kraken\""));
}
