#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "abkowitz_ships.hpp"
#include "json.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/pack.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/models/abkowitz/abkowitz_forces.hpp"

namespace swayaw {
namespace {

// ---------------------------------------------------------------- ships

using test::mariner;
using test::mariner_text;
using test::parse_abkowitz;
using test::RandomAbkowitz;
using test::symmetric;

/// A force small against this is nothing.
double force_scale(const AbkowitzShip<double>& ship) {
  const double L = ship.particulars.L, U_0 = ship.particulars.U_0;
  return 0.5 * ship.water.rho * L * L * U_0 * U_0;
}

Controls<double> mirrored(const Controls<double>& c) { return {.delta = -c.delta}; }

template <class S>
AbkowitzForces<S> forces_of(const AbkowitzShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& c) {
  return forces(ship, m, c, branch_at(ship, m, c));
}

// ---------------------------------------------------------------- laws

TEST_CASE("a symmetric Abkowitz ship in mirrored motion feels mirrored forces", "[nonlinear][symmetry]") {
  RandomAbkowitz random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = symmetric(random.ship());
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto port = forces_of(ship, mirrored(m), mirrored(c)), starboard = forces_of(ship, m, c);
    REQUIRE(port.hull.X == starboard.hull.X);
    REQUIRE(port.hull.Y == -starboard.hull.Y);
    REQUIRE(port.hull.N == -starboard.hull.N);
    REQUIRE(port.rudder.X == starboard.rudder.X);
    REQUIRE(port.rudder.Y == -starboard.rudder.Y);
    REQUIRE(port.rudder.N == -starboard.rudder.N);
  }
}

TEST_CASE("Y_0 and N_0 are what breaks the symmetry", "[nonlinear][symmetry]") {
  RandomAbkowitz random(2);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto sum = forces_of(ship, mirrored(m), mirrored(c)).total() + forces_of(ship, m, c).total();
    const auto& h = ship.hull;
    const double V = ship.particulars.primes_at_nominal_speed() ? ship.particulars.U_0 : speed(m);
    const double u = (m.u - ship.particulars.U_0) / V, L = ship.particulars.L,
                 unit = 0.5 * ship.water.rho * L * L * V * V;
    REQUIRE_THAT(sum.Y, WithinAbs(2.0 * unit * (h.Y_0 + h.Y_0u * u + h.Y_0uu * u * u), 1e-13 * force_scale(ship)));
    REQUIRE_THAT(sum.N,
                 WithinAbs(2.0 * unit * L * (h.N_0 + h.N_0u * u + h.N_0uu * u * u), 1e-13 * force_scale(ship) * L));
    REQUIRE(std::abs(sum.Y) + std::abs(sum.N) > 0.0);
  }
}

TEST_CASE("a mirrored force gives an Abkowitz ship the mirrored acceleration", "[nonlinear][symmetry]") {
  RandomAbkowitz random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const PlanarForce<double> force{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const auto a = acceleration(ship, m, force), b = acceleration(ship, mirrored(m), mirrored(force));
    REQUIRE(b.u == a.u);
    REQUIRE(b.v == -a.v);
    REQUIRE(b.r == -a.r);
  }
}

TEST_CASE("a symmetric Abkowitz ship with rudder amidships keeps U_0", "[nonlinear][limit]") {
  RandomAbkowitz random(4);
  for (int i = 0; i < 200; ++i) {
    const auto ship = symmetric(random.ship());
    const PlanarMotion<double> ahead{ship.particulars.U_0, 0.0, 0.0};
    const auto a = acceleration(ship, ahead, forces_of(ship, ahead, {.delta = 0.0}).total());
    REQUIRE(a.u == 0.0);
    REQUIRE(a.v == 0.0);
    REQUIRE(a.r == 0.0);
  }
}

TEST_CASE("without rudder angle there is no rudder force", "[nonlinear][limit]") {
  RandomAbkowitz random(5);
  for (int i = 0; i < 200; ++i) {
    const auto ship = random.ship();
    const auto rudder = forces_of(ship, random.motion(ship), {.delta = 0.0}).rudder;
    REQUIRE(rudder.X == 0.0);
    REQUIRE(rudder.Y == 0.0);
    REQUIRE(rudder.N == 0.0);
  }
}

