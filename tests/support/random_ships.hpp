#pragma once

#include <random>
#include <tuple>

#include "files.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/controls.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// Seeded ships and motions for laws that must hold for all of them.
namespace swayaw::test {

inline Ship kvlcc2_l7() { return read_ship(ships / "kvlcc2_l7.toml"); }
inline Ship kvlcc2() { return read_ship(ships / "kvlcc2.toml"); }

inline const MmgShip<double>& mmg(const Ship& ship) { return std::get<MmgShip<double>>(ship.model); }

class RandomShips {
 public:
  explicit RandomShips(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  /// A tanker-like ship: every number of the KVLCC2 model changed by up to a quarter.
  MmgShip<double> ship() {
    auto result = mmg(kvlcc2_l7());
    const auto shake = [&](const auto& section) {
      auto& part = result.*section.part;
      for (const auto& parameter : part.parameters()) part.*parameter.member *= uniform(0.75, 1.25);
    };
    std::apply([&](const auto&... section) { (shake(section), ...); }, MmgShip<double>::sections());
    return result;
  }

  /// Way ahead with drift up to 25 deg and r' up to 0.9.
  PlanarMotion<double> motion(const MmgShip<double>& ship) {
    const double U = ship.particulars.U_0 * uniform(0.4, 1.2);
    const double beta = uniform(-0.45, 0.45);
    return {U * std::cos(beta), -U * std::sin(beta), uniform(-0.9, 0.9) * U / ship.particulars.L};
  }

  Controls<double> controls(const MmgShip<double>& ship) {
    return {uniform(-1.0, 1.0) * ship.steering_gear.max_angle,
            uniform(0.7, 1.3) * 1.5 * ship.particulars.U_0 / ship.propeller.D};
  }

 private:
  std::mt19937_64 engine_;
};

/// The ship seen in a mirror: what is asymmetric in her is exchanged.
inline MmgShip<double> mirrored(MmgShip<double> ship) {
  std::swap(ship.rudder.gamma_R_negative, ship.rudder.gamma_R_positive);
  std::swap(ship.propeller.C_2_negative, ship.propeller.C_2_positive);
  return ship;
}

inline Controls<double> mirrored(const Controls<double>& controls) { return {-controls.delta, controls.rev}; }

}  // namespace swayaw::test
