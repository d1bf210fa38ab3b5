#include <benchmark/benchmark.h>

#include <cstdio>

#include "reference_loops.hpp"

/// The counter x_atan2 tells a time in units of one std::atan2 on the same machine in the same run.
int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  const auto& reference = swayaw::bench::reference_times();
  std::fprintf(stderr, "reference: atan2 %.2f ns, fused multiply-add %.3f ns\n", 1e9 * reference.atan2,
               1e9 * reference.fused_multiply_add);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
