#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Text of comma-separated files. Not installed.
namespace swayaw::inline core::detail {

inline constexpr std::string_view blanks = " \t\r";

/// The text without blanks around it; it still points into `text` when nothing is left.
inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return text.substr(0, 0);
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Takes the text before the next separator off the front of `rest`.
inline std::string_view take(std::string_view& rest, char separator) {
  const auto end = rest.find(separator);
  const auto piece = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return piece;
}

/// Characters of UTF-8 text: bytes that do not continue one.
inline std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// Where the cell at the front of a line ends; a comma between quotes belongs to the cell.
inline std::size_t cell_end(std::string_view line) {
  const auto first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos || line[first] != '"') return std::min(line.find(','), line.size());
  bool quoted = false;
  for (std::size_t i = first; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == ',' && !quoted) return i;
  }
  return line.size();
}

/// The cells of a line as written, without blanks around them.
inline std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto end = cell_end(line);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

/// The text between quotes, if there are any.
inline std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// Name of a column; a quote within quotes is written twice.
inline std::string name_in(std::string_view cell) {
  std::string name(unquoted(cell));
  if (name.size() == cell.size()) return name;
  for (auto at = name.find("\"\""); at != std::string::npos; at = name.find("\"\"", at + 1)) name.erase(at, 1);
  return name;
}

/// The cell that names a column, in quotes where it needs them.
inline std::string cell_naming(std::string_view name) {
  std::string cell(name);
  if (trimmed(name) == name && name.find_first_of(",\"") == std::string_view::npos) return cell;
  for (auto at = cell.find('"'); at != std::string::npos; at = cell.find('"', at + 2)) cell.insert(at, 1, '"');
  return '"' + cell + '"';
}

inline bool is_missing(std::string_view cell) {
  constexpr std::array<std::string_view, 3> marks{"", "nan", "-nan"};
  return cell.size() <= 4 && std::ranges::count(marks, lower_case(cell)) > 0;
}

/// The finite number that a cell holds.
inline std::optional<double> number_in(std::string_view cell) {
  if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Text of a file as a message shows it: on one line, and not longer than a phrase.
inline std::string shown(std::string_view text) {
  constexpr std::size_t phrase = 40;
  const bool long_text = text.size() > phrase;
  std::string result(text.substr(0, phrase));
  while (long_text && !result.empty() && (result.back() & 0x80) != 0) result.pop_back();
  std::ranges::replace_if(
      result, [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; }, '?');
  return long_text ? result + "..." : result;
}

}  // namespace swayaw::core::detail
