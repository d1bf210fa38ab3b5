#include "swayaw/nonlinear/simulation/batch.hpp"

#include <catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "random_manoeuvres.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw {
namespace {

using test::RandomShips;
using test::with_model;

constexpr InstructionSet every_set[] = {InstructionSet::numbers, InstructionSet::baseline, InstructionSet::avx2,
                                        InstructionSet::avx512};

ZigzagOrder ten_ten(Side first) { return {.rudder = radians(10), .heading = radians(10), .first = first}; }

/// Coefficients of the KVLCC2 within a share, some with other selections and steering gear.
std::vector<MmgShip<double>> fleet_of(std::size_t count, unsigned seed, double share = 0.1) {
  RandomShips random(seed);
  std::vector<MmgShip<double>> ships(count, test::mmg(test::kvlcc2_l7()));
  for (std::size_t i = 0; i < count; ++i) {
    auto& ship = ships[i];
    const auto shake = [&](const auto& section) {
      auto& part = ship.*section.part;
      for (const auto& p : part.parameters())
        if (p.role == Role::coefficient) part.*p.member *= 1.0 + share * random.uniform(-1.0, 1.0);
    };
    std::apply([&](const auto&... section) { (shake(section), ...); }, MmgShip<double>::sections());
    if (i % 3 == 1) ship.steering_gear.lag = random.uniform(0.1, 1.0);
    if (i % 4 == 1) ship.steering_gear.dead_band = radians(random.uniform(0.1, 1.0));
    if (i % 5 == 1) ship.added_mass.surge_coupling.index = 1;
  }
  return ships;
}

/// A number, or not a number twice.
bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same(const ZigzagBatch& a, std::size_t i, const ZigzagBatch& b, std::size_t k) {
  bool all = a.end[i] == b.end[k] && a.count[i] == b.count[k];
  for (std::size_t r = 0; r < a.reversals; ++r)
    all = all && same(a.time[a.at(r, i)], b.time[b.at(r, k)]) &&
          same(a.peak_time[a.at(r, i)], b.peak_time[b.at(r, k)]) &&
          same(a.overshoot[a.at(r, i)], b.overshoot[b.at(r, k)]);
  return all;
}

/// Compares a ship of a batch with her own zigzag at a small tolerance. @return how many overshoots both made
std::size_t check_ship(const ZigzagBatch& batch, std::size_t i, const Zigzag& alone, double time, double angle) {
  const auto& reversals = alone.reversals;
  std::size_t overshoots = 0;
  for (std::size_t r = 0; r < batch.reversals; ++r) {
    const std::size_t cell = batch.at(r, i);
    REQUIRE(std::isnan(batch.time[cell]) == (r >= reversals.size()));
    if (r >= reversals.size()) continue;
    REQUIRE_THAT(batch.time[cell], WithinAbs(reversals[r].time, time));
    REQUIRE(std::isnan(batch.overshoot[cell]) == !reversals[r].overshoot.has_value());
    if (!reversals[r].overshoot) continue;
    ++overshoots;
    REQUIRE_THAT(batch.peak_time[cell], WithinAbs(*reversals[r].peak_time, time));
    REQUIRE_THAT(batch.overshoot[cell], WithinAbs(*reversals[r].overshoot, angle));
  }
  CHECK(batch.count[i] == overshoots);
  return overshoots;
}

TEST_CASE("a batch of MMG zigzags is that of the single ships, with every instruction set",
          "[nonlinear][second-route]") {
  const auto ships = fleet_of(500, 81);
  for (const Side first : {Side::port, Side::starboard}) {
    std::vector<Zigzag> alone;
    for (const auto& ship : ships)
      alone.push_back(
          zigzag(with_model(ship), ten_ten(first), {.duration = 100.0, .tolerance = 1e-11, .sampled = false}));
    for (const auto set : every_set) {
      if (!available(set)) continue;
      INFO("instruction set " << static_cast<int>(set));
      const auto batch =
          zigzag_batch(ships, ten_ten(first), {.reversals = 8, .duration = 100.0, .batch = {.set = set}});
      std::size_t overshoots = 0;
      for (std::size_t i = 0; i < ships.size(); ++i) {
        overshoots += check_ship(batch, i, alone[i], 1e-4, radians(1e-4));
        CHECK(batch.end[i] == ZigzagEnd::time_over);
      }
      CHECK(overshoots > 2 * ships.size());
    }
  }
}

TEST_CASE("a tighter tolerance brings a batch of zigzags nearer to the single ships", "[nonlinear][limit]") {
  const auto ships = fleet_of(60, 82);
  const auto batch = zigzag_batch(ships, ten_ten(Side::starboard), {.tolerance = 1e-10});
  for (std::size_t i = 0; i < ships.size(); ++i) {
    check_ship(batch, i, zigzag(with_model(ships[i]), ten_ten(Side::starboard), {.tolerance = 1e-12, .sampled = false}),
               1e-7, 1e-8);
    CHECK(batch.end[i] == ZigzagEnd::complete);
  }
}

TEST_CASE("ships limited by the torque of their engine make the same zigzag in a batch", "[nonlinear][second-route]") {
  auto ships = fleet_of(20, 83);
  RandomShips random(84);
  for (std::size_t i = 0; i < ships.size(); ++i) {
    auto& ship = ships[i];
    ship.propeller.q_0 = 0.031;
    ship.propeller.q_1 = -0.026;
    ship.propeller.q_2 = -0.013;
    const Controls<double> ahead = self_propulsion(ship, ship.particulars.U_0);
    ship.engine.kind.index = i % 3 != 0;
    ship.engine.Q_max = random.uniform(1.001, 1.05) *
                        torque(ship, ahead.rev, propeller_inflow(ship.propeller, ship.particulars.U_0, 0.0, false));
  }
  const auto batch = zigzag_batch(ships, ten_ten(Side::port), {.tolerance = 1e-8});
  for (std::size_t i = 0; i < ships.size(); ++i)
    check_ship(batch, i, zigzag(with_model(ships[i]), ten_ten(Side::port), {.tolerance = 1e-11, .sampled = false}),
               1e-5, 1e-6);
}

TEST_CASE("a ship makes the same zigzag whatever her neighbours and the number of threads", "[nonlinear][symmetry]") {
  const auto ships = fleet_of(1100, 85);
  std::vector<std::size_t> shuffled(ships.size());
  std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(86));
  std::vector<MmgShip<double>> mixed;
  for (const std::size_t i : shuffled) mixed.push_back(ships[i]);
  for (const auto set : every_set) {
    if (!available(set) || set == InstructionSet::numbers) continue;
    INFO("instruction set " << static_cast<int>(set));
    const auto one = zigzag_batch(ships, ten_ten(Side::port), {.batch = {.threads = 1, .set = set}});
    const auto many = zigzag_batch(mixed, ten_ten(Side::port), {.batch = {.threads = 5, .set = set}});
    for (std::size_t k = 0; k < ships.size(); ++k) REQUIRE(same(one, shuffled[k], many, k));
    for (const std::size_t i : {std::size_t{3}, std::size_t{700}}) {
      const auto alone = zigzag_batch({&ships[i], 1}, ten_ten(Side::port), {.batch = {.set = set}});
      REQUIRE(same(one, i, alone, 0));
    }
  }
}

