#include "swayaw/nonlinear/manoeuvre.hpp"

#include <array>
#include <catch.hpp>

#include "froude_scaled.hpp"
#include "random_manoeuvres.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"
#include "swayaw/nonlinear/manoeuvres/williamson_turn.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw {
namespace {

using test::froude_scaled;
using test::RandomShips;
using test::with_model;

const ZigzagOrder ten_ten{.rudder = radians(10), .heading = radians(10), .first = Side::starboard};

/// Zigzag with classical Runge–Kutta steps of fixed length and a switch found by bisection of the step:
/// a second route that shares the forces only.
std::vector<double> slow_zigzag(const MmgShip<double>& ship, const ZigzagOrder& order, double end, double h) {
  using State = std::array<double, 7>;  // x, y, psi, u, v, r, delta
  const double U = ship.particulars.U_0, rev = self_propulsion_rev(ship, U);
  double target = rudder_sign(order.first) * order.rudder, turn = yaw_sign(order.first);
  const auto rate = [&](const State& s, double slope) {
    const PlanarMotion<double> m{s[3], s[4], s[5]};
    const auto a = acceleration(ship, m, forces(ship, m, Controls<double>{s[6], rev}).total());
    return State{m.u * std::cos(s[2]) - m.v * std::sin(s[2]),
                 m.u * std::sin(s[2]) + m.v * std::cos(s[2]),
                 m.r,
                 a.u,
                 a.v,
                 a.r,
                 slope};
  };
  const auto step = [&](const State& s, double length, double slope) {
    const auto plus = [](const State& a, const State& k, double f) {
      State b = a;
      for (std::size_t i = 0; i < b.size(); ++i) b[i] += f * k[i];
      return b;
    };
    const State k1 = rate(s, slope), k2 = rate(plus(s, k1, length / 2), slope),
                k3 = rate(plus(s, k2, length / 2), slope), k4 = rate(plus(s, k3, length), slope);
    State next = s;
    for (std::size_t i = 0; i < next.size(); ++i) next[i] += length / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    return next;
  };
  std::vector<double> switches;
  State s{0, 0, 0, U, 0, 0, 0};
  for (double t = 0.0; t < end;) {
    const double left = target - s[6];
    const double slope = left == 0.0 ? 0.0 : std::copysign(ship.steering_gear.rate, left);
    double length = slope != 0.0 ? std::min(h, std::abs(left) / ship.steering_gear.rate) : h;
    const bool arrives = slope != 0.0 && length < h;
    State next = step(s, length, slope);
    if (turn * next[2] >= order.heading) {
      double low = 0.0, high = length;
      for (int i = 0; i < 60; ++i) {
        length = 0.5 * (low + high);
        (turn * step(s, length, slope)[2] >= order.heading ? high : low) = length;
      }
      s = step(s, length, slope);
      t += length;
      switches.push_back(t);
      target = turn * order.rudder;
      turn = -turn;
      continue;
    }
    s = next;
    if (arrives) s[6] = target;
    t += length;
  }
  return switches;
}

TEST_CASE("zigzag switches agree with a fixed-step integration", "[nonlinear][second-route]") {
  RandomShips random(11);
  for (int i = 0; i < 10; ++i) {
    const auto ship = random.ship();
    const ZigzagOrder order{.rudder = radians(random.uniform(5, 20)),
                            .heading = radians(random.uniform(3, 20)),
                            .first = i % 2 ? Side::port : Side::starboard};
    const double end = 15.0 * ship.particulars.L / ship.particulars.U_0;
    const auto slow = slow_zigzag(ship, order, end, 2e-3 * ship.particulars.L / ship.particulars.U_0);
    const auto fast = zigzag(with_model(ship), order, {.duration = end});
    REQUIRE(fast.reversals.size() == slow.size());
    for (std::size_t k = 0; k < slow.size(); ++k) CHECK_THAT(fast.reversals[k].time, WithinAbs(slow[k], 1e-5));
  }
}

TEST_CASE("the rudder is reversed at the switch angle and the peak is where yaw rate is zero", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto whole = zigzag(ship, ten_ten, {.duration = 100.0});
  for (const auto& reversal : whole.reversals) {
    const auto until_switch = zigzag(ship, ten_ten, {.duration = reversal.time, .step = reversal.time / 8});
    CHECK_THAT(std::abs(until_switch.run[Channel::psi].back()), WithinAbs(radians(10), 1e-9));
    const auto until_peak = zigzag(ship, ten_ten, {.duration = *reversal.peak_time, .step = *reversal.peak_time / 8});
    CHECK_THAT(until_peak.run[Channel::r].back(), WithinAbs(0.0, 1e-10));
    CHECK_THAT(std::abs(until_peak.run[Channel::psi].back()) - radians(10), WithinAbs(*reversal.overshoot, 1e-9));
  }
}

TEST_CASE("the rudder never leaves its order and never moves faster than the gear", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2();
  const auto run = zigzag(ship, {.rudder = radians(20), .heading = radians(5), .first = Side::port},
                          {.duration = 1500.0, .step = 0.25})
                       .run;
  const auto delta = run[Channel::delta];
  for (std::size_t i = 1; i < delta.size(); ++i) {
    REQUIRE(std::abs(delta[i]) <= radians(20) * (1.0 + 1e-12));
    REQUIRE(std::abs(delta[i] - delta[i - 1]) <= 0.25 * steering_gear(ship).rate * (1.0 + 1e-9));
  }
  CHECK(delta.front() == 0.0);
}

TEST_CASE("a mirrored ship makes the mirrored zigzag", "[nonlinear][symmetry]") {
  RandomShips random(12);
  for (int i = 0; i < 20; ++i) {
    const auto ship = random.ship();
    const auto starboard = zigzag(with_model(ship), ten_ten, {.duration = 100.0});
    const auto port = zigzag(with_model(test::mirrored(ship)),
                             {.rudder = radians(10), .heading = radians(10), .first = Side::port}, {.duration = 100.0});
    REQUIRE(port.reversals.size() == starboard.reversals.size());
    for (std::size_t k = 0; k < port.reversals.size(); ++k)
      CHECK_THAT(port.reversals[k].time, WithinAbs(starboard.reversals[k].time, 1e-7));
    CHECK_THAT(port.run[Channel::y].back(), WithinAbs(-starboard.run[Channel::y].back(), 1e-7));
  }
}

TEST_CASE("a ship scaled by Froude makes the same zigzag in scaled time", "[nonlinear][limit]") {
  const auto ship = test::mmg(test::kvlcc2_l7());
  const double n = 45.7;
  const auto model = zigzag(with_model(ship), ten_ten, {.duration = 100.0});
  const auto full = zigzag(with_model(froude_scaled(ship, n)), ten_ten, {.duration = 100.0 * std::sqrt(n)});
  REQUIRE(model.reversals.size() == full.reversals.size());
  for (std::size_t k = 0; k < model.reversals.size(); ++k) {
    CHECK_THAT(full.reversals[k].time, WithinRel(model.reversals[k].time * std::sqrt(n), 1e-9));
    CHECK_THAT(full.reversals[k].overshoot.value(), WithinRel(model.reversals[k].overshoot.value(), 1e-8));
  }
}

TEST_CASE("sampling does not change the manoeuvre", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto fine = zigzag(ship, ten_ten, {.step = 0.01});
  const auto none = zigzag(ship, ten_ten, {.sampled = false});
  REQUIRE(fine.reversals.size() == none.reversals.size());
  for (std::size_t k = 0; k < fine.reversals.size(); ++k) CHECK(fine.reversals[k].time == none.reversals[k].time);
  CHECK(none.run.samples() == 0);
}

TEST_CASE("a tighter tolerance gives a smaller error", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto last_switch = [&](double tolerance) {
    return zigzag(ship, ten_ten, {.duration = 100.0, .tolerance = tolerance, .sampled = false}).reversals.back().time;
  };
  const double exact = last_switch(1e-13);
  CHECK(std::abs(last_switch(1e-6) - exact) < 1e-4);
  CHECK(std::abs(last_switch(1e-9) - exact) < 1e-7);
}

TEST_CASE("indices that were not reached are not told", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto short_turn = turning_circle(ship, {.rudder = radians(35)}, {.duration = 30.0});
  CHECK(short_turn.advance.has_value());
  CHECK_FALSE(short_turn.tactical_diameter.has_value());
  const auto short_zigzag = zigzag(ship, ten_ten, {.duration = 5.0});
  CHECK(short_zigzag.reversals.empty());
  CHECK_FALSE(short_zigzag.period.has_value());
}

TEST_CASE("the way made is the length of the track", "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto circle = turning_circle(ship, {.rudder = radians(35)}, {.step = 0.01});
  double way = 0.0;
  for (std::size_t i = 1; circle.run[Channel::psi][i] < radians(10); ++i)
    way += std::hypot(circle.run[Channel::x][i] - circle.run[Channel::x][i - 1],
                      circle.run[Channel::y][i] - circle.run[Channel::y][i - 1]);
  CHECK_THAT(circle.initial_turning.value(), WithinAbs(way, 0.02));
}

TEST_CASE("what is measured on samples does not depend on the step of those that are written",
          "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto circle = turning_circle(ship, {.rudder = radians(35)});
  const auto pulled = pull_out(ship, {.rudder = radians(20)});
  for (const double step : {0.05, 1.0, 20.0}) {
    INFO(step);
    CHECK(zigzag(ship, ten_ten, {.step = step}).initial_turning == zigzag(ship, ten_ten).initial_turning);
    CHECK(turning_circle(ship, {.rudder = radians(35)}, {.step = step}).initial_turning == circle.initial_turning);
    CHECK(williamson_turn(ship, {.rudder = radians(35)}, {.step = step}).way ==
          williamson_turn(ship, {.rudder = radians(35)}).way);
    const auto again = pull_out(ship, {.rudder = radians(20)}, {.step = step});
    for (const auto side : {&Sides<PullOutSide>::port, &Sides<PullOutSide>::starboard}) {
      CHECK((again.sides.*side).fall_time == (pulled.sides.*side).fall_time);
      CHECK((again.sides.*side).decay_time == (pulled.sides.*side).decay_time);
    }
  }
}

TEST_CASE("a steady turn is in balance", "[nonlinear][limit]") {
  RandomShips random(13);
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const auto model = random.ship();
    const Ship ship = with_model(model);
    const auto circle = turning_circle(ship, {.rudder = model.steering_gear.max_angle});
    if (!circle.steady) continue;
    ++found;
    const Controls<double> controls{rudder_sign(Side::starboard) * model.steering_gear.max_angle,
                                    circle.propulsion.rev};
    const auto a = acceleration(model, *circle.steady, forces(model, *circle.steady, controls).total());
    const double unit = model.particulars.U_0 * model.particulars.U_0 / model.particulars.L;
    CHECK_THAT(a.u, WithinAbs(0.0, 1e-12 * unit));
    CHECK_THAT(a.v, WithinAbs(0.0, 1e-12 * unit));
    CHECK_THAT(a.r * model.particulars.L, WithinAbs(0.0, 1e-12 * unit));
  }
  CHECK(found > 20);
}

