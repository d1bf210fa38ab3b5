#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "number_cell.hpp"
#include "table_rows.hpp"

namespace swayaw::inline core::detail {

/// A column as the header names it.
struct HeaderCell {
  std::string name;
  std::string units;  ///< of the row of units below, if there is one
  CellPlace place;
};

/// A line above the header.
struct PreambleLine {
  std::size_t line;
  std::string text;
};

/// A text table taken apart as far as its header.
struct RawTable {
  std::filesystem::path file;
  std::string text;  ///< UTF-8
  std::string encoding;
  char separator = ',';
  std::vector<HeaderCell> header;
  std::vector<PreambleLine> preamble;
  std::size_t data_begin = 0;  ///< of the first row of samples in the text
  std::size_t data_line = 1;   ///< its number

  /// "Heading [deg]", "Heading" with a row of units.
  std::string shown_name(std::size_t column) const;
};

/// Reads the file and finds separator, header row and row of units.
/// @throws FileError  where there is no table of numbers with names above them
RawTable read_table(const std::filesystem::path& file, const NumberRules& rules);

/// The same of text in UTF-8.
RawTable table_of(std::string text, const std::filesystem::path& file, const NumberRules& rules);

/// Rows of samples: those as long as the header, without empty cells behind it; headers repeated and a last row that
/// breaks off are passed over.
class SampleRows {
 public:
  explicit SampleRows(const RawTable& table)
      : table_(table), rows_(table.text, table.separator, table.data_line, table.data_begin) {}

  /// @throws FileError  for a row that is too short or too long
  bool next();

  const std::vector<std::string_view>& cells() { return rows_.cells(); }
  std::size_t line() const { return rows_.line(); }
  CellPlace place_of(std::string_view cell) const { return rows_.place_of(cell); }

  std::size_t repeated_headers() const { return repeated_headers_; }
  bool broke_off() const { return broke_off_; }

 private:
  bool is_header_again() const;
  void require_length();

  const RawTable& table_;
  TableRows rows_;
  std::size_t repeated_headers_ = 0;
  bool broke_off_ = false;
};

}  // namespace swayaw::core::detail
