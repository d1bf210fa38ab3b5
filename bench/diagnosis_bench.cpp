#include "diagnosis_bench.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference_loops.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"

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

// ---------------------------------------------------------------- a line of the table

/// A question to `diagnose`, made ready before the clock runs.
struct Case {
  Ship ship;
  std::vector<Recording> train, reference, holdout;
};

std::size_t samples_of(const Case& c) {
  std::size_t sum = 0;
  for (const auto* runs : {&c.train, &c.reference, &c.holdout})
    for (const auto& run : *runs) sum += run.samples();
  return sum;
}

/// The peak of the memory in use counts from now on, where the system can do that.
void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

/// [MB]; 0 where the system does not tell.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      double kilobytes = 0.0;
      status >> kilobytes;
      return 1e-3 * kilobytes;
    }
  return 0.0;
}

/// Of all threads [s].
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Processor time of the last diagnosis, over which the next tells its own [s].
double& last_diagnosis() {
  static double seconds = 0.0;
  return seconds;
}

/// Calibration, baseline and all candidates on all cores; the counters tell the processor time from each stage to the
/// next, that of all over the line before, and the peak of the memory.
void diagnose_case(benchmark::State& state, const Case& c) {
  DiagnosisOptions options;
  std::string stage;
  double since = processor_time();
  const double begin = since;
  options.progress = [&](std::string_view next) {
    const double now = processor_time();
    if (!stage.empty()) state.counters[stage] += now - since;
    stage = std::string(next), since = now;
    return true;
  };
  forget_peak_memory();
  Diagnosis d{};
  for (auto _ : state) d = diagnose(c.ship, c.train, c.reference, c.holdout, options);
  options.progress("");
  const double before = std::exchange(last_diagnosis(), since - begin);
  if (before > 0.0) state.counters["over_line_before"] = last_diagnosis() / before;
  state.counters["samples"] = static_cast<double>(samples_of(c));
  state.counters["found"] = static_cast<double>(d.effects.size());
  state.counters["peak_MB"] = peak_memory();
  tell_ratio(state);
}

/// As every diagnosis is timed: once, on all cores.
void once(benchmark::internal::Benchmark* line) {
  line->Iterations(1)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kSecond);
}

void diagnosis_3_runs_1000_samples(benchmark::State& state) {
  const Ship ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2_l7.toml");
  diagnose_case(state, {ship, three_runs(with_effect(ship, RudderOffset<double>{radians(1.5)})), {}, {}});
}
BENCHMARK(diagnosis_3_runs_1000_samples)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kSecond);

// ---------------------------------------------------------------- a voyage

/// A tanker of 320 m that changes her course by 10 deg every ten minutes, recorded once a second for three hours.
Recording voyage(const Ship& ship) {
  constexpr double duration = 3.0 * 3600.0, leg = 600.0, change = radians(10.0);
  const double T = time_unit_of(ship);
  Simulator simulator(ship);
  Recording run{.name = "voyage.csv", .facts = {}, .time = {}, .channels = {}, .extra = {}};
  for (double t = 0.0; t <= duration; t += 1.0) run.time.push_back(t);
  const std::array shown{Channel::x, Channel::y, Channel::psi, Channel::u, Channel::r, Channel::delta, Channel::rev};
  for (const auto channel : shown) run.fill(channel);
  for (std::size_t k = 0; k < run.samples(); ++k) {
    const auto values = simulator.instruments();
    for (const auto channel : shown) run.channels[index_of(channel)][k] = values[index_of(channel)];
    // an autopilot: rudder to port turns the heading down
    const double course = static_cast<int>(run.time[k] / leg) % 2 == 0 ? 0.0 : change;
    simulator.order_rudder(
        std::clamp(values[index_of(Channel::psi)] - course + 2.0 * T * values[index_of(Channel::r)], -0.17, 0.17));
    simulator.step(1.0);
  }
  return run;
}

void diagnosis_voyage_3_hours_1_hz(benchmark::State& state) {
  const Ship ship = read_ship(SWAYAW_BENCH_SHIPS "/kvlcc2.toml");
  const Ship real = with_effect(ship, SteadyCurrent<double>{0.5, 1.0});
  diagnose_case(state, {ship, {noisy(voyage(real), ship, 1)}, {}, {}});
}

// ---------------------------------------------------------------- cases in folders

std::vector<Recording> recordings_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Recording> runs;
  for (const auto& file : files) runs.push_back(read_recording(file).recording);
  return runs;
}

}  // namespace

void register_diagnoses(const std::filesystem::path& folder) {
  for (const auto& entry : std::set<std::filesystem::path>(std::filesystem::directory_iterator(folder), {})) {
    const auto name = "diagnosis_" + entry.filename().string();
    once(benchmark::RegisterBenchmark(name.c_str(), [entry](benchmark::State& state) {
      diagnose_case(state, {read_ship(entry / "ship.toml"), recordings_in(entry / "train"),
                            recordings_in(entry / "reference"), recordings_in(entry / "holdout")});
    }));
  }
  once(benchmark::RegisterBenchmark("diagnosis_voyage_3_hours_1_hz", diagnosis_voyage_3_hours_1_hz));
}

}  // namespace swayaw::bench
