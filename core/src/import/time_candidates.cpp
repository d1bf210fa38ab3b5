#include <fmt/format.h>

#include <algorithm>

#include "column_plan.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

bool looks_like_time(const RawTables& raw, std::size_t i) {
  const auto& c = raw.survey.columns[i];
  const auto found = c.first_text ? time_cell(c.first_text->text) : std::nullopt;
  return found && found->clock && c.numbers == 0;
}

bool looks_like_date_and_time(const RawTables& raw, std::size_t i) {
  const auto& first = raw.survey.columns[i].first_text;
  const auto found = first ? time_cell(first->text) : std::nullopt;
  return found && found->date && found->clock;
}

TimeColumns time_column(const RawTables& raw, std::size_t i, std::optional<std::size_t> date = {}) {
  const auto& header = raw.tables.front().header[i];
  const auto named = named_column(header.name, header.units);
  const auto unit = named.unit && named.unit->measure == Measure::time ? named.unit : std::nullopt;
  const auto of_date = date ? named_column(raw.tables.front().header[*date].name, {}).zone_minutes : std::nullopt;
  return {.date = date,
          .time = i,
          .unit = unit,
          .zone_minutes = named.zone_minutes ? named.zone_minutes : of_date,
          .is_own = header.name == "time_s"};
}

std::size_t column_named_in_map(const RawTables& raw, const std::string& name) {
  for (std::size_t i = 0; i < raw.columns(); ++i)
    if (name == raw.tables.front().header[i].name || name == raw.shown_name(i)) return i;
  throw FileError(raw.header_place(0),
                  fmt::format("there is no column \"{}\", which [time] of the column map names", shown(name)));
}

/// Columns that may tell the time, by how they do.
struct TimeColumnKinds {
  std::vector<TimeColumns> settled, date_and_clock, clocks, numbers, unnamed;

  std::vector<TimeColumns> in_order() {
    for (auto* list : {&date_and_clock, &clocks})
      std::ranges::stable_sort(*list, {}, [](const auto& c) { return c.zone_minutes != 0; });
    auto all = settled;
    for (const auto* list : {&date_and_clock, &clocks, &numbers, &unnamed})
      all.insert(all.end(), list->begin(), list->end());
    return all;
  }
};

bool is_date_alone(const RawTables& raw, const PlannedColumn& c) {
  return !c.is_left_out && c.quantity == Quantity::date && !looks_like_date_and_time(raw, c.source);
}

}  // namespace

std::vector<TimeColumns> time_candidates(const RawTables& raw, const std::vector<PlannedColumn>& columns,
                                         const ColumnMap& map) {
  if (map.time.columns.size() == 1) return {time_column(raw, column_named_in_map(raw, map.time.columns[0]))};
  if (map.time.columns.size() == 2)
    return {
        time_column(raw, column_named_in_map(raw, map.time.columns[1]), column_named_in_map(raw, map.time.columns[0]))};
  TimeColumnKinds kinds;
  const auto dates = std::ranges::find_if(columns, [&](const auto& c) { return is_date_alone(raw, c); });
  const auto date = dates == columns.end() ? std::nullopt : std::optional(dates->source);
  for (const auto& c : columns) {
    const bool is_named = c.quantity == Quantity::time, text = raw.survey.columns[c.source].texts > 0;
    if (c.is_left_out || (c.quantity && !is_named && c.quantity != Quantity::date)) continue;
    if (c.is_settled && is_named) kinds.settled.push_back(time_column(raw, c.source));
    else if (looks_like_date_and_time(raw, c.source)) kinds.date_and_clock.push_back(time_column(raw, c.source));
    else if (looks_like_time(raw, c.source))
      (is_named ? kinds.clocks : kinds.unnamed).push_back(time_column(raw, c.source, date));
    else if (is_named) (text ? kinds.clocks : kinds.numbers).push_back(time_column(raw, c.source, date));
  }
  auto all = kinds.in_order();
  if (all.empty())
    throw FileError(raw.header_place(0),
                    "no column is known as the time; [time] column = \"...\" in the column map names it");
  return all;
}

}  // namespace swayaw::core::detail
