#include <benchmark/benchmark.h>

#include <random>

#include "reference_loops.hpp"
#include "swayaw/identification/regression.hpp"

namespace swayaw::bench {
namespace {

/// 20,000 samples of 30 features, normal.
Design large_design() {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(engine); };
  Design design{.names = std::vector<std::string>(30, "b"),
                .X = Eigen::MatrixXd::NullaryExpr(20'000, 30, draw),
                .y = Eigen::VectorXd::NullaryExpr(20'000, draw)};
  return design;
}

/// Least squares with its whole report.
void regression_20000_by_30(benchmark::State& state) {
  const auto design = large_design();
  for (auto _ : state) benchmark::DoNotOptimize(regress(design));
  tell_ratio(state);
}
BENCHMARK(regression_20000_by_30)->Unit(benchmark::kMicrosecond);

/// The same with residuals of a first-order autoregression.
void regression_20000_by_30_autoregressive(benchmark::State& state) {
  const auto design = large_design();
  for (auto _ : state) benchmark::DoNotOptimize(regress(design, {.residuals = Residuals::autoregressive}));
  tell_ratio(state);
}
BENCHMARK(regression_20000_by_30_autoregressive)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swayaw::bench
