#include "swayaw/linear/batch.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <limits>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using test::printed_indices;
using test::RandomLinearShips;
using test::ten_ten;

constexpr InstructionSet every_set[] = {InstructionSet::best, InstructionSet::numbers, InstructionSet::baseline,
                                        InstructionSet::avx2, InstructionSet::avx512};

struct Fleet {
  std::vector<double> a1, b1, c1, a2, b2, c2;

  void add(const SwayYawCoefficients<double>& m) {
    a1.push_back(m.a1), b1.push_back(m.b1), c1.push_back(m.c1);
    a2.push_back(m.a2), b2.push_back(m.b2), c2.push_back(m.c2);
  }
  SwayYawCoefficients<double> ship(std::size_t i) const { return {a1[i], b1[i], c1[i], a2[i], b2[i], c2[i]}; }
  ShipColumns columns() const { return {a1, b1, c1, a2, b2, c2}; }
  std::size_t size() const { return a1.size(); }
};

/// Random ships, some of first order, some with equal, zero or nearly zero poles.
Fleet fleet_of(std::size_t count, unsigned seed) {
  RandomLinearShips random(seed);
  Fleet fleet;
  for (std::size_t i = 0; i < count; ++i) {
    auto m = random.ship();
    if (i % 17 == 3) m = first_order_ship(-random.uniform(0.3, 5.0), random.uniform(-3.0, 12.0));
    if (i % 97 == 5) m = {-1.0, 0.0, -0.2, 0.5, -1.0, -1.0};
    if (i % 97 == 6) m = {-1.0, 0.5, -0.2, 1.0, -0.5, -1.0};
    if (i % 97 == 7) m = {-1.0, 0.5, -0.2, 1.0, -0.5 + 1e-7 * random.uniform(-1.0, 1.0), -1.0};
    fleet.add(m);
  }
  return fleet;
}

/// Compares to 1e-10.
void check_against_numbers(const Fleet& fleet, const ZigzagTable& table, const LinearZigzagOrder& order) {
  std::size_t compared = 0;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const auto single = linear_zigzag(fleet.ship(i), order).reversals;
    REQUIRE(table.count[i] == single.size());
    for (std::size_t r = 0; r < order.reversals; ++r) {
      const std::size_t cell = table.at(r, i);
      if (r >= single.size()) {
        REQUIRE(std::isnan(table.execute[cell]));
        continue;
      }
      ++compared;
      REQUIRE_THAT(table.execute[cell], WithinAbs(single[r].execute, 1e-10));
      REQUIRE_THAT(table.peak[cell], WithinAbs(single[r].peak, 1e-10));
      REQUIRE_THAT(table.overshoot[cell], WithinAbs(single[r].overshoot, 1e-10 * (1.0 + single[r].overshoot)));
    }
  }
  CHECK(compared > fleet.size() / 2);
}

TEST_CASE("a batch of zigzags is that of the single ships, with every instruction set", "[linear][second-route]") {
  const auto fleet = fleet_of(12'003, 61);
  const LinearZigzagOrder order{.rudder = radians(10),
                                .heading = radians(10),
                                .rate = 0.6,
                                .first = Side::port,
                                .reversals = 6,
                                .longest = 100.0};
  std::size_t unstable = 0, complex = 0;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    unstable += !is_stable(fleet.ship(i));
    complex += has_complex_poles(fleet.ship(i));
  }
  CHECK(unstable > 1000);
  CHECK(complex > 1000);
  for (const auto set : every_set) {
    if (!available(set)) continue;
    INFO("instruction set " << static_cast<int>(set));
    const auto table = zigzag_batch(fleet.columns(), order, {.set = set});
    check_against_numbers(fleet, table, order);
    if (set == InstructionSet::numbers) CHECK(table.by_numbers == fleet.size());
    else CHECK(table.by_numbers < fleet.size() / 2);
  }
}

TEST_CASE("batches agree for slow rudders, fast rudders, steps and angles", "[linear][second-route]") {
  const auto fleet = fleet_of(1000, 62);
  for (const double rate : {0.03, 0.2, 5.0, std::numeric_limits<double>::infinity()})
    for (const double heading : {1.0, 20.0})
      for (const std::size_t reversals : {1u, 3u}) {
        const LinearZigzagOrder order{
            .rudder = radians(15), .heading = radians(heading), .rate = rate, .reversals = reversals, .longest = 150.0};
        INFO("rate " << rate << ", heading " << heading);
        check_against_numbers(fleet, zigzag_batch(fleet.columns(), order), order);
      }
}

