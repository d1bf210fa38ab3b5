#include "table_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "position_cell.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"
#include "text_encoding.hpp"
#include "time_cell.hpp"
#include "units.hpp"

namespace swayaw::inline core::detail {
namespace {

/// Whether a cell holds a sample rather than a name.
bool holds_value(std::string_view cell, const NumberRules& rules) {
  NumberCell number;
  if (cell.empty()) return false;
  const auto kind = read_cell(cell, rules, number);
  if (kind != CellKind::text || time_cell(cell)) return true;
  const auto position = position_cell(cell);
  return position && (position->side != '\0' || cell.find("\xC2\xB0") != std::string_view::npos);
}

bool is_comment(std::string_view raw) {
  const auto line = trimmed(raw);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

/// A row of the beginning of a file.
struct Row {
  std::size_t line, begin;
  std::string_view raw;
  std::vector<std::string_view> cells;
  std::size_t values = 0;  ///< cells that hold one
  std::size_t filled = 0;  ///< cells that are not empty

  /// Of a piece of the row.
  CellPlace place_of(std::string_view piece) const {
    const auto before = raw.substr(0, static_cast<std::size_t>(piece.data() - raw.data()));
    const auto last_line = before.substr(before.rfind('\n') + 1);  // all of it without a line end
    return {line + static_cast<std::size_t>(std::ranges::count(before, '\n')), characters(last_line) + 1};
  }
  bool is_samples() const { return cells.size() >= 2 && values >= 2 && 2 * values >= filled; }
};

std::vector<Row> rows_of(std::string_view text, char separator, const NumberRules& rules) {
  std::vector<Row> rows;
  TableRows reader(text, separator);
  while (reader.next()) {
    Row row{.line = reader.line(), .begin = reader.begin(), .raw = reader.raw(), .cells = reader.cells()};
    for (const auto cell : row.cells) {
      row.filled += cell.empty() ? 0 : 1;
      row.values += !is_comment(row.raw) && holds_value(cell, rules) ? 1 : 0;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Rows of a beginning under one separator, and how long most rows of samples are.
struct Layout {
  char separator;
  std::vector<Row> rows;
  std::size_t length = 0;  ///< cells of most rows of samples
  std::size_t count = 0;   ///< of such rows
};

Layout layout_with(char separator, std::string_view beginning, const NumberRules& rules) {
  Layout layout{.separator = separator, .rows = rows_of(beginning, separator, rules)};
  std::map<std::size_t, std::size_t> lengths;
  for (const auto& row : layout.rows)
    if (row.is_samples()) ++lengths[row.cells.size()];
  for (const auto& [length, count] : lengths)
    if (count >= layout.count) layout.length = length, layout.count = count;
  return layout;
}

/// The first separator under which most lines with values are rows of one length, in the order of how seldom the mark
/// stands inside a cell.
Layout best_layout(std::string_view beginning, const NumberRules& rules) {
  Layout best{.separator = ',', .rows = {}};
  for (const char separator : {';', '\t', '|', ',', blanks_between}) {
    auto layout = layout_with(separator, beginning, rules);
    const auto lines = static_cast<std::size_t>(
        std::ranges::count_if(layout.rows, [](const Row& row) { return !is_comment(row.raw); }));
    if (layout.count > best.count) best = std::move(layout);
    if (best.separator == separator && 2 * best.count >= lines) break;
  }
  return best;
}

/// The whole lines at the beginning of a text.
std::string_view beginning_of(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;  // bytes: longer than any preamble, 100 rows of 40 columns
  if (text.size() <= enough) return text;
  const auto end = text.substr(0, enough).rfind('\n');
  return text.substr(0, end == std::string_view::npos ? enough : end);
}

/// "[deg]", "(kn)", "m/s", "-": the cell of a row of units.
bool is_unit_cell(std::string_view cell) {
  if (cell.empty() || cell == "-" || unit_named(cell)) return true;
  const bool bracketed = cell.front() == '[' || cell.front() == '(';
  return bracketed || lower_case(cell).find("hh:mm") != std::string::npos || cell == "UTC";
}

bool is_row_of_units(const Row& row) {
  const auto units = std::ranges::count_if(row.cells, [](auto cell) { return !cell.empty() && is_unit_cell(cell); });
  return units > 0 && std::ranges::all_of(row.cells, is_unit_cell);
}

/// Names between runs of blanks: cells as they are, or "Rudder angle [deg]" as one between at least two blanks, or
/// "Heading [deg]" as one; whichever are as many as the samples have.
std::vector<std::string_view> names_between_blanks(const Row& row, std::size_t wanted) {
  if (row.cells.size() == wanted) return row.cells;
  std::vector<std::string_view> wide, bracketed;
  for (auto rest = trimmed(row.raw); !rest.empty();) {
    const auto end = std::min(rest.find("  "), rest.find('\t'));
    wide.push_back(trimmed(rest.substr(0, end)));
    rest = end == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(end));
  }
  if (wide.size() == wanted) return wide;
  for (const auto cell : row.cells)
    if (!bracketed.empty() && (cell.starts_with('[') || cell.starts_with('(')))
      bracketed.back() = {bracketed.back().data(),
                          static_cast<std::size_t>(cell.data() + cell.size() - bracketed.back().data())};
    else bracketed.push_back(cell);
  return bracketed.size() == wanted ? bracketed : row.cells;
}

void name_columns(RawTable& table, const Row& names, const Row* units, std::size_t wanted) {
  const auto cells = table.separator == blanks_between ? names_between_blanks(names, wanted) : names.cells;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    auto name = without_double_quotes(cells[k]);
    std::ranges::replace(name, '\n', ' ');
    std::erase(name, '\r');
    const auto unit = units && k < units->cells.size() ? std::string(units->cells[k]) : std::string{};
    table.header.push_back({std::move(name), unit, names.place_of(cells[k])});
  }
  while (!table.header.empty() && table.header.back().name.empty()) table.header.pop_back();
}

/// The names behind the mark of a comment: "# time, heading, rudder".
std::optional<Row> names_in_comment(const Row& row, char separator) {
  const auto line = trimmed(row.raw);
  const auto after = line.substr(std::min(line.find_first_not_of("#%/ "), line.size()));
  TableRows reader(after, separator, row.line);
  if (!reader.next() || reader.cells().size() < 2) return std::nullopt;
  Row names = row;
  names.cells = reader.cells();
  return names;
}

[[noreturn]] void refuse_without_table(const RawTable& table) {
  throw FileError({table.file, 1, 1},
                  table.text.find_first_not_of(" \t\r\n") == std::string::npos
                      ? "the file is empty"
                      : "no table: no rows of numbers separated by comma, semicolon, tab or blanks");
}

void find_header(RawTable& table, const Layout& layout) {
  const auto is_first = [&](const Row& row) { return row.is_samples() && row.cells.size() == layout.length; };
  const auto data = std::ranges::find_if(layout.rows, is_first);
  if (data == layout.rows.end()) refuse_without_table(table);
  table.data_begin = data->begin;
  table.data_line = data->line;
  auto names = data;
  const Row* units = nullptr;
  const auto above = [&](auto row) { return row != layout.rows.begin() && !is_comment(std::prev(row)->raw); };
  if (above(names) && is_row_of_units(*std::prev(names)) && above(std::prev(names))) units = &*--names;
  std::optional<Row> commented;
  if (above(names)) --names;
  else if (names != layout.rows.begin()) commented = names_in_comment(*--names, table.separator);
  else names = layout.rows.end();
  if (names == layout.rows.end() || (is_comment(names->raw) && !commented) || (!commented && names->is_samples()))
    throw FileError({table.file, data->line, 1}, "no row of column names above the numbers");
  name_columns(table, commented ? *commented : *names, units, layout.length);
  for (auto row = layout.rows.begin(); row != names; ++row)
    table.preamble.push_back({row->line, std::string(row->raw)});
}

}  // namespace

std::string RawTable::shown_name(std::size_t column) const {
  const auto& [name, units, place] = header[column];
  const auto named = name.empty() ? fmt::format("column {}", column + 1) : name;
  if (units.empty() || units == "-") return named;
  return units.front() == '[' || units.front() == '(' ? named + ' ' + units : fmt::format("{} [{}]", named, units);
}

RawTable table_of(std::string text, const std::filesystem::path& file, const NumberRules& rules) {
  RawTable table{.file = file, .text = std::move(text), .encoding = "UTF-8", .header = {}, .preamble = {}};
  const auto layout = best_layout(beginning_of(table.text), rules);
  table.separator = layout.separator;
  find_header(table, layout);
  return table;
}

RawTable read_table(const std::filesystem::path& file, const NumberRules& rules) {
  auto [text, encoding] = decoded(read_text(file), file);
  auto table = table_of(std::move(text), file, rules);
  table.encoding = encoding;
  if (table.header.size() > most_columns)
    throw FileError({.file = file},
                    fmt::format("{} columns; tables of up to {} are read", table.header.size(), most_columns));
  return table;
}

bool SampleRows::next() {
  while (rows_.next()) {
    if (is_comment(rows_.raw())) continue;
    if (is_header_again()) {
      ++repeated_headers_;
      continue;
    }
    const auto length = table_.header.size();
    if (rows_.cells().size() < length && rows_.ends_without_line_end()) {
      broke_off_ = true;
      return false;
    }
    require_length();
    rows_.cells().resize(length);
    return true;
  }
  return false;
}

/// The names again, or the units below them.
bool SampleRows::is_header_again() const {
  const auto& cells = rows_.cells();
  const auto first = std::ranges::find_if(cells, [](auto cell) { return !cell.empty(); });
  const auto i = static_cast<std::size_t>(first - cells.begin());
  if (i >= table_.header.size()) return false;
  const auto& [name, units, place] = table_.header[i];
  if (*first != name && (units.empty() || *first != units)) return false;
  for (std::size_t k = i; k < std::min(cells.size(), table_.header.size()); ++k)
    if (cells[k] != table_.header[k].name && cells[k] != table_.header[k].units) return false;
  return true;
}

void SampleRows::require_length() {
  const auto& cells = rows_.cells();
  const auto length = table_.header.size();
  const auto fail = [&](std::string_view cell, std::string_view hint) {
    const auto [line, column] = place_of(cell);
    throw FileError({table_.file, line, column}, fmt::format("{} cell{}, but the row of names has {}{}", cells.size(),
                                                             cells.size() == 1 ? "" : "s", length, hint));
  };
  if (cells.size() < length) fail(cells.back(), "");
  for (std::size_t i = length; i < cells.size(); ++i)
    if (!cells[i].empty())
      fail(cells[i], table_.separator == ',' ? "; are there decimal commas? Such cells need quotes" : "");
}

}  // namespace swayaw::core::detail
