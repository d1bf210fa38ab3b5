#pragma once

#include <random>

#include "swayaw/linear/ship_parts.hpp"
#include "swayaw/linear/sway_yaw.hpp"

/// Seeded linear ships of every kind.
namespace swayaw::test {

class RandomLinearShips {
 public:
  explicit RandomLinearShips(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  /// The chemical tanker of Artyszuk 2016, table 3, as printed.
  static SwayYawCoefficients<double> tanker() { return {-0.622, 0.405, -0.171, 3.552, -2.827, -1.539}; }

  /// Coefficients of ship-like size: stable and unstable, real and complex poles; about 1 in 6 is unstable, 1 in 4 has
  /// complex poles.
  SwayYawCoefficients<double> ship() {
    return {uniform(-2.0, -0.05), uniform(-0.6, 1.2),  uniform(-0.5, -0.02),
            uniform(-4.0, 6.0),   uniform(-5.0, -0.3), uniform(-3.0, -0.3)};
  }

  /// Hull and rudder around the chemical tanker.
  LinearParts<double> parts() {
    const auto about = [&](double x) { return x * uniform(0.7, 1.3); };
    return {.hull = {about(5.867), uniform(0.5, 0.85), about(0.056), about(1.004), about(0.247), about(0.225),
                     about(0.0043), about(0.026), about(0.0024), about(-0.063)},
            .rudder = {about(0.0177), uniform(0.1, 0.45), about(2.127), about(0.0385), uniform(0.05, 0.9),
                       uniform(0.3, 2.0), uniform(-0.6, -0.4)}};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace swayaw::test