TEST_CASE("the parts of the Abkowitz force add up, and it has no thrust to tell", "[nonlinear][round-trip]") {
  RandomAbkowitz random(14);
  for (int i = 0; i < 200; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto split = forces_of(ship, m, c);
    PlanarForce<double> sum{};
    for (const auto& part : split.parts()) sum = sum + part.force;
    REQUIRE(sum.X == split.total().X);
    REQUIRE(sum.Y == split.total().Y);
    REQUIRE(sum.N == split.total().N);
    REQUIRE(std::isnan(thrust(ship, m, c)));
  }
}

TEST_CASE("the equations of motion hold for the acceleration of an Abkowitz ship", "[nonlinear][round-trip]") {
  RandomAbkowitz random(6);
  for (int k = 0; k < 1000; ++k) {
    const auto ship = random.ship();
    const auto [u, v, r] = random.motion(ship);
    const double L = ship.particulars.L, scale = force_scale(ship), half = 0.5 * ship.water.rho * L * L * L;
    const PlanarForce<double> force{scale * random.uniform(-0.01, 0.01), scale * random.uniform(-0.01, 0.01),
                                    L * scale * random.uniform(-0.01, 0.01)};
    const auto a = acceleration(ship, {u, v, r}, force);
    const auto& i = ship.inertia;
    const double m = half * i.m, m_x_G = half * L * i.m * i.x_G;
    const double X = (m - half * i.X_udot) * a.u - m * v * r - m_x_G * r * r;
    const double Y = (m - half * i.Y_vdot) * a.v + (m_x_G - half * L * i.Y_rdot) * a.r + m * u * r;
    const double N = (m_x_G - half * L * i.N_vdot) * a.v + half * L * L * (i.I_z - i.N_rdot) * a.r + m_x_G * u * r;
    REQUIRE_THAT(X, WithinAbs(force.X, 1e-14 * scale));
    REQUIRE_THAT(Y, WithinAbs(force.Y, 1e-14 * scale));
    REQUIRE_THAT(N, WithinAbs(force.N, 1e-14 * scale * L));
  }
}

TEST_CASE("primes of the nominal speed let forces go with uv and u^2", "[nonlinear][limit]") {
  RandomAbkowitz random(7);
  for (int i = 0; i < 200; ++i) {
    const double L = random.uniform(2.0, 300.0), U_0 = random.uniform(0.5, 15.0);
    AbkowitzShip<double> ship{};
    ship.water.rho = 1000.0;
    ship.particulars = {.L = L, .U_0 = U_0, .A_front = 0.0, .A_lateral = 0.0, .prime_speed = {1}};
    ship.hull.Y_v = ship.hull.Y_vu = -0.01;
    ship.rudder.Y_d = ship.rudder.Y_uud = 0.003;
    ship.rudder.Y_ud = 2.0 * ship.rudder.Y_d;
    const double u = U_0 * random.uniform(0.2, 1.5), v = U_0 * random.uniform(-0.2, 0.2),
                 delta = random.uniform(-0.6, 0.6);
    const auto split = forces_of(ship, {u, v, 0.0}, {.delta = delta});
    const double half = 0.5 * 1000.0 * L * L;
    REQUIRE_THAT(split.hull.Y, WithinRel(-0.01 * half * u * v, 1e-12));
    REQUIRE_THAT(split.rudder.Y, WithinRel(0.003 * half * u * u * delta, 1e-12));
  }
}

// ---------------------------------------------------------------- second routes

/// A term of the polynomial: what its coefficient is multiplied by.
struct Term {
  double coefficient;
  int u, v, r, d;
};

double sum_of(const std::vector<Term>& terms, double u, double v, double r, double d) {
  double sum = 0.0;
  for (const auto& t : terms)
    sum += t.coefficient * std::pow(u, t.u) * std::pow(v, t.v) * std::pow(r, t.r) * std::pow(d, t.d);
  return sum;
}

