#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "column_map.hpp"
#include "survey.hpp"
#include "time_rows.hpp"

namespace swayaw::inline core::detail {

/// Stands for a row that is left out.
inline constexpr Microseconds no_time = std::numeric_limits<Microseconds>::min();

/// Times of all rows, in the order of the files, which is that of time.
struct Times {
  std::vector<std::vector<Microseconds>> of_file;  ///< by row, or `no_time`
  std::vector<std::size_t> order;                  ///< of the files
  bool uses_date = false;                          ///< of a column of its own, or of the cells
  bool as_written = false;                         ///< seconds, to be written as the cells have them
  Microseconds first = 0;                          ///< that `time_s` = 0 means
  std::optional<std::string> start_utc;
  std::string words;               ///< how the column was read
  std::vector<std::string> notes;  ///< midnight, what was dropped, what is not known
};

/// @throws FileError  for cells that are no time, and for time that does not increase
Times times_of(const std::vector<RawTable>& tables, const Survey& survey, const TimeColumns& columns,
               const TimeRules& time_rules, const NumberRules& number_rules);

}  // namespace swayaw::core::detail
