#include <benchmark/benchmark.h>

#include "mmg_bench_states.hpp"
#include "pi_bench_states.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/dual.hpp"

/// Right-hand sides with derivatives by u, v, r and delta. In a file of its own and with all calls put in place, as the
/// library compiles dual numbers: beside much else the compiler calls their operations one by one.
namespace swayaw::bench {
namespace {

using D = Dual<4>;

[[gnu::flatten]] auto rates(const MmgShip<D>& ship, const PlanarMotion<D>& m, const Controls<D>& controls) {
  return right_hand_side(ship, D(0.3), m, controls);
}

[[gnu::flatten]] auto rates(const PiShip<D>& ship, const PlanarMotion<D>& m, const Controls<D>& controls) {
  return right_hand_side(ship, D(0.3), m, forces(ship, m, controls));
}

/// @param motions  1,024 of them
void time_rates(benchmark::State& state, const auto& ship, const auto& motions) {
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& s = motions[i++ & 1023];
    const PlanarMotion<D> m{D(s.motion.u, 0), D(s.motion.v, 1), D(s.motion.r, 2)};
    auto controls = cast<D>(s.controls);
    controls.delta.v[3] = 1.0;
    benchmark::DoNotOptimize(rates(ship, m, controls));
  }
  tell_ratio(state);
}

void mmg_right_hand_side_dual4(benchmark::State& state) { time_rates(state, cast<D>(kvlcc2()), samples(1024)); }
BENCHMARK(mmg_right_hand_side_dual4);

void pi_right_hand_side_dual4(benchmark::State& state) { time_rates(state, cast<D>(wpcc()), pi_samples(1024)); }
BENCHMARK(pi_right_hand_side_dual4);

}  // namespace
}  // namespace swayaw::bench
