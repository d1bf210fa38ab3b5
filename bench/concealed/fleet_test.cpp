#include <algorithm>

#include "catch.hpp"
#include "fleet_case.hpp"
#include "swayaw/core/refusal.hpp"

/// Fleets of ships that are not built like the models of swayaw.
using namespace swayaw;
using namespace swayaw::concealed;

TEST_CASE("a fleet is made again by its seed, and nothing changes on a quiet one", "[bench][fleet][regression]") {
  const auto first = fleet_by_chance(3), again = fleet_by_chance(3), quiet = fleet_by_chance(3, true);
  REQUIRE(first.runs.size() == again.runs.size());
  const auto rudder = [](const FleetCase& fleet) {
    const auto values = fleet.runs.back().run[Channel::delta];
    return std::vector(values.begin(), values.end());
  };
  CHECK(rudder(first) == rudder(again));
  CHECK(std::ranges::none_of(quiet.changes, [](const auto& change) { return change.has_value(); }));
}

TEST_CASE("what changed on one of two sisters is found with its date and its size, in whatever order runs come",
          "[bench][fleet][limit]") {
  auto fleet = fleet_by_chance(2000);
  const auto changed = std::ranges::find_if(fleet.changes, [](const auto& change) { return change.has_value(); });
  REQUIRE(std::ranges::count_if(fleet.changes, [](const auto& change) { return change.has_value(); }) == 1);
  const auto vessel = fleet.vessels[static_cast<std::size_t>(changed - fleet.changes.begin())];
  std::ranges::reverse(fleet.runs);
  const auto d = diagnose_fleet(fleet.ship, fleet.runs);
  REQUIRE(d.vessels.size() == fleet.vessels.size());
  const auto& worst = d.vessels.front();
  CHECK(worst.vessel == vessel);
  REQUIRE(worst.changes.size() == 1);
  const auto& found = worst.changes.front();
  CHECK(id_of(found.effect) == (*changed)->effect);
  CHECK(found.shape == (*changed)->shape);
  CHECK(found.since.from <= (*changed)->since);
  CHECK((*changed)->since <= found.since.to);
  CHECK(std::abs(found.after - found.before - (*changed)->size) < 3.0 * found.standard_error);
  for (const auto& v : d.vessels) {
    CHECK(v.errors.own < v.errors.given);
    if (v.vessel != vessel) CHECK(v.changes.empty());
  }
}

TEST_CASE("a run without a date is refused by name", "[bench][fleet][refusal]") {
  auto fleet = fleet_by_chance(3, true);
  fleet.runs.resize(2);
  fleet.runs.back().run.facts.remarks.clear();
  CHECK_THROWS_WITH(diagnose_fleet(fleet.ship, fleet.runs),
                    Catch::Contains(fleet.runs.back().run.name) && Catch::Contains("start_utc"));
}

TEST_CASE("days are dates of the calendar", "[bench][fleet][limit]") {
  CHECK(date_text(0.0) == "1970-01-01");
  CHECK(date_text(20454.9) == "2026-01-01");
}
