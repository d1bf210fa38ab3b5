#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "column_plan.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr double turn_rad = 2.0 * pi;

/// Cells that are not plain numbers: each must be read, and lie where the quantity can.
void require_cells(const RawTables& raw, const PlannedColumn& c) {
  const double most = c.form == CellForm::sided          ? facts_of(*c.quantity).most / c.unit->si
                      : c.quantity == Quantity::latitude ? 90.0
                                                         : 360.0;
  for (const auto& table : raw.tables) {
    SampleRows rows(table);
    while (rows.next()) {
      const auto cell = rows.cells()[c.source];
      const auto [value, kind] = value_in(cell, raw.rules[c.source], c.form);
      if (kind == CellKind::missing || (kind == CellKind::number && std::abs(value) <= most)) continue;
      const auto [line, column] = rows.place_of(cell);
      throw FileError({table.file, line, column},
                      fmt::format("\"{}\" in column {} is not a {}", shown(cell), shown(raw.shown_name(c.source)),
                                  facts_of(*c.quantity).shown));
    }
  }
}

[[noreturn]] void refuse_value(const RawTables& raw, const PlannedColumn& c, const std::string& what, auto&& is_wrong) {
  for (const auto& table : raw.tables) {
    SampleRows rows(table);
    double before = std::numeric_limits<double>::quiet_NaN();
    while (rows.next()) {
      NumberCell number;
      const auto cell = rows.cells()[c.source];
      if (read_cell(cell, raw.rules[c.source], number) != CellKind::number) continue;
      const auto [line, column] = rows.place_of(cell);
      if (is_wrong(number.value, before))
        throw FileError(
            {table.file, line, column},
            fmt::format("\"{}\" in column {} is {}; missing = [{}] in the column map if it stands for no value",
                        shown(cell), shown(raw.shown_name(c.source)), what, number.text()));
      before = number.value;
    }
  }
  throw FileError(raw.header_place(c.source),
                  fmt::format("{} has a value that is {}", shown(raw.shown_name(c.source)), what));
}

}  // namespace

void require_sense(const RawTables& raw, const PlannedColumn& c) {
  if (c.form != CellForm::number) return require_cells(raw, c);
  const auto& facts = facts_of(*c.quantity);
  const double most = facts.most / c.unit->si;
  if (facts.most > 0.0 && raw.survey.columns[c.source].largest() > most * 1.001)
    refuse_value(raw, c, fmt::format("more than {} can be, {:.4g} {}", facts.shown, most, c.unit->shown),
                 [&](double value, double) { return std::abs(value) > most * 1.001; });
  const double turn = turn_rad / c.unit->si;
  const bool is_bearing =
      c.quantity == Quantity::heading || c.quantity == Quantity::course || c.quantity == Quantity::wind_from;
  if (is_bearing && raw.survey.columns[c.source].longest_step > 1.1 * turn)
    refuse_value(raw, c, "more than a turn away from the sample before",
                 [&](double value, double before) { return std::abs(value - before) > 1.1 * turn; });
}

}  // namespace swayaw::core::detail
