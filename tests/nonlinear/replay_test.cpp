#include "swayaw/nonlinear/replay.hpp"

#include <catch.hpp>

#include "random_effects.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

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

TEST_CASE("a run whose rudder moves at once begins at its first sample", "[nonlinear][limit]") {
  const Ship ship = published_ship("kvlcc2");
  for (const double step : {1.0, 5.0, 10.0}) {
    const auto run =
        zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 600.0, .step = step}).run;
    const auto start = recorded_state(ship, run, 0.0);
    CHECK_THAT(start.x, WithinAbs(0.0, 1e-9));
    CHECK_THAT(start.y, WithinAbs(0.0, 1e-9));
    CHECK_THAT(start.motion.u, WithinAbs(run[Channel::u][0], 1e-9));
    CHECK_THAT(start.motion.v, WithinAbs(0.0, 1e-9));
    CHECK_THAT(start.motion.r, WithinAbs(0.0, 1e-12));
    CHECK_THAT(replay(ship, run)[Channel::x].front(), WithinAbs(0.0, 1e-9));
  }
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

// ---------------------------------------------------------------- start in a current

Ship in_current(Ship ship, double speed, double to) {
  ship.effects.push_back(SteadyCurrent<>{.speed = speed, .to = to});
  return ship;
}

/// A simulated run with what a receiver and a log show besides.
Recording with_instruments(Recording run, const Current<double>& current) {
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double psi = run[Channel::psi][i];
    const auto ground =
        over_ground(current, ShipState<double>{0.0, 0.0, psi, {run[Channel::u][i], run[Channel::v][i], 0.0}});
    const auto put = [&](Channel channel, double value) { run.channels[index_of(channel)].push_back(value); };
    put(Channel::speed_through_water, run[Channel::u][i]);
    put(Channel::u_ground, ground.u);
    put(Channel::v_ground, ground.v);
    put(Channel::speed_over_ground, std::hypot(ground.u, ground.v));
    put(Channel::course_over_ground, wrapped(psi + std::atan2(ground.v, ground.u)));
  }
  return run;
}

/// The run from a sample on.
Recording from_sample(Recording run, std::size_t first) {
  const auto cut = [&](std::vector<double>& values) {
    if (!values.empty()) values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  };
  cut(run.time);
  for (auto& channel : run.channels) cut(channel);
  return run;
}

/// The run with nothing but these channels, heading, rudder and shaft speed.
Recording with_only(const Recording& run, std::initializer_list<Channel> channels) {
  Recording result;
  result.name = run.name;
  result.time = run.time;
  const auto keep = [&](Channel channel) { result.channels[index_of(channel)] = run.channels[index_of(channel)]; };
  for (const Channel channel : {Channel::psi, Channel::delta, Channel::rev}) keep(channel);
  for (const Channel channel : channels) keep(channel);
  return result;
}

TEST_CASE("a replay in a known current begins with the velocity through the water, whatever tells it",
          "[nonlinear][second-route][regression]") {
  // 2026-11-22: velocity over ground was taken for that through the water
  using enum Channel;
  test::RandomShips random(15);
  for (int i = 0; i < 6; ++i) {
    const Ship calm{.name = "test ship", .model = random.ship(), .confidence = {}, .surroundings = {}};
    const double U = service_speed(calm), L = length(calm), time_unit = L / U;
    const auto ship = in_current(calm, random.uniform(0.05, 0.3) * U, random.uniform(-pi, pi));
    const auto current = surroundings_at(ship, 0.0).current;
    const auto whole = with_instruments(
        zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 15 * time_unit}).run, current);
    for (const std::size_t first : {0u, 100u, 230u}) {
      const auto run = from_sample(whole, first);
      const auto told_by = [&](std::initializer_list<Channel> channels) {
        return recorded_state(ship, with_only(run, channels), run.time.front()).motion;
      };
      INFO("ship " << i << " from " << run.time.front());
      const double u0 = run[u].front(), v0 = run[v].front();
      for (const auto& channels : {std::initializer_list<Channel>{x, y},
                                   {speed_through_water, x, y},
                                   {u_ground, v_ground},
                                   {speed_through_water, v_ground},
                                   {speed_over_ground, course_over_ground},
                                   {speed_over_ground, v},
                                   {u, v}}) {
        const auto motion = told_by(channels);
        CHECK_THAT(motion.u, WithinAbs(u0, 0.01 * U));
        CHECK_THAT(motion.v, WithinAbs(v0, 0.015 * U));
        CHECK_THAT(motion.r, WithinAbs(run[r].front(), 0.03 * U / L));
      }
    }
  }
}

