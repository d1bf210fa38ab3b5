#include "swayaw/linear/loop.hpp"

#include <catch.hpp>
#include <cmath>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using test::printed_indices;
using test::RandomLinearShips;
using test::ten_ten;
using Indices = SteeringIndices<double>;

TEST_CASE("loops of the ninth reversal agree with the reference", "[linear][published]") {
  const auto& figures = test::reference().at("figure_numbers_printed_TK");
  const std::tuple<const char*, Indices, double> cases[] = {{"REF", printed_indices(), 2.5},
                                                            {"T3b=0.309", printed_indices(0.309), 2.5},
                                                            {"T3w=0.492", printed_indices(0.154, 0.492), 2.5},
                                                            {"T3w=1.966", printed_indices(0.154, 1.966), 2.5},
                                                            {"REF rate0.5", printed_indices(), 0.5}};
  for (const auto& [name, indices, rate] : cases) {
    INFO(name);
    const auto& wanted = figures.at(name);
    const auto ship = coefficients_from(indices);
    // the 'limit loop' of the reference is the one that ends with the ninth reversal, by a polygon of its samples
    auto order = ten_ten(rate);
    order.reversals = 9;
    const auto zigzag = linear_zigzag(ship, order);
    CHECK_THAT(zigzag.period().value(), WithinRel(wanted.at("period_s").get<double>(), 1e-10));
    const auto loop = drift_yaw_loop(ship, zigzag).value();
    const auto& limit = wanted.at("limit_loop");
    CHECK_THAT(loop.area, WithinRel(limit.at("area_rad").get<double>(), 1e-5));
    CHECK_THAT(degrees(loop.beta_max), WithinRel(limit.at("beta_max_deg").get<double>(), 1e-5));
    CHECK_THAT(loop.omega_max, WithinRel(limit.at("omega_max").get<double>(), 1e-5));
    CHECK_THAT(loop.omega_at_beta_zero, WithinRel(limit.at("omega_at_beta0").get<double>(), 1e-4));
    order.reversals = 3;
    const auto first = drift_yaw_loop(ship, linear_zigzag(ship, order)).value();
    CHECK_THAT(first.area, WithinRel(wanted.at("first_loop(exec1..exec3)").at("area_rad").get<double>(), 1e-5));
  }
}

TEST_CASE("the limit cycle repeats itself, a little beyond the ninth reversal", "[linear][limit]") {
  const auto ship = coefficients_from(printed_indices());
  const auto cycle = limit_cycle(ship, ten_ten());
  REQUIRE(cycle.settled);
  const auto loop = drift_yaw_loop(ship, cycle.zigzag).value();
  CHECK_THAT(loop.area, WithinRel(0.04471029, 1e-6));
  CHECK_THAT(cycle.zigzag.period().value(), WithinRel(13.38591504, 1e-8));
  const auto& r = cycle.zigzag.reversals;
  CHECK_THAT(r.back().overshoot, WithinRel(r[r.size() - 2].overshoot, 1e-11));
}

TEST_CASE("as T2 vanishes the limit cycle and its loop settle, as fast as T2", "[linear][limit]") {
  const auto cycle_of = [](double T2) {
    const auto ship = coefficients_from(Indices{10.491 * T2, 10.491 + T2, 0.154, 0.983, -3.464, -4.896});
    const auto cycle = limit_cycle(ship, ten_ten());
    CHECK(cycle.settled);
    CHECK(cycle.zigzag.legs.size() < 130);
    return drift_yaw_loop(ship, cycle.zigzag).value();
  };
  const auto a = cycle_of(1e-3), b = cycle_of(1e-5), c = cycle_of(1e-7);
  CHECK_THAT((a.area - b.area) / (b.area - c.area), WithinRel(100.0, 0.02));
  CHECK_THAT((a.length - b.length) / (b.length - c.length), WithinRel(100.0, 0.02));
}

TEST_CASE("area and moments are those of a fine polygon", "[linear][second-route]") {
  RandomLinearShips random(51);
  int compared = 0;
  for (int k = 0; k < 100; ++k) {
    const auto m = random.ship();
    LinearZigzagOrder order{.rudder = radians(10), .heading = radians(8), .rate = 0.8, .reversals = 5, .longest = 80.0};
    const auto z = linear_zigzag(m, order);
    const auto loop = drift_yaw_loop(m, z);
    if (!loop) continue;
    ++compared;
    const LinearResponse<double> ship(m);
    double area = 0.0, beta_max = 0.0, omega_max = 0.0;
    LinearState<double> first{}, previous{};
    bool started = false;
    const auto add = [&](const LinearState<double>& x) {
      if (!started) first = x;
      else area += 0.5 * (previous.beta * x.omega - x.beta * previous.omega);
      started = true;
      previous = x;
      beta_max = std::max(beta_max, std::abs(x.beta));
      omega_max = std::max(omega_max, std::abs(x.omega));
    };
    for (std::size_t i = z.reversals[z.reversals.size() - 3].leg; i < z.reversals.back().leg; ++i)
      for (int j = 0; j <= 4000; ++j)
        add(state_after(ship, z.legs[i].start, z.legs[i].rudder, z.legs[i].length * j / 4000.0));
    add(first);
    const double scale = beta_max * omega_max;
    CHECK_THAT(loop->area, WithinAbs(std::abs(area), 2e-5 * scale + 1e-4 * loop->area));
    CHECK_THAT(loop->beta_max, WithinRel(beta_max, 1e-3));
    CHECK_THAT(loop->omega_max, WithinRel(omega_max, 1e-3));
    CHECK(loop->width <= loop->length);
  }
  CHECK(compared > 40);
}

