#include "reference_loops.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

namespace swayaw::bench {
namespace {

std::vector<double> random_numbers(std::size_t count, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> parameters(count);
  for (double& x : parameters) x = uniform(engine);
  return parameters;
}

/// One pass of y += a x over 1,000 doubles in the first cache.
void fused_multiply_add_pass(const std::vector<double>& x, std::vector<double>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += 1e-9 * x[i];
  benchmark::DoNotOptimize(y.data());
  benchmark::ClobberMemory();
}

double atan2_pass(const std::vector<double>& y, const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += std::atan2(y[i], x[i]);
  return sum;
}

/// Seconds for one of the 1,000 items of a pass.
template <class Pass>
double fastest(Pass&& pass) {
  constexpr int passes = 500, tries = 20;
  double best = 1e9;
  for (int t = 0; t < tries; ++t) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < passes; ++i) pass();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    best = std::min(best, elapsed.count() / (passes * 1000.0));
  }
  return best;
}

ReferenceTimes measure() {
  const auto x = random_numbers(1000, 1);
  auto y = random_numbers(1000, 2);
  const auto angles = y;
  return {.fused_multiply_add = fastest([&] { fused_multiply_add_pass(x, y); }),
          .atan2 = fastest([&] { benchmark::DoNotOptimize(atan2_pass(angles, x)); })};
}

/// 10,000 passes of y += a x over 1,000 doubles.
void reference_fused_multiply_add(benchmark::State& state) {
  const auto x = random_numbers(1000, 1);
  auto y = random_numbers(1000, 2);
  for (auto _ : state)
    for (int pass = 0; pass < 10'000; ++pass) fused_multiply_add_pass(x, y);
}
BENCHMARK(reference_fused_multiply_add)->Unit(benchmark::kMillisecond);

/// a = b + s c over 64 MB.
void reference_triad(benchmark::State& state) {
  const auto b = random_numbers(8'000'000 / 3, 1), c = random_numbers(8'000'000 / 3, 2);
  std::vector<double> a(b.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * sizeof(double) * a.size()));
}
BENCHMARK(reference_triad)->Unit(benchmark::kMillisecond);

/// 10^6 arc tangents of random arguments.
void reference_atan2(benchmark::State& state) {
  const auto y = random_numbers(1000, 2), x = random_numbers(1000, 1);
  for (auto _ : state)
    for (int pass = 0; pass < 1000; ++pass) benchmark::DoNotOptimize(atan2_pass(y, x));
}
BENCHMARK(reference_atan2)->Unit(benchmark::kMillisecond);

}  // namespace

const ReferenceTimes& reference_times() {
  static const ReferenceTimes times = measure();
  return times;
}

void tell_ratio(benchmark::State& state, double items) {
  using benchmark::Counter;
  state.counters["x_atan2"] =
      Counter(items * reference_times().atan2, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

}  // namespace swayaw::bench
