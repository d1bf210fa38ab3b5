#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"

#include <catch.hpp>

#include "random_ships.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/pack.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw {
namespace {

using test::RandomShips;

/// A force small against this is nothing.
double force_scale(const MmgShip<double>& ship, double U) {
  return 0.5 * ship.water.rho * ship.particulars.L * ship.particulars.d * U * U;
}

TEST_CASE("a mirrored ship in mirrored motion feels mirrored forces", "[nonlinear][symmetry]") {
  RandomShips random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto motion = random.motion(ship);
    const auto controls = random.controls(ship);
    const auto port = forces(test::mirrored(ship), mirrored(motion), test::mirrored(controls)).total();
    const auto starboard = mirrored(forces(ship, motion, controls).total());
    REQUIRE(port.X == starboard.X);
    REQUIRE(port.Y == starboard.Y);
    REQUIRE(port.N == starboard.N);
  }
}

TEST_CASE("a mirrored force gives the mirrored acceleration", "[nonlinear][symmetry]") {
  RandomShips random(2);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto motion = random.motion(ship);
    const PlanarForce<double> force{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const auto a = acceleration(ship, motion, force);
    const auto b = acceleration(ship, mirrored(motion), mirrored(force));
    REQUIRE(b.u == a.u);
    REQUIRE(b.v == -a.v);
    REQUIRE(b.r == -a.r);
  }
}

TEST_CASE("forces grow with the square of speed at equal drift, yaw rate, rudder and advance", "[nonlinear][limit]") {
  RandomShips random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const double k = random.uniform(0.2, 5.0);
    const auto slow = forces(ship, m, c).total();
    const auto fast = forces(ship, {k * m.u, k * m.v, k * m.r}, {c.delta, k * c.rev}).total();
    const double scale = k * k * force_scale(ship, speed(m));
    REQUIRE_THAT(fast.X, WithinAbs(k * k * slow.X, 1e-13 * scale));
    REQUIRE_THAT(fast.Y, WithinAbs(k * k * slow.Y, 1e-13 * scale));
    REQUIRE_THAT(fast.N, WithinAbs(k * k * slow.N, 1e-13 * scale * ship.particulars.L));
  }
}

/// Rudder and propeller as [Yasukawa2015] prints them: angles of attack, J and K_T.
struct AsPrinted {
  double thrust;
  double F_N;
};

AsPrinted as_printed(const MmgShip<double>& ship, const PlanarMotion<double>& m, const Controls<double>& controls) {
  const auto& p = ship.propeller;
  const auto& k = ship.rudder;
  const double U = std::hypot(m.u, m.v), beta = std::atan2(-m.v, m.u), r = m.r * ship.particulars.L / U;
  const double beta_P = beta - p.x_P * r, beta_R = beta - k.l_R * r;
  const double C_2 = beta_P > 0.0 ? p.C_2_positive : p.C_2_negative;
  const double one_minus_w = (1.0 - p.w_P0) * (1.0 + (1.0 - std::exp(-p.C_1 * std::abs(beta_P))) * (C_2 - 1.0));
  const double J = m.u * one_minus_w / (controls.rev * p.D);
  const double K_T = p.k_0 + p.k_1 * J + p.k_2 * J * J;
  const double eta = p.D / k.H_R;
  const double race = 1.0 + k.kappa * (std::sqrt(1.0 + 8.0 * K_T / (pi * J * J)) - 1.0);
  const double u_R = k.epsilon * m.u * one_minus_w * std::sqrt(eta * race * race + (1.0 - eta));
  const double v_R = U * (beta_R > 0.0 ? k.gamma_R_positive : k.gamma_R_negative) * beta_R;
  const double alpha_R = -controls.delta - std::atan2(v_R, u_R);
  return {.thrust = ship.water.rho * controls.rev * controls.rev * std::pow(p.D, 4) * K_T,
          .F_N = 0.5 * ship.water.rho * k.A_R * (u_R * u_R + v_R * v_R) * k.f_alpha * std::sin(alpha_R)};
}

TEST_CASE("thrust and rudder force are those of the printed equations", "[nonlinear][second-route]") {
  RandomShips random(4);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto printed = as_printed(ship, m, c);
    const auto split = forces(ship, m, c);
    const double scale = force_scale(ship, speed(m));
    const double lever = (ship.rudder.x_R + ship.rudder.a_H * ship.rudder.x_H) * ship.particulars.L;
    REQUIRE_THAT(thrust(ship, m, c), WithinAbs(printed.thrust, 1e-13 * scale));
    REQUIRE_THAT(split.propeller.X, WithinAbs((1.0 - ship.propeller.t_P) * printed.thrust, 1e-13 * scale));
    REQUIRE_THAT(split.rudder.X, WithinAbs((1.0 - ship.rudder.t_R) * printed.F_N * std::sin(c.delta), 1e-13 * scale));
    REQUIRE_THAT(split.rudder.Y, WithinAbs(-(1.0 + ship.rudder.a_H) * printed.F_N * std::cos(c.delta), 1e-13 * scale));
    REQUIRE_THAT(split.rudder.N,
                 WithinAbs(-lever * printed.F_N * std::cos(c.delta), 1e-13 * scale * ship.particulars.L));
  }
}