TEST_CASE("a track tells the velocity in a steady turn in a current to the last digits", "[nonlinear][limit]") {
  // x = x_0 + V_c cos(psi_c) t + (u sin ψ + v cos ψ)/r,   y = y_0 + V_c sin(psi_c) t + (v sin ψ − u cos ψ)/r
  const Ship ship = in_current(test::kvlcc2_l7(), 0.2, 2.0);
  const double u = 0.7, v = -0.2, r = 0.08;
  Recording run;
  run.name = "turn";
  for (int i = 0; i < 200; ++i) run.time.push_back(0.1 * i);
  const auto x = run.fill(Channel::x), y = run.fill(Channel::y), psi = run.fill(Channel::psi);
  std::ranges::fill(run.fill(Channel::delta), -0.3);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double t = run.time[i], s = std::sin(r * t), c = std::cos(r * t);
    psi[i] = r * t;
    x[i] = 0.2 * std::cos(2.0) * t + (u * s + v * c) / r;
    y[i] = 0.2 * std::sin(2.0) * t + (v * s - u * c) / r;
  }
  for (const double time : {0.0, 5.0, 12.3}) {
    const auto motion = recorded_state(ship, run, time).motion;
    CHECK_THAT(motion.u, WithinAbs(u, 1e-8));
    CHECK_THAT(motion.v, WithinAbs(v, 1e-8));
    CHECK_THAT(motion.r, WithinAbs(r, 1e-8));
  }
}

TEST_CASE("a receiver that is late, or beside a wrong heading, tells no sway by its velocities, the track does",
          "[nonlinear][regression]") {
  // 2026-11-25: positions 10 s late of a ship of 250 m, with velocities of the same receiver, made a sway of U r τ at
  // every start of a comparison; 2026-11-26: those in axes of a compass that is off by 4 deg made one of U sin 4 deg
  struct Wrong {
    double position_delay, heading_delay;  // [L/U]
    double compass;
  };
  const auto wrong = GENERATE(Wrong{0.3, 0.0, 0.0}, Wrong{0.0, 0.3, 0.0}, Wrong{0.0, 0.0, radians(-4.0)});
  CAPTURE(wrong.position_delay, wrong.heading_delay, wrong.compass);
  test::RandomShips random(16);
  for (int i = 0; i < 6; ++i) {
    Ship ship{.name = "test ship", .model = random.ship(), .confidence = {}, .surroundings = {}};
    const double U = service_speed(ship), time_unit = length(ship) / U;
    const double late = wrong.position_delay * time_unit, heading_late = wrong.heading_delay * time_unit;
    const auto run = with_instruments(
        zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 15 * time_unit}).run, {});
    Recording earth{.name = "earth", .facts = {}, .time = run.time, .channels = {}, .extra = {}};
    const auto north = earth.fill(Channel::u), east = earth.fill(Channel::v);
    for (std::size_t k = 0; k < run.samples(); ++k) {
      const double c = std::cos(run[Channel::psi][k]), s = std::sin(run[Channel::psi][k]);
      north[k] = run[Channel::u][k] * c - run[Channel::v][k] * s;
      east[k] = run[Channel::u][k] * s + run[Channel::v][k] * c;
    }
    // in axes of the earth everything of the receiver is late; it is turned by the heading that is shown
    const Interpolant x(run, Channel::x), y(run, Channel::y), psi(run, Channel::psi), to_north(earth, Channel::u),
        to_east(earth, Channel::v);
    auto shown = run;
    for (std::size_t k = 0; k < run.samples(); ++k) {
      const double then = run.time[k] - late, heading = psi(run.time[k] - heading_late) + wrong.compass;
      const double c = std::cos(heading), s = std::sin(heading);
      shown.fill(Channel::x)[k] = x(then), shown.fill(Channel::y)[k] = y(then), shown.fill(Channel::psi)[k] = heading;
      shown.fill(Channel::u_ground)[k] = to_north(then) * c + to_east(then) * s;
      shown.fill(Channel::v_ground)[k] = to_east(then) * c - to_north(then) * s;
    }
    shown = without(std::move(shown), {Channel::u, Channel::v});
    ship.effects = {ChannelDelay<>{.channel = Channel::x, .delay = late},
                    ChannelDelay<>{.channel = Channel::psi, .delay = heading_late},
                    HeadingBias<>{.bias = wrong.compass}};
    double worst = 0.0, by_receiver = 0.0;
    for (double t = 3.0; t < 12.0; t += 1.0) {
      const double time = t * time_unit, v = Interpolant(run, Channel::v)(time);
      worst = std::max(worst, std::abs(recorded_state(ship, shown, time).motion.v - v));
      by_receiver = std::max(by_receiver, std::abs(Interpolant(shown, Channel::v_ground)(time) - v));
    }
    INFO("ship " << i);
    CHECK(by_receiver > 0.04 * U);
    CHECK(worst < 0.015 * U);
  }
}

