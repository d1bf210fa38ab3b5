#include <algorithm>
#include <catch.hpp>
#include <filesystem>
#include <vector>

#include "random_ships.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

/// `diagnose` on the free-running KVLCC2 models of HSVA and MARIN (SIMMAN 2008), of which it is known what is missing.
namespace swayaw {
namespace {

/// Every n-th sample: the channels are smoothed, neighbours tell the same thing twice.
Recording thinned(const std::filesystem::path& file, std::size_t every) {
  const auto whole = read_recording(file).recording;
  Recording run;
  run.name = whole.name, run.facts = whole.facts;
  for (std::size_t i = 0; i < whole.samples(); i += every) run.time.push_back(whole.time[i]);
  for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta,
                             Channel::rev, Channel::thrust}) {
    if (!whole.has(channel)) continue;
    const auto values = run.fill(channel);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = whole[channel][i * every];
  }
  return run;
}

std::vector<Recording> runs_of(const std::filesystem::path& folder, std::initializer_list<const char*> names,
                               std::size_t every) {
  std::vector<Recording> runs;
  for (const auto* name : names) runs.push_back(thinned(folder / name, every));
  return runs;
}

const FoundEffect* found(const Diagnosis& d, std::string_view id) {
  const auto effect = std::ranges::find(d.effects, id, [](const FoundEffect& e) { return id_of(e.effect); });
  return effect == d.effects.end() ? nullptr : &*effect;
}

void blames_no_weather(const Diagnosis& d) {
  for (const auto* id : {"steady_wind", "gust", "steady_current", "wave_drift", "shallow_water"}) {
    INFO(id);
    CHECK(found(d, id) == nullptr);
  }
}

double window_error(std::span<const QuantityError> errors, Quantity quantity) {
  return std::ranges::find(errors, quantity, &QuantityError::quantity)->window_rms;
}

TEST_CASE("the published form for the KVLCC2 lacks cubic terms of the hull, which halve the error of a run not used",
          "[mismatch][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto runs = runs_of(*folder, {"hsva_zz10_10_port.csv", "hsva_zz20_10_stbd.csv"}, 5);
  const auto held_out = runs_of(*folder, {"hsva_zz15_05_stbd.csv"}, 5);
  const auto d = diagnose(published_ship("kvlcc2_pi"), runs, {}, held_out);
  CHECK((found(d, "hull_nonlinear_damping") != nullptr || found(d, "cross_flow_drag") != nullptr));
  blames_no_weather(d);
  for (const auto quantity : {Quantity::heading, Quantity::yaw_rate})
    CHECK(window_error(d.holdout.front().after, quantity) < 0.5 * window_error(d.holdout.front().refitted, quantity));
}

TEST_CASE("the zero of MARIN's gyro is found in each of the two runs", "[mismatch][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  // integral of the yaw rate against the heading: recordings.json, r_bias_rad_s
  for (const auto& [name, zero] :
       {std::pair{"marin_zz10_10_port.csv", 5.459e-4}, std::pair{"marin_zz20_20_stbd.csv", 6.078e-4}}) {
    INFO(name);
    const auto d = diagnose(published_ship("kvlcc2_pi_vvr"), runs_of(*folder, {name}, 2), {}, {});
    const auto* gyro = found(d, "gyro_bias");
    REQUIRE(gyro != nullptr);
    CHECK(gyro == &d.effects.front());
    CHECK(std::abs(gyro->parameters.front().value - zero) < 3.0 * gyro->parameters.front().standard_error);
    CHECK(gyro->parameters.front().standard_error < 0.1 * zero);
    blames_no_weather(d);
  }
}

}  // namespace
}  // namespace swayaw
