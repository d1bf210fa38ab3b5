#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "diagnosis_bench.hpp"
#include "reference_loops.hpp"

/// The counter x_atan2 tells a time in units of one std::atan2 on the same machine in the same run.
/// --diagnoses=FOLDER adds lines that take minutes.
int main(int count, char** arguments) try {
  constexpr std::string_view diagnoses = "--diagnoses=";
  benchmark::Initialize(&count, arguments);
  if (count > 1 && std::string_view(arguments[count - 1]).starts_with(diagnoses))
    swayaw::bench::register_diagnoses(std::string_view(arguments[--count]).substr(diagnoses.size()));
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  const auto& reference = swayaw::bench::reference_times();
  std::fprintf(stderr, "reference: atan2 %.2f ns, fused multiply-add %.3f ns\n", 1e9 * reference.atan2,
               1e9 * reference.fused_multiply_add);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
} catch (const std::exception& trouble) {
  std::fprintf(stderr, "%s\n", trouble.what());
  return 1;
}
