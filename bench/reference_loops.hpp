#pragma once

#include <benchmark/benchmark.h>

/// Loops whose speed tells what this machine can do; every other time is told as a multiple of theirs.
namespace swayaw::bench {

struct ReferenceTimes {
  double fused_multiply_add;  ///< y += a x for one double in the first cache [s]
  double atan2;               ///< one scalar std::atan2 of random arguments [s]
};

/// Measured once, at the first call; the fastest of several passes.
const ReferenceTimes& reference_times();

/// Adds the time of one iteration, or of one of its `items`, in units of one std::atan2.
void tell_ratio(benchmark::State& state, double items = 1.0);

}  // namespace swayaw::bench
