#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

/// Loops whose speed tells what the machine can do; every result is read beside them.
namespace {

std::vector<double> random_numbers(std::size_t count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> numbers(count);
  for (double& x : numbers) x = uniform(engine);
  return numbers;
}

/// 10,000 passes of y += a x over 1,000 doubles in the first cache.
void reference_fused_multiply_add(benchmark::State& state) {
  const auto x = random_numbers(1000);
  auto y = random_numbers(1000);
  for (auto _ : state) {
    for (int pass = 0; pass < 10'000; ++pass) {
      for (std::size_t i = 0; i < x.size(); ++i) y[i] += 1e-9 * x[i];
      benchmark::ClobberMemory();
    }
    benchmark::DoNotOptimize(y.data());
  }
}
BENCHMARK(reference_fused_multiply_add)->Unit(benchmark::kMillisecond);

/// a = b + s c over 64 MB.
void reference_triad(benchmark::State& state) {
  const auto b = random_numbers(8'000'000 / 3), c = random_numbers(8'000'000 / 3);
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
  const auto y = random_numbers(1000), x = random_numbers(1000);
  for (auto _ : state) {
    double sum = 0.0;
    for (int pass = 0; pass < 1000; ++pass)
      for (std::size_t i = 0; i < x.size(); ++i) sum += std::atan2(y[i], x[i]);
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(reference_atan2)->Unit(benchmark::kMillisecond);

}  // namespace