TEST_CASE("the number of threads does not matter", "[linear][symmetry]") {
  const auto fleet = fleet_of(2000, 63);
  const LinearZigzagOrder order{
      .rudder = radians(10), .heading = radians(10), .rate = 0.6, .reversals = 4, .longest = 100.0};
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  const auto one = zigzag_batch(fleet.columns(), order, {.threads = 1}),
             seven = zigzag_batch(fleet.columns(), order, {.threads = 7});
  CHECK(std::ranges::equal(one.execute, seven.execute, same));
  CHECK(std::ranges::equal(one.overshoot, seven.overshoot, same));
  CHECK(one.by_numbers == seven.by_numbers);
  auto again = zigzag_batch(fleet_of(5000, 66).columns(), order);
  zigzag_batch(fleet.columns(), order, again);
  CHECK(std::ranges::equal(one.execute, again.execute, same));
  CHECK(one.count == again.count);
}

TEST_CASE("a batch may be empty, and refuses what makes no sense", "[linear][refusal]") {
  const LinearZigzagOrder order{.rudder = 0.1, .heading = 0.1, .rate = 1.0};
  CHECK(zigzag_batch({}, order).execute.empty());
  auto fleet = fleet_of(4, 64);
  fleet.c2.pop_back();
  CHECK_THROWS_WITH(zigzag_batch(fleet.columns(), order), "columns of ship coefficients differ in length");
  CHECK_THROWS_WITH(zigzag_batch(fleet_of(4, 64).columns(), {.rudder = 0.0, .heading = 0.1, .rate = 1.0}),
                    ContainsSubstring("rudder angle"));
  CHECK_THROWS_WITH(
      zigzag_batch(fleet_of(4, 64).columns(), {.rudder = 0.1, .heading = 0.1, .rate = 1.0, .reversals = 17}),
      ContainsSubstring("16 reversals"));
}

TEST_CASE("a ship whose motion changes without end makes no reversal, and the others of her batch make theirs",
          "[linear][refusal]") {
  const LinearZigzagOrder order{.rudder = radians(10.0), .heading = radians(10.0), .rate = radians(10.0)};
  auto fleet = fleet_of(3, 67);
  auto too_fast = RandomLinearShips::tanker();
  for (double* c : {&too_fast.a1, &too_fast.b1, &too_fast.c1, &too_fast.a2, &too_fast.b2, &too_fast.c2}) *c *= 1e56;
  fleet.add(too_fast);
  CHECK_THROWS_WITH(linear_zigzag(too_fast, order), ContainsSubstring("changes too fast to be sailed"));
  const auto table = zigzag_batch(fleet.columns(), order);
  CHECK(table.count[3] == 0);
  CHECK(std::isnan(table.execute[table.at(0, 3)]));
  for (const std::size_t ship : {0, 1, 2}) {
    INFO("ship " << ship);
    CHECK(table.count[ship] == linear_zigzag(fleet.ship(ship), order).reversals.size());
  }
}

TEST_CASE("samples of a zigzag are the states of its legs", "[linear][second-route]") {
  const auto fleet = fleet_of(300, 65);
  const LinearZigzagOrder order{
      .rudder = radians(10), .heading = radians(10), .rate = 0.6, .reversals = 4, .longest = 60.0};
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const LinearResponse<double> ship(fleet.ship(i));
    const auto zigzag = linear_zigzag(ship.m, order);
    const double step = (zigzag.legs.back().from + zigzag.legs.back().length) / 499.0;
    std::vector<LinearState<double>> states(500);
    sample_legs(ship.m, zigzag.legs, step, states);
    std::size_t leg = 0;
    for (std::size_t k = 0; k < states.size(); ++k) {
      const double s = static_cast<double>(k) * step;
      while (leg + 1 < zigzag.legs.size() && zigzag.legs[leg + 1].from <= s) ++leg;
      const auto& l = zigzag.legs[leg];
      const auto x = state_after(ship, l.start, l.rudder, s - l.from);
      const double scale = 1.0 + std::abs(x.psi) + std::abs(x.omega);
      REQUIRE_THAT(states[k].beta, WithinAbs(x.beta, 1e-11 * scale));
      REQUIRE_THAT(states[k].omega, WithinAbs(x.omega, 1e-11 * scale));
      REQUIRE_THAT(states[k].psi, WithinAbs(x.psi, 1e-11 * scale));
    }
  }
  CHECK_THROWS_WITH(sample_legs(fleet.ship(0), {}, 0.1, {}), "no legs to sample");
}

