#include <array>
#include <catch.hpp>
#include <cmath>
#include <string>

#include "model_ships.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

/// What holds for every model of the nonlinear floor.
namespace swayaw {
namespace {

using test::RandomModels;

#define EVERY_MODEL MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>

constexpr int states = 1000;

/// Units of force and moment: ½ρL²U², ½ρL³U².
template <class Model>
double force_unit(const Model& ship, double U) {
  const double L = ship.particulars.L;
  return 0.5 * ship.water.rho * L * L * U * U;
}

// ---------------------------------------------------------------- derivatives

/// u, v, r, delta, shaft speed, thrust on port, thrust on starboard.
constexpr std::size_t inputs = 7;

template <class S>
using Inputs = std::array<S, inputs>;

Inputs<double> inputs_of(const PlanarMotion<double>& m, const Controls<double>& c) {
  return {m.u, m.v, m.r, c.delta, c.rev, c.thrust.port, c.thrust.starboard};
}

/// du/dt, dv/dt and L dr/dt on a branch.
template <template <class> class Model, class S, std::size_t N>
std::array<S, 3> acceleration_on(const Model<S>& ship, const Inputs<S>& x, bool by_thrust, const Branch<S, N>& branch) {
  const PlanarMotion<S> m{x[0], x[1], x[2]};
  const Controls<S> c{.delta = x[3], .rev = x[4], .thrust = {x[5], x[6]}, .by_thrust = by_thrust};
  const auto a = acceleration(ship, m, forces(ship, m, c, branch).total());
  return {a.u, a.v, a.r * ship.particulars.L};
}

/// What one per cent of speed, of yaw rate U/L, of a radian, of propulsion is.
template <class Model>
Inputs<double> unit_steps(const Model& ship, double U, const Controls<double>& c) {
  const double thrust = c.thrust.port + c.thrust.starboard;
  return {1e-2 * U, 1e-2 * U, 1e-2 * U / ship.particulars.L, 1e-2, 1e-2 * c.rev, 1e-2 * thrust, 1e-2 * thrust};
}

/// df/dx · h from central differences over h/16, h/8, h/4, extrapolated twice; errors of order h⁶.
template <class Function>
std::array<double, 3> extrapolated_difference(Function&& f) {
  std::array<double, 3> result;
  const auto central = [&](double h) {
    const auto p = f(h), m = f(-h);
    return std::array{(p[0] - m[0]) / (2 * h), (p[1] - m[1]) / (2 * h), (p[2] - m[2]) / (2 * h)};
  };
  const auto d1 = central(1.0 / 16), d2 = central(1.0 / 8), d4 = central(1.0 / 4);
  for (std::size_t j = 0; j < 3; ++j) {
    const double once = (4.0 * d1[j] - d2[j]) / 3.0, coarse = (4.0 * d2[j] - d4[j]) / 3.0;
    result[j] = (16.0 * once - coarse) / 15.0;
  }
  return result;
}

TEMPLATE_TEST_CASE("derivatives of the acceleration by duals equal extrapolated differences at 1,000 seeded states",
                   "[nonlinear][second-route]", EVERY_MODEL) {
  using D = Dual<static_cast<int>(inputs)>;
  RandomModels random(61);
  for (int i = 0; i < states; ++i) {
    const auto ship = random.ship<TestType>();
    const auto motion = random.motion(ship);
    const auto controls = random.controls(ship);
    const auto branch = branch_at(ship, motion, controls);
    const auto x = inputs_of(motion, controls);
    Inputs<D> seeded;
    for (std::size_t k = 0; k < inputs; ++k) seeded[k] = D(x[k], static_cast<int>(k));
    const auto dual = acceleration_on(cast<D>(ship), seeded, controls.by_thrust, branch);
    const double U = speed(motion), unit = U * U / ship.particulars.L;
    const auto steps = unit_steps(ship, U, controls);
    for (std::size_t k = 0; k < inputs; ++k) {
      const auto difference = extrapolated_difference([&](double part) {
        auto moved = x;
        moved[k] += part * steps[k];
        return acceleration_on(ship, moved, controls.by_thrust, branch);
      });
      for (std::size_t j = 0; j < 3; ++j)
        REQUIRE_THAT(dual[j].v[static_cast<int>(k)] * steps[k] * 1e2, WithinAbs(difference[j] * 1e2, 1e-8 * unit));
    }
  }
}

// The race behind a propeller that is dragged stands still at some speed; its slope by the speed is no number there.
TEMPLATE_TEST_CASE("derivatives are numbers where the ship drags her propellers", "[nonlinear][limit]", EVERY_MODEL) {
  using D = Dual<static_cast<int>(inputs)>;
  RandomModels random(62);
  for (int i = 0; i < 20; ++i) {
    const auto ship = random.ship<TestType>();
    const auto motion = random.motion(ship);
    auto controls = random.controls(ship);
    controls.by_thrust = true;
    for (const double drag : {0.0, 0.01, 0.1, 1.0}) {
      controls.thrust.port = controls.thrust.starboard = -drag * force_unit(ship, speed(motion));
      const auto x = inputs_of(motion, controls);
      Inputs<D> seeded;
      for (std::size_t k = 0; k < inputs; ++k) seeded[k] = D(x[k], static_cast<int>(k));
      for (const auto& a : acceleration_on(cast<D>(ship), seeded, true, branch_at(ship, motion, controls))) {
        INFO("thrust " << controls.thrust.port << " N on each side");
        CHECK(std::isfinite(a.a));
        CHECK(a.v.allFinite());
      }
    }
  }
}

// ---------------------------------------------------------------- forces

TEMPLATE_TEST_CASE("a ship without asymmetric numbers feels mirrored forces in mirrored motion",
                   "[nonlinear][symmetry]", EVERY_MODEL) {
  RandomModels random(62);
  for (int i = 0; i < states; ++i) {
    const auto ship = test::symmetric(random.ship<TestType>());
    const auto m = random.motion(ship);
    const auto c = random.controls(ship);
    const auto port = forces(ship, mirrored(m), test::mirrored_sides(c)).parts(),
               starboard = forces(ship, m, c).parts();
    const double F = force_unit(ship, speed(m)), L = ship.particulars.L;
    for (std::size_t k = 0; k < port.size(); ++k) {
      const auto there = mirrored(port[k].force), here = starboard[k].force;
      REQUIRE_THAT(there.X, WithinAbs(here.X, 1e-14 * F));
      REQUIRE_THAT(there.Y, WithinAbs(here.Y, 1e-14 * F));
      REQUIRE_THAT(there.N, WithinAbs(here.N, 1e-14 * F * L));
    }
  }
}

TEMPLATE_TEST_CASE("the parts of the force add up to the total", "[nonlinear][round-trip]", EVERY_MODEL) {
  RandomModels random(63);
  for (int i = 0; i < states; ++i) {
    const auto ship = random.ship<TestType>();
    const auto split = forces(ship, random.motion(ship), random.controls(ship));
    PlanarForce<double> sum{};
    for (const auto& part : split.parts()) sum = sum + part.force;
    const auto total = split.total();
    REQUIRE(sum.X == total.X);
    REQUIRE(sum.Y == total.Y);
    REQUIRE(sum.N == total.N);
    REQUIRE(std::isfinite(total.X + total.Y + total.N));
  }
}

TEMPLATE_TEST_CASE("the acceleration is affine in the force", "[nonlinear][limit]", EVERY_MODEL) {
  RandomModels random(64);
  for (int i = 0; i < states; ++i) {
    const auto ship = random.ship<TestType>();
    const auto m = random.motion(ship);
    const double U = speed(m), L = ship.particulars.L, F = 1e-2 * force_unit(ship, U), s = random.uniform(-1.0, 2.0);
    const auto any = [&] {
      return PlanarForce<double>{F * random.uniform(-1, 1), F * random.uniform(-1, 1), F * L * random.uniform(-1, 1)};
    };
    const auto f = any(), g = any();
    const PlanarForce<double> mixed{s * f.X + (1 - s) * g.X, s * f.Y + (1 - s) * g.Y, s * f.N + (1 - s) * g.N};
    const auto a = acceleration(ship, m, f), b = acceleration(ship, m, g), c = acceleration(ship, m, mixed);
    const double unit = U * U / L;
    REQUIRE_THAT(c.u, WithinAbs(s * a.u + (1 - s) * b.u, 1e-12 * unit));
    REQUIRE_THAT(c.v, WithinAbs(s * a.v + (1 - s) * b.v, 1e-12 * unit));
    REQUIRE_THAT(c.r, WithinAbs(s * a.r + (1 - s) * b.r, 1e-12 * unit / L));
  }
}

// ---------------------------------------------------------------- manoeuvres

/// A ship of each model that ends a zigzag.
template <class Model>
Model published_ship() {
  if constexpr (std::is_same_v<Model, MmgShip<double>>) return test::mmg(test::kvlcc2_l7());
  else if constexpr (std::is_same_v<Model, PiShip<double>>) return test::pi_ship("wpcc_pi");
  else if constexpr (std::is_same_v<Model, PuShip<double>>) return test::wpcc_pu();
  else return test::mariner();
}

constexpr ZigzagOrder ten_ten(Side first) { return {.rudder = radians(10), .heading = radians(10), .first = first}; }

/// For 15 ship lengths.
template <class Model>
ManoeuvreOptions options_for(const Model& ship) {
  return {.duration = 15.0 * ship.particulars.L / ship.particulars.U_0, .tolerance = 1e-11};
}

TEMPLATE_TEST_CASE("a current carries a ship along and changes nothing else", "[nonlinear][symmetry]", EVERY_MODEL) {
  RandomModels random(65);
  const auto model = published_ship<TestType>();
  const double L = model.particulars.L, U_0 = model.particulars.U_0;
  auto ship = test::ship_of(model);
  const auto still = zigzag(ship, ten_ten(Side::starboard), options_for(model));
  REQUIRE(still.reversals.size() >= 2);
  for (int i = 0; i < 5; ++i) {
    ship.surroundings.current = {.speed = U_0 * random.uniform(0.1, 1.0), .to = random.uniform(-pi, pi)};
    const auto& [V_c, psi_c] = ship.surroundings.current;
    const auto carried = zigzag(ship, ten_ten(Side::starboard), options_for(model));
    REQUIRE(carried.run.samples() == still.run.samples());
    for (std::size_t k = 0; k < still.run.samples(); ++k) {
      const double way = V_c * still.run.time[k];
      const auto off = [&](Channel channel) { return carried.run[channel][k] - still.run[channel][k]; };
      REQUIRE_THAT(off(Channel::x), WithinAbs(way * std::cos(psi_c), 1e-9 * L));
      REQUIRE_THAT(off(Channel::y), WithinAbs(way * std::sin(psi_c), 1e-9 * L));
      REQUIRE_THAT(off(Channel::psi), WithinAbs(0.0, 1e-9));
      REQUIRE_THAT(off(Channel::u), WithinAbs(0.0, 1e-9 * U_0));
      REQUIRE_THAT(off(Channel::v), WithinAbs(0.0, 1e-9 * U_0));
      REQUIRE_THAT(off(Channel::r), WithinAbs(0.0, 1e-9 * U_0 / L));
    }
  }
}

TEMPLATE_TEST_CASE("mirrored winds make mirrored zigzags of a symmetric ship", "[nonlinear][symmetry]", EVERY_MODEL) {
  RandomModels random(66);
  const auto model = test::symmetric(published_ship<TestType>());
  const double L = model.particulars.L, U_0 = model.particulars.U_0;
  auto ship = test::ship_of(model);
  ship.surroundings.windage = *windage_from({.frontal = 0.02 * L * L, .lateral = 0.08 * L * L, .length = L});
  ship.surroundings.windy = true;
  for (int i = 0; i < 5; ++i) {
    const double V = U_0 * random.uniform(0.5, 2.0), from = random.uniform(0.0, pi);
    ship.surroundings.wind = {.speed = V, .from = from};
    const auto starboard = zigzag(ship, ten_ten(Side::starboard), options_for(model)).run;
    ship.surroundings.wind = {.speed = V, .from = -from};
    const auto port = zigzag(ship, ten_ten(Side::port), options_for(model)).run;
    REQUIRE(port.samples() == starboard.samples());
    const auto sum = [&](Channel channel, std::size_t k) { return port[channel][k] + starboard[channel][k]; };
    for (std::size_t k = 0; k < port.samples(); ++k) {
      REQUIRE_THAT(port[Channel::x][k], WithinAbs(starboard[Channel::x][k], 1e-9 * L));
      REQUIRE_THAT(port[Channel::u][k], WithinAbs(starboard[Channel::u][k], 1e-9 * U_0));
      REQUIRE_THAT(sum(Channel::y, k), WithinAbs(0.0, 1e-9 * L));
      REQUIRE_THAT(sum(Channel::psi, k), WithinAbs(0.0, 1e-9));
      REQUIRE_THAT(sum(Channel::v, k), WithinAbs(0.0, 1e-9 * U_0));
      REQUIRE_THAT(sum(Channel::r, k), WithinAbs(0.0, 1e-9 * U_0 / L));
    }
    // the wind is felt
    ship.surroundings.wind.speed = 0.0;
    CHECK(std::abs(zigzag(ship, ten_ten(Side::port), options_for(model)).run[Channel::y].back() -
                   port[Channel::y].back()) > 1e-4 * L);
  }
}

}  // namespace
}  // namespace swayaw
