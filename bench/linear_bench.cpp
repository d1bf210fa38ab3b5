#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "reference_loops.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/batch.hpp"

namespace swayaw::bench {
namespace {

/// The chemical tanker of Artyszuk 2016, table 3; she sails a length in 13.39 s.
constexpr SwayYawCoefficients<double> tanker{-0.622, 0.405, -0.171, 3.552, -2.827, -1.539};
constexpr SteeringIndices<double> tanker_indices{10.491 * 0.298, 10.491 + 0.298, 0.154, 0.983, -3.464, -4.896};

/// 10/10 zigzag at 2.5 deg/s.
LinearZigzagOrder ten_ten(std::int64_t reversals) {
  return {.rudder = radians(10),
          .heading = radians(10),
          .rate = radians(2.5) * 13.39,
          .reversals = static_cast<std::size_t>(reversals)};
}

/// Exact switches, peaks and overshoots of N reversals.
void linear_zigzag_10_10(benchmark::State& state) {
  const auto order = ten_ten(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(linear_zigzag(tanker, order));
  tell_ratio(state);
}
BENCHMARK(linear_zigzag_10_10)->Arg(3)->Arg(6);

/// The same with 3,001 states.
void linear_zigzag_3001_samples(benchmark::State& state) {
  const auto order = ten_ten(3);
  std::vector<LinearState<double>> states(3001);
  for (auto _ : state) {
    const auto zigzag = linear_zigzag(tanker, order);
    sample_legs(tanker, zigzag.legs, zigzag.reversals.back().peak / 3000.0, states);
    benchmark::DoNotOptimize(states.data());
    benchmark::ClobberMemory();
  }
  tell_ratio(state);
}
BENCHMARK(linear_zigzag_3001_samples);

/// Derivatives of every switch and overshoot by T3b and T3w, the zigzag itself known.
void linear_zigzag_dual2(benchmark::State& state) {
  using D = Dual<2>;
  const auto order = ten_ten(3);
  const auto& i = tanker_indices;
  const auto ship =
      coefficients_from(SteeringIndices<D>{D(i.T1T2), D(i.T1_plus_T2), D(i.T3b, 0), D(i.T3w, 1), D(i.Kb), D(i.Kw)});
  const auto zigzag = linear_zigzag(coefficients_from(i), order);
  for (auto _ : state) benchmark::DoNotOptimize(carried_through(zigzag, ship, order));
  tell_ratio(state);
}
BENCHMARK(linear_zigzag_dual2);

/// Ships around the tanker, each coefficient within 5 %.
struct Fleet {
  std::array<std::vector<double>, 6> columns;

  explicit Fleet(std::size_t ships) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> about(0.95, 1.05);
    for (std::size_t i = 0; i < ships; ++i) {
      std::size_t c = 0;
      for (const double x : {tanker.a1, tanker.b1, tanker.c1, tanker.a2, tanker.b2, tanker.c2})
        columns[c++].push_back(x * about(engine));
    }
  }
  ShipColumns ships() const { return {columns[0], columns[1], columns[2], columns[3], columns[4], columns[5]}; }
};

void linear_zigzag_batch(benchmark::State& state, InstructionSet set) {
  if (!available(set)) return state.SkipWithError("instruction set not available");
  const auto order = ten_ten(state.range(0));
  const Fleet fleet(4096);
  ZigzagTable table;
  for (auto _ : state) zigzag_batch(fleet.ships(), order, table, {.threads = 1, .set = set});
  state.counters["per_ship"] =
      benchmark::Counter(4096.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  tell_ratio(state, 4096.0);
}
BENCHMARK_CAPTURE(linear_zigzag_batch, numbers, InstructionSet::numbers)->Arg(3);
BENCHMARK_CAPTURE(linear_zigzag_batch, baseline, InstructionSet::baseline)->Arg(3);
BENCHMARK_CAPTURE(linear_zigzag_batch, avx2, InstructionSet::avx2)->Arg(3);
BENCHMARK_CAPTURE(linear_zigzag_batch, avx512, InstructionSet::avx512)->Arg(3)->Arg(6);

/// Limit cycles and loop measures of 1,000 × 1,000 ships on N cores, 0 for all.
void linear_t3_map_1000000(benchmark::State& state) {
  std::vector<double> T3b, T3w;
  for (int i = 0; i < 1000; ++i) {
    T3b.push_back(0.02 + 0.0015 * i);
    T3w.push_back(0.10 + 0.0030 * i);
  }
  const auto threads = static_cast<unsigned>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(t3_map(tanker_indices, ten_ten(3), T3b, T3w, threads));
  tell_ratio(state, 1e6);
}
BENCHMARK(linear_t3_map_1000000)->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace swayaw::bench
