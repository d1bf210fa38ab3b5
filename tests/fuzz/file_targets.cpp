#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "case_tasks.hpp"
#include "swayaw/app/sweep/plan.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/manoeuvres_in.hpp"
#include "swayaw/core/mat_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/ship_text.hpp"
#include "swayaw/identification/captive.hpp"
#include "targets.hpp"

namespace swayaw::fuzz {
namespace {

// ---------------------------------------------------------------- recordings

bool is_finite_or_missing(double value) { return std::isfinite(value) || std::isnan(value); }

void require_sound(const Recording& run) {
  promise(run.samples() > 0, "a recording has no samples");
  promise(std::ranges::all_of(run.time, [](double t) { return std::isfinite(t); }), "a time is not finite");
  promise(std::ranges::is_sorted(run.time, std::less_equal<>{}) || run.samples() == 1, "time does not increase");
  for (const auto& channel : run.channels) {
    promise(channel.empty() || channel.size() == run.samples(), "a channel has another length than time");
    promise(std::ranges::all_of(channel, is_finite_or_missing), "a sample is infinite");
  }
}

void require_within(const ManoeuvrePiece& piece, const Recording& run) {
  promise(piece.begin <= piece.end, "a manoeuvre ends before it begins");
  promise(piece.begin >= run.time.front() && piece.end <= run.time.back(), "a manoeuvre lies outside of its log");
}

/// Noise, joined samples and manoeuvres of a recording.
void use(const Recording& run) {
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    if (!run.has(channel)) continue;
    promise(!std::isnan(white_noise_of(run[channel])), "the noise of a channel is not a number");
    promise(!std::isnan(Interpolant(run, channel)(run.time.front() + 0.5)), "a joined sample is not a number");
  }
  for (const auto& piece : manoeuvres_in(run)) require_within(piece, run);
}

void recording(std::string_view bytes, const std::filesystem::path&) {
  const auto read = parse_recording(bytes, "run.csv");
  require_sound(read.recording);
  const auto written = recording_text(read.recording);
  promise(recording_text(parse_recording(written, "run.csv").recording) == written,
          "what was read does not survive writing");
  use(read.recording);
}

/// Long logs: what the bytes say of rudder and heading, second by second.
void manoeuvres(std::string_view bytes, const std::filesystem::path&) {
  if (bytes.size() < 8) return;
  Recording log;
  log.name = "log.bin";
  std::vector<double> heading, rudder;
  double time = 0.0, psi = 0.0;
  for (std::size_t i = 0; i + 4 <= bytes.size() && log.time.size() < 4096; i += 4) {
    const auto byte = [&](std::size_t k) { return static_cast<double>(static_cast<signed char>(bytes[i + k])); };
    // seconds, minutes or a thousandth of a second between samples
    time += bytes[i] == 0 ? 1e-3 : bytes[i] == 127 ? 600.0 : 0.1 * std::abs(byte(0)) + 0.1;
    psi += 1e-3 * byte(1) * (bytes[i + 3] == 1 ? 1e6 : 1.0);
    log.time.push_back(time);
    heading.push_back(bytes[i + 3] == 2 ? missing : psi);
    rudder.push_back(bytes[i + 3] == 3 ? missing : 0.01 * byte(2));
  }
  log.channels[index_of(Channel::psi)] = heading;
  log.channels[index_of(Channel::delta)] = rudder;
  if (!log.has(Channel::psi) || !log.has(Channel::delta)) return;
  for (const auto& piece : manoeuvres_in(log)) {
    require_within(piece, log);
    require_sound(piece_of(log, piece));
  }
}

// ---------------------------------------------------------------- import

/// What is imported is a recording that reads.
void require_recording(const Import& import) { require_sound(parse_recording(import.text, "run.csv").recording); }

void table(std::string_view bytes, const std::filesystem::path& file) {
  write(file, bytes);
  require_recording(import_table({file}, {}));
}

constexpr std::string_view plain_table =
    "Clock;Kurs;Ruder;Fahrt [kn];Wind\n10:00:00;350;5;12,5;3\n10:00:01;351;-5;12,25;3\n10:00:02;352;5;-999;4\n";

void column_map(std::string_view bytes, const std::filesystem::path& file) {
  write(file, bytes);
  require_recording(import_table_text(plain_table, file.parent_path() / "map.toml.csv", {file}));
}

void nmea(std::string_view bytes, const std::filesystem::path& file) {
  write(file, bytes);
  require_recording(import_nmea({file}, {}));
}

/// Ends in a result or a refusal.
template <class Read>
void try_each(Read&& read) {
  try {
    read();
  } catch (const FileError&) {}
}

/// A MATLAB file may be a recording, a ship, or to be imported.
void mat(std::string_view bytes, const std::filesystem::path& file) {
  write(file, bytes);
  const auto variables = read_mat(file);
  promise(std::ranges::none_of(variables, [](const auto& v) { return v.name.empty(); }), "a variable has no name");
  try_each([&] { require_sound(read_recording(file).recording); });
  try_each([&] { static_cast<void>(model_of(read_ship_text(file), file)); });
  require_recording(import_mat(file, {}));
}

// ---------------------------------------------------------------- descriptions

void plan(std::string_view bytes, const std::filesystem::path& file) {
  const auto plan = app::parse_sweep_plan(std::string(bytes), file);
  for (const auto& v : plan.variations) promise(!v.from || std::isfinite(*v.from), "a number of a plan is not finite");
}

/// Answers of the program to a sweep over recordings.
void json(std::string_view bytes, const std::filesystem::path&) {
  for (const auto task : {app::SweepTask::trial, app::SweepTask::diagnose, app::SweepTask::identify}) {
    const app::SweepPlan plan{.file = "plan.toml", .text = "", .task = task, .ships = {}, .find = {"N_v", "N_r"}};
    const auto block = app::block_of_document(plan, 0, bytes);
    promise(block.values.size() == app::results_of_case(plan).size(), "an answer has another number of results");
    promise(block.notes.empty() != block.documents.empty(), "an answer is neither a document nor a note");
    promise(std::ranges::none_of(block.values, [](double value) { return std::isinf(value); }), "a result is infinite");
  }
}

void captive(std::string_view bytes, const std::filesystem::path& file) {
  write(file, bytes);
  for (const auto& point : identification::read_captive(file, {.L = 7.0, .test = "static_drift"}))
    for (const auto& moment : point.moments)
      promise(std::isfinite(moment.motion.u + moment.motion.v + moment.motion.r), "a motion in the tank is not finite");
}

/// As for the trial reading (core/src/mat/trial_reading.hpp): MATLAB compresses what it saves.
constexpr Memory compressed{.at_rest = 68'000'000, .per_byte = 40};

constexpr std::array targets{
    Target{"recording", "run.csv", true, 1.5, "recordings: CSV and run keys", recording},
    Target{"table", "log.csv", true, 1.0, "import of text tables, all encodings", table},
    Target{"nmea", "log.nmea", true, 1.0, "import of NMEA 0183 logs", nmea},
    Target{"mat", "run.mat", false, 0.1, "MATLAB files: recording, ship, import", mat, compressed},
    Target{"column_map", "map.toml", true, 1.0, "column maps of imports", column_map},
    Target{"plan", "plan.toml", true, 1.5, "plans of sweeps", plan},
    Target{"captive", "captive.csv", true, 1.0, "tables of captive tests", captive},
    Target{"json", "answer.json", true, 1.0, "JSON of the program, as sweeps over recordings read it", json},
    Target{"manoeuvres", "log.bin", false, 0.5, "manoeuvres in long logs", manoeuvres},
};

}  // namespace

std::span<const Target> file_targets() { return targets; }

}  // namespace swayaw::fuzz