TEST_CASE("forces are the sum of the printed terms", "[nonlinear][second-route]") {
  RandomAbkowitz random(8);
  for (int i = 0; i < 1000; ++i) {
    auto ship = random.ship();
    ship.inertia.centripetal.index = 0;
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto& h = ship.hull;
    const auto& k = ship.rudder;
    const double L = ship.particulars.L, U_0 = ship.particulars.U_0;
    const double V = ship.particulars.primes_at_nominal_speed() ? U_0 : std::hypot(m.u, m.v);
    const double u = (m.u - U_0) / V, v = m.v / V, r = m.r * L / V, d = c.delta;
    const auto sum = [&](const std::vector<Term>& terms) { return sum_of(terms, u, v, r, d); };
    const double X_H = sum({{h.X_u, 1, 0, 0, 0},
                            {h.X_uu, 2, 0, 0, 0},
                            {h.X_uuu, 3, 0, 0, 0},
                            {h.X_vv, 0, 2, 0, 0},
                            {h.X_vr, 0, 1, 1, 0},
                            {h.X_rr, 0, 0, 2, 0},
                            {h.X_vvu, 1, 2, 0, 0},
                            {h.X_vru, 1, 1, 1, 0},
                            {h.X_rru, 1, 0, 2, 0}});
    const double Y_H = sum({{h.Y_0, 0, 0, 0, 0},
                            {h.Y_0u, 1, 0, 0, 0},
                            {h.Y_0uu, 2, 0, 0, 0},
                            {h.Y_v, 0, 1, 0, 0},
                            {h.Y_vu, 1, 1, 0, 0},
                            {h.Y_vuu, 2, 1, 0, 0},
                            {h.Y_r, 0, 0, 1, 0},
                            {h.Y_ru, 1, 0, 1, 0},
                            {h.Y_ruu, 2, 0, 1, 0},
                            {h.Y_vvv, 0, 3, 0, 0},
                            {h.Y_vvr, 0, 2, 1, 0},
                            {h.Y_vrr, 0, 1, 2, 0},
                            {h.Y_rrr, 0, 0, 3, 0}});
    const double N_H = sum({{h.N_0, 0, 0, 0, 0},
                            {h.N_0u, 1, 0, 0, 0},
                            {h.N_0uu, 2, 0, 0, 0},
                            {h.N_v, 0, 1, 0, 0},
                            {h.N_vu, 1, 1, 0, 0},
                            {h.N_vuu, 2, 1, 0, 0},
                            {h.N_r, 0, 0, 1, 0},
                            {h.N_ru, 1, 0, 1, 0},
                            {h.N_ruu, 2, 0, 1, 0},
                            {h.N_vvv, 0, 3, 0, 0},
                            {h.N_vvr, 0, 2, 1, 0},
                            {h.N_vrr, 0, 1, 2, 0},
                            {h.N_rrr, 0, 0, 3, 0}});
    const double X_R = sum({{k.X_dd, 0, 0, 0, 2},
                            {k.X_udd, 1, 0, 0, 2},
                            {k.X_vd, 0, 1, 0, 1},
                            {k.X_uvd, 1, 1, 0, 1},
                            {k.X_rd, 0, 0, 1, 1},
                            {k.X_urd, 1, 0, 1, 1}});
    const double Y_R = sum({{k.Y_d, 0, 0, 0, 1},
                            {k.Y_ud, 1, 0, 0, 1},
                            {k.Y_uud, 2, 0, 0, 1},
                            {k.Y_ddd, 0, 0, 0, 3},
                            {k.Y_vvd, 0, 2, 0, 1},
                            {k.Y_vdd, 0, 1, 0, 2},
                            {k.Y_rrd, 0, 0, 2, 1},
                            {k.Y_rdd, 0, 0, 1, 2},
                            {k.Y_vrd, 0, 1, 1, 1}});
    const double N_R = sum({{k.N_d, 0, 0, 0, 1},
                            {k.N_ud, 1, 0, 0, 1},
                            {k.N_uud, 2, 0, 0, 1},
                            {k.N_ddd, 0, 0, 0, 3},
                            {k.N_vvd, 0, 2, 0, 1},
                            {k.N_vdd, 0, 1, 0, 2},
                            {k.N_rrd, 0, 0, 2, 1},
                            {k.N_rdd, 0, 0, 1, 2},
                            {k.N_vrd, 0, 1, 1, 1}});
    const auto split = forces_of(ship, m, c);
    const double unit = 0.5 * ship.water.rho * L * L * V * V, tolerance = 1e-13 * force_scale(ship);
    REQUIRE_THAT(split.hull.X, WithinAbs(unit * X_H, tolerance));
    REQUIRE_THAT(split.hull.Y, WithinAbs(unit * Y_H, tolerance));
    REQUIRE_THAT(split.hull.N, WithinAbs(unit * L * N_H, tolerance * L));
    REQUIRE_THAT(split.rudder.X, WithinAbs(unit * X_R, tolerance));
    REQUIRE_THAT(split.rudder.Y, WithinAbs(unit * Y_R, tolerance));
    REQUIRE_THAT(split.rudder.N, WithinAbs(unit * L * N_R, tolerance * L));
  }
}