TEST_CASE("as T3b nears T3w the loop becomes the first-order line", "[linear][limit]") {
  double previous = 1e9;
  for (const double gap : {0.4, 0.1, 0.01, 0.001}) {
    const auto ship = coefficients_from(printed_indices(0.983 + gap, 0.983));
    const auto loop = drift_yaw_loop(ship, limit_cycle(ship, ten_ten()).zigzag).value();
    CHECK(loop.distance_from_line < previous);
    previous = loop.distance_from_line;
    if (gap == 0.001) CHECK_THAT(loop.inclination, WithinAbs(std::atan2(-4.896, -3.464) + pi, 2e-3));
  }
  CHECK(previous < 1e-3);
}

TEST_CASE("sensitivities of loop and overshoots to T3b and T3w are those of differences", "[linear][second-route]") {
  const double h = 1e-5;
  const auto exact = loop_sensitivity(printed_indices(), ten_ten()).value();
  CHECK(exact.settled);
  for (const bool by_T3w : {false, true}) {
    const auto shifted = [&](double by) {
      return loop_sensitivity(by_T3w ? printed_indices(0.154, 0.983 + by) : printed_indices(0.154 + by), ten_ten())
          .value();
    };
    const auto up = shifted(h), down = shifted(-h);
    const auto& d = by_T3w ? exact.by_T3w : exact.by_T3b;
    const auto check = [&](double LoopMeasures<double>::*measure) {
      const double difference = (up.value.*measure - down.value.*measure) / (2 * h);
      CHECK_THAT(d.*measure, WithinAbs(difference, 1e-6 * (1.0 + std::abs(difference))));
    };
    using M = LoopMeasures<double>;
    for (const auto measure : {&M::area, &M::length, &M::width, &M::inclination, &M::beta_max, &M::omega_max,
                               &M::omega_at_beta_zero, &M::beta_at_omega_zero, &M::distance_from_line})
      check(measure);
    const auto& overshoot = by_T3w ? exact.overshoot_by_T3w : exact.overshoot_by_T3b;
    for (std::size_t i = 0; i < 6; ++i)
      CHECK_THAT(overshoot[i], WithinAbs((up.overshoot[i] - down.overshoot[i]) / (2 * h), 1e-6));
    CHECK_THAT(by_T3w ? exact.period_by_T3w : exact.period_by_T3b,
               WithinAbs((up.period - down.period) / (2 * h), 1e-5));
  }
}

TEST_CASE("T3b changes the loop and not the overshoots", "[linear][published]") {
  const auto s = loop_sensitivity(printed_indices(), ten_ten()).value();
  for (const double x : s.overshoot_by_T3b) CHECK_THAT(x, WithinAbs(0.0, 1e-12));
  CHECK_THAT(s.period_by_T3b, WithinAbs(0.0, 1e-10));
  CHECK(std::abs(s.by_T3b.area) > 1e-3);
}

TEST_CASE("a mirrored zigzag draws the same loop", "[linear][symmetry]") {
  const auto ship = coefficients_from(printed_indices());
  auto starboard = ten_ten();
  starboard.first = Side::starboard;
  const auto a = drift_yaw_loop(ship, linear_zigzag(ship, ten_ten())).value(),
             b = drift_yaw_loop(ship, linear_zigzag(ship, starboard)).value();
  CHECK_THAT(a.area, WithinRel(b.area, 1e-12));
  CHECK_THAT(a.inclination, WithinRel(b.inclination, 1e-12));
}

TEST_CASE("no loop without three reversals, no sensitivity without a ship", "[linear][refusal]") {
  const auto ship = coefficients_from(printed_indices());
  auto order = ten_ten();
  order.reversals = 2;
  CHECK_FALSE(drift_yaw_loop(ship, linear_zigzag(ship, order)).has_value());
  CHECK_THROWS_WITH(loop_sensitivity(printed_indices(0.5, 0.5), ten_ten()), ContainsSubstring("T3b and T3w are equal"));
}

}  // namespace
}  // namespace swayaw
