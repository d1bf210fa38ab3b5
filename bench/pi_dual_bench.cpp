#include <benchmark/benchmark.h>

#include "pi_bench_states.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/dual.hpp"

/// In a file of its own, as the library compiles dual numbers: beside much else the compiler calls their operations
/// where it should put them in place.
namespace swayaw::bench {
namespace {

[[gnu::flatten]] auto rates(const PiShip<Dual<4>>& ship, const PlanarMotion<Dual<4>>& m,
                            const Controls<Dual<4>>& controls) {
  return right_hand_side(ship, Dual<4>(0.3), m, forces(ship, m, controls));
}

/// Derivatives by u, v, r and delta.
void pi_right_hand_side_dual4(benchmark::State& state) {
  using D = Dual<4>;
  const auto ship = cast<D>(wpcc());
  const auto motions = pi_samples(1024);
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
BENCHMARK(pi_right_hand_side_dual4);

}  // namespace
}  // namespace swayaw::bench
