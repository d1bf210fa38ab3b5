#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <tuple>

#include "found_effects.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// `diagnose` on labelled cases of ships of another form than their file's, with instruments as on board, made by
/// another simulator.
namespace swayaw {
namespace {

namespace fs = std::filesystem;

std::vector<Recording> runs_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Recording> runs;
  for (const auto& file : files) runs.push_back(read_recording(file).recording);
  return runs;
}

/// The folder of a labelled case; nothing, with a word, where there are none.
std::optional<fs::path> case_folder(const char* name) {
  const auto folder = fs::path(SWAYAW_TEST_SHARED) / "concealed" / "on_board" / name;
  if (fs::exists(folder)) return folder;
  std::cout << "[skipped] no concealed cases in " << folder.parent_path().string() << "\n";
  return std::nullopt;
}

/// Each is worked out once, whatever tests ask for it.
/// @param without_effect  whether the runs held out are those that the effect is not in
std::optional<Diagnosis> diagnosis_of(const char* name, bool without_effect = false,
                                      std::size_t most_effects = DiagnosisOptions{}.most_effects) {
  static std::map<std::tuple<std::string, bool, std::size_t>, Diagnosis> told;
  const auto folder = case_folder(name);
  if (!folder) return std::nullopt;
  const std::tuple asked{std::string(name), without_effect, most_effects};
  if (const auto known = told.find(asked); known != told.end()) return known->second;
  const DiagnosisOptions options{.most_effects = most_effects};
  const auto ship = read_ship(*folder / "ship.toml");
  const auto train = runs_in(*folder / "train"), reference = runs_in(*folder / "reference");
  return told[asked] = without_effect ? diagnose(ship, train, {}, reference, options)
                                      : diagnose(ship, train, reference, runs_in(*folder / "holdout"), options);
}

/// A run of the same ship through the same water that runs over the ground [m/s].
Recording in_stream(Recording run, double speed, double to) {
  const double north = speed * std::cos(to), east = speed * std::sin(to);
  const auto put = [&](Channel channel, auto&& added) {
    auto& values = run.channels[index_of(channel)];
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += added(i);
  };
  const auto psi = run[Channel::psi];
  put(Channel::x, [&](std::size_t i) { return north * run.time[i]; });
  put(Channel::y, [&](std::size_t i) { return east * run.time[i]; });
  put(Channel::u_ground, [&](std::size_t i) { return north * std::cos(psi[i]) + east * std::sin(psi[i]); });
  put(Channel::v_ground, [&](std::size_t i) { return east * std::cos(psi[i]) - north * std::sin(psi[i]); });
  return run;
}

using test::found;

double value_of(const FoundEffect& effect, std::string_view key) {
  return std::ranges::find(effect.parameters, key, &ParameterEstimate::key)->value;
}

}  // namespace

TEST_CASE("of a ship of another form, with the instruments that ships have, nothing is said to be missing",
          "[mismatch][published]") {
  for (const auto* name : {"001", "016"}) {
    const auto d = diagnosis_of(name);
    if (!d) return;
    INFO(name << " " << d->words);
    CHECK(d->verdict == DiagnosisVerdict::nothing_missing);
    CHECK(d->effects.empty());
  }
}

TEST_CASE("what no effect explains, and much process noise covers, is not called nothing", "[mismatch][published]") {
  if (const auto d = diagnosis_of("002", false, 0)) {  // a tug that pushes for a while
    INFO(d->words);
    CHECK(d->verdict == DiagnosisVerdict::unexplained);
    CHECK(d->process_noise > 5.0);
  }
}

TEST_CASE("what has no name is said to be unknown, with the time for which it acts", "[mismatch][published]") {
  if (const auto d = diagnosis_of("002")) {  // a tug that pushes from 290 to 565 s
    INFO(d->words);
    CHECK(d->verdict == DiagnosisVerdict::unexplained);
    const auto* unknown = found(*d, "unknown");
    REQUIRE(unknown != nullptr);
    constexpr double onset = 290.3, end = 565.4, tolerance = 0.05 * (end - onset);  // s
    CHECK(std::abs(unknown->onset.value() - onset) < tolerance);
    CHECK(std::abs(value_of(*unknown, "end_s") - end) < tolerance);
    for (const auto& c : d->candidates)
      if (c.trace) CHECK(c.probability == 0.0);
  }
}

TEST_CASE("waves that move a ship are not taken for a force without a name, and the words say so",
          "[mismatch][published]") {
  if (const auto d = diagnosis_of("049")) {  // the bank of a canal, less than the waves of 10 s
    INFO(d->words);
    CHECK(d->runs_in_waves == 1.0);
    CHECK(d->effects.empty());
    CHECK_THAT(d->words, ContainsSubstring("Waves move the ship"));
    CHECK(d->discrepancy->after < 0.05);  // 0.46 with what the waves do
  }
  if (const auto d = diagnosis_of("013")) {  // a steering gear that is late by 3.7 s
    INFO(d->words);
    CHECK(d->runs_in_waves > 0.5);
    const auto* gear = found(*d, "steering_gear_lag");
    REQUIRE(gear != nullptr);
    CHECK(std::abs(value_of(*gear, "lag_s") - 3.75) < 3.0);
  }
}

TEST_CASE("beside another form and real instruments the strong errors are found, as large as they are",
          "[mismatch][published]") {
  if (const auto d = diagnosis_of("010")) {  // a current of 1.46 m/s to 115.6 deg, a gyro off by −0.00325 rad/s
    const auto *current = found(*d, "steady_current"), *gyro = found(*d, "gyro_bias");
    REQUIRE(gyro != nullptr);
    REQUIRE(current != nullptr);
    CHECK(std::abs(value_of(*gyro, "bias_rad_s") + 0.00325) < 0.0005);
    CHECK(std::abs(value_of(*current, "current_speed_m_s") - 1.456) < 0.15);
    CHECK(std::abs(value_of(*current, "current_to_rad") - 2.018) < 0.1);
  }
}

TEST_CASE("a stream beyond an ordinary one is named, as large as it is", "[mismatch][second-route]") {
  const auto folder = case_folder("001");
  if (!folder) return;
  const auto ship = read_ship(*folder / "ship.toml");
  const double speed = 0.04 * service_speed(ship), to = radians(200);
  const auto runs_of = [&](const char* name) {
    auto runs = runs_in(*folder / name);
    for (auto& run : runs) run = in_stream(std::move(run), speed, to);
    return runs;
  };
  const auto d = diagnose(ship, runs_of("train"), runs_in(*folder / "reference"), runs_of("holdout"));
  INFO(d.words);
  const auto* current = found(d, "steady_current");
  REQUIRE(current != nullptr);
  CHECK(std::abs(value_of(*current, "current_speed_m_s") / speed - 1.0) < 0.3);  // her own stream is 0.015 U at most
  CHECK(std::abs(wrapped(value_of(*current, "current_to_rad") - to)) < 0.4);
}

TEST_CASE("an effect that runs not used do not show is refuted by them", "[mismatch][limit]") {
  if (const auto d = diagnosis_of("013")) {  // steering gear that lags
    INFO(d->words);
    CHECK(found(*d, "steering_gear_lag") != nullptr);
  }
  if (const auto d = diagnosis_of("013", true)) {
    INFO(d->words);
    CHECK(found(*d, "steering_gear_lag") == nullptr);
    const auto lag = std::ranges::find(d->candidates, "steering_gear_lag", &Candidate::effect);
    if (lag != d->candidates.end()) CHECK(lag->refuted);
  }
}

}  // namespace swayaw
