#include "swayaw/nonlinear/manoeuvres/steady_run_in_wind.hpp"

#include <array>
#include <catch.hpp>
#include <cmath>
#include <limits>

#include "random_manoeuvres.hpp"
#include "random_windage.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw {
namespace {

using test::with_model;

/// A ship, what the wind takes hold of, a wind up to three times her speed and a current up to a fifth of it.
struct RandomRuns {
  explicit RandomRuns(unsigned seed) : winds(seed) {}

  test::RandomWinds winds;

  double uniform(double low, double high) { return winds.uniform(low, high); }
  MmgShip<double> model() { return winds.random.ship(); }

  Windage<double> windage(const MmgShip<double>& ship) {
    const double L = ship.particulars.L, scale = L * L;
    auto w = winds.windage();
    w.A_F = uniform(0.01, 0.02) * scale;
    w.A_L = uniform(0.03, 0.06) * scale;
    w.x_A *= L / w.L_OA;
    w.L_OA = L;
    return w;
  }

  Wind<double> wind(const MmgShip<double>& ship) {
    return {.speed = uniform(0.0, 3.0) * ship.particulars.U_0, .from = uniform(-pi, pi)};
  }
  Current<double> current(const MmgShip<double>& ship) {
    return {.speed = uniform(0.0, 0.2) * ship.particulars.U_0, .to = uniform(-pi, pi)};
  }
};

Ship in_current(const MmgShip<double>& model, const Current<double>& current) {
  auto ship = with_model(model);
  ship.surroundings.current = current;
  return ship;
}

/// Acceleration of a ship in wind and current.
PlanarAcceleration<double> acceleration_in(const MmgShip<double>& ship, const Windage<double>& windage,
                                           const Wind<double>& wind, const Current<double>& current,
                                           const PlanarMotion<double>& m, double psi, const Controls<double>& c) {
  return acceleration(
      ship, m, forces(ship, m, c).total() + wind_force(windage, wind, over_ground(current, {0.0, 0.0, psi, m}), psi));
}

TEST_CASE("nothing accelerates on a straight run in wind, and what is to be kept is kept", "[nonlinear][limit]") {
  RandomRuns random(91);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    const auto model = random.model();
    const auto windage = random.windage(model);
    const auto wind = random.wind(model);
    const auto current = random.current(model);
    const auto propulsion = self_propulsion(model, model.particulars.U_0);
    const WindRunOrder order{.direction = random.uniform(-pi, pi), .kept = i % 2 ? Kept::heading : Kept::course};
    const auto run = steady_run_in_wind(in_current(model, current), windage, wind, order);
    if (!run) continue;
    ++found;
    const auto a =
        acceleration_in(model, windage, wind, current, run->motion, run->psi, with_rudder(propulsion, run->delta));
    const double L = model.particulars.L, unit = model.particulars.U_0 * test::yaw_unit(model);
    CHECK(std::max({std::abs(a.u), std::abs(a.v), std::abs(a.r) * L}) < 1e-10 * unit);
    CHECK_THAT(wrapped((i % 2 ? run->psi : run->course) - order.direction), WithinAbs(0.0, 1e-10));
    CHECK(run->motion.r == 0.0);
    CHECK(run->holds == (std::abs(run->delta) <= model.steering_gear.max_angle));
  }
  CHECK(found > 40);
}

TEST_CASE("a symmetric ship needs no helm without wind, nor in wind from ahead or astern", "[nonlinear][limit]") {
  RandomRuns random(92);
  for (int i = 0; i < 20; ++i) {
    const auto model = test::symmetric_as_negative(random.model());
    const double U = model.particulars.U_0, psi = random.uniform(-pi, pi);
    const auto windage = random.windage(model);
    for (const Wind<double>& wind :
         {Wind<double>{0.0, 1.0}, Wind<double>{0.8 * U, psi}, Wind<double>{0.8 * U, psi + pi}})
      for (const Kept kept : {Kept::heading, Kept::course}) {
        const auto run = steady_run_in_wind(with_model(model), windage, wind, {.direction = psi, .kept = kept});
        REQUIRE(run);
        CHECK_THAT(run->delta, WithinAbs(0.0, 1e-10));
        CHECK_THAT(run->leeway(), WithinAbs(0.0, 1e-10));
        CHECK_THAT(run->psi, WithinAbs(psi, 1e-10));
      }
    const auto none = steady_run_in_wind(with_model(model), Windage<double>{}, {3.0 * U, 0.5});
    CHECK_THAT(none.value().motion.u, WithinRel(U, 1e-9));
  }
}

TEST_CASE("wind from ahead slows a ship, wind from astern speeds her up", "[nonlinear][limit]") {
  RandomRuns random(93);
  for (int i = 0; i < 10; ++i) {
    const auto model = random.model();
    const auto ship = with_model(model);
    const auto windage = random.windage(model);
    const double V = 2.0 * model.particulars.U_0;
    const double still = steady_run_in_wind(ship, windage, {})->motion.u;
    CHECK(steady_run_in_wind(ship, windage, {V, 0.0})->motion.u < still);
    CHECK(steady_run_in_wind(ship, windage, {V, pi})->motion.u > still);
  }
}

