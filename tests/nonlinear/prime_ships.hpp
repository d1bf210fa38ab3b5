#pragma once

#include <random>

#include "files.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/nonlinear/models/pi/pi_forces.hpp"
#include "swayaw/nonlinear/models/pu/pu_forces.hpp"

/// Ships of the physics-informed and the physics-uninformed model, and seeded relatives of them.
namespace swayaw::test {

template <class Ship>
Ship prime_ship(const std::string& name) {
  const auto path = ships / (name + ".toml");
  const PartsReader file(read_text(path), path);
  Ship ship{};
  file.read(file_keys(ship));
  return ship;
}

inline PiShip<double> pi_ship(const std::string& name) { return prime_ship<PiShip<double>>(name); }
inline PuShip<double> wpcc_pu() { return prime_ship<PuShip<double>>("wpcc_pu"); }

template <template <class> class Model, class S>
PlanarAcceleration<S> acceleration_at(const Model<S>& ship, const PlanarMotion<S>& m, const Controls<S>& c) {
  return acceleration(ship, m, forces(ship, m, c).total());
}

class RandomPrimeShips {
 public:
  explicit RandomPrimeShips(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  /// The wPCC with every number changed by up to a quarter, and with every term that she lacks.
  PiShip<double> pi() {
    auto ship = shaken(pi_ship("wpcc_pi"));
    fill_hull(ship.hull);
    fill_propeller(ship.propeller);
    ship.rudder.y_R_port = uniform(-0.3, -0.1);
    ship.rudder.y_R_starboard = uniform(0.1, 0.3);
    ship.rudder.Omega = uniform(-0.2, 0.2);
    ship.rudder.friction_line.index = uniform(0, 1) < 0.5;
    ship.rudder.gap_factor.index = uniform(0, 1) < 0.5;
    return ship;
  }

  PuShip<double> pu() {
    auto ship = shaken(wpcc_pu());
    fill_hull(ship.hull);
    fill_propeller(ship.propeller);
    return ship;
  }

  /// Way ahead with drift up to 20 deg and r' up to 0.6.
  PlanarMotion<double> motion(double L, double U_0) {
    const double U = U_0 * uniform(0.4, 1.2), beta = uniform(-0.35, 0.35);
    return {U * std::cos(beta), -U * std::sin(beta), uniform(-0.6, 0.6) * U / L};
  }

  /// Rudder up to 40 deg; thrust that differs from side to side, or a shaft speed.
  Controls<double> controls(double U_0) {
    const bool by_thrust = uniform(0, 1) < 0.5;
    return {.delta = uniform(-0.7, 0.7),
            .rev = uniform(8, 14) * U_0,
            .thrust = {uniform(2, 8), uniform(2, 8)},
            .by_thrust = by_thrust};
  }

 private:
  template <class Ship>
  Ship shaken(Ship ship) {
    const auto shake = [&](const auto& section) {
      auto& part = ship.*section.part;
      for (const auto& parameter : part.parameters()) part.*parameter.member *= uniform(0.75, 1.25);
    };
    std::apply([&](const auto&... section) { (shake(section), ...); }, Ship::sections());
    return ship;
  }

  void fill_hull(PrimeHull<double>& hull) {
    for (const auto& parameter : hull.parameters()) hull.*parameter.member += uniform(-1, 1) * 5e-3;
  }

  void fill_propeller(PrimePropeller<double>& p) {
    p.x_P = uniform(-2.6, -2.2);
    p.k_0 = uniform(0.3, 0.5);
    p.k_1 = uniform(-0.3, -0.2);
    p.k_2 = uniform(-0.2, -0.1);
    p.C_1 = uniform(1, 3);
    p.C_2_positive = uniform(0.5, 1.8);
    p.C_2_negative = uniform(0.5, 1.8);
    p.wake.index = uniform(0, 1) < 0.5;
  }

  std::mt19937_64 engine_;
};

// ---------------------------------------------------------------- mirrors

inline void mirror(PrimeHull<double>& hull) {
  hull.Y_0 *= -1.0;
  hull.N_0 *= -1.0;
}

inline void mirror(PrimePropeller<double>& p) {
  std::swap(p.C_2_positive, p.C_2_negative);
  p.y_P_port = -std::exchange(p.y_P_starboard, -p.y_P_port);
}

inline void mirror(LiftingLineRudder<double>& k) {
  k.y_R_port = -std::exchange(k.y_R_starboard, -k.y_R_port);
  k.gamma_0_port = -std::exchange(k.gamma_0_starboard, -k.gamma_0_port);
}

inline void mirror(MathematicalRudder<double>&) {}

/// The ship seen in a mirror: what is asymmetric in her is exchanged.
template <PrimeShip Ship>
Ship mirrored(Ship ship) {
  mirror(ship.hull);
  mirror(ship.propeller);
  mirror(ship.rudder);
  return ship;
}

inline Controls<double> mirrored_sides(Controls<double> c) {
  c.delta *= -1.0;
  std::swap(c.thrust.port, c.thrust.starboard);
  return c;
}

}  // namespace swayaw::test