TEST_CASE("a simulation that is taken up where it is goes on as if nothing had been", "[nonlinear][round-trip]") {
  // what the water remembers, and the heel, are in no state that is taken up
  const Ship calm = test::kvlcc2();
  const double time_unit = time_unit_of(calm);
  for (const Effect& effect : {Effect{FluidMemory<>{.tau = 0.8 * time_unit, .share = 0.5}},
                               Effect{RollCoupling<>{.GM = 1.5, .Y_phi = -0.02, .N_phi = -0.01}}}) {
    Ship ship = calm;
    ship.effects.push_back(effect);
    const auto run = zigzag(ship, {.rudder = radians(20), .heading = radians(20)},
                            {.duration = 12 * time_unit, .step = 0.02 * time_unit})
                         .run;
    const RecordedControls controls(ship, run);
    const auto start = recorded_state(ship, run, 0.0);
    const auto whole = replay_from(ship, controls, start, run.time);
    std::vector<ReplayStart> starts;
    double by_steady = 0.0;
    for (std::size_t k = 0; k + 1 < run.samples(); k += 100) {
      const auto of = [&](Channel channel) { return whole[channel][k]; };
      starts.push_back(
          {k, {of(Channel::x), of(Channel::y), of(Channel::psi), {of(Channel::u), of(Channel::v), of(Channel::r)}}});
      const auto piece = std::span<const double>(run.time).subspan(k, std::min<std::size_t>(100, run.samples() - k));
      const auto steady = replay_from(ship, controls, starts.back().state, piece);
      for (std::size_t i = 0; i < piece.size(); ++i)
        by_steady = std::max(by_steady, std::abs(steady[Channel::r][i] - whole[Channel::r][k + i]));
    }
    const auto anew = replay_anew(ship, controls, starts, run.time);
    INFO(id_of(effect));
    CHECK(anew.time == whole.time);
    CHECK(largest_difference(anew, whole, Channel::r) < 1e-6 / time_unit);
    CHECK(largest_difference(anew, whole, Channel::psi) < 1e-6);
    CHECK(by_steady > 100.0 * largest_difference(anew, whole, Channel::r));
  }
}

TEST_CASE("a run taken up anew on its way has the clocks of the whole run", "[nonlinear][round-trip]") {
  Ship ship = test::kvlcc2_l7();
  // 0.6 s late after a minute, and a heading that is early by as much
  ship.effects = {ClockDrift<>{.channel = Channel::x, .rate = 0.01},
                  ClockDrift<>{.channel = Channel::psi, .rate = -0.01}};
  const auto run = zigzag_run(ship, 0.1);
  const RecordedControls controls(ship, run);
  std::vector<double> times;
  std::vector<ReplayStart> starts;
  for (std::size_t k = 0; k + 1 < run.samples(); k += 100) starts.push_back({k, {}}), times.push_back(run.time[k]);
  const auto states = recorded_states(ship, run, times);
  for (std::size_t i = 0; i < starts.size(); ++i) starts[i].state = states[i];
  const auto anew = replay_anew(ship, controls, starts, run.time);
  // 0.6 s are 0.7 m and more than 0.5 deg
  CHECK(largest_difference(anew, run, Channel::x) < 0.02);
  CHECK(largest_difference(anew, run, Channel::y) < 0.02);
  CHECK(largest_difference(anew, run, Channel::psi) < radians(0.1));
}

