#include "survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {

/// Goes through the rows of one file.
class Surveyor {
 public:
  Surveyor(const RawTable& table, const NumberRules& rules, Survey& survey)
      : table_(table), rules_(rules), rows_(table), survey_(survey) {}

  void run() {
    while (rows_.next()) {
      ++survey_.rows;
      for (std::size_t i = 0; i < survey_.columns.size(); ++i) take(survey_.columns[i], rows_.cells()[i]);
    }
    survey_.repeated_headers += rows_.repeated_headers();
    if (rows_.broke_off()) survey_.broke_off.push_back(table_.file.filename().string());
  }

 private:
  ShownCell shown_cell(std::string_view cell) const { return {table_.file, rows_.place_of(cell), shown(cell)}; }

  void take(ColumnSurvey& column, std::string_view cell) {
    NumberCell number;
    switch (read_cell(cell, rules_, number)) {
      case CellKind::missing: ++column.missing; break;
      case CellKind::number: take_number(column, cell, number); break;
      case CellKind::text:
        ++column.texts;
        if (!column.first_text) column.first_text = shown_cell(cell);
    }
  }

  void take_number(ColumnSurvey& column, std::string_view cell, const NumberCell& number) {
    if (column.numbers++ == 0) {
      column.first_number = shown_cell(cell);
      column.first = number.value;
      column.unit = number.unit;
    } else if (column.unit != number.unit && !column.first_other_unit) column.first_other_unit = shown_cell(cell);
    take_mark(column, cell, number);
    column.not_plain += number.is_plain ? 0 : 1;
    column.decimals = std::max(column.decimals, number.decimals);
    column.least = std::min(column.least, number.value);
    column.most = std::max(column.most, number.value);
    const double step = std::abs(number.value - column.previous_);
    if (step > column.longest_step) column.longest_step = step;
    if (step > 0.0 && step < column.shortest_step) column.shortest_step = step;
    column.previous_ = number.value;
  }

  void take_mark(ColumnSurvey& column, std::string_view cell, const NumberCell& number) {
    const auto s = number.separators;
    const bool point = s == Separators::point || s == Separators::doubtful_point;
    if (s == Separators::none) return;
    ++(s == Separators::point            ? column.points
       : s == Separators::comma          ? column.commas
       : s == Separators::doubtful_point ? column.doubtful_points
                                         : column.doubtful_commas);
    auto& first = point ? column.first_point : column.first_comma;
    if (!first) first = shown_cell(cell);
  }

  const RawTable& table_;
  const NumberRules& rules_;
  SampleRows rows_;
  Survey& survey_;
};

namespace {

[[noreturn]] void refuse_cell(const ShownCell& cell, std::string_view what) {
  throw FileError({cell.file, cell.place.line, cell.place.column}, what);
}

/// What the marks of all columns together leave no doubt of.
struct ProvenMarks {
  bool point = false, comma = false;
};

char mark_of(const ColumnSurvey& c, const ProvenMarks& proven) {
  if (c.points > 0 && c.commas + c.doubtful_commas > 0)
    refuse_cell(*c.first_comma,
                fmt::format("\"{}\" has a comma and other cells of the column a decimal point; decimal = "
                            "\".\" and thousands = \",\" in the column map, or the other way, settle it",
                            c.first_comma->text));
  if (c.commas > 0 && c.doubtful_points > 0)
    refuse_cell(*c.first_point,
                fmt::format("\"{}\" has a point and other cells of the column a decimal comma; thousands "
                            "= \".\" in the column map makes it a thousand",
                            c.first_point->text));
  if (c.points > 0) return '.';
  if (c.commas > 0) return ',';
  if (c.doubtful_points > 0 && c.doubtful_commas > 0)
    refuse_cell(*c.first_comma,
                fmt::format("points and commas both stand before three digits, as in \"{}\"; decimal in "
                            "the column map settles which of them is that of decimals",
                            c.first_comma->text));
  if (c.doubtful_points > 0 && proven.comma && !proven.point)
    refuse_cell(*c.first_point, fmt::format("is \"{}\" a thousand or a decimal? The file has decimal commas elsewhere; "
                                            "decimal = \".\" or thousands = \".\" in the column map settles it",
                                            c.first_point->text));
  if (c.doubtful_commas > 0 && (proven.point || !proven.comma))
    refuse_cell(*c.first_comma,
                fmt::format("is \"{}\" a thousand or a decimal? decimal = \",\" or thousands = \",\" in "
                            "the column map settles it",
                            c.first_comma->text));
  return c.doubtful_commas > 0 ? ',' : '.';
}

}  // namespace

Survey survey_of(const std::vector<RawTable>& tables, const NumberRules& rules) {
  Survey survey;
  survey.columns.resize(tables.front().header.size());
  for (const auto& table : tables) Surveyor(table, rules, survey).run();
  return survey;
}

std::vector<char> decimal_marks(const std::vector<RawTable>& tables, const Survey& survey, const NumberRules& rules) {
  ProvenMarks proven;
  for (const auto& c : survey.columns) {
    if (c.texts > 0) continue;
    proven.point = proven.point || c.points > 0;
    proven.comma = proven.comma || c.commas > 0;
  }
  std::vector<char> marks;
  for (std::size_t i = 0; i < tables.front().header.size(); ++i) {
    const auto& c = survey.columns[i];
    const bool of_numbers = c.numbers > 0 && c.texts == 0;
    marks.push_back(rules.decimal != '\0' ? rules.decimal : of_numbers ? mark_of(c, proven) : proven.comma ? ',' : '.');
  }
  return marks;
}

}  // namespace swayaw::core::detail
