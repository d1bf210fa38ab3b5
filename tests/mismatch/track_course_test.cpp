#include "trial/track_course.hpp"

#include <catch.hpp>
#include <cmath>
#include <memory>

#include "swayaw/core/angle.hpp"

namespace swayaw {
using namespace mismatch::detail;

namespace {

constexpr double U = 7.0, time_unit = 20.0;  // [m/s], [s]

/// What carries a ship and what her compass shows.
struct Day {
  double north = 0.0, east = 0.0;  ///< stream [m/s]
  double compass = 0.0;            ///< recorded less true heading [rad]
};

/// Five minutes on a course, with a helmsman's 1 deg to either side, then a turn with 10 deg of drift.
PreparedRun run_on(double course, const Day& day) {
  auto run = std::make_shared<Recording>(Recording{.name = "run.csv"});
  for (int i = 0; i < 600; ++i) run->time.push_back(i);
  const auto x = run->fill(Channel::x), y = run->fill(Channel::y), psi = run->fill(Channel::psi);
  double north = 0.0, east = 0.0;
  for (int i = 0; i < 600; ++i) {
    const double heading = course + (i < 300 ? radians(1.0) * std::sin(0.1 * i) : radians(0.8) * (i - 300));
    const double drift = i < 300 ? 0.0 : radians(-10.0);
    x[i] = north, y[i] = east, psi[i] = heading + day.compass;
    north += U * std::cos(heading + drift) + day.north, east += U * std::sin(heading + drift) + day.east;
  }
  return {.run = std::move(run)};
}

/// On opposite courses.
std::vector<PreparedRun> runs_on(const Day& day) { return {run_on(0.4, day), run_on(0.4 + pi, day)}; }

}  // namespace

TEST_CASE("a heading that is off the track on all courses is told, a stream on opposite ones is not",
          "[mismatch][law]") {
  for (const double error : {0.0, radians(4.0), radians(-2.5)}) {
    const auto off = heading_off_track(runs_on({.compass = error}), time_unit);
    REQUIRE(off);
    CHECK(std::abs(*off - error) < radians(0.3));
  }
  const double across = std::atan(0.1);  // of a stream of 0.1 U
  const auto both = heading_off_track(runs_on({.east = 0.1 * U, .compass = radians(4.0)}), time_unit);
  REQUIRE(both);
  CHECK(std::abs(*both - radians(4.0)) < across);
}

// A run that is thinned, as those of instruments on board, hardly has a sample with both.
TEST_CASE("headings between the fixes tell the same as headings at them", "[mismatch][second-route]") {
  const double error = radians(3.6);
  std::vector<PreparedRun> thinned;
  for (const auto& run : runs_on({.compass = error})) {
    auto lean = std::make_shared<Recording>(*run.run);
    for (std::size_t i = 0; i < lean->samples(); ++i) {
      const bool fix = i % 6 == 0, heading = i % 6 == 3;
      if (!fix) lean->fill(Channel::x)[i] = lean->fill(Channel::y)[i] = missing;
      if (!heading) lean->fill(Channel::psi)[i] = missing;
    }
    thinned.push_back({.run = std::move(lean)});
  }
  const auto off = heading_off_track(thinned, time_unit);
  REQUIRE(off);
  CHECK(std::abs(*off - error) < radians(0.5));
}

TEST_CASE("without positions, or on one course alone, nothing is told of the heading", "[mismatch][limit]") {
  CHECK_FALSE(heading_off_track(runs_on({}), 1e4));
  CHECK_FALSE(heading_off_track(std::vector{run_on(0.0, {.compass = 0.1})}, time_unit));  // or a stream across
  auto blind = std::make_shared<Recording>(*run_on(0.0, {}).run);
  blind->channels[index_of(Channel::y)].clear();
  CHECK_FALSE(heading_off_track(std::vector{PreparedRun{.run = std::move(blind)}}, time_unit));
  CHECK_FALSE(heading_off_track({}, time_unit));
}

}  // namespace swayaw
