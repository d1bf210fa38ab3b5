#include "swayaw/nonlinear/surroundings/recorded_surroundings.hpp"

#include <catch.hpp>
#include <cmath>

#include "gusty_run.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Wind and depth of a recording, against simulations in them and against the effects of the same name.
namespace swayaw {
namespace {

using test::run_in_wind;
using test::WanderingWind;
using test::without_wind;

const Ship& pond_model() {
  static const Ship ship = published_ship("esso_osaka_3m");
  return ship;
}

/// 1.5 m/s from the north-east, on a ship of 0.35 m/s.
constexpr test::AirMoves mean_wind{-1.2, -0.9};

double unit_of_time(const Ship& ship) { return time_unit_of(ship); }

/// Root mean square of the difference.
double rms_difference(const Recording& a, const Recording& b, Channel channel) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.samples(); ++i) sum += std::pow(a[channel][i] - b[channel][i], 2);
  return std::sqrt(sum / static_cast<double>(a.samples()));
}

/// A run with columns of a wind, constant but for what `change` makes of them.
template <class Change>
Recording with_columns(Recording run, const Wind<double>& wind, Change&& change) {
  auto speed = run.fill(Channel::wind_speed), from = run.fill(Channel::wind_from);
  for (std::size_t i = 0; i < run.samples(); ++i) speed[i] = wind.speed, from[i] = wind.from, change(i, speed, from);
  return run;
}

Recording with_columns(Recording run, const Wind<double>& wind) {
  return with_columns(std::move(run), wind, [](std::size_t, auto, auto) {});
}

Recording calm_run(double lengths = 15.0) {
  return without_wind(run_in_wind(pond_model(), {{0.0, 0.0}, 0.0, 1.0, 1}, lengths));
}

Ship in_steady_wind(const Wind<double>& wind) { return with_effect(pond_model(), SteadyWind<>{wind.speed, wind.from}); }

constexpr std::array place_and_velocity{Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r};

void check_same(const Recording& a, const Recording& b, double tolerance) {
  for (const auto channel : place_and_velocity) {
    INFO(column_name(channel));
    CHECK(rms_difference(a, b, channel) <= tolerance);
  }
}

}  // namespace

TEST_CASE("a replay with the recorded gusty wind sails as the ship did, and one without it does not",
          "[nonlinear][second-route]") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto run = run_in_wind(pond_model(), {mean_wind, 0.5, unit_of_time(pond_model()), seed});
    const auto with = replay(pond_model(), run), without = replay(pond_model(), without_wind(run));
    INFO(seed);
    for (const auto channel : place_and_velocity) {
      INFO(column_name(channel));
      CHECK(rms_difference(with, run, channel) < 0.1 * rms_difference(without, run, channel));
    }
    CHECK(rms_difference(without, run, Channel::y) > length(pond_model()));
  }
}

TEST_CASE("a recorded wind that never changes is a steady wind", "[nonlinear][second-route]") {
  const auto run = calm_run();
  for (const Wind<double> wind : {Wind<double>{1.5, 0.7}, {2.0, -2.5}})
    check_same(replay(pond_model(), with_columns(run, wind)), replay(in_steady_wind(wind), run), 1e-7);
}

TEST_CASE("recorded wind and wind of the ship's effects add as vectors", "[nonlinear][second-route]") {
  const auto run = calm_run();
  const auto both = replay(in_steady_wind({0.9, 0.0}), with_columns(run, {1.2, 0.5 * pi}));
  check_same(both, replay(in_steady_wind({1.5, std::atan2(1.2, 0.9)}), run), 1e-7);
  auto gust = pond_model();
  gust.effects.push_back(Gust<>{0.9, 0.0, 40.0, 70.0});
  auto blown = gust;
  blown.effects.push_back(SteadyWind<>{1.2, 0.5 * pi});
  check_same(replay(gust, with_columns(run, {1.2, 0.5 * pi})), replay(blown, run), 1e-7);
}

TEST_CASE("missing samples of the wind are bridged", "[nonlinear][limit]") {
  const auto run = calm_run();
  const Wind<double> wind{1.5, 0.7};
  const auto gappy = with_columns(run, wind, [&](std::size_t i, auto speed, auto from) {
    if (i < 20 || (i > 100 && i < 300)) speed[i] = missing;
    if (i % 3 == 0 || i + 40 > run.samples()) from[i] = missing;
  });
  check_same(replay(pond_model(), gappy), replay(pond_model(), with_columns(run, wind)), 1e-9);
}

TEST_CASE("without wind columns, without windage, or in a calm that was recorded, nothing changes a bit",
          "[nonlinear][limit]") {
  const auto run = calm_run();
  const auto calm = replay(pond_model(), run);
  check_same(replay(pond_model(), with_columns(run, {0.0, 1.0})), calm, 0.0);
  auto bare = pond_model();
  bare.surroundings.windage = {};
  check_same(replay(bare, with_columns(run, {3.0, 1.0})), calm, 0.0);
  CHECK(recorded_wind(bare, with_columns(run, {3.0, 1.0})).empty());
  REQUIRE(measured_in_vain(bare, with_columns(run, {3.0, 1.0})).size() == 1);
  CHECK_THAT(measured_in_vain(bare, with_columns(run, {3.0, 1.0})).front(), ContainsSubstring("[windage]"));
  CHECK(measured_in_vain(pond_model(), with_columns(run, {3.0, 1.0})).empty());
  const auto half = [&] {
    auto half_run = with_columns(run, {3.0, 1.0});
    half_run.channels[index_of(Channel::wind_from)].clear();
    return half_run;
  }();
  check_same(replay(pond_model(), half), calm, 0.0);
  CHECK_THAT(measured_in_vain(pond_model(), half).front(), ContainsSubstring("wind_from"));
}