TEST_CASE("senseless orders are refused in words", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_WITH(zigzag(ship, {.rudder = radians(40), .heading = radians(10)}),
                    "rudder angle 40 deg is beyond the ship's largest, 35 deg");
  CHECK_THROWS_WITH(zigzag(ship, {.rudder = radians(-10), .heading = radians(10)}),
                    ContainsSubstring("rudder angle [rad] must be positive"));
  CHECK_THROWS_WITH(zigzag(ship, {.rudder = radians(10), .heading = 0.0}),
                    "heading angle [rad] must be positive, got 0");
  CHECK_THROWS_WITH(turning_circle(ship, {.rudder = radians(20)}, {.speed = -1.0}),
                    "approach speed [m/s] must be positive, got -1");
  CHECK_THROWS_WITH(turning_circle(ship, {.rudder = radians(20)}, {.duration = 0.0}),
                    "duration [s] must be positive, got 0");
}

TEST_CASE("a ship that turns until she stops is refused with the loss of her way", "[nonlinear][refusal]") {
  // at 35 deg the published gap factor turns the lift round; she turns to the wrong side, ever more across her course
  auto ship = read_ship(test::ships / "wpcc_pi.toml");
  const TurnOrder hard{.rudder = radians(35)};
  CHECK_THROWS_WITH(turning_circle(ship, hard),
                    ContainsSubstring("the ship loses her way at 14.9") && ContainsSubstring("for way ahead only"));
  // where the lift ends at zero, the rudder's drag stops her, but much later
  std::get<PiShip<double>>(ship.model).rudder.gap_factor.index = 1;
  CHECK_THROWS_WITH(turning_circle(ship, hard), ContainsSubstring("the ship loses her way at 5"));
  CHECK(turning_circle(ship, {.rudder = radians(30)}).steady.has_value());
}

TEST_CASE("a motion without bound is refused, not tabled", "[nonlinear][refusal]") {
  auto model = test::mmg(test::kvlcc2_l7());
  for (double* derivative : {&model.hull.N_rrr, &model.hull.Y_vvv, &model.hull.X_vvvv}) *derivative = 50.0;
  CHECK_THROWS_WITH(turning_circle(with_model(model), {.rudder = radians(35)}),
                    ContainsSubstring("grows without bound"));
}

TEST_CASE("a ship whose propeller cannot carry her is refused", "[nonlinear][refusal]") {
  auto model = test::mmg(test::kvlcc2_l7());
  model.propeller.k_1 = 0.0;
  model.propeller.k_2 = 50.0;  // a thrust curve that never falls
  CHECK_THROWS_AS(self_propulsion_rev(model, 1.0), Refusal);
}

}  // namespace
}  // namespace swayaw
