#include <benchmark/benchmark.h>

#include "pi_bench_states.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/pack.hpp"

namespace swayaw::bench {
namespace {

/// One ship in each lane; the time is that of one ship, its branch found on the way.
void pi_right_hand_side_pack(benchmark::State& state) {
  constexpr std::size_t lanes = Pack::size;
  const auto ship = cast<Pack>(wpcc());
  const auto motions = pi_samples(1024);
  std::vector<PlanarMotion<Pack>> packs;
  std::vector<Controls<Pack>> controls;
  for (std::size_t i = 0; i + lanes <= motions.size(); i += lanes) {
    const auto gather = [&](auto&& value) {
      alignas(64) std::array<double, lanes> lane;
      for (std::size_t k = 0; k < lanes; ++k) lane[k] = value(motions[i + k]);
      return Pack::load_aligned(lane.data());
    };
    packs.push_back({gather([](const PiSample& s) { return s.motion.u; }),
                     gather([](const PiSample& s) { return s.motion.v; }),
                     gather([](const PiSample& s) { return s.motion.r; })});
    controls.push_back({.delta = gather([](const PiSample& s) { return s.controls.delta; }),
                        .thrust = {gather([](const PiSample& s) { return s.controls.thrust.port; }),
                                   gather([](const PiSample& s) { return s.controls.thrust.starboard; })},
                        .by_thrust = true});
  }
  for (auto _ : state) {
    for (std::size_t i = 0; i < packs.size(); ++i)
      benchmark::DoNotOptimize(
          right_hand_side(ship, Pack(packs[i].r * 10.0), packs[i], forces(ship, packs[i], controls[i])));
  }
  const auto ships = static_cast<double>(packs.size() * lanes);
  state.counters["per_ship"] =
      benchmark::Counter(ships, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  tell_ratio(state, ships);
}
BENCHMARK(pi_right_hand_side_pack);

}  // namespace
}  // namespace swayaw::bench