TEST_CASE("states at several times are those at each", "[nonlinear][second-route]") {
  Ship ship = test::kvlcc2_l7();
  auto run =
      without(with_instruments(zigzag_run(ship, 0.1), {}), {Channel::u, Channel::v, Channel::rev, Channel::thrust});
  ship.effects = {ChannelDelay<>{.channel = Channel::r, .delay = 0.7}, LogScale<>{.scale = 1.03},
                  AntennaLeverArm<>{.x = 2.0}};
  const std::vector times{0.0, 12.5, 33.3, 60.0};
  const auto states = recorded_states(ship, run, times);
  REQUIRE(states.size() == times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto one = recorded_state(ship, run, times[i]);
    CHECK(vector_of(one) == vector_of(states[i]));
  }
  // the shaft speed that carries her is that of the speed at the start, whatever comes later
  const double U = speed(states.front().motion);
  CHECK(RecordedControls(ship, run).constant().rev == self_propulsion(ship, U).rev);
  auto longer = run;
  std::ranges::fill(longer.fill(Channel::speed_through_water).subspan(300), missing);
  CHECK(RecordedControls(ship, longer).constant().rev == self_propulsion(ship, U).rev);
}

TEST_CASE("without a shaft speed a run begins settled in wind and waves", "[nonlinear][second-route]") {
  const auto bare = test::with_areas(test::mmg(test::kvlcc2_l7()));
  const double U = service_speed(bare), L = length(bare);
  auto run = without(zigzag_run(bare, 0.1), {Channel::rev, Channel::thrust});
  const double turned = GENERATE(-2.0, 0.0, 0.7, 3.0);
  for (double& psi : run.channels[index_of(Channel::psi)]) psi += turned;
  const auto calm = RecordedControls(bare, run).constant();
  CHECK_THAT(calm.rev, WithinRel(self_propulsion(bare, U).rev, 1e-6));
  for (const Effect& effect : {Effect(SteadyWind<>{5.0 * U, 0.5}), Effect(WaveDrift<>{.from = 0.5, .force = 2.0}),
                               Effect(UnknownForce<>{.drag = 5e-4}), Effect(UnknownForce<>{.X_cos = -5e-4})}) {
    INFO(id_of(effect) << " " << turned);
    const auto ship = with_effect(bare, effect);
    const auto controls = RecordedControls(ship, run).constant();
    CHECK(std::abs(controls.rev - calm.rev) > 1e-4 * calm.rev);
    const auto a = force_breakdown(ship, {0.0, 0.0, turned, {U, 0.0, 0.0}}, with_rudder(controls, 0.0)).acceleration;
    CHECK_THAT(a.u, WithinAbs(0.0, 1e-6 * U * U / L));
  }
  // what comes later finds her as she was
  for (const Effect& effect : {Effect(UnknownForce<>{.X_0 = -1e-3, .onset = 10.0, .end = 60.0}),
                               Effect(Gust<>{.speed = 5.0, .onset = 20.0, .end = 40.0})})
    CHECK(RecordedControls(with_effect(bare, effect), run).constant().rev == calm.rev);
}

TEST_CASE("without a shaft speed an engine that slows is set to what it slows from", "[nonlinear][second-route]") {
  const Ship bare = test::kvlcc2_l7();
  const double slow = 0.8 * service_speed(bare);
  const auto run = without(
      zigzag(bare, {.rudder = radians(10), .heading = radians(10)}, {.speed = slow, .duration = 60.0, .step = 0.1}).run,
      {Channel::rev, Channel::thrust});
  const auto tired = with_effect(bare, ShaftSpeedDrop<>{0.3});
  const auto controls = RecordedControls(tired, run).constant();
  CHECK_THAT(controls.rev * (1.0 - 0.3 * 0.2), WithinRel(self_propulsion(bare, slow).rev, 1e-6));
  const auto a = force_breakdown(tired, {0.0, 0.0, 0.0, {slow, 0.0, 0.0}}, controls).acceleration;
  CHECK_THAT(a.u, WithinAbs(0.0, 1e-6 * slow * slow / length(bare)));
}

