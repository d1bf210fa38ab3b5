#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "number_cell.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/refusal.hpp"
#include "time_cell.hpp"

namespace swayaw::inline core::detail {

/// How a column of numbers counts time.
enum class TimeFormat { seconds, milliseconds, minutes, hours, excel, unix_s, unix_ms, hhmmss, day_fraction };

/// What to do with rows that have the time of the row before, or an earlier one.
enum class Repeats { refuse, drop, spread };

/// [time] of a column map.
struct TimeRules {
  std::vector<std::string> columns;     ///< one, or date and time; empty: by name
  std::optional<TimeFormat> format;     ///< nothing: by values
  std::optional<DateOrder> date_order;  ///< nothing: by values
  std::optional<int> zone_minutes;      ///< east of UTC
  std::optional<TimeCell> origin;       ///< date and time that the column counts from
  Repeats repeats = Repeats::refuse;
};

/// A column of the raw file and the column of recordings that the user says it is.
struct MappedColumn {
  std::string source;
  std::string target;
  FilePlace place;
};

/// What the files do not say themselves (docs/import.md).
struct ColumnMap {
  std::vector<MappedColumn> columns;
  std::vector<MappedColumn> ignored;
  NumberRules numbers;
  TimeRules time;
  std::vector<RunRemark> run;  ///< keys to write above the header row

  const MappedColumn* of(const std::string& source) const;
  bool ignores(const std::string& source) const;
};

/// @param file  empty: a map that says nothing
/// @throws FileError
ColumnMap read_column_map(const std::filesystem::path& file);

/// The column of recordings, `time_s`, `lat_deg` and `lon_deg` among them.
bool is_recording_column(std::string_view name);

}  // namespace swayaw::core::detail
