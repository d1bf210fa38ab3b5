#include <benchmark/benchmark.h>

#include "mmg_bench_states.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/dual.hpp"

/// In a file of its own, as the library compiles dual numbers: beside much else the compiler calls their operations
/// where it should put them in place.
namespace swayaw::bench {
namespace {

[[gnu::flatten]] auto rates(const MmgShip<Dual<4>>& ship, const PlanarMotion<Dual<4>>& m,
                            const Controls<Dual<4>>& controls) {
  return right_hand_side(ship, Dual<4>(0.3), m, controls);
}

/// Derivatives by u, v, r and delta.
void mmg_right_hand_side_dual4(benchmark::State& state) {
  using D = Dual<4>;
  const auto ship = cast<D>(kvlcc2());
  const auto motions = samples(1024);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& s = motions[i++ & 1023];
    const PlanarMotion<D> m{D(s.motion.u, 0), D(s.motion.v, 1), D(s.motion.r, 2)};
    benchmark::DoNotOptimize(rates(ship, m, {D(s.controls.delta, 3), D(s.controls.rev)}));
  }
  tell_ratio(state);
}
BENCHMARK(mmg_right_hand_side_dual4);

}  // namespace
}  // namespace swayaw::bench
