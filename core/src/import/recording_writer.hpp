#pragma once

#include <string>
#include <vector>

#include "column_plan.hpp"
#include "times.hpp"

namespace swayaw::inline core::detail {

/// A column of the recording file that holds none of a recording's channels.
struct KeptColumn {
  std::size_t source;
  std::string name;
};

/// Everything that the rows of a recording file are written from.
struct RecordingPlan {
  std::vector<PlannedColumn> channels;
  std::vector<KeptColumn> kept;
  std::size_t time_source = 0;
};

/// Lines above the header row, `# key = value`.
std::string key_lines(const std::vector<RunRemark>& keys);

/// Header row and rows of samples, after the text that is there.
void append_rows(std::string& text, const RawTables& raw, const RecordingPlan& plan, const Times& times);

/// A text as TOML writes it.
std::string toml_text(const std::string& text);

/// A list of texts as TOML writes it.
std::string toml_list(const std::vector<std::string>& texts);

}  // namespace swayaw::core::detail