TEST_CASE("a mirrored ship in the mirrored wind makes the mirrored run", "[nonlinear][symmetry]") {
  RandomRuns random(94);
  for (int i = 0; i < 30; ++i) {
    const auto model = random.model();
    const auto windage = random.windage(model);
    const auto wind = random.wind(model);
    const auto current = random.current(model);
    const double direction = random.uniform(-pi, pi);
    const auto run = steady_run_in_wind(in_current(model, current), windage, wind, {.direction = direction});
    const auto mirror = steady_run_in_wind(in_current(test::mirrored(model), {current.speed, -current.to}), windage,
                                           {wind.speed, -wind.from}, {.direction = -direction});
    REQUIRE(run.has_value() == mirror.has_value());
    if (!run) continue;
    CHECK_THAT(mirror->delta, WithinAbs(-run->delta, 1e-9));
    CHECK_THAT(mirror->psi, WithinAbs(-run->psi, 1e-9));
    CHECK_THAT(mirror->motion.u, WithinRel(run->motion.u, 1e-9));
  }
}

TEST_CASE("turning course, wind and current together changes nothing", "[nonlinear][symmetry]") {
  RandomRuns random(95);
  for (int i = 0; i < 20; ++i) {
    const auto model = random.model();
    const auto windage = random.windage(model);
    const auto wind = random.wind(model);
    const auto current = random.current(model);
    const double turn = random.uniform(-pi, pi);
    const auto run = steady_run_in_wind(in_current(model, current), windage, wind);
    const auto turned = steady_run_in_wind(in_current(model, {current.speed, current.to + turn}), windage,
                                           {wind.speed, wind.from + turn}, {.direction = turn});
    REQUIRE(run.has_value() == turned.has_value());
    if (!run) continue;
    CHECK_THAT(turned->delta, WithinAbs(run->delta, 1e-9));
    CHECK_THAT(turned->psi - turn, WithinAbs(run->psi, 1e-9));
  }
}

TEST_CASE("the heading of a kept course, kept as heading, gives that course", "[nonlinear][round-trip]") {
  RandomRuns random(96);
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const auto model = random.model();
    const auto ship = in_current(model, random.current(model));
    const auto windage = random.windage(model);
    const auto wind = random.wind(model);
    const auto by_course = steady_run_in_wind(ship, windage, wind, {.direction = 0.7, .kept = Kept::course});
    if (!by_course) continue;
    const auto by_heading =
        steady_run_in_wind(ship, windage, wind, {.direction = by_course->psi, .kept = Kept::heading});
    if (!by_heading) continue;
    ++found;
    CHECK_THAT(by_heading->course, WithinAbs(0.7, 1e-9));
    CHECK_THAT(by_heading->delta, WithinAbs(by_course->delta, 1e-9));
  }
  CHECK(found > 20);
}

TEST_CASE("without wind a current sets the heading by the triangle of velocities", "[nonlinear][second-route]") {
  RandomRuns random(97);
  for (int i = 0; i < 20; ++i) {
    const auto model = test::symmetric_as_negative(random.model());
    const auto current = random.current(model);
    const double U = model.particulars.U_0, chi = random.uniform(-pi, pi);
    const auto run = steady_run_in_wind(in_current(model, current), Windage<double>{}, {}, {.direction = chi});
    REQUIRE(run);
    // U sin(psi − chi) + V_c sin(psi_c − chi) = 0
    CHECK_THAT(run->psi - chi, WithinAbs(-std::asin(current.speed * std::sin(current.to - chi) / U), 1e-9));
    CHECK_THAT(run->speed_over_ground,
               WithinRel(U * std::cos(run->psi - chi) + current.speed * std::cos(current.to - chi), 1e-9));
  }
}

/// Where a helmsman who keeps the heading ends: RK4 with a PID rudder without steering gear.
struct Sailed {
  PlanarMotion<double> motion;
  double delta;
};

Sailed sailed(const MmgShip<double>& ship, const Windage<double>& windage, const Wind<double>& wind, double psi,
              double end) {
  using State = std::array<double, 5>;  // u, v, r, psi, integral
  const double unit = ship.particulars.L / ship.particulars.U_0;
  const auto propulsion = self_propulsion(ship, ship.particulars.U_0);
  const auto helm = [&](const State& s) { return 2.0 * (s[3] - psi) + 2.0 * unit * s[2] + s[4]; };
  const auto rate = [&](const State& s) {
    const PlanarMotion<double> m{s[0], s[1], s[2]};
    const auto a = acceleration_in(ship, windage, wind, {}, m, s[3], with_rudder(propulsion, helm(s)));
    return State{a.u, a.v, a.r, s[2], 0.2 / unit * (s[3] - psi)};
  };
  const auto plus = [](State a, const State& k, double f) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += f * k[i];
    return a;
  };
  const double h = 0.02 * unit;
  State s{ship.particulars.U_0, 0.0, 0.0, psi, 0.0};
  for (double t = 0.0; t < end * unit; t += h) {
    const State k1 = rate(s), k2 = rate(plus(s, k1, h / 2)), k3 = rate(plus(s, k2, h / 2)), k4 = rate(plus(s, k3, h));
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return {{s[0], s[1], s[2]}, helm(s)};
}