/// With primes of the nominal speed both conventions can say the same: X_vr + m for X_vr, and so on; u r = U_0 r + (u −
/// U_0) r.
TEST_CASE("derivatives with and without the centripetal terms move a ship alike", "[nonlinear][second-route]") {
  RandomAbkowitz random(9);
  for (int i = 0; i < 1000; ++i) {
    auto separate = random.ship();
    separate.particulars.prime_speed.index = 1;
    separate.inertia.centripetal.index = 0;
    auto joined = separate;
    joined.inertia.centripetal.index = 1;
    const double m = separate.inertia.m, m_x_G = m * separate.inertia.x_G;
    joined.hull.X_vr += m;
    joined.hull.X_rr += m_x_G;
    joined.hull.Y_r -= m;
    joined.hull.Y_ru -= m;
    joined.hull.N_r -= m_x_G;
    joined.hull.N_ru -= m_x_G;
    const auto motion = random.motion(separate);
    const auto c = random.controls(separate);
    const auto a = forces_of(separate, motion, c).hull, b = forces_of(joined, motion, c).hull;
    REQUIRE_THAT(b.X, WithinAbs(a.X, 1e-13 * force_scale(separate)));
    REQUIRE_THAT(b.Y, WithinAbs(a.Y, 1e-13 * force_scale(separate)));
    REQUIRE_THAT(b.N, WithinAbs(a.N, 1e-13 * force_scale(separate) * separate.particulars.L));
  }
}

template <class S>
PlanarAcceleration<S> acceleration_of(const AbkowitzShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& c) {
  return acceleration(ship, m, forces_of(ship, m, c).total());
}

TEST_CASE("dual numbers carry the value and the derivatives of the Abkowitz model", "[nonlinear][second-route]") {
  using D = Dual<4>;
  RandomAbkowitz random(10);
  for (int i = 0; i < 300; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const double U = speed(m), L = ship.particulars.L, unit = U * U / L;
    const auto dual = acceleration_of(cast<D>(ship), {D(m.u, 0), D(m.v, 1), D(m.r, 2)}, {.delta = D(c.delta, 3)});
    REQUIRE_THAT(dual.v.a, WithinAbs(acceleration_of(ship, m, c).v, 1e-13 * unit));
    // central differences, extrapolated once
    const auto along = [&](int k, double h) {
      const auto step = [&](int j) { return j == k ? h : 0.0; };
      const auto a = acceleration_of(ship, {m.u + step(0), m.v + step(1), m.r + step(2)}, {.delta = c.delta + step(3)});
      return std::array{a.u, a.v, a.r * L};
    };
    const double size[] = {1e-3 * U, 1e-3 * U, 1e-3 * U / L, 1e-3};
    for (int k = 0; k < 4; ++k) {
      const double h = size[k];
      const auto p1 = along(k, h), m1 = along(k, -h), p2 = along(k, 2 * h), m2 = along(k, -2 * h);
      const double exact[] = {dual.u.v[k], dual.v.v[k], dual.r.v[k] * L};
      for (std::size_t j = 0; j < 3; ++j) {
        const double difference = (8.0 * (p1[j] - m1[j]) - (p2[j] - m2[j])) / (12.0 * h);
        REQUIRE_THAT(exact[j] * h / 1e-3, WithinAbs(difference * h / 1e-3, 1e-8 * unit));
      }
    }
  }
}

