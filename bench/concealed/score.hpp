#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Diagnoses of concealed cases beside their truth, one line of JSON for each.
namespace swayaw::concealed {

using Json = nlohmann::ordered_json;

/// A case as whoever has to solve it gets it.
struct Riddle {
  Ship ship;
  std::vector<Recording> train, holdout, reference;
  std::vector<Recording> true_holdout;  ///< without noise, for the score alone
};
Riddle read_riddle(const std::filesystem::path& folder);

struct ScoreOptions {
  std::filesystem::path lines;  ///< file of answers; cases that stand in it are not done again
  unsigned jobs = 1;            ///< cases at a time
  bool rivals_only = false;     ///< without the diagnosis itself
};

/// Answers for all cases of a folder that are not answered yet; told(line) after each.
void score(const std::filesystem::path& cases, const ScoreOptions& options,
           const std::function<void(const Json&)>& told);

/// All answers of a file; a last line that was cut off is left out.
std::vector<Json> read_lines(const std::filesystem::path& file);

/// Tables in Markdown, by the names of docs/concealed.md.
std::vector<std::pair<std::string, std::string>> tables_of(const std::vector<Json>& answers);

}  // namespace swayaw::concealed
