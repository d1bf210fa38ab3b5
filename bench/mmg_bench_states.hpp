#pragma once

#include <array>
#include <random>
#include <vector>

#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::bench {

inline MmgShip<double> kvlcc2() {
  return std::get<MmgShip<double>>(read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml").model);
}

/// A motion and controls that a manoeuvring KVLCC2 model may have.
struct Sample {
  PlanarMotion<double> motion;
  Controls<double> controls;
};

inline std::vector<Sample> samples(std::size_t count) {
  std::mt19937_64 engine(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  std::vector<Sample> result(count);
  for (auto& s : result)
    s = {{uniform(0.5, 1.2), uniform(-0.2, 0.2), uniform(-0.06, 0.06)}, {uniform(-0.6, 0.6), uniform(9.0, 12.0)}};
  return result;
}

/// Right-hand side of the equations of motion with earth-fixed track.
template <class S>
std::array<S, 6> right_hand_side(const MmgShip<S>& ship, const S& psi, const PlanarMotion<S>& m,
                                 const Controls<S>& controls) {
  const auto a = acceleration(ship, m, forces(ship, m, controls).total());
  const auto [s, c] = sin_cos(psi);
  return {m.u * c - m.v * s, m.u * s + m.v * c, m.r, a.u, a.v, a.r};
}

}  // namespace swayaw::bench
