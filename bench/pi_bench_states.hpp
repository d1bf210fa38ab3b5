#pragma once

#include <array>
#include <random>
#include <vector>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/nonlinear/models/pi/pi_forces.hpp"

namespace swayaw::bench {

inline PiShip<double> wpcc() {
  const std::filesystem::path path = SWAYAW_BENCH_SHIPS "/wpcc_pi.toml";
  const PartsReader file(read_text(path), path);
  PiShip<double> ship{};
  file.read(file_keys(ship));
  return ship;
}

/// A motion and controls that the manoeuvring model of the wPCC may have.
struct PiSample {
  PlanarMotion<double> motion;
  Controls<double> controls;
};

inline std::vector<PiSample> pi_samples(std::size_t count) {
  std::mt19937_64 engine(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  std::vector<PiSample> result(count);
  for (auto& s : result)
    s = {{uniform(0.5, 1.0), uniform(-0.15, 0.15), uniform(-0.07, 0.07)},
         {.delta = uniform(-0.5, 0.5), .thrust = {uniform(4.0, 7.0), uniform(4.0, 7.0)}, .by_thrust = true}};
  return result;
}

/// Right-hand side of the equations of motion with earth-fixed track, under given forces.
template <class S>
std::array<S, 6> right_hand_side(const PiShip<S>& ship, const S& psi, const PlanarMotion<S>& m, const PiForces<S>& f) {
  const auto a = acceleration(ship, m, f.total());
  const S c = cos(psi), s = sin(psi);
  return {m.u * c - m.v * s, m.u * s + m.v * c, m.r, a.u, a.v, a.r};
}

}  // namespace swayaw::bench
