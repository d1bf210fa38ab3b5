#include <benchmark/benchmark.h>

#include "mmg_bench_states.hpp"
#include "reference_loops.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/simulation/batch.hpp"
#include "swayaw/nonlinear/simulator.hpp"

namespace swayaw::bench {
namespace {

Ship kvlcc2_ship() { return read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml"); }

void mmg_right_hand_side(benchmark::State& state) {
  const auto ship = kvlcc2();
  const auto motions = samples(1024);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& s = motions[i++ & 1023];
    benchmark::DoNotOptimize(right_hand_side(ship, s.motion.r * 10.0, s.motion, s.controls));
  }
  tell_ratio(state);
}
BENCHMARK(mmg_right_hand_side);

/// KVLCC2 10/10 zigzag of 100 s, events only, at the tolerance 10^-N; with the error of the last switch.
void kvlcc2_zigzag_10_10(benchmark::State& state) {
  const Ship ship = kvlcc2_ship();
  const ZigzagOrder order{.rudder = radians(10), .heading = radians(10), .first = Side::starboard};
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  const ManoeuvreOptions options{.duration = 100.0, .tolerance = tolerance, .sampled = false};
  const auto exact = zigzag(ship, order, {.duration = 100.0, .tolerance = 1e-12, .sampled = false});
  double error = 0.0;
  for (auto _ : state) {
    const auto result = zigzag(ship, order, options);
    error = std::abs(result.reversals.back().time - exact.reversals.back().time);
  }
  state.counters["switch_error_s"] = error;
  tell_ratio(state);
}
BENCHMARK(kvlcc2_zigzag_10_10)->DenseRange(5, 10)->Unit(benchmark::kMicrosecond);

/// KVLCC2 and ships whose coefficients are within 5 % of hers.
std::vector<MmgShip<double>> perturbed(std::size_t count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> about(0.95, 1.05);
  std::vector<MmgShip<double>> ships(count, kvlcc2());
  for (auto& ship : ships) {
    const auto shake = [&](const auto& section) {
      auto& part = ship.*section.part;
      for (const auto& p : part.parameters())
        if (p.role == Role::coefficient) part.*p.member *= about(engine);
    };
    std::apply([&](const auto&... section) { (shake(section), ...); }, MmgShip<double>::sections());
  }
  return ships;
}

/// 10/10 zigzags of 10,000 perturbed ships over 100 s at the tolerance 10^-N on one core; with the largest error of a
/// switch among the first hundred.
void kvlcc2_zigzag_batch_10000(benchmark::State& state, InstructionSet set) {
  if (!available(set)) return state.SkipWithError("instruction set not available");
  const auto ships = perturbed(10'000);
  const ZigzagOrder order{.rudder = radians(10), .heading = radians(10), .first = Side::starboard};
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  const auto simulate = [&](std::size_t count, double to) {
    return zigzag_batch(std::span(ships).first(count), order,
                        {.reversals = 8, .duration = 100.0, .tolerance = to, .batch = {.threads = 1, .set = set}});
  };
  for (auto _ : state) benchmark::DoNotOptimize(simulate(ships.size(), tolerance));
  const auto batch = simulate(100, tolerance), exact = simulate(100, 1e-11);
  double error = 0.0;
  for (std::size_t i = 0; i < exact.time.size(); ++i)
    if (std::isfinite(exact.time[i])) error = std::max(error, std::abs(batch.time[i] - exact.time[i]));
  state.counters["switch_error_s"] = error;
  state.counters["per_ship"] =
      benchmark::Counter(1e4, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  tell_ratio(state, 1e4);
}
BENCHMARK_CAPTURE(kvlcc2_zigzag_batch_10000, baseline, InstructionSet::baseline)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kvlcc2_zigzag_batch_10000, avx2, InstructionSet::avx2)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kvlcc2_zigzag_batch_10000, avx512, InstructionSet::avx512)
    ->DenseRange(6, 8)
    ->Unit(benchmark::kMillisecond);

void kvlcc2_turn_35(benchmark::State& state) {
  const Ship ship = kvlcc2_ship();
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(turning_circle(ship, {.rudder = radians(35)}, {.tolerance = tolerance, .sampled = false}));
  tell_ratio(state);
}
BENCHMARK(kvlcc2_turn_35)->Arg(6)->Arg(9)->Unit(benchmark::kMicrosecond);

/// Open-loop replay of 100 s at 20 Hz.
void kvlcc2_replay_2000_samples(benchmark::State& state) {
  const Ship ship = kvlcc2_ship();
  const auto run = zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.duration = 100.0, .step = 0.05}).run;
  for (auto _ : state) benchmark::DoNotOptimize(replay(ship, run));
  tell_ratio(state);
}
BENCHMARK(kvlcc2_replay_2000_samples)->Unit(benchmark::kMicrosecond);

/// A step of 0.02 s; the rudder is reversed every 20 s.
void simulator_step_50_hz(benchmark::State& state) {
  Simulator simulator(kvlcc2_ship());
  int steps = 0;
  for (auto _ : state) {
    if (steps++ % 1000 == 0) simulator.order_rudder(radians(steps % 2000 == 1 ? 10.0 : -10.0));
    simulator.step(0.02);
    benchmark::DoNotOptimize(simulator.state());
  }
  tell_ratio(state);
}
BENCHMARK(simulator_step_50_hz);

}  // namespace
}  // namespace swayaw::bench