TEST_CASE("every lane of a pack is one Abkowitz ship", "[nonlinear][second-route]") {
  constexpr std::size_t lanes = Pack::size;
  RandomAbkowitz random(11);
  for (int i = 0; i < 200; ++i) {
    alignas(64) std::array<std::array<double, lanes>, 4> column;
    const auto ship = random.ship();
    for (std::size_t k = 0; k < lanes; ++k) {
      const auto m = random.motion(ship);
      const double values[] = {m.u, m.v, m.r, random.controls(ship).delta};
      for (std::size_t j = 0; j < 4; ++j) column[j][k] = values[j];
    }
    const auto load = [&](std::size_t j) { return Pack::load_unaligned(column[j].data()); };
    const auto packed = acceleration_of(cast<Pack>(ship), {load(0), load(1), load(2)}, {.delta = load(3)});
    for (std::size_t k = 0; k < lanes; ++k) {
      const PlanarMotion<double> m{column[0][k], column[1][k], column[2][k]};
      const auto alone = acceleration_of(ship, m, {.delta = column[3][k]});
      const double unit = speed(m) * speed(m) / ship.particulars.L;
      REQUIRE_THAT(packed.u.get(k), WithinAbs(alone.u, 1e-12 * unit));
      REQUIRE_THAT(packed.v.get(k), WithinAbs(alone.v, 1e-12 * unit));
      REQUIRE_THAT(packed.r.get(k), WithinAbs(alone.r, 1e-12 * unit / ship.particulars.L));
    }
  }
}

TEST_CASE("straight ahead the derivatives of the forces are the first derivatives of the polynomial",
          "[nonlinear][limit]") {
  using D = Dual<4>;
  RandomAbkowitz random(12);
  for (int i = 0; i < 200; ++i) {
    const auto ship = symmetric(random.ship());
    const double L = ship.particulars.L, U_0 = ship.particulars.U_0;
    const double F = force_scale(ship), m = ship.inertia.centripetal_in_derivatives() ? ship.inertia.m : 0.0;
    const auto f = forces_of(cast<D>(ship), {D(U_0, 0), D(0.0, 1), D(0.0, 2)}, {.delta = D(0.0, 3)}).total();
    const double unit[] = {F / U_0, F / U_0, F * L / U_0, F};  // of X_u, Y_v, Y_r, Y_d
    const auto& h = ship.hull;
    REQUIRE_THAT(f.X.v[0] / unit[0], WithinRel(h.X_u, 1e-12));
    REQUIRE_THAT(f.Y.v[1] / unit[1], WithinRel(h.Y_v, 1e-12));
    REQUIRE_THAT(f.Y.v[2] / unit[2], WithinRel(h.Y_r + m, 1e-12));
    REQUIRE_THAT(f.Y.v[3] / unit[3], WithinRel(ship.rudder.Y_d, 1e-12));
    REQUIRE_THAT(f.N.v[1] / unit[1] / L, WithinRel(h.N_v, 1e-12));
    REQUIRE_THAT(f.N.v[2] / unit[2] / L, WithinRel(h.N_r + m * ship.inertia.x_G, 1e-12));
    REQUIRE_THAT(f.N.v[3] / unit[3] / L, WithinRel(ship.rudder.N_d, 1e-12));
  }
}

// ---------------------------------------------------------------- the Mariner

/// mariner.m of the Marine Systems Simulator (github.com/cybergalactic/MSS), as printed there; u is the change of
/// surge.
PlanarAcceleration<double> mss_mariner(const PlanarMotion<double>& motion, double delta) {
  const double U0 = 7.7175, L = 160.93, U = std::hypot(motion.u, motion.v);
  const double u = (motion.u - U0) / U, v = motion.v / U, r = motion.r * L / U, d = delta;
  const double m = 798e-5, Iz = 39.2e-5, xG = -0.023;
  const double X = -184e-5 * u - 110e-5 * u * u - 215e-5 * u * u * u - 899e-5 * v * v + 18e-5 * r * r + 798e-5 * r * v -
                   95e-5 * d * d - 190e-5 * u * d * d + 93e-5 * v * d + 93e-5 * u * v * d;
  const double Y = -1160e-5 * v - 499e-5 * r - 8078e-5 * v * v * v + 15356e-5 * v * v * r - 1160e-5 * v * u -
                   499e-5 * r * u + 278e-5 * d - 90e-5 * d * d * d + 556e-5 * u * d + 278e-5 * u * u * d -
                   4e-5 * v * d * d + 1190e-5 * v * v * d + (-4e-5 - 8e-5 * u - 4e-5 * u * u);
  const double N = -264e-5 * v - 166e-5 * r + 1636e-5 * v * v * v - 5483e-5 * v * v * r - 264e-5 * v * u -
                   166e-5 * r * u - 139e-5 * d + 45e-5 * d * d * d - 278e-5 * u * d - 139e-5 * u * u * d +
                   13e-5 * v * d * d - 489e-5 * v * v * d + (3e-5 + 6e-5 * u + 3e-5 * u * u);
  const double m11 = m + 42e-5, m22 = m + 748e-5, m23 = m * xG + 9.354e-5, m32 = m * xG - 4.646e-5, m33 = Iz + 43.8e-5;
  const double det = m22 * m33 - m23 * m32;
  return {X * (U * U / L) / m11, (m33 * Y - m23 * N) * (U * U / L) / det,
          (m22 * N - m32 * Y) * (U * U / (L * L)) / det};
}

