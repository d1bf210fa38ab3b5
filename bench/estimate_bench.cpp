#include <benchmark/benchmark.h>

#include <random>

#include "reference_loops.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::bench {
namespace {

constexpr std::size_t sample_count = 20'000;

/// 20,000 samples at 20 Hz of a 20/20 zigzag, seen as position and heading with noise.
Recording noisy_zigzag(const Ship& ship) {
  constexpr double step = 0.05;
  auto run = zigzag(ship, {.rudder = radians(20), .heading = radians(20)},
                    {.duration = step * (sample_count + 1), .step = step})
                 .run;
  run.time.resize(sample_count);
  for (auto& column : run.channels)
    if (!column.empty()) column.resize(sample_count);
  for (const Channel c : {Channel::u, Channel::v, Channel::r}) run.channels[index_of(c)].clear();
  std::mt19937_64 engine(1);
  for (const auto& [channel, deviation] :
       {std::pair{Channel::x, 0.02}, {Channel::y, 0.02}, {Channel::psi, radians(0.1)}}) {
    std::normal_distribution<double> noise(0.0, deviation);
    for (double& value : run.fill(channel)) value += noise(engine);
  }
  return run;
}

EstimationOptions known_noise() {
  EstimationOptions options{.channels = {Channel::x, Channel::y, Channel::psi},
                            .process_noise = ProcessNoise{{1e-3, 1e-3, 1e-4}}};
  for (const Channel c : {Channel::x, Channel::y}) options.noise[index_of(c)] = 0.02;
  options.noise[index_of(Channel::psi)] = radians(0.1);
  return options;
}

/// Filter, or filter and smoother, over 20,000 samples with noise known; 6 states, or 9 with the unmodelled
/// accelerations.
void states_20000(benchmark::State& state, const char* ship_name, bool coloured, bool smooth) {
  const Ship ship = read_ship(std::string(SWAYAW_BENCH_SHIPS "/") + ship_name);
  const auto run = noisy_zigzag(ship);
  auto options = known_noise();
  options.coloured = coloured;
  options.smooth = smooth;
  for (auto _ : state) benchmark::DoNotOptimize(estimate_states(ship, run, options));
  state.counters["per_sample"] =
      benchmark::Counter(sample_count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  tell_ratio(state);
}
BENCHMARK_CAPTURE(states_20000, kvlcc2_6_filtered, "kvlcc2_l7.toml", false, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(states_20000, kvlcc2_6_smoothed, "kvlcc2_l7.toml", false, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(states_20000, kvlcc2_9_filtered, "kvlcc2_l7.toml", true, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(states_20000, kvlcc2_9_smoothed, "kvlcc2_l7.toml", true, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(states_20000, wpcc_6_smoothed, "wpcc_pi.toml", false, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(states_20000, wpcc_9_smoothed, "wpcc_pi.toml", true, true)->Unit(benchmark::kMillisecond);

/// Noise and process noise of 1,000 samples found from the run.
void noise_of_1000_samples(benchmark::State& state) {
  const Ship ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml");
  auto run = noisy_zigzag(ship);
  run.time.resize(1000);
  for (auto& column : run.channels)
    if (!column.empty()) column.resize(1000);
  for (auto _ : state)
    benchmark::DoNotOptimize(estimate_noise(ship, {&run, 1}, {.channels = {Channel::x, Channel::y, Channel::psi}}));
  tell_ratio(state);
}
BENCHMARK(noise_of_1000_samples)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace swayaw::bench