TEST_CASE("forces are continuous where the branch changes", "[nonlinear][limit]") {
  RandomShips random(5);
  for (int i = 0; i < 1000; ++i) {
    const auto ship = random.ship();
    const auto c = random.controls(ship);
    const double U = ship.particulars.U_0, r = random.uniform(-0.8, 0.8);
    for (const double x : {ship.propeller.x_P, ship.rudder.l_R}) {
      const double beta = x * r;  // beta − x' r' = 0
      const PlanarMotion<double> motion{U * std::cos(beta), -U * std::sin(beta), r * U / ship.particulars.L};
      auto other = branch_at(ship, motion, c);
      bool& changed = other[x == ship.propeller.x_P ? MmgBranch::propeller : MmgBranch::rudder];
      changed = !changed;
      const auto here = forces(ship, motion, c).total(), there = forces(ship, motion, c, other).total();
      REQUIRE_THAT(here.Y, WithinAbs(there.Y, 1e-13 * force_scale(ship, U)));
      REQUIRE_THAT(here.X, WithinAbs(there.X, 1e-13 * force_scale(ship, U)));
    }
  }
}

TEST_CASE("at the self-propulsion point nothing accelerates", "[nonlinear][limit]") {
  RandomShips random(6);
  for (int i = 0; i < 200; ++i) {
    const auto ship = random.ship();
    const double U = random.uniform(0.3, 2.0) * ship.particulars.U_0;
    const PlanarMotion<double> ahead{U, 0.0, 0.0};
    const auto a = acceleration(ship, ahead, forces(ship, ahead, self_propulsion(ship, U)).total());
    REQUIRE_THAT(a.u, WithinAbs(0.0, 1e-13 * U * U / ship.particulars.L));
    REQUIRE(a.v == 0.0);
    REQUIRE(a.r == 0.0);
  }
}

// ---------------------------------------------------------------- the three scalars

template <class S>
PlanarAcceleration<S> acceleration_of(const MmgShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& c) {
  return acceleration(ship, m, forces(ship, m, c).total());
}

TEST_CASE("dual numbers carry the value and the derivatives of the MMG model", "[nonlinear][second-route]") {
  using D = Dual<5>;
  RandomShips random(7);
  for (int i = 0; i < 300; ++i) {
    const auto ship = random.ship();
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const double U = speed(m), L = ship.particulars.L, unit = U * U / L;
    const auto dual = acceleration_of(cast<D>(ship), {D(m.u, 0), D(m.v, 1), D(m.r, 2)}, {D(c.delta, 3), D(c.rev, 4)});
    REQUIRE_THAT(dual.v.a, WithinAbs(acceleration_of(ship, m, c).v, 1e-14 * unit));
    // central differences, extrapolated once, on the branch of the point
    const auto branch = branch_at(ship, m, c);
    const auto along = [&](int k, double h) {
      const auto a =
          acceleration(ship, {m.u + (k == 0 ? h : 0.0), m.v + (k == 1 ? h : 0.0), m.r + (k == 2 ? h : 0.0)},
                       forces(ship, {m.u + (k == 0 ? h : 0.0), m.v + (k == 1 ? h : 0.0), m.r + (k == 2 ? h : 0.0)},
                              {c.delta + (k == 3 ? h : 0.0), c.rev + (k == 4 ? h : 0.0)}, branch)
                           .total());
      return std::array{a.u, a.v, a.r * L};
    };
    const double step[] = {1e-3 * U, 1e-3 * U, 1e-3 * U / L, 1e-3, 1e-3 * c.rev};
    for (int k = 0; k < 5; ++k) {
      const double h = step[k];
      const auto p1 = along(k, h), m1 = along(k, -h), p2 = along(k, 2 * h), m2 = along(k, -2 * h);
      const double exact[] = {dual.u.v[k], dual.v.v[k], dual.r.v[k] * L};
      for (std::size_t j = 0; j < 3; ++j) {
        const double difference = (8.0 * (p1[j] - m1[j]) - (p2[j] - m2[j])) / (12.0 * h);
        REQUIRE_THAT(exact[j] * h / 1e-3, WithinAbs(difference * h / 1e-3, 1e-8 * unit));
      }
    }
  }
}

TEST_CASE("every lane of a pack is one ship", "[nonlinear][second-route]") {
  constexpr std::size_t lanes = Pack::size;
  RandomShips random(8);
  for (int i = 0; i < 200; ++i) {
    alignas(64) std::array<std::array<double, lanes>, 5> column;
    const auto ship = random.ship();
    for (std::size_t k = 0; k < lanes; ++k) {
      const auto m = random.motion(ship);
      const auto c = random.controls(ship);
      const double values[] = {m.u, m.v, m.r, c.delta, c.rev};
      for (std::size_t j = 0; j < 5; ++j) column[j][k] = values[j];
    }
    const auto load = [&](std::size_t j) { return Pack::load_unaligned(column[j].data()); };
    const auto packed = acceleration_of(cast<Pack>(ship), {load(0), load(1), load(2)}, {load(3), load(4)});
    for (std::size_t k = 0; k < lanes; ++k) {
      const PlanarMotion<double> m{column[0][k], column[1][k], column[2][k]};
      const auto alone = acceleration_of(ship, m, {column[3][k], column[4][k]});
      const double unit = speed(m) * speed(m) / ship.particulars.L;
      REQUIRE_THAT(packed.u.get(k), WithinAbs(alone.u, 1e-12 * unit));
      REQUIRE_THAT(packed.v.get(k), WithinAbs(alone.v, 1e-12 * unit));
      REQUIRE_THAT(packed.r.get(k), WithinAbs(alone.r, 1e-12 * unit / ship.particulars.L));
    }
  }
}

}  // namespace
}  // namespace swayaw