TEST_CASE("the Mariner accelerates as mariner.m has her do", "[nonlinear][published]") {
  const auto ship = mariner();
  RandomAbkowitz random(13);
  for (int i = 0; i < 1000; ++i) {
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto a = acceleration_of(ship, m, c), printed = mss_mariner(m, c.delta);
    const double unit = speed(m) * speed(m) / ship.particulars.L;
    REQUIRE_THAT(a.u, WithinAbs(printed.u, 1e-12 * unit));
    REQUIRE_THAT(a.v, WithinAbs(printed.v, 1e-12 * unit));
    REQUIRE_THAT(a.r, WithinAbs(printed.r, 1e-12 * unit / ship.particulars.L));
  }
}

/// u, v, r, psi, delta after a time step in which the rudder follows its order as in mariner.m.
using Run = std::array<double, 5>;

template <class Acceleration>
Run rk4_step(const Acceleration& acceleration_at, const Run& s, double order, double h) {
  const auto rate = [&](const Run& x) {
    const auto a = acceleration_at(PlanarMotion<double>{x[0], x[1], x[2]}, x[4]);
    const double limit = radians(5);
    return Run{a.u, a.v, a.r, x[2], std::clamp(order - x[4], -limit, limit)};
  };
  const auto moved = [](Run x, const Run& k, double by) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * k[i];
    return x;
  };
  const Run k1 = rate(s), k2 = rate(moved(s, k1, 0.5 * h)), k3 = rate(moved(s, k2, 0.5 * h)),
            k4 = rate(moved(s, k3, h));
  Run result = s;
  for (std::size_t i = 0; i < s.size(); ++i) result[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  return result;
}

TEST_CASE("a 20/20 zigzag of the Mariner is that of mariner.m", "[nonlinear][second-route]") {
  const auto ship = mariner();
  const auto ours = [&](const PlanarMotion<double>& m, double delta) {
    return acceleration_of(ship, m, {.delta = delta});
  };
  Run a{ship.particulars.U_0, 0.0, 0.0, 0.0, 0.0}, b = a;
  double order = radians(-20);  // to starboard
  int reversals = 0;
  for (int i = 0; i < 6000; ++i) {
    a = rk4_step(ours, a, order, 0.1);
    b = rk4_step(mss_mariner, b, order, 0.1);
    for (std::size_t k = 0; k < a.size(); ++k) REQUIRE_THAT(a[k], WithinAbs(b[k], 1e-10));
    if (order * a[3] < 0.0 && std::abs(a[3]) >= radians(20)) order = -order, ++reversals;
  }
  CHECK(reversals >= 3);
}

nlohmann::json published_mariner() { return test::json_in(test::golden / "mariner.json"); }

/// Half a unit of the last digit that is printed.
double rounding(double unit) { return 0.5 * unit * (1.0 + 1e-9); }

TEST_CASE("the linear Mariner has the published gain and time constants", "[nonlinear][published]") {
  using D = Dual<3>;
  const auto ship = mariner();
  const auto a = acceleration_of(cast<D>(ship), {D(ship.particulars.U_0), D(0.0, 0), D(0.0, 1)}, {.delta = D(0.0, 2)});
  const double a11 = a.v.v[0], a12 = a.v.v[1], b1 = a.v.v[2], a21 = a.r.v[0], a22 = a.r.v[1], b2 = a.r.v[2];
  const double det = a11 * a22 - a12 * a21, trace = a11 + a22, numerator = a21 * b1 - a11 * b2;
  REQUIRE(det > 0.0);  // stable on her course
  REQUIRE(trace < 0.0);
  // T1 T2 = 1/det, T1 + T2 = −tr/det
  const double half = -0.5 * trace / det, root = std::sqrt(half * half - 1.0 / det);
  const auto published = published_mariner().at("nomoto");
  CHECK_THAT(-numerator / det, WithinAbs(published.at("K_1_s").get<double>(), rounding(1e-3)));  // rudder to starboard
  CHECK_THAT(half + root, WithinAbs(published.at("T1_s").get<double>(), rounding(1.0)));
  CHECK_THAT(half - root, WithinAbs(published.at("T2_s").get<double>(), rounding(0.1)));
  CHECK_THAT(b2 / numerator, WithinAbs(published.at("T3_s").get<double>(), rounding(0.1)));
}

