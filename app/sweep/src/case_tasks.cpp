#include "case_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "child_process.hpp"
#include "swayaw/core/file_limits.hpp"

namespace swayaw::app {
namespace {

using Json = nlohmann::json;

/// A column and where the document of the command has it.
struct Place {
  const char* column;
  const char* unit;
  const char* pointer;
};

constexpr std::array trial_places{
    Place{"approach_speed_m_s", "m/s", "/runs/0/approach_speed_m_s/value"},
    Place{"overshoot_1_deg", "deg", "/runs/0/overshoot_deg/0/value"},
    Place{"overshoot_1_error_deg", "deg", "/runs/0/overshoot_deg/0/standard_error"},
    Place{"overshoot_2_deg", "deg", "/runs/0/overshoot_deg/1/value"},
    Place{"overshoot_2_error_deg", "deg", "/runs/0/overshoot_deg/1/standard_error"},
    Place{"period_s", "s", "/runs/0/period_s/value"},
    Place{"advance_m", "m", "/runs/0/advance_m/value"},
    Place{"tactical_diameter_m", "m", "/runs/0/tactical_diameter_m/value"},
    Place{"K_1_s", "1/s", "/runs/0/nomoto/least_squares/K_1_s/value"},
    Place{"T_s", "s", "/runs/0/nomoto/least_squares/T_s/value"},
};

constexpr std::array diagnosis_places{
    Place{"probability_1", "-", "/effects/0/probability"},
    Place{"probability_2", "-", "/effects/1/probability"},
    Place{"yaw_rate_error_given", "-", "/discrepancy/given"},
    Place{"yaw_rate_error_refitted", "-", "/discrepancy/refitted"},
    Place{"yaw_rate_error_after", "-", "/discrepancy/after"},
};

std::span<const Place> places_of(SweepTask task) {
  if (task == SweepTask::trial) return trial_places;
  if (task == SweepTask::diagnose) return diagnosis_places;
  return {};
}

/// The entry of a list whose `name` is that.
const Json* named(const Json& list, std::string_view name) {
  const auto is_named = [&](const Json& entry) {
    return entry.is_object() && entry.contains("name") && entry["name"] == name;
  };
  const auto found = std::ranges::find_if(list, is_named);
  return found == list.end() ? nullptr : &*found;
}

double number_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// Of an identification: each coefficient and its standard error.
std::vector<double> coefficients_of(const SweepPlan& plan, const Json& document) {
  std::vector<double> values;
  for (const auto& key : plan.find) {
    const auto* found = document.contains("coefficients") ? named(document["coefficients"], key) : nullptr;
    for (const char* number : {"value", "standard_error"})
      values.push_back(found ? number_in(*found, number) : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

/// The same files by names that no command takes for an option: a plan or a folder of others may hold "--report=page".
SweepCase as_files(SweepCase c) {
  const auto beside_option = [](std::string& file) {
    if (file.starts_with('-')) file.insert(0, "./");
  };
  beside_option(c.ship);
  for (auto* runs : {&c.runs, &c.reference, &c.holdout}) std::ranges::for_each(*runs, beside_option);
  return c;
}

std::vector<std::string> words_of(const SweepPlan& plan, const SweepCase& named) {
  const auto c = as_files(named);
  std::vector<std::string> words{std::filesystem::read_symlink("/proc/self/exe").string()};
  const auto add = [&](const char* option, const std::vector<std::string>& values) {
    if (!values.empty() && *option) words.emplace_back(option);
    words.insert(words.end(), values.begin(), values.end());
  };
  if (plan.task == SweepTask::trial) {
    words.insert(words.end(), {"trial", "--json"});
    add("--ship", c.ship.empty() ? std::vector<std::string>{} : std::vector{c.ship});
    add("", c.runs);
  } else if (plan.task == SweepTask::identify) {
    words.insert(words.end(), {"identify", "--json", "--ship", c.ship, "--model", plan.model, "--find",
                               fmt::format("{}", fmt::join(plan.find, ","))});
    if (plan.prior) words.emplace_back("--prior");
    add("--holdout", c.holdout);
    words.emplace_back("--");
    add("", c.runs);
  } else {
    words.insert(words.end(), {"diagnose", "--json", c.ship});
    add("", c.runs);
    add("--reference", c.reference);
    add("--holdout", c.holdout);
  }
  if (const auto most = largest_file(FileUse::samples); most != usual_samples_size)
    words.insert(words.begin() + 2, {"--max-file-size", std::to_string(most)});
  return words;
}

/// The document; discarded where the text is none, or has lists in lists that would take the stack to write again.
Json shallow_json(std::string_view text) {
  constexpr int deepest = 100;  // documents of the program have 8
  bool deep = false;
  const auto look = [&](int depth, Json::parse_event_t, Json&) { return !(deep |= depth > deepest); };
  auto document = Json::parse(text, look, false);
  return deep ? Json(Json::value_t::discarded) : document;
}

/// The last line that the program said, without its own name.
std::string last_line(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  text.erase(0, text.rfind('\n') + 1);
  return text.empty() ? "it said nothing" : text;
}

}  // namespace

std::vector<SweepColumn> results_of_case(const SweepPlan& plan) {
  std::vector<SweepColumn> columns;
  for (const auto& place : places_of(plan.task)) columns.push_back({place.column, place.unit, false});
  for (const auto& key : plan.find)
    for (const char* end : {"", "_error"}) columns.push_back({key + end, "-", false});
  return columns;
}

SweepBlock block_of_document(const SweepPlan& plan, std::size_t place, std::string_view text) {
  const auto places = places_of(plan.task);
  SweepBlock block{.place = place, .first = place, .count = 1};
  block.values.assign(results_of_case(plan).size(), std::numeric_limits<double>::quiet_NaN());
  const auto document = shallow_json(text);
  if (!document.is_object()) {
    block.notes.emplace_back(place, "what the command answered is no document");
    return block;
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Json::json_pointer pointer(places[k].pointer);
    if (document.contains(pointer) && document[pointer].is_number()) block.values[k] = document[pointer].get<double>();
  }
  if (plan.task == SweepTask::identify) block.values = coefficients_of(plan, document);
  block.documents.emplace_back(place, document.dump());
  return block;
}

SweepBlock block_of_case(const SweepPlan& plan, std::size_t place) {
  const auto end = run_program(words_of(plan, plan.cases[place]), {});
  if (end && end->code == 0) return block_of_document(plan, place, end->out);
  auto block = block_of_document(plan, place, "");
  block.notes.front().second =
      end ? fmt::format("exit code {}: {}", end->code, last_line(end->err)) : "the program cannot be started";
  return block;
}

}  // namespace swayaw::app
