#include <catch.hpp>

#include "prime_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/pack.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/models/parts/prime_propulsion.hpp"

namespace swayaw {
namespace {

using test::acceleration_at;
using test::RandomPrimeShips;

template <PrimeShip Ship>
double force_scale(const Ship& ship, double U) {
  return 0.5 * ship.water.rho * ship.particulars.L * ship.particulars.L * U * U * 1e-2;
}

template <template <class> class Model>
Model<double> random_ship(RandomPrimeShips& random) {
  if constexpr (std::is_same_v<Model<double>, PiShip<double>>) return random.pi();
  else return random.pu();
}

// ---------------------------------------------------------------- symmetry

template <template <class> class Model>
void check_mirror(unsigned seed) {
  RandomPrimeShips random(seed);
  for (int i = 0; i < 500; ++i) {
    const auto ship = random_ship<Model>(random);
    const auto m = random.motion(ship.particulars.L, ship.particulars.U_0);
    const auto c = random.controls(ship.particulars.U_0);
    const auto port = forces(test::mirrored(ship), mirrored(m), test::mirrored_sides(c)).total();
    const auto starboard = mirrored(forces(ship, m, c).total());
    const double scale = force_scale(ship, speed(m));
    REQUIRE_THAT(port.X, WithinAbs(starboard.X, 1e-14 * scale));
    REQUIRE_THAT(port.Y, WithinAbs(starboard.Y, 1e-14 * scale));
    REQUIRE_THAT(port.N, WithinAbs(starboard.N, 1e-14 * scale * ship.particulars.L));
  }
}

TEST_CASE("a mirrored PI or PU ship in mirrored motion feels mirrored forces", "[nonlinear][symmetry]") {
  check_mirror<PiShip>(1);
  check_mirror<PuShip>(2);
}

TEST_CASE("the wPCC, whose sides are alike, goes straight ahead without side force", "[nonlinear][symmetry]") {
  const auto ship = test::pi_ship("wpcc_pi");
  const Controls<double> c{.delta = 0.0, .thrust = {5.0, 5.0}, .by_thrust = true};
  const auto total = forces(ship, PlanarMotion<double>{0.9, 0.0, 0.0}, c).total();
  CHECK(total.Y == 0.0);
  CHECK(total.N == 0.0);
}

// ---------------------------------------------------------------- the three scalars

template <template <class> class Model>
void check_duals(unsigned seed) {
  using D = Dual<6>;
  RandomPrimeShips random(seed);
  for (int i = 0; i < 200; ++i) {
    const auto ship = random_ship<Model>(random);
    const auto m = random.motion(ship.particulars.L, ship.particulars.U_0);
    auto c = random.controls(ship.particulars.U_0);
    const double U = speed(m), L = ship.particulars.L, unit = U * U / L;
    Controls<D> controls = cast<D>(c);
    controls.delta.v[3] = 1.0;
    (c.by_thrust ? controls.thrust.port : controls.rev).v[4] = 1.0;
    controls.thrust.starboard.v[5] = c.by_thrust ? 1.0 : 0.0;
    const auto dual = acceleration_at(cast<D>(ship), {D(m.u, 0), D(m.v, 1), D(m.r, 2)}, controls);
    REQUIRE_THAT(dual.v.a, WithinAbs(acceleration_at(ship, m, c).v, 1e-13 * unit));
    const auto branch = branch_at(ship, m, c);
    const double step[] = {1e-3 * U,
                           1e-3 * U,
                           1e-3 * U / L,
                           1e-3,
                           1e-3 * (c.by_thrust ? c.thrust.port : c.rev),
                           1e-3 * c.thrust.starboard};
    const auto along = [&](std::size_t k, double h) {
      const auto moved = [&](std::size_t j, double x) { return x + (j == k ? h * step[k] : 0.0); };
      const PlanarMotion<double> at{moved(0, m.u), moved(1, m.v), moved(2, m.r)};
      Controls<double> with = c;
      with.delta = moved(3, c.delta);
      (c.by_thrust ? with.thrust.port : with.rev) += k == 4 ? h * step[4] : 0.0;
      with.thrust.starboard = moved(5, c.thrust.starboard);
      const auto a = acceleration(ship, at, forces(ship, at, with, branch).total());
      return std::array{a.u, a.v, a.r * L};
    };
    for (int k = 0; k < 6; ++k) {
      const auto j = static_cast<std::size_t>(k);
      const auto p1 = along(j, 1), m1 = along(j, -1), p2 = along(j, 2), m2 = along(j, -2);
      const double exact[] = {dual.u.v[k] * step[k], dual.v.v[k] * step[k], dual.r.v[k] * step[k] * L};
      for (std::size_t n = 0; n < 3; ++n)
        REQUIRE_THAT(exact[n], WithinAbs((8.0 * (p1[n] - m1[n]) - (p2[n] - m2[n])) / 12.0, 1e-10 * unit));
    }
  }
}

TEST_CASE("dual numbers carry the derivatives of the PI and PU models", "[nonlinear][second-route]") {
  check_duals<PiShip>(3);
  check_duals<PuShip>(4);
}

template <template <class> class Model>
void check_packs(unsigned seed) {
  constexpr std::size_t lanes = Pack::size;
  RandomPrimeShips random(seed);
  for (int i = 0; i < 200; ++i) {
    const auto ship = random_ship<Model>(random);
    const bool by_thrust = i % 2 == 0;
    std::array<std::array<double, lanes>, 7> column;
    for (std::size_t k = 0; k < lanes; ++k) {
      const auto m = random.motion(ship.particulars.L, ship.particulars.U_0);
      const auto c = random.controls(ship.particulars.U_0);
      const double values[] = {m.u, m.v, m.r, c.delta, c.rev, c.thrust.port, c.thrust.starboard};
      for (std::size_t j = 0; j < 7; ++j) column[j][k] = values[j];
    }
    const auto load = [&](std::size_t j) { return Pack::load_unaligned(column[j].data()); };
    const auto packed = acceleration_at(cast<Pack>(ship), {load(0), load(1), load(2)},
                                        Controls<Pack>{load(3), load(4), {load(5), load(6)}, by_thrust});
    for (std::size_t k = 0; k < lanes; ++k) {
      const PlanarMotion<double> m{column[0][k], column[1][k], column[2][k]};
      const auto alone = acceleration_at(
          ship, m, Controls<double>{column[3][k], column[4][k], {column[5][k], column[6][k]}, by_thrust});
      const double unit = speed(m) * speed(m) / ship.particulars.L;
      REQUIRE_THAT(packed.u.get(k), WithinAbs(alone.u, 1e-12 * unit));
      REQUIRE_THAT(packed.v.get(k), WithinAbs(alone.v, 1e-12 * unit));
      REQUIRE_THAT(packed.r.get(k), WithinAbs(alone.r, 1e-12 * unit / ship.particulars.L));
    }
  }
}

TEST_CASE("every lane of a pack is one PI or PU ship", "[nonlinear][second-route]") {
  check_packs<PiShip>(5);
  check_packs<PuShip>(6);
}

// ---------------------------------------------------------------- limits

TEST_CASE("PI forces are continuous where a branch changes", "[nonlinear][limit]") {
  RandomPrimeShips random(7);
  std::array<int, 6> changes{};
  for (int i = 0; i < 3000; ++i) {
    const auto ship = random.pi();
    const double L = ship.particulars.L, U = ship.particulars.U_0;
    auto from = random.motion(L, U), to = random.motion(L, U);
    auto c = random.controls(U);
    const double delta_from = c.delta, delta_to = random.uniform(-0.7, 0.7);
    const auto at = [&](double s) {
      c.delta = delta_from + s * (delta_to - delta_from);
      return PlanarMotion<double>{from.u + s * (to.u - from.u), from.v + s * (to.v - from.v),
                                  from.r + s * (to.r - from.r)};
    };
    for (std::size_t b = 0; b < 6; ++b) {
      const auto g = [&](double s) {
        const auto m = at(s);
        return branch_functions(ship, m, c)[b];
      };
      double low = 0.0, high = 1.0;
      if (g(low) * g(high) >= 0.0) continue;
      for (int n = 0; n < 60; ++n) (g(low) * g(0.5 * (low + high)) <= 0.0 ? high : low) = 0.5 * (low + high);
      const auto m = at(low);
      auto branch = branch_at(ship, m, c);
      const auto here = forces(ship, m, c, branch).total();
      branch[b] = !branch[b];
      const auto there = forces(ship, m, c, branch).total();
      ++changes[b];
      REQUIRE_THAT(here.X, WithinAbs(there.X, 1e-11 * force_scale(ship, U)));
      REQUIRE_THAT(here.Y, WithinAbs(there.Y, 1e-11 * force_scale(ship, U)));
      REQUIRE_THAT(here.N, WithinAbs(there.N, 1e-11 * force_scale(ship, U) * L));
    }
  }
  for (const int n : changes) CHECK(n > 20);
}

template <template <class> class Model>
void check_self_propulsion(unsigned seed) {
  RandomPrimeShips random(seed);
  for (int i = 0; i < 200; ++i) {
    auto ship = random_ship<Model>(random);
    ship.hull.X_0 = -1.5e-3;
    ship.hull.X_u = 0.0;
    if (i % 2 == 0) ship.propeller.k_0 = 0.0;
    const double U = random.uniform(0.4, 2.0) * ship.particulars.U_0;
    const auto c = self_propulsion(ship, U);
    REQUIRE(c.by_thrust == (i % 2 == 0));
    REQUIRE_THAT(acceleration_at(ship, PlanarMotion<double>{U, 0.0, 0.0}, c).u,
                 WithinAbs(0.0, 1e-14 * U * U / ship.particulars.L));
  }
}

TEST_CASE("at the self-propulsion point a PI or PU ship does not lose speed", "[nonlinear][limit]") {
  check_self_propulsion<PiShip>(8);
  check_self_propulsion<PuShip>(9);
  const auto ship = test::pi_ship("wpcc_pi");
  const auto c = self_propulsion(ship, ship.particulars.U_0);
  CHECK_THAT(c.thrust.port + c.thrust.starboard, WithinRel(ship.propeller.T_0, 1e-13));
}

TEST_CASE("a hull without resistance has no self-propulsion point", "[nonlinear][refusal]") {
  auto ship = test::pi_ship("wpcc_pi");
  ship.hull.X_0 = 5e-3;
  CHECK_THROWS_AS(self_propulsion(ship, 0.9), Refusal);
  CHECK_THROWS_AS(self_propulsion(ship, 0.0), std::domain_error);
}

TEST_CASE("a radius of gyration about the centre of gravity stands for an inertia about midship",
          "[nonlinear][second-route]") {
  auto ship = test::pi_ship("wpcc_pi");
  const double m = ship.water.rho * ship.particulars.nabla, x_G = ship.particulars.x_G;
  const PlanarForce<double> force{1.0, 2.0, 3.0};
  const auto given = acceleration(ship, PlanarMotion<double>{0.9, 0.1, -0.05}, force);
  ship.particulars.k_zz = std::sqrt(ship.particulars.I_z / m - x_G * x_G);
  ship.particulars.I_z = 0.0;
  const auto by_radius = acceleration(ship, PlanarMotion<double>{0.9, 0.1, -0.05}, force);
  CHECK_THAT(by_radius.v, WithinRel(given.v, 1e-13));
  CHECK_THAT(by_radius.r, WithinRel(given.r, 1e-13));
}

TEST_CASE("without thrust the race has the speed and the width of the propeller disc", "[nonlinear][limit]") {
  const auto race = race_at(0.03, 0.06, 1000.0, 0.7, 0.0);
  CHECK_THAT(race.V_corr, WithinRel(0.7, 1e-15));
  CHECK_THAT(race.r, WithinRel(0.06, 1e-15));
  CHECK_THAT(lift_diminution(race, 0.17), WithinRel(1.0, 1e-15));
}

TEST_CASE("a race far behind the propeller contracts as momentum theory says", "[nonlinear][limit]") {
  // ρ π r_inf² V_inf (V_inf − V_A) = T, and all the water of the disc, r_0² (V_A + V_inf)/2 = r_inf² V_inf
  const double rho = 1000.0, r_0 = 0.06, V_A = 0.7, T = 6.0, far = 1e4;
  const double V_inf = std::sqrt(V_A * V_A + 2.0 * T / (pi * rho * r_0 * r_0));
  const double r_inf = r_0 * std::sqrt(0.5 * (V_A + V_inf) / V_inf);
  CHECK_THAT(rho * pi * r_inf * r_inf * V_inf * (V_inf - V_A), WithinRel(T, 1e-14));
  const auto race = race_at(far, r_0, rho, V_A, T);
  // mixing keeps the excess of volume flow, (V_corr − V_A) r² = (V_inf − V_A) r_inf²
  CHECK_THAT((race.V_corr - V_A) * race.r * race.r, WithinRel((V_inf - V_A) * r_inf * r_inf, 1e-6));
}

TEST_CASE("the gap takes lift away, all of it beyond 33 deg, and more only when it is not clipped",
          "[nonlinear][limit]") {
  auto ship = test::pi_ship("wpcc_pi");
  const auto K = [&](double angle_deg) {
    const double beyond = std::abs(radians(angle_deg)) - ship.rudder.delta_lim;
    const bool open = beyond > 0.0, lifts = 1.0 + ship.rudder.s * beyond * beyond > 0.0;
    return gap_factor(ship.rudder, radians(angle_deg), open, lifts);
  };
  CHECK(K(14.9) == 1.0);
  CHECK_THAT(K(-20.0), WithinAbs(0.9238456450533228, 1e-15));
  CHECK_THAT(K(33.1), WithinAbs(0.0, 3e-3));
  CHECK_THAT(K(35.0), WithinAbs(-0.22, 2e-3));
  ship.rudder.gap_factor.index = 1;
  CHECK(K(35.0) == 0.0);
  CHECK(K(-35.0) == 0.0);
  CHECK_THAT(K(-20.0), WithinAbs(0.9238456450533228, 1e-15));
  const Controls<double> c{.delta = radians(35.0), .thrust = {5.0, 5.0}, .by_thrust = true};
  CHECK_THAT(forces(ship, PlanarMotion<double>{0.9, 0.0, 0.0}, c).rudder.Y, WithinAbs(0.0, 1e-12));
  // a late gap is closed, not clipped, amidships
  ship.rudder.delta_lim = 0.6;
  CHECK(branch_functions(
            ship, PlanarMotion<double>{0.9, 0.0, 0.0},
            Controls<double>{.delta = 0.1, .thrust = {5.0, 5.0}, .by_thrust = true})[PiBranch::gap_lifts] == 1.0);
}

TEST_CASE("the ITTC 1957 line is 2.7 times the published one at the Reynolds number of the model rudder",
          "[nonlinear][published]") {
  CHECK_THAT(friction_coefficient(1.31e5, true) / friction_coefficient(1.31e5, false), WithinAbs(2.70, 0.01));
  CHECK_THAT(friction_coefficient(1e7, true), WithinRel(0.003, 1e-14));
}

}  // namespace
}  // namespace swayaw