TEST_CASE("the Mariner turns at the published steady yaw rates", "[nonlinear][published]") {
  const auto ship = mariner();
  const auto ours = [&](const PlanarMotion<double>& m, double delta) {
    return acceleration_of(ship, m, {.delta = delta});
  };
  const auto steady_yaw_rate = [&](double delta) {
    Run run{ship.particulars.U_0, 0.0, 0.0, 0.0, delta};
    for (int i = 0; i < 2000; ++i) run = rk4_step(ours, run, delta, 2.0);
    return run[2];
  };
  const auto published = published_mariner().at("steady_turns");
  const auto& angles = published.at("rudder_deg");
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double delta = radians(angles[i].get<double>());
    INFO("rudder " << angles[i] << " deg");
    const double gain = (steady_yaw_rate(-delta) - steady_yaw_rate(delta)) / (2.0 * delta);
    CHECK_THAT(gain, WithinAbs(published.at("gain_1_s")[i].get<double>(), rounding(1e-4)));
  }
  CHECK_THAT(degrees(steady_yaw_rate(0.0)),
             WithinAbs(published.at("yaw_rate_amidships_deg_s").get<double>(), rounding(0.01)));
  CHECK_THAT(degrees(steady_yaw_rate(radians(-5))),
             WithinAbs(published.at("yaw_rate_5_deg_to_starboard_deg_s").get<double>(), rounding(1e-4)));
}

// ---------------------------------------------------------------- ship files

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

std::string refusal_of(const std::string& text) {
  try {
    parse_abkowitz(text);
    return {};
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST_CASE("an Abkowitz ship file may leave out every term but the first derivatives", "[nonlinear]") {
  CHECK(parse_abkowitz(replaced(mariner_text(), "Y_vvr = 15356e-5\n", "")).hull.Y_vvr == 0.0);
  for (const std::string line : {"X_u = -184e-5\n", "Y_v = -1160e-5\n", "Y_r = -499e-5\n", "N_v = -264e-5\n",
                                 "N_r = -166e-5\n", "Y_d = 278e-5\n", "N_d = -139e-5\n"})
    CHECK_THAT(refusal_of(replaced(mariner_text(), "\n" + line, "\n")),
               ContainsSubstring(line.substr(0, line.find(' '))));
}

TEST_CASE("choices of an Abkowitz ship file default to actual speed and separate centripetal terms", "[nonlinear]") {
  auto text = replaced(mariner_text(), "prime_speed = \"actual\"\n", "");
  const auto ship = parse_abkowitz(replaced(text, "centripetal = \"in_derivatives\"\n", ""));
  CHECK_FALSE(ship.particulars.primes_at_nominal_speed());
  CHECK_FALSE(ship.inertia.centripetal_in_derivatives());
  CHECK(parse_abkowitz(replaced(mariner_text(), "\"actual\"", "\"nominal\"")).particulars.primes_at_nominal_speed());
  CHECK(mariner().inertia.centripetal_in_derivatives());
  CHECK(cast<Pack>(mariner()).inertia.centripetal_in_derivatives());
}

TEST_CASE("an Abkowitz ship file with a wrong number, word or term is refused", "[nonlinear][refusal]") {
  CHECK_THAT(refusal_of(replaced(mariner_text(), "m = 798e-5", "m = 0")), ContainsSubstring("m"));
  CHECK_THAT(refusal_of(replaced(mariner_text(), "Y_vdot = -748e-5", "Y_vdot = 748e-5")), ContainsSubstring("Y_vdot"));
  CHECK_THAT(refusal_of(replaced(mariner_text(), "\"actual\"", "\"mean\"")), ContainsSubstring("prime_speed"));
  CHECK_THAT(refusal_of(replaced(mariner_text(), "Y_vvr", "Y_vvq")), ContainsSubstring("Y_vvq"));
}

}  // namespace
}  // namespace swayaw