TEST_CASE("runs that tell no propulsion are named, unless the model needs none or takes what they tell",
          "[nonlinear]") {
  const Ship ship = test::kvlcc2_l7();
  auto whole = zigzag_run(ship, 0.5);
  whole.name = "whole.csv";
  auto by_thrust = without(whole, {Channel::rev}), bare = without(whole, {Channel::rev, Channel::thrust});
  bare.name = "bare.csv";
  CHECK(tells_propulsion(ship, whole));
  CHECK(tells_propulsion(ship, by_thrust));
  CHECK_FALSE(tells_propulsion(ship, bare));
  CHECK(assumed_propulsion(ship, std::vector{whole, by_thrust}).empty());
  CHECK_THAT(assumed_propulsion(ship, std::vector{whole, bare}),
             ContainsSubstring("no shaft speed recorded") && ContainsSubstring("in bare.csv: the run is"));
  CHECK_THAT(assumed_propulsion(ship, std::vector(7, bare)), ContainsSubstring("and 3 more: these runs are"));
  CHECK(tells_propulsion(published_ship("mariner"), bare));  // a polynomial
  const Ship towed = published_ship("wpcc_pi");              // a model that takes a thrust, no shaft speed
  CHECK_FALSE(tells_propulsion(towed, without(whole, {Channel::thrust})));
  CHECK_THAT(assumed_propulsion(towed, std::vector{bare}), ContainsSubstring("no thrust recorded"));
}

TEST_CASE("what carries another ship from the start of a run is what her own controls have",
          "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run =
      without(with_instruments(zigzag_run(ship, 0.1), {}), {Channel::u, Channel::v, Channel::rev, Channel::thrust});
  const RecordedControls controls(ship, run);
  const auto with = [&](const Effect& effect) {
    Ship other = ship;
    other.effects = {effect};
    return other;
  };
  Ship heavier = ship;
  std::get<MmgShip<double>>(heavier.model).hull.R_0 *= 1.2;
  std::vector<double> speeds;
  for (const Ship& other :
       {ship, heavier, with(LogScale<>{.scale = 1.03}), with(SteadyCurrent<>{.speed = 0.2, .to = 2.0}),
        with(ChannelDelay<>{.channel = Channel::x, .delay = 2.0}), with(HeadingBias<>{radians(4)})}) {
    const double rev = controls.propulsion_of(other, run).rev;
    CHECK(rev == RecordedControls(other, run).constant().rev);
    speeds.push_back(rev);
  }
  std::ranges::sort(speeds);
  CHECK(std::unique(speeds.begin(), speeds.end()) - speeds.begin() >= 4);
}

TEST_CASE("a rudder record that is late is shifted, its corners as they were", "[nonlinear][second-route]") {
  const auto run = zigzag_run(test::kvlcc2_l7(), 1.0);
  const Interpolant recorded(run, Channel::delta);
  for (const double delay : {-1.7, -0.3, 0.4, 2.0}) {
    Ship ship = test::kvlcc2_l7();
    ship.effects = {ChannelDelay<>{.channel = Channel::delta, .delay = delay}};
    const RecordedControls controls(ship, run);
    CAPTURE(delay);
    for (double time = 0.05; time < 60.0; time += 0.37)
      if (const double shown = time + delay; shown >= run.time.front() && shown <= run.time.back())
        CHECK_THAT(controls.rudder(time), WithinAbs(recorded(shown), 1e-12));
    // where the record shows no time of the run it goes on as it begins or ends
    const double end = delay < 0.0 ? run.time.front() : run.time.back(), within = end + (delay < 0.0 ? 0.5 : -0.5),
                 slope = (recorded(within) - recorded(end)) / (within - end);
    CHECK_THAT(controls.rudder(end), WithinAbs(recorded(end) + slope * delay, 1e-12));
  }
}