TEST_CASE("a helmsman who keeps the heading in wind ends on the straight run", "[nonlinear][second-route]") {
  const auto model = test::mmg(test::kvlcc2_l7());
  const Windage<double> windage{.A_F = 0.6, .A_L = 1.75, .L_OA = 7.0};
  for (const double from : {30.0, 75.0, 120.0, 200.0, 300.0}) {
    const Wind<double> wind{2.0 * model.particulars.U_0, radians(from)};
    const auto run = steady_run_in_wind(with_model(model), windage, wind, {.direction = 0.3, .kept = Kept::heading});
    REQUIRE(run);
    const auto end = sailed(model, windage, wind, 0.3, 400.0);
    CHECK_THAT(end.delta, WithinAbs(run->delta, 1e-7));
    CHECK_THAT(end.motion.u, WithinAbs(run->motion.u, 1e-7));
    CHECK_THAT(end.motion.v, WithinAbs(run->motion.v, 1e-7));
  }
}

TEST_CASE("a wind too strong for the rudder is told, and one that no helm balances has no run", "[nonlinear][limit]") {
  const auto model = test::mmg(test::kvlcc2_l7());
  const Windage<double> windage{.A_F = 0.6, .A_L = 1.75, .L_OA = 7.0};
  const double U = model.particulars.U_0;
  bool was_too_strong = false;
  for (double ratio = 0.0; ratio < 60.0; ratio += 1.0) {
    const auto run =
        steady_run_in_wind(with_model(model), windage, {ratio * U, radians(70.0)}, {.kept = Kept::heading});
    if (run && run->holds) {
      CHECK_FALSE(was_too_strong);
      continue;
    }
    was_too_strong = true;
  }
  CHECK(was_too_strong);
  auto weak = model;
  weak.steering_gear.max_angle = radians(1.0);
  const auto run = steady_run_in_wind(with_model(weak), windage, {3.0 * U, radians(70.0)});
  REQUIRE(run);
  CHECK_FALSE(run->holds);
  CHECK_FALSE(steady_run_in_wind(with_model(model), windage, {1000.0 * U, radians(70.0)}));
}

TEST_CASE("a table over wind directions has the run of each, mirrored on a symmetric ship", "[nonlinear][symmetry]") {
  const auto model = test::symmetric_as_negative(test::mmg(test::kvlcc2_l7()));
  const Windage<double> windage{.A_F = 0.6, .A_L = 1.75, .L_OA = 7.0};
  const std::vector<double> directions{radians(-120), radians(-45), 0.0, radians(45), radians(120)};
  const auto rows = steady_runs_in_wind(with_model(model), windage, 2.0, directions, {.direction = 0.4});
  REQUIRE(rows.size() == directions.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(rows[i].relative == directions[i]);
    CHECK_THAT(rows[i].run.value().delta, WithinAbs(-rows[rows.size() - 1 - i].run.value().delta, 1e-10));
    CHECK_THAT(rows[i].run->course, WithinAbs(0.4, 1e-10));
  }
  CHECK(std::abs(rows[1].run->delta) > radians(0.1));
}

TEST_CASE("the Mariner needs helm without wind, that of her steady straight course", "[nonlinear][second-route]") {
  const Ship ship = read_ship(test::ships / "mariner.toml");
  const auto run = steady_run_in_wind(ship, Windage<double>{}, {}, {.direction = 1.0, .kept = Kept::course});
  REQUIRE(run);
  CHECK(std::abs(run->delta) > radians(0.1));
  CHECK_THAT(run->course, WithinAbs(1.0, 1e-12));
  const auto steady = steady_motion(ship, {.delta = run->delta}, run->motion);
  REQUIRE(steady);
  CHECK_THAT(steady->motion.r, WithinAbs(0.0, 1e-12));
  CHECK_THAT(steady->motion.v, WithinAbs(run->motion.v, 1e-10));
}

TEST_CASE("a wind speed below zero is refused", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_WITH(steady_run_in_wind(ship, Windage<double>{}, {-1.0, 0.0}),
                    "wind speed [m/s] must not be negative, got -1");
  CHECK_THROWS_WITH(steady_run_in_wind(ship, Windage<double>{}, {std::nan(""), 0.0}),
                    ContainsSubstring("must not be negative"));
}

}  // namespace
}  // namespace swayaw
