#include "swayaw/nonlinear/replay.hpp"

#include <catch.hpp>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

namespace swayaw {
namespace {

Recording zigzag_run(const Ship& ship, double step) {
  return zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 60.0, .step = step}).run;
}

double largest_difference(const Recording& a, const Recording& b, Channel channel) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.samples(); ++i) largest = std::max(largest, std::abs(a[channel][i] - b[channel][i]));
  return largest;
}

Recording without(Recording run, std::initializer_list<Channel> channels) {
  for (const Channel channel : channels) run.channels[index_of(channel)].clear();
  return run;
}

TEST_CASE("a replay of a simulation is the simulation", "[nonlinear][round-trip]") {
  const Ship ship = test::kvlcc2_l7();
  for (const double step : {0.01, 0.04}) {
    const auto run = zigzag_run(ship, step);
    const auto again = replay(ship, run);
    CHECK(largest_difference(again, run, Channel::psi) < radians(0.005));
    CHECK(largest_difference(again, run, Channel::x) < 1e-3);
    CHECK(largest_difference(again, run, Channel::y) < 5e-3);
  }
}

TEST_CASE("a replay starts from log, track and heading when nothing else was recorded", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship, 0.05);
  const auto full = recorded_state(ship, run, 30.0);
  const auto column = run[Channel::u];
  const std::vector<double> log(column.begin(), column.end());
  run = without(run, {Channel::u, Channel::v, Channel::r});
  const auto from_track = recorded_state(ship, run, 30.0);
  CHECK_THAT(from_track.motion.u, WithinAbs(full.motion.u, 2e-3));
  CHECK_THAT(from_track.motion.v, WithinAbs(full.motion.v, 5e-3));
  CHECK_THAT(from_track.motion.r, WithinAbs(full.motion.r, 1e-3));
  run.channels[index_of(Channel::speed_through_water)] = log;
  CHECK_THAT(recorded_state(ship, run, 30.0).motion.u, WithinAbs(full.motion.u, 1e-3));
}

TEST_CASE("the recorded state is that of the simulation", "[nonlinear][round-trip]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run = zigzag_run(ship, 0.05);
  for (const std::size_t i : {0u, 200u, 400u, 600u, 1000u}) {
    const auto state = recorded_state(ship, run, run.time[i]);
    CHECK_THAT(state.x, WithinAbs(run[Channel::x][i], 3e-3));
    CHECK_THAT(state.psi, WithinAbs(run[Channel::psi][i], 2e-3));
    CHECK_THAT(state.motion.u, WithinAbs(run[Channel::u][i], 2e-3));
    CHECK_THAT(state.motion.v, WithinAbs(run[Channel::v][i], 3e-3));
    CHECK_THAT(state.motion.r, WithinAbs(run[Channel::r][i], 1e-3));
  }
}

TEST_CASE("a track alone tells the speed at the start, even where the rudder moves at once",
          "[nonlinear][regression]") {
  // 2026-11-21: with one sample before the rudder had left its angle the speed came out as 0
  const Ship ship = test::kvlcc2_l7();
  const auto run = without(zigzag_run(ship, 0.2), {Channel::u, Channel::v});
  const auto state = recorded_state(ship, run, run.time.front());
  CHECK_THAT(state.motion.u, WithinRel(service_speed(ship), 0.01));
  CHECK_THAT(state.motion.v, WithinAbs(0.0, 0.01 * service_speed(ship)));
}

TEST_CASE("samples a third of a ship length apart tell the speed at the start", "[nonlinear][regression]") {
  // 2026-11-21: one sample within a quarter of a ship length gave the speed 0
  const Ship ship = test::kvlcc2_l7();
  const auto run = zigzag_run(ship, 2.0);
  const auto start = recorded_state(ship, without(run, {Channel::u, Channel::v}), 0.0);
  CHECK_THAT(start.motion.u, WithinRel(run[Channel::u].front(), 0.05));
}

TEST_CASE("a ship whose polynomial holds her propulsion replays a start at another speed", "[nonlinear][regression]") {
  // 2026-11-21: refused, as if the speed had been asked for
  const Ship ship = read_ship(test::ships / "mariner.toml");
  auto run = zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 60.0, .step = 0.5}).run;
  for (double& u : run.fill(Channel::u)) u *= 0.98;
  const auto replayed = replay(ship, run);
  CHECK_THAT(replayed[Channel::u].front(), WithinRel(run[Channel::u].front(), 1e-2));
}

TEST_CASE("missing samples do not stop a replay", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto whole = zigzag_run(ship, 0.05);
  auto run = whole;
  for (const Channel channel : {Channel::delta, Channel::rev, Channel::r, Channel::u})
    for (std::size_t i = 0; i < run.samples(); i += 3) run.fill(channel)[i] = missing;
  CHECK(largest_difference(replay(ship, run), replay(ship, whole), Channel::psi) < radians(1.0));
}

TEST_CASE("an ordered angle passes through the steering gear", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2();
  Recording run;
  run.name = "order";
  run.time = {0.0, 10.0, 10.001, 60.0};
  const double order = radians(-20);
  const double orders[] = {0.0, 0.0, order, order};
  std::ranges::copy(orders, run.fill(Channel::delta_order).begin());
  std::ranges::fill(run.fill(Channel::psi), 0.0);
  std::ranges::fill(run.fill(Channel::u), 8.0);
  const RecordedControls controls(ship, run);
  CHECK_THAT(controls.rudder(10.001), WithinAbs(0.0, 1e-3));
  CHECK_THAT(controls.rudder(60.0), WithinAbs(order, 1e-12));
}

TEST_CASE("recorded thrust stands in for a shaft speed that was not recorded", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run = zigzag_run(ship, 0.05);
  const auto replayed = replay(ship, without(run, {Channel::rev}));
  CHECK(!replayed.has(Channel::rev));
  CHECK(largest_difference(replayed, replay(ship, run), Channel::psi) < radians(0.01));
}

TEST_CASE("without a recorded shaft speed or thrust the model propels herself", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run = zigzag_run(ship, 0.05);
  const auto replayed = replay(ship, without(run, {Channel::rev, Channel::thrust}));
  CHECK_THAT(replayed[Channel::rev].front(), WithinRel(run[Channel::rev].front(), 1e-6));
}

TEST_CASE("a run that does not tell its speed is refused", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = without(zigzag_run(ship, 0.05), {Channel::u, Channel::v, Channel::x, Channel::y});
  run.name = "blind.csv";
  CHECK_THROWS_WITH(replay(ship, run), "blind.csv: no channel tells the speed of the ship at 0 s");
}

}  // namespace
}  // namespace swayaw
