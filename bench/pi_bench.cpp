#include <benchmark/benchmark.h>

#include "pi_bench_states.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/dual.hpp"

namespace swayaw::bench {
namespace {

/// Twin rudders, each in its own race; the branch is known, as it is to the integrator.
void pi_right_hand_side(benchmark::State& state) {
  const auto ship = wpcc();
  const auto motions = pi_samples(1024);
  std::vector<Branch<double, 6>> branches;
  for (const auto& s : motions) branches.push_back(branch_at(ship, s.motion, s.controls));
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t k = i++ & 1023;
    const auto& s = motions[k];
    benchmark::DoNotOptimize(
        right_hand_side(ship, s.motion.r * 10.0, s.motion, forces(ship, s.motion, s.controls, branches[k])));
  }
  tell_ratio(state);
}
BENCHMARK(pi_right_hand_side);

/// The branch, asked for once a step.
void pi_branch(benchmark::State& state) {
  const auto ship = wpcc();
  const auto motions = pi_samples(1024);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& s = motions[i++ & 1023];
    benchmark::DoNotOptimize(branch_functions(ship, s.motion, s.controls));
  }
  tell_ratio(state);
}
BENCHMARK(pi_branch);

}  // namespace
}  // namespace swayaw::bench
