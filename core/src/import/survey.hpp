#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "number_cell.hpp"
#include "table_layout.hpp"

namespace swayaw::inline core::detail {

/// A cell to be shown in a message.
struct ShownCell {
  std::filesystem::path file;
  CellPlace place;
  std::string text;
};

/// What the cells of one column have in common.
struct ColumnSurvey {
  std::size_t numbers = 0, texts = 0, missing = 0;
  std::size_t points = 0, commas = 0;                    ///< numbers with a decimal mark that is beyond doubt
  std::size_t doubtful_points = 0, doubtful_commas = 0;  ///< 12.345 and 12,345
  std::size_t not_plain = 0;                             ///< numbers that cannot be written as they are
  int decimals = 0;                                      ///< most of them
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  double first = std::numeric_limits<double>::quiet_NaN();
  double longest_step = 0.0;                                       ///< between neighbouring samples
  double shortest_step = std::numeric_limits<double>::infinity();  ///< that is not 0
  std::string unit;                                                ///< behind the numbers
  std::optional<ShownCell> first_number, first_text, first_point, first_comma, first_other_unit;

  double largest() const { return numbers == 0 ? 0.0 : std::max(-least, most); }
  std::size_t samples() const { return numbers + texts; }

 private:
  friend class Surveyor;
  double previous_ = std::numeric_limits<double>::quiet_NaN();
};

/// What all rows of all files have in common.
struct Survey {
  std::vector<ColumnSurvey> columns;
  std::size_t rows = 0;
  std::size_t repeated_headers = 0;
  std::vector<std::string> broke_off;  ///< files whose last row is not whole
};

/// @throws FileError  for rows that are not as long as the header
Survey survey_of(const std::vector<RawTable>& tables, const NumberRules& rules);

/// Decimal mark of each column, and refusal where points and commas leave it open.
/// @throws FileError
std::vector<char> decimal_marks(const std::vector<RawTable>& tables, const Survey& survey, const NumberRules& rules);

}  // namespace swayaw::core::detail
