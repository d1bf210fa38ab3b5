#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace swayaw::inline core::detail {

/// Lines and columns count from 1.
struct CellPlace {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Stands for runs of blanks and tabs between cells.
inline constexpr char blanks_between = ' ';

/// Rows of a text table, one after the other; empty lines are passed over. Cells come without blanks and quotes around
/// them; a separator or a line end between quotes belongs to the cell, and a quote is written there twice.
class TableRows {
 public:
  /// @param line   number of the first row's line
  /// @param begin  of the first row in the text
  TableRows(std::string_view text, char separator, std::size_t line = 1, std::size_t begin = 0)
      : text_(text), separator_(separator), next_(begin), next_line_(line) {}

  /// @return whether there is another row
  bool next();

  std::vector<std::string_view>& cells() { return cells_; }
  const std::vector<std::string_view>& cells() const { return cells_; }
  std::size_t line() const { return line_; }
  std::string_view raw() const { return text_.substr(begin_, end_ - begin_); }  ///< without the line end
  std::size_t begin() const { return begin_; }                                  ///< of the row in the text
  bool ends_without_line_end() const { return end_ == text_.size(); }
  CellPlace place_of(std::string_view cell) const;

 private:
  std::string_view take_cell(std::size_t& at, bool& more) const;
  std::string_view quoted_cell(std::size_t& at) const;
  void split();

  std::string_view text_;
  char separator_;
  std::size_t next_ = 0;       ///< begin of the next row
  std::size_t next_line_ = 1;  ///< its number
  std::size_t begin_ = 0, end_ = 0, line_ = 0;
  std::vector<std::string_view> cells_;
};

/// Text of a quoted cell with its double quotes made single.
std::string without_double_quotes(std::string_view cell);

}  // namespace swayaw::core::detail