TEST_CASE("a ship that never turns, or cannot propel herself, does not hold up the others", "[nonlinear][refusal]") {
  const auto all = fleet_of(40, 87);
  auto some = all;
  some[7].rudder.f_alpha = 1e-9;  // no rudder force to speak of
  some[7].hull.N_r = -10.0;
  some[11].hull.R_0 = 0.0;  // thrust at any shaft speed, but no resistance
  some[11].propeller.k_1 = 0.0;
  some[11].propeller.k_2 = 1.0;
  some[13].hull.N_v = -40.0;  // drift that feeds itself
  some[13].hull.N_vvv = some[13].hull.N_vvr = -1e3;
  some[13].hull.Y_v = some[13].hull.Y_vvv = 40.0;
  for (const auto set : every_set) {
    if (!available(set)) continue;
    INFO("instruction set " << static_cast<int>(set));
    const auto without = zigzag_batch(all, ten_ten(Side::port), {.batch = {.set = set}});
    const auto with = zigzag_batch(some, ten_ten(Side::port), {.batch = {.set = set}});
    CHECK(with.end[7] == ZigzagEnd::time_over);
    CHECK(with.count[7] == 0);
    CHECK(std::isnan(with.time[with.at(0, 7)]));
    CHECK(with.end[11] == ZigzagEnd::no_propulsion);
    CHECK(with.end[13] == ZigzagEnd::unbounded);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i != 7 && i != 11 && i != 13) CHECK(same(with, i, without, i));
  }
  CHECK(in_words(ZigzagEnd::no_propulsion) == "no shaft speed propels the ship at the approach speed");
}

TEST_CASE("a batch of MMG zigzags may be empty, and refuses what makes no sense", "[nonlinear][refusal]") {
  CHECK(zigzag_batch({}, ten_ten(Side::port)).time.empty());
  const auto ships = fleet_of(3, 88);
  CHECK_THROWS_WITH(zigzag_batch(ships, {.rudder = radians(40), .heading = 0.1}),
                    ContainsSubstring("beyond the ship's largest"));
  CHECK_THROWS_WITH(zigzag_batch(ships, {.rudder = 0.1, .heading = 0.0}), ContainsSubstring("heading angle"));
  CHECK_THROWS_WITH(zigzag_batch(ships, ten_ten(Side::port), {.reversals = 0}),
                    ContainsSubstring("1 to 255 reversals"));
  CHECK_THROWS_WITH(zigzag_batch(ships, ten_ten(Side::port), {.tolerance = 0.0}), ContainsSubstring("tolerance"));
  CHECK_THROWS_WITH(zigzag_batch(ships, ten_ten(Side::port), {.speed = -1.0}), ContainsSubstring("approach speed"));
}

}  // namespace
}  // namespace swayaw
