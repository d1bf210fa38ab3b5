#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "column_map.hpp"
#include "survey.hpp"
#include "time_cell.hpp"
#include "units.hpp"

namespace swayaw::inline core::detail {

/// Columns that tell the time.
struct TimeColumns {
  std::optional<std::size_t> date;  ///< where it is a column of its own
  std::size_t time;
  std::optional<Unit> unit;              ///< of the name
  std::optional<int> zone_minutes = {};  ///< by the name, east of UTC
  bool is_own = false;                   ///< `time_s` of a recording: kept as it is
};

/// A row's time as it is written.
struct RowTime {
  std::optional<WrittenDate> date = {};
  Microseconds time = 0;  ///< of the day, or since the origin of the format
  std::optional<int> zone_minutes = {};
  CellPlace place = {};
};

/// Times of all rows as they are written.
struct TimeRows {
  std::optional<TimeFormat> format;  ///< of a column of numbers; nothing: of clock times
  std::vector<std::vector<RowTime>> of_file;
};

/// @throws FileError  for cells that are no time, and numbers that may count in two ways
TimeRows time_rows(const std::vector<RawTable>& tables, const Survey& survey, const TimeColumns& columns,
                   const TimeRules& rules, const NumberRules& numbers);

/// What numbers of the format count, in words.
std::string_view words_of_format(TimeFormat format);

}  // namespace swayaw::core::detail
