#include "checked_runs.hpp"

#include <algorithm>
#include <string>

#include "input.hpp"
#include "recorded_inputs.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/identification/data_compatibility.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

/// An order that is called an angle is told, and worked with: the steering gear is within the ship then.
bool forbids_work(const InstrumentError& e) { return is_mistake(e.kind) && e.kind != InstrumentErrorKind::order; }

void refuse_mistakes(const RunCheck& check) {
  const auto wrong = std::ranges::find_if(check.errors, forbids_work);
  if (wrong == check.errors.end()) return;
  throw Refusal(fmt::format("{}: {}; {} (swayaw check tells more; --no-check believes the file)", check.run,
                            words_for(*wrong), remedy_for(*wrong)));
}

/// "samples far from their neighbours left out: x 2, y 2"; empty where there are none.
std::string outlier_words(const RunCheck& check) {
  std::vector<std::string> counts;
  for (const auto& c : check.channels)
    if (!c.outliers.empty() && std::ranges::count(motion_channels(), c.channel) > 0)
      counts.push_back(fmt::format("{} {}", short_name(c.channel), c.outliers.size()));
  if (counts.empty()) return {};
  return fmt::format("samples far from their neighbours left out: {}", fmt::join(counts, ", "));
}

void tell(const RunCheck& check) {
  std::vector<std::string> told;
  for (const auto& e : check.errors)
    if (e.told) told.push_back(words_for(e));
  if (auto words = outlier_words(check); !words.empty()) told.push_back(std::move(words));
  if (!told.empty()) say_aside("swayaw: {}: {}\n", check.run, fmt::join(told, "; "));
}

}  // namespace

std::vector<Recording> loaded_runs(const std::vector<std::filesystem::path>& files, std::string_view rudder_positive) {
  std::vector<Recording> runs;
  for (const auto& file : files) runs.push_back(load_run(file, rudder_positive));
  return runs;
}

std::vector<RunCheck> checks_of(const std::vector<Recording>& runs, ShortRuns short_runs) {
  std::vector<RunCheck> checks(runs.size());
  in_parallel(runs.size(), 0, [&](std::size_t i) {
    const bool enough = runs[i].samples() >= samples_for_check;
    if (enough || short_runs == ShortRuns::refused) checks[i] = check_run(runs[i]);
  });
  return checks;
}

std::vector<Recording> checked_runs(const std::vector<std::filesystem::path>& files, const Reading& reading) {
  auto runs = loaded_runs(files, reading.rudder_positive);
  for (auto& run : runs) run = without(std::move(run), reading.ignored);
  if (reading.no_check) return runs;
  const auto checks = checks_of(runs, ShortRuns::passed_over);
  std::ranges::for_each(checks, refuse_mistakes);
  std::ranges::for_each(checks, tell);
  for (auto& run : runs) run = without_outliers(std::move(run));
  return runs;
}

}  // namespace swayaw::app
