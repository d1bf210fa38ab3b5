#include "table_rows.hpp"

#include <algorithm>
#include <string>

#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {

bool TableRows::next() {
  while (next_ < text_.size()) {
    begin_ = next_;
    line_ = next_line_;
    split();
    next_line_ = line_ + static_cast<std::size_t>(std::ranges::count(raw(), '\n')) + 1;
    next_ = std::min(end_ + 1, text_.size());
    if (!trimmed(raw()).empty()) return true;
  }
  return false;
}

void TableRows::split() {
  cells_.clear();
  auto at = begin_;
  for (bool more = true; more;) cells_.push_back(take_cell(at, more));
  end_ = at;
}

/// @param at    before: where the cell begins; after: where the next begins, or the line end
/// @param more  whether a separator follows
std::string_view TableRows::take_cell(std::size_t& at, bool& more) const {
  const auto is_blank = [&](std::size_t i) {
    return text_[i] == ' ' || text_[i] == '\r' || (text_[i] == '\t' && separator_ != '\t');
  };
  while (at < text_.size() && is_blank(at)) ++at;
  std::string_view cell;
  if (at < text_.size() && text_[at] == '"') cell = quoted_cell(at);
  const auto begin = at;
  const auto ends = [&](char c) {
    return c == separator_ || c == '\n' || (separator_ == blanks_between && (c == '\t' || c == '\r'));
  };
  while (at < text_.size() && !ends(text_[at])) ++at;
  if (cell.data() == nullptr) cell = trimmed(text_.substr(begin, at - begin));
  if (separator_ == blanks_between)
    while (at < text_.size() && is_blank(at)) ++at;
  more = at < text_.size() && text_[at] != '\n';
  if (more && separator_ != blanks_between) ++at;
  return cell;
}

/// The text between quotes; nothing, and no step forward, where the cell has no closing quote before a separator.
std::string_view TableRows::quoted_cell(std::size_t& at) const {
  constexpr std::size_t longest = 2000;  // characters; a note in a cell, not the rest of a file
  const auto last = std::min(text_.size(), at + longest);
  for (auto i = at + 1; i < last; ++i) {
    if (text_[i] != '"') continue;
    if (i + 1 < text_.size() && text_[i + 1] == '"') {
      ++i;
      continue;
    }
    const auto cell = text_.substr(at + 1, i - at - 1);
    at = i + 1;
    return trimmed(cell);
  }
  return {};
}

CellPlace TableRows::place_of(std::string_view cell) const {
  const auto before = text_.substr(begin_, static_cast<std::size_t>(cell.data() - text_.data()) - begin_);
  const auto line_begin = before.rfind('\n') + 1;  // 0 if there is none
  const auto lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
  return {line_ + lines, characters(before.substr(line_begin)) + 1};
}

std::string without_double_quotes(std::string_view cell) {
  std::string text(cell);
  for (auto at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1)) text.erase(at, 1);
  return text;
}

}  // namespace swayaw::core::detail
