#include <sqlite3.h>

#include <catch.hpp>
#include <cmath>
#include <cstring>

#include "files.hpp"
#include "swayaw/app/sweep/run.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/linear/linear_ship_file.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

namespace swayaw::app {
namespace {

SweepPlan parsed(const std::string& text) { return parse_sweep_plan(text, test::ships / "plan.toml"); }

/// Every column of every ship, to the last bit.
std::vector<std::uint64_t> bits(const SweepStore& store, const SweepWork& work) {
  std::vector<std::uint64_t> all;
  for (std::size_t ship = 0; ship < work.subjects().size(); ++ship)
    for (std::size_t c = 0; c < work.columns().size(); ++c)
      for (const double x : store.column(ship, c)) {
        std::uint64_t word;
        std::memcpy(&word, &x, sizeof word);
        all.push_back(word);
      }
  return all;
}

std::size_t place_of(const SweepWork& work, const std::string& column) {
  const auto found = std::ranges::find(work.columns(), column, &SweepColumn::name);
  REQUIRE(found != work.columns().end());
  return static_cast<std::size_t>(found - work.columns().begin());
}

const std::string mmg_plan =
    "task = \"zigzag 10/10\"\nships = [\"kvlcc2.toml\", \"kvlcc2_l7.toml\"]\ndraws = 1500\ntolerance = 1e-6\n"
    "[vary]\nN_v = { relative_sd = 0.05 }\nY_v = { relative_sd = 0.05 }\n";

TEST_CASE("results do not depend on threads, interruptions and resumptions", "[sweep]") {
  const test::Scratch scratch;
  const SweepWork work(parsed(mmg_plan));
  const auto always = [](const SweepCount&) { return true; };
  SweepStore one(scratch / "one", work);
  CHECK(run_sweep(work, one, 1, always).done == 3000);

  for (int round = 0; round < 20; ++round) {
    SweepStore many(scratch / "many", work);
    const auto count = run_sweep(work, many, 3, [](const SweepCount& now) { return now.done == now.before; });
    CHECK(count.done > count.before - (count.before == count.all));
    if (count.done == count.all) break;
  }
  SweepStore many(scratch / "many", work);
  CHECK(run_sweep(work, many, 3, always).done == 3000);
  CHECK(bits(one, work) == bits(many, work));
}

TEST_CASE("an item is the manoeuvre of the ship with its parameters", "[sweep]") {
  const test::Scratch scratch;
  const SweepWork work(parsed(mmg_plan));
  SweepStore store(scratch / "out", work);
  run_sweep(work, store, 2, [](const SweepCount&) { return true; });
  const auto overshoot = store.column(1, place_of(work, "overshoot_1_deg")),
             second = store.column(1, place_of(work, "reversal_2_s"));
  const auto ship = published_ship("kvlcc2_l7");
  const auto numbers = parameters_of(ship, std::array{std::string("N_v"), std::string("Y_v")});
  for (const std::size_t i : {0u, 7u, 777u, 1499u}) {
    const auto values = work.parameters_of(1500 + i);
    const auto alone = zigzag(with_values(ship, numbers, values), {radians(10.0), radians(10.0)}, {.tolerance = 1e-10});
    CHECK_THAT(overshoot[i], WithinAbs(degrees(*alone.reversals[0].overshoot), 1e-3));
    CHECK_THAT(second[i], WithinAbs(alone.reversals[1].time, 1e-2));
  }
}

/// First overshoot of an item of the tanker by the function for one ship [deg]; not a number if there is none.
double overshoot_alone(const SweepWork& work, const LinearShip& ship, std::size_t item) {
  auto changed = ship;
  auto& parts = std::get<LinearParts<double>>(changed.form);
  const auto values = work.parameters_of(item);
  const auto put = [&](auto& part) {
    for (const auto& p : parameter_list<std::remove_cvref_t<decltype(part)>>)
      for (std::size_t d = 0; d < values.size(); ++d)
        if (p.key == work.columns()[d].name) part.*p.member = values[d] * p.si;
  };
  put(parts.hull), put(parts.rudder), put(changed.steering_gear);
  const auto found = linear_zigzag(yaw_coefficients(changed),
                                   {.rudder = radians(20.0),
                                    .heading = radians(10.0),
                                    .rate = changed.steering_gear.rate * ship.particulars.L / ship.particulars.U_0,
                                    .reversals = 2,
                                    .longest = 200.0});
  return found.reversals.empty() ? NAN : degrees(found.reversals[0].overshoot);
}

TEST_CASE("linear ships in packs and one by one are those of the function for one ship", "[sweep]") {
  const auto ship = read_linear_ship(test::ships / "tanker97.toml");
  const std::string head = "task = \"zigzag 20/10\"\nships = [\"tanker97.toml\"]\ndraws = 300\nconfidence = true\n";
  // with a rudder rate of her own every ship has another order, which packs cannot share
  for (const std::string vary : {"", "[vary]\nrate_deg_s = { from = 2.0, to = 3.0 }\n"}) {
    const test::Scratch scratch;
    const SweepWork work(parsed(head + vary));
    SweepStore store(scratch / "out", work);
    run_sweep(work, store, 2, [](const SweepCount&) { return true; });
    const auto overshoot = store.column(0, place_of(work, "overshoot_1_deg"));
    std::size_t sailed = 0;
    for (std::size_t i = 0; i < 300; ++i) {
      const double alone = overshoot_alone(work, ship, i);
      CHECK(std::isnan(alone) == std::isnan(overshoot[i]));
      if (std::isnan(alone)) continue;
      ++sailed;
      CHECK_THAT(overshoot[i], WithinAbs(alone, 1e-7));
    }
    CHECK(sailed > 250);
  }
}

TEST_CASE("a folder belongs to one plan and to one sweep at a time", "[sweep]") {
  const test::Scratch scratch;
  const SweepWork work(parsed(mmg_plan)), other(parsed(mmg_plan + "# another\n"));
  {
    SweepStore store(scratch / "out", work);
    CHECK_THROWS_WITH(SweepStore(scratch / "out", work), ContainsSubstring("another sweep works in this folder"));
  }
  CHECK_THROWS_WITH(SweepStore(scratch / "out", other), ContainsSubstring("results of another plan"));
  std::filesystem::create_directories(scratch / "file");
  CHECK_THROWS_WITH(SweepStore("/proc/nowhere", work), ContainsSubstring("cannot be written"));
}

TEST_CASE("a ship that cannot sail has a note and no result", "[sweep]") {
  const test::Scratch scratch;
  const SweepWork work(
      parsed("task = \"turn 35\"\nships = [\"kvlcc2.toml\"]\ndesign = \"grid\"\n[vary]\n"
             "max_angle_deg = { values = [35.0, 20.0] }\n"));
  SweepStore store(scratch / "out", work);
  run_sweep(work, store, 1, [](const SweepCount&) { return true; });
  const auto advance = store.column(0, place_of(work, "advance_m"));
  CHECK(std::isfinite(advance[0]));
  CHECK(std::isnan(advance[1]));
  REQUIRE(store.note_count() == 1);
  CHECK(store.notes(5).front().first == 1);
}

void change(const std::filesystem::path& file, const char* statement) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open(file.c_str(), &database) == SQLITE_OK);
  CHECK(sqlite3_exec(database, statement, nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(database);
}

TEST_CASE("results that somebody changed are refused, whatever they claim", "[sweep][refusal]") {
  const SweepWork work(
      parsed("task = \"indices\"\nships = [\"kvlcc2.toml\"]\ndraws = 20\n[vary]\nN_v = { relative_sd = 0.1 }\n"));
  for (const char* statement :
       {"UPDATE block SET numbers = x'00'", "UPDATE block SET count = 1000000", "UPDATE block SET count = -1",
        "UPDATE block SET first = 19", "UPDATE block SET place = 99", "UPDATE block SET place = -1",
        "INSERT INTO note VALUES (1000000, 'why')", "INSERT INTO note VALUES (-1, 'why')"}) {
    const test::Scratch scratch;
    {
      SweepStore store(scratch / "out", work);
      run_sweep(work, store, 1, [](const SweepCount&) { return true; });
    }
    change(scratch / "out" / "sweep.sqlite", statement);
    const auto read = [&] {
      const SweepStore store(scratch / "out", work);
      store.notes(10);
      store.column(0, 0);
    };
    INFO(statement);
    CHECK_THROWS_WITH(read(), ContainsSubstring("sweep.sqlite: holds a block that is none of this plan"));
  }
}

}  // namespace
}  // namespace swayaw::app
