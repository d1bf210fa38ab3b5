#include <cmath>

#include "catch.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// What engine and steering gear do to a simulated ship.
namespace swayaw {
namespace {

/// KVLCC2 with a torque curve, and the torque of her straight course as the largest, times a factor.
MmgShip<double> with_engine(double factor) {
  auto ship = test::mmg(test::kvlcc2_l7());
  ship.propeller.q_0 = 0.035;
  ship.propeller.q_1 = -0.025;
  ship.propeller.q_2 = -0.018;
  const double U = ship.particulars.U_0, rev = self_propulsion_rev(ship, U);
  ship.engine.kind.index = 1;
  ship.engine.Q_max = factor * torque(ship, rev, (1.0 - ship.propeller.w_P0) * U);
  return ship;
}

Ship ship_of(const MmgShip<double>& model) {
  return {.name = "ship", .model = model, .confidence = {}, .surroundings = {}};
}

// ---------------------------------------------------------------- engine

TEST_CASE("an engine at its torque limit gives exactly that torque", "[nonlinear][second-route]") {
  test::RandomShips random(61);
  int limited = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto ship = with_engine(random.uniform(0.2, 1.0));
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto branch = branch_at(ship, m, c);
    const double u_P =
        propeller_inflow(ship.propeller, m.u, local_drift(ship, m).propeller, branch[MmgBranch::propeller]);
    const bool held = torque(ship, c.rev, u_P) < ship.engine.Q_max;
    REQUIRE(branch[MmgBranch::torque] == held);
    const double rev = held ? c.rev : rev_at_full_torque(ship, u_P);
    if (!held) {
      ++limited;
      REQUIRE_THAT(torque(ship, rev, u_P), WithinRel(ship.engine.Q_max, 1e-12));
      REQUIRE(rev < c.rev);
    }
    auto free = ship;
    free.engine.kind.index = 0;
    REQUIRE_THAT(forces(ship, m, c).total().X,
                 WithinAbs(forces(free, m, Controls<double>{c.delta, rev}).total().X, 1e-9));
  }
  CHECK(limited > 200);
}

TEST_CASE("an engine with torque to spare changes nothing, a weak one slows the ship in a turn", "[nonlinear][limit]") {
  auto held = with_engine(1.0);
  held.engine.kind.index = 0;
  const TurnOrder order{.rudder = radians(35), .side = Side::starboard};
  const auto circle = turning_circle(ship_of(held), order, {.sampled = false});
  const auto strong = turning_circle(ship_of(with_engine(3.0)), order, {.sampled = false});
  const auto weak = turning_circle(ship_of(with_engine(1.02)), order, {.sampled = false});
  CHECK(strong.tactical_diameter == circle.tactical_diameter);
  REQUIRE(weak.steady);
  CHECK(speed(*weak.steady) < 0.97 * speed(*circle.steady));
}

TEST_CASE("a run across the torque limit converges, since the limit is an event", "[nonlinear][second-route]") {
  const Ship ship = ship_of(with_engine(1.05));
  const TurnOrder order{.rudder = radians(35), .side = Side::port};
  const auto coarse = turning_circle(ship, order, {.tolerance = 1e-6, .sampled = false});
  const auto fine = turning_circle(ship, order, {.tolerance = 1e-12, .sampled = false});
  CHECK_THAT(*coarse.tactical_diameter, WithinRel(*fine.tactical_diameter, 1e-5));
}

TEST_CASE("dual numbers pass through the torque limit", "[nonlinear][second-route]") {
  using D = Dual<1>;
  const auto ship = with_engine(0.8);
  const PlanarMotion<double> m{1.0, 0.05, 0.01};
  const auto x_force = [&](double u) {
    return forces(ship, PlanarMotion<double>{u, m.v, m.r}, Controls<double>{0.1, 11.0}).total().X;
  };
  const auto dual =
      forces(cast<D>(ship), PlanarMotion<D>{D(m.u, 0), D(m.v), D(m.r)}, Controls<D>{D(0.1), D(11.0)}).total().X;
  CHECK_THAT(dual.v[0], WithinRel((x_force(m.u + 1e-5) - x_force(m.u - 1e-5)) / 2e-5, 1e-7));
}

TEST_CASE("the propeller may be driven by its thrust", "[nonlinear][second-route]") {
  test::RandomShips random(62);
  for (int i = 0; i < 200; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const double T = thrust(ship, m, c);
    const Controls<double> given{.delta = c.delta, .thrust = {0.3 * T, 0.7 * T}, .by_thrust = true};
    REQUIRE_THAT(forces(ship, m, given).total().N, WithinRel(forces(ship, m, c).total().N, 1e-12));
  }
}

// ---------------------------------------------------------------- steering gear

/// Zigzag by small Runge–Kutta steps with the rudder as a state, until `reversals` have passed: their times.
std::vector<double> plain_zigzag(const MmgShip<double>& ship, double angle, std::size_t reversals, double step) {
  using State = std::array<double, 5>;  // psi, u, v, r, delta
  const double U = ship.particulars.U_0;
  const auto propulsion = self_propulsion(ship, U);
  const auto& gear = ship.steering_gear;
  double order = -angle, turn = 1.0, time = 0.0;
  const auto rates = [&](const State& s) {
    const PlanarMotion<double> m{s[1], s[2], s[3]};
    const auto a = acceleration(ship, m, forces(ship, m, with_rudder(propulsion, s[4])).total());
    const double error = order - s[4];
    const double rate = std::abs(error) <= gear.dead_band ? 0.0 : std::clamp(error / gear.lag, -gear.rate, gear.rate);
    return State{s[3], a.u, a.v, a.r, rate};
  };
  const auto moved = [](State s, const State& k, double h) {
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += h * k[i];
    return s;
  };
  State s{0.0, U, 0.0, 0.0, 0.0};
  std::vector<double> times;
  while (times.size() < reversals) {
    const auto k1 = rates(s), k2 = rates(moved(s, k1, 0.5 * step)), k3 = rates(moved(s, k2, 0.5 * step)),
               k4 = rates(moved(s, k3, step));
    const double before = s[0];
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    time += step;
    if (turn * s[0] < angle) continue;
    times.push_back(time - step * (turn * s[0] - angle) / (turn * (s[0] - before)));
    turn = -turn;
    order = -turn * angle;
  }
  return times;
}

TEST_CASE("a zigzag with lag and dead band equals plain integration of ship and steering gear",
          "[nonlinear][second-route]") {
  auto ship = test::mmg(test::kvlcc2_l7());
  ship.steering_gear.lag = 0.8;
  ship.steering_gear.dead_band = radians(0.7);
  const auto result = zigzag(ship_of(ship), {.rudder = radians(10), .heading = radians(10)}, {.sampled = false});
  const auto plain = plain_zigzag(ship, radians(10), 3, 5e-4);
  for (std::size_t i = 0; i < plain.size(); ++i) CHECK_THAT(result.reversals[i].time, WithinAbs(plain[i], 2e-3));
}

TEST_CASE("a lagging rudder widens the zigzag", "[nonlinear][limit]") {
  auto ship = test::mmg(test::kvlcc2_l7());
  const ZigzagOrder order{.rudder = radians(10), .heading = radians(10)};
  const auto prompt = zigzag(ship_of(ship), order, {.sampled = false});
  ship.steering_gear.lag = 2.0;
  const auto late = zigzag(ship_of(ship), order, {.sampled = false});
  CHECK(*late.reversals[0].overshoot > *prompt.reversals[0].overshoot);
}

// ---------------------------------------------------------------- current

TEST_CASE("a current only carries the ship along", "[nonlinear][symmetry]") {
  Ship ship = test::kvlcc2_l7();
  const ZigzagOrder order{.rudder = radians(20), .heading = radians(20)};
  const auto still = zigzag(ship, order).run;
  ship.surroundings.current = {.speed = 0.2, .to = 1.1};
  const auto carried = zigzag(ship, order).run;
  const std::size_t last = std::min(still.samples(), carried.samples()) - 1;
  const double way = 0.2 * still.time[last];
  CHECK_THAT(carried[Channel::psi][last], WithinAbs(still[Channel::psi][last], 1e-7));
  CHECK_THAT(carried[Channel::x][last], WithinAbs(still[Channel::x][last] + way * std::cos(1.1), 1e-6));
  CHECK_THAT(carried[Channel::y][last], WithinAbs(still[Channel::y][last] + way * std::sin(1.1), 1e-6));
}

}  // namespace
}  // namespace swayaw