TEST_CASE("a rudder record whose clock is behind at one end and ahead at the other is drawn on at both",
          "[nonlinear][limit]") {
  const auto run = zigzag_run(test::kvlcc2_l7(), 0.1);
  const double begin = run.time.front(), end = run.time.back();
  auto ramp = run;
  for (std::size_t i = 0; i < run.samples(); ++i) ramp.channels[index_of(Channel::delta)][i] = 1e-3 * run.time[i];
  for (const double delay : {-2.0, 2.0}) {
    CAPTURE(delay);
    const double rate = -2.0 * delay / (end - begin);  // late by -delay at the end
    Ship ship = test::kvlcc2_l7();
    ship.effects = {ChannelDelay<>{.channel = Channel::delta, .delay = delay},
                    ClockDrift<>{.channel = Channel::delta, .rate = rate}};
    const RecordedControls controls(ship, ramp);
    // shown at t: the angle at t - delay - rate (t - begin)
    for (const double time : {begin, begin + 0.5, 0.5 * (begin + end), end - 0.5, end})
      CHECK(controls.shown()(time) == Approx(1e-3 * (time + delay - rate * begin) / (1.0 - rate)).margin(1e-12));
  }
}

// at 0.05 L/U a late heading begins to make velocities over ground a false drift, which a start is not told by
TEST_CASE("what carries a ship from the start does not leap with the delay of a channel", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = without(with_instruments(zigzag_run(ship, 0.1), {}),
                     {Channel::u, Channel::v, Channel::rev, Channel::thrust, Channel::speed_through_water});
  for (double& x : run.channels[index_of(Channel::x)]) x += 0.01 * std::sin(40.0 * x);  // positions tell another speed
  const auto rev = [&](Channel channel, double delay) {
    Ship late = ship;
    late.effects = {ChannelDelay<>{.channel = channel, .delay = delay * time_unit_of(ship)}};
    return RecordedControls(late, run).constant().rev;
  };
  for (const auto channel : {Channel::x, Channel::psi})
    for (const double delay : {-0.05, 0.05})
      CHECK_THAT(rev(channel, 1.0001 * delay), WithinRel(rev(channel, 0.9999 * delay), 1e-4));
}

TEST_CASE("a run that does not tell its speed is refused", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = without(zigzag_run(ship, 0.05), {Channel::u, Channel::v, Channel::x, Channel::y});
  run.name = "blind.csv";
  CHECK_THROWS_WITH(replay(ship, run), "blind.csv: no channel tells the speed of the ship at 0 s");
}

TEST_CASE("in a gap the state is on straight lines between what was recorded about it", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship, 0.05);
  const double unit = time_unit_of(ship), begin = 20.0, end = begin + 3.0 * unit;
  const auto before = recorded_state(ship, run, begin - 0.5 * unit),
             after = recorded_state(ship, run, end + 0.5 * unit);
  for (auto& channel : run.channels)
    for (std::size_t i = 0; i < channel.size(); ++i)
      if (run.time[i] > begin && run.time[i] < end) channel[i] = missing;
  for (const double share : {0.3, 0.5, 0.7}) {
    const auto state = recorded_state(ship, run, begin + share * (end - begin));
    for (const auto part : {&ShipState<double>::x, &ShipState<double>::psi}) {
      const double low = std::min(before.*part, after.*part), high = std::max(before.*part, after.*part);
      CHECK(state.*part > low);
      CHECK(state.*part < high);
    }
    CHECK_THAT(state.motion.u, WithinAbs(0.5 * (before.motion.u + after.motion.u), 0.1 * service_speed(ship)));
  }
}

TEST_CASE("controls at times in order are those at each time", "[nonlinear][second-route]") {
  Ship late = test::kvlcc2_l7();
  late.effects = {SteeringGearLag<>{.lag = 1.5}};
  for (const auto& ship : {test::kvlcc2_l7(), late}) {
    const auto run = zigzag_run(test::kvlcc2_l7(), 0.5);
    const RecordedControls controls(ship, run);
    CHECK(controls.track().has_value() == !ship.effects.empty());
    const auto together = controls.at(run.time);
    REQUIRE(together.size() == run.samples());
    for (std::size_t i = 0; i < together.size(); ++i) {
      const auto alone = controls.at(run.time[i]);
      CHECK(together[i].delta == alone.delta);
      CHECK(together[i].rev == alone.rev);
    }
  }
}

}  // namespace
}  // namespace swayaw