// ---------------------------------------------------------------- maps

void check_map(const SteeringIndices<double>& indices, const LinearZigzagOrder& order, const std::vector<double>& T3b,
               const std::vector<double>& T3w) {
  const auto map = t3_map(indices, order, T3b, T3w);
  for (std::size_t w = 0; w < T3w.size(); ++w)
    for (std::size_t b = 0; b < T3b.size(); ++b) {
      INFO("T3b " << T3b[b] << " T3w " << T3w[w]);
      auto i = indices;
      i.T3b = T3b[b];
      i.T3w = T3w[w];
      const auto ship = coefficients_from(i);
      const auto cycle = limit_cycle(ship, order);
      const auto loop = drift_yaw_loop(ship, cycle.zigzag);
      const auto& point = map.at(b, w);
      if (!loop) {
        CHECK(std::isnan(point.area));
        continue;
      }
      CHECK_THAT(point.area, WithinRel(loop->area, 1e-8));
      CHECK_THAT(point.beta_max, WithinRel(loop->beta_max, 1e-9));
      CHECK_THAT(point.omega_max, WithinRel(loop->omega_max, 1e-9));
      CHECK_THAT(point.omega_at_beta_zero, WithinRel(loop->omega_at_beta_zero, 1e-8));
      CHECK_THAT(point.overshoot1, WithinRel(cycle.zigzag.reversals[0].overshoot, 1e-9));
      CHECK_THAT(point.overshoot2, WithinRel(cycle.zigzag.reversals[1].overshoot, 1e-9));
      CHECK_THAT(point.period, WithinRel(cycle.zigzag.period().value(), 1e-9));
    }
}

TEST_CASE("a map of T3b and T3w is that of the single ships", "[linear][second-route]") {
  check_map(printed_indices(), ten_ten(), {-1.0, 0.0, 0.05, 0.154, 0.309, 0.7, 2.5},
            {-0.3, 0.2, 0.492, 0.983, 1.966, 5.0});
  auto order = ten_ten();
  order.rate = 0.1;
  check_map(printed_indices(), order, {0.1, 0.4, 3.0}, {0.3, 1.2});
}

TEST_CASE("maps of complex, close and unstable poles", "[linear][second-route]") {
  check_map({2.0, 1.5, 0.2, 0.8, -0.9, -1.2}, ten_ten(), {-0.2, 0.1, 0.6}, {0.3, 0.9});
  check_map({1.0, 2.0, 0.2, 0.8, -0.9, -1.2}, ten_ten(), {-0.2, 0.1, 0.6}, {0.3, 0.9});
  check_map({-6.0, -10.0, 0.2, 0.8, 3.0, 4.0}, ten_ten(), {0.1, 0.6}, {0.3, 0.9});
}

TEST_CASE("area grows with |T3w − T3b| from nothing, and T3b leaves the yaw alone", "[linear][limit]") {
  const auto map = t3_map(printed_indices(), ten_ten(), std::vector{0.983, 0.783, 0.583, 1.183}, std::vector{0.983});
  CHECK(map.at(0, 0).area == 0.0);
  CHECK(map.at(0, 0).omega_at_beta_zero == 0.0);
  CHECK_THAT(map.at(2, 0).area, WithinRel(2.0 * map.at(1, 0).area, 1e-12));
  CHECK_THAT(map.at(3, 0).area, WithinRel(map.at(1, 0).area, 1e-12));
  CHECK(map.at(3, 0).period == map.at(0, 0).period);
}

TEST_CASE("the number of threads does not matter to a map; a map without gain is refused", "[linear][refusal]") {
  const std::vector T3b{0.1, 0.2, 0.3}, T3w{0.5, 0.6, 0.7, 0.8};
  const auto one = t3_map(printed_indices(), ten_ten(), T3b, T3w, 1),
             five = t3_map(printed_indices(), ten_ten(), T3b, T3w, 5);
  for (std::size_t i = 0; i < one.points.size(); ++i) CHECK(one.points[i].beta_max == five.points[i].beta_max);
  auto no_gain = printed_indices();
  no_gain.Kb = 0.0;
  CHECK_THROWS_WITH(t3_map(no_gain, ten_ten(), T3b, T3w), "gain Kb must not be zero");
  auto order = ten_ten();
  order.heading = -0.1;
  CHECK_THROWS_WITH(t3_map(printed_indices(), order, T3b, T3w), ContainsSubstring("heading angle"));
}

}  // namespace
}  // namespace swayaw
