#pragma once

#include "batch_kernel.hpp"

/// Sampling of a leg. Only for the units of the batch kernels; see batch_kernel.hpp. A plain loop, which the compiler
/// turns into the instructions of the unit.
namespace swayaw::inline linear::batch {

/// @tparam Set  names the instruction set, so that each unit has a function of its own
template <class Set>
void sample_blocks(const BlockMap& m, SampleJob& job) {
  constexpr std::size_t next = 3 * block;
  double forced[next + 3];
  for (std::size_t i = 0; i < next + 3; ++i) forced[i] = job.turn * m.by_turn[i];
  double beta = job.beta, omega = job.omega, psi = job.psi, angle = job.angle;
  const auto value = [&](std::size_t i) {
    return forced[i] + beta * m.by_beta[i] + omega * m.by_omega[i] + angle * m.by_angle[i] + psi * m.by_psi[i];
  };
  double* __restrict out = job.states;
  for (std::size_t n = 0; n < job.blocks; ++n, out += next) {
    for (std::size_t i = 0; i < next; ++i) out[i] = value(i);
    const double b = value(next), w = value(next + 1), p = value(next + 2);
    beta = b, omega = w, psi = p;
    angle += static_cast<double>(block) * job.turn;
  }
  job.beta = beta, job.omega = omega, job.psi = psi, job.angle = angle;
}

}  // namespace swayaw::linear::batch
