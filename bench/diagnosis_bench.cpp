#include <benchmark/benchmark.h>

#include <chrono>
#include <random>
#include <string>

#include "reference_loops.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::bench {
namespace {

Recording noisy(Recording run, const Ship& ship, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const double L = length(ship), U = service_speed(ship);
  const auto shake = [&](Channel channel, double size) {
    for (double& x : run.fill(channel)) x += size * normal(engine);
  };
  shake(Channel::x, 1e-3 * L), shake(Channel::y, 1e-3 * L);
  shake(Channel::psi, radians(0.1)), shake(Channel::r, 0.01 * U / L), shake(Channel::u, 0.01 * U);
  run.channels[index_of(Channel::v)].clear();
  return run;
}

/// Two zigzags and a turn of 1,000 samples each, with a rudder that is 1.5 deg off.
std::vector<Recording> three_runs(const Ship& ship) {
  const ManoeuvreOptions options{.duration = 119.88, .step = 0.12};
  return {noisy(zigzag(ship, {radians(10.0), radians(10.0)}, options).run, ship, 1),
          noisy(zigzag(ship, {radians(20.0), radians(20.0)}, options).run, ship, 2),
          noisy(turning_circle(ship, {radians(35.0), Side::starboard}, options).run, ship, 3)};
}

/// Calibration, baseline and all candidates on all cores; the counters tell the seconds from each stage to the next.
void diagnosis_3_runs_1000_samples(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  const Ship ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml");
  const auto runs = three_runs(with_effect(ship, RudderOffset<double>{radians(1.5)}));
  DiagnosisOptions options;
  std::string stage;
  auto since = Clock::now();
  options.progress = [&](std::string_view next) {
    const auto now = Clock::now();
    if (!stage.empty()) state.counters[stage] += std::chrono::duration<double>(now - since).count();
    stage = std::string(next), since = now;
    return true;
  };
  Diagnosis d{};
  for (auto _ : state) d = diagnose(ship, runs, {}, {}, options);
  options.progress("");
  state.counters["samples"] = static_cast<double>(runs.front().samples());
  state.counters["found"] = static_cast<double>(d.effects.size());
  tell_ratio(state);
}
BENCHMARK(diagnosis_3_runs_1000_samples)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);

}  // namespace
}  // namespace swayaw::bench
