#include "score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <mutex>
#include <set>

#include "rivals.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::concealed {
namespace {

namespace fs = std::filesystem;

std::vector<Recording> read_runs(const fs::path& folder) {
  std::set<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.insert(entry.path());
  std::vector<Recording> runs;
  for (const auto& file : files) runs.push_back(read_recording(file).recording);
  return runs;
}

Json number(std::optional<double> value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

Json effect_of(const FoundEffect& e) {
  Json parameters = Json::object();
  for (const auto& p : e.parameters) parameters[p.key] = {number(p.value), number(p.standard_error)};
  Json json{{"effect", id_of(e.effect)},           {"probability", number(e.probability)},
            {"onset_s", number(e.onset)},          {"end_s", number(e.end)},
            {"parameters", std::move(parameters)}, {"indistinguishable_from", e.indistinguishable_from}};
  if (const auto* channel = channel_of(e.effect)) json["channel"] = short_name(*channel);
  return json;
}

/// Mean of error with the effects over error of the refitted baseline, heading and yaw rate of the runs held out as
/// they truly went; infinite where the ship that was found cannot sail one of them.
std::optional<double> holdout_ratio(const Diagnosis& d, const std::vector<Recording>& true_runs) try {
  double sum = 0.0;
  int count = 0;
  for (const auto& run : true_runs) {
    const auto refitted = compare(d.refitted, run).errors, after = compare(d.improved, run).errors;
    for (const auto quantity : {Quantity::heading, Quantity::yaw_rate}) {
      const auto of = [&](const std::vector<QuantityError>& errors) {
        return std::ranges::find(errors, quantity, &QuantityError::quantity)->window_rms;
      };
      if (!(of(refitted) > 0.0)) continue;
      sum += of(after) / of(refitted);
      ++count;
    }
  }
  return count ? std::optional(sum / count) : std::nullopt;
} catch (const Refusal&) {
  return HUGE_VAL;
}

/// Errors of each quantity in each run held out: given model, refitted, with the effects; and the noise that is in all
/// three.
Json holdout_errors(const Diagnosis& d) {
  Json runs = Json::array();
  for (const auto& run : d.holdout) {
    Json quantities = Json::object();
    for (std::size_t i = 0; i < run.before.size() && i < run.refitted.size() && i < run.after.size(); ++i)
      quantities[std::string(name_of(run.before[i].quantity))] = {
          number(run.before[i].window_rms), number(run.refitted[i].window_rms), number(run.after[i].window_rms),
          number(run.before[i].noise)};
    runs.push_back({{"run", run.run}, {"errors", std::move(quantities)}});
  }
  return runs;
}

Json diagnosis_of(const Riddle& riddle) {
  const auto d = diagnose(riddle.ship, riddle.train, riddle.reference, riddle.holdout);
  Json effects = Json::array(), candidates = Json::array();
  for (const auto& e : d.effects) effects.push_back(effect_of(e));
  for (const auto& c : d.candidates)
    candidates.push_back(
        {{"effect", c.effect}, {"probability", number(c.probability)}, {"gain", number(c.log_evidence_gain)}});
  const auto ratio = holdout_ratio(d, riddle.true_holdout);
  return {{"verdict", name_of(d.verdict)},  {"imperfection", number(d.process_noise)},
          {"effects", std::move(effects)},  {"candidates", std::move(candidates)},
          {"holdout_ratio", number(ratio)}, {"runs_away", ratio && std::isinf(*ratio)},
          {"holdout", holdout_errors(d)}};
}

/// Time that this thread has worked, whatever others and the machine do: a case is diagnosed on one thread.
double work_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The answers to one case beside its truth. What cannot be diagnosed is a wrong answer.
Json answered(const fs::path& folder, bool rivals_only) {
  Json line = Json::parse(read_text(folder / "truth.json"));
  line["case"] = folder.filename().string();
  const auto riddle = read_riddle(folder);
  line["time_unit_s"] = time_unit_of(riddle.ship);
  for (const auto& [rival, effects] : rivals_on(riddle, line.value("seed", std::uint64_t{0})))
    line["rivals"][rival] = effects;
  if (rivals_only) return line;
  const double begun = work_seconds();
  try {
    line["answer"] = diagnosis_of(riddle);
  } catch (const std::exception& trouble) {
    line["answer"] = {{"verdict", "failed"},
                      {"words", trouble.what()},
                      {"effects", Json::array()},
                      {"candidates", Json::array()},
                      {"holdout_ratio", nullptr}};
  }
  line["seconds"] = work_seconds() - begun;
  return line;
}

}  // namespace

Riddle read_riddle(const fs::path& folder) {
  return {read_ship(folder / "ship.toml"), read_runs(folder / "train"), read_runs(folder / "holdout"),
          read_runs(folder / "reference"), read_runs(folder / "truth")};
}

std::vector<Json> read_lines(const fs::path& file) {
  std::vector<Json> lines;
  std::ifstream in(file);
  for (std::string text; std::getline(in, text);)
    if (auto line = Json::parse(text, nullptr, false); !line.is_discarded()) lines.push_back(std::move(line));
  return lines;
}

void score(const fs::path& cases, const ScoreOptions& options, const std::function<void(const Json&)>& told) {
  std::set<std::string> done;
  std::string kept;
  for (const auto& line : read_lines(options.lines)) done.insert(line.at("case")), kept += line.dump() + "\n";
  if (fs::exists(options.lines)) write_text(options.lines, kept);  // without a line that was cut off
  std::set<fs::path> waiting;
  for (const auto& entry : fs::directory_iterator(cases))
    if (fs::exists(entry.path() / "truth.json") && !done.contains(entry.path().filename().string()))
      waiting.insert(entry.path());
  const std::vector<fs::path> order(waiting.begin(), waiting.end());
  std::ofstream out(options.lines, std::ios::app);
  if (!out) throw FileError({options.lines}, "cannot be written");
  std::mutex guard;
  in_parallel(order.size(), options.jobs, [&](std::size_t i) {
    const auto line = answered(order[i], options.rivals_only);
    const std::scoped_lock lock(guard);
    out << line.dump() << std::endl;
    told(line);
  });
}

}  // namespace swayaw::concealed