TEST_CASE("pieces of wind have its mean, begin at samples and are no longer than said", "[nonlinear][limit]") {
  const auto run = run_in_wind(pond_model(), {mean_wind, 0.5, unit_of_time(pond_model()), 7}, 20.0);
  const auto wind = recorded_wind(pond_model(), run);
  const double longest = wind_averaging * unit_of_time(pond_model());
  double north = 0.0, samples = 0.0;
  for (std::size_t k = 0; k < wind.size(); ++k) {
    const double from = k == 0 ? run.time.front() : wind[k].time,
                 to = k + 1 < wind.size() ? wind[k + 1].time : run.time.back();
    CHECK(std::ranges::binary_search(run.time, from));
    CHECK(to - from <= longest * (1.0 + 1e-9));
    north += wind[k].north * (to - from);
  }
  double mean = 0.0;
  for (std::size_t i = 0; i < run.samples(); ++i)
    mean -= run[Channel::wind_speed][i] * std::cos(run[Channel::wind_from][i]), ++samples;
  CHECK_THAT(north / (run.time.back() - run.time.front()), WithinRel(mean / samples, 2e-3));
}

TEST_CASE("a replay that begins in the middle has the wind of that time", "[nonlinear][round-trip]") {
  const auto run = run_in_wind(pond_model(), {mean_wind, 0.5, unit_of_time(pond_model()), 5}, 20.0);
  const RecordedControls controls(pond_model(), run);
  const auto times = std::span(run.time).subspan(600, 300);
  const auto part = replay_from(pond_model(), controls, recorded_state(pond_model(), run, times.front()), times);
  double sum = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) sum += std::pow(part[Channel::v][i] - run[Channel::v][600 + i], 2);
  CHECK(std::sqrt(sum / 300.0) < 5e-3 * service_speed(pond_model()));
}

TEST_CASE("a delay that the ship's instruments have in the wind is undone", "[nonlinear][second-route]") {
  const auto run = run_in_wind(pond_model(), {mean_wind, 0.5, unit_of_time(pond_model()), 5}, 20.0);
  const double delay = 0.4 * unit_of_time(pond_model());
  auto late = pond_model();
  late.effects.push_back(ChannelDelay<>{Channel::wind_speed, delay});
  late.effects.push_back(ChannelDelay<>{Channel::wind_from, delay});
  const auto recorded = as_recorded(run, instruments_of(late));
  const auto known = replay(late, recorded), believed = replay(pond_model(), recorded);
  CHECK(rms_difference(known, run, Channel::v) < 0.3 * rms_difference(believed, run, Channel::v));
}

// ---------------------------------------------------------------- depth

TEST_CASE("a run with a measured depth is sailed as in shallow water of that depth", "[nonlinear][second-route]") {
  auto run = calm_run();
  const double draught = std::get<MmgShip<double>>(pond_model().model).particulars.d;
  const auto in_water = with_effect(pond_model(), ShallowWater<>{1.5});
  const auto shallow = replay(in_water, run);
  run.facts.water_depth = 1.5 * draught;
  check_same(replay(pond_model(), run), shallow, 0.0);
  run.facts.water_depth.reset();
  auto sounder = run.fill(Channel::depth);
  for (std::size_t i = 0; i < sounder.size(); i += 2) sounder[i] = (1.5 + (i % 4 == 0 ? 0.0 : 1e-9)) * draught;
  check_same(replay(pond_model(), run), shallow, 1e-6);
  CHECK(measured_in_vain(pond_model(), run).empty());
  CHECK(rms_difference(shallow, calm_run(), Channel::psi) > radians(5));
}

TEST_CASE("deep water changes nothing, and a depth that the ship's effects tell is believed", "[nonlinear][limit]") {
  auto run = calm_run();
  const auto deep = replay(pond_model(), run);
  const double draught = std::get<MmgShip<double>>(pond_model().model).particulars.d;
  run.facts.water_depth = (deep_water + 0.1) * draught;
  check_same(replay(pond_model(), run), deep, 0.0);
  const auto in_water = with_effect(pond_model(), ShallowWater<>{2.5});
  const auto told = replay(in_water, run);
  run.facts.water_depth = 1.5 * draught;
  check_same(replay(in_water, run), told, 0.0);
}

TEST_CASE("sway forces in water that counts as deep differ by less than 1 per cent", "[nonlinear][limit]") {
  const auto at = [](double depth) { return shallow_water_factors(0.8, depth, ShallowWaterGrowth<>{}).sway; };
  CHECK(at(deep_water) < 1.01);
  CHECK(at(0.9 * deep_water) > 1.01);
}

TEST_CASE("what cannot act of a measured depth is said", "[nonlinear][refusal]") {
  auto run = calm_run();
  run.facts.water_depth = 0.1;
  CHECK_THAT(measured_in_vain(pond_model(), run).front(), ContainsSubstring("draughts"));
  run.facts.water_depth = 12.0;
  CHECK_THAT(measured_in_vain(published_ship("mariner"), run).front(), ContainsSubstring("depth of 12 m is not used"));
  CHECK_FALSE(in_depth(published_ship("mariner"), 12.0));
}

}  // namespace swayaw
