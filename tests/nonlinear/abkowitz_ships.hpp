#pragma once

#include <random>
#include <string>

#include "files.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/nonlinear/models/abkowitz/abkowitz_forces.hpp"

/// The Mariner, and seeded relatives of her.
namespace swayaw::test {

inline AbkowitzShip<double> parse_abkowitz(const std::string& text) {
  const PartsReader file(text, "ship.toml");
  file.require_model("abkowitz");
  AbkowitzShip<double> ship{};
  file.read(file_keys(ship));
  return ship;
}

inline std::string mariner_text() { return read_text(ships / "mariner.toml"); }

inline AbkowitzShip<double> mariner() { return parse_abkowitz(mariner_text()); }

class RandomAbkowitz {
 public:
  explicit RandomAbkowitz(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  /// Every number of the Mariner changed by up to a quarter, every term she lacks added, both choices at random.
  AbkowitzShip<double> ship() {
    auto result = mariner();
    const auto shake = [&](const auto& section) {
      auto& part = result.*section.part;
      for (const auto& p : part.parameters())
        part.*p.member = part.*p.member == 0.0 ? uniform(-0.01, 0.01) : part.*p.member * uniform(0.75, 1.25);
    };
    std::apply([&](const auto&... section) { (shake(section), ...); }, AbkowitzShip<double>::sections());
    result.particulars.prime_speed.index = uniform(0.0, 1.0) < 0.5;
    result.inertia.centripetal.index = uniform(0.0, 1.0) < 0.5;
    return result;
  }

  /// Way ahead with drift up to 25 deg and r' up to 0.9.
  PlanarMotion<double> motion(const AbkowitzShip<double>& ship) {
    const double U = ship.particulars.U_0 * uniform(0.4, 1.2), beta = uniform(-0.45, 0.45);
    return {U * std::cos(beta), -U * std::sin(beta), uniform(-0.9, 0.9) * U / ship.particulars.L};
  }

  Controls<double> controls(const AbkowitzShip<double>& ship) {
    return {.delta = uniform(-1.0, 1.0) * ship.steering_gear.max_angle};
  }

 private:
  std::mt19937_64 engine_;
};

/// Without what is not symmetric straight ahead.
inline AbkowitzShip<double> symmetric(AbkowitzShip<double> ship) {
  auto& h = ship.hull;
  h.Y_0 = h.Y_0u = h.Y_0uu = h.N_0 = h.N_0u = h.N_0uu = 0.0;
  return ship;
}

}  // namespace swayaw::test
