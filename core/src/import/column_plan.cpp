#include "column_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "characters.hpp"
#include "position_cell.hpp"
#include "swayaw/core/channel.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

/// The quantity that a column of recordings holds.
std::optional<Quantity> quantity_of_column(std::string_view column) {
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Quantity::depth); ++i) {
    const auto quantity = static_cast<Quantity>(i);
    const auto name = facts_of(quantity).column;
    if (name.empty() || quantity == Quantity::magnetic_heading) continue;
    const auto known = column_named(column);
    if (known ? short_name(known->channel) == name
              : column == std::string(name) + (quantity == Quantity::time ? "_s" : "_deg"))
      return quantity;
  }
  return std::nullopt;
}

PlannedColumn settled(std::size_t i, const std::string& target, std::string why) {
  PlannedColumn column{.source = i, .quantity = quantity_of_column(target), .target = target, .is_settled = true};
  column.unit = unit_of_column(target);
  if (column.quantity == Quantity::latitude || column.quantity == Quantity::longitude) column.unit = unit_named("deg");
  column.why = std::move(why);
  return column;
}

PlannedColumn left_out(std::size_t i, std::string why) {
  PlannedColumn column{.source = i, .is_left_out = true};
  column.why = std::move(why);
  return column;
}

PlannedColumn planned_column(const RawTables& raw, std::size_t i, const ColumnMap& map) {
  const auto& header = raw.tables.front().header[i];
  const auto& survey = raw.survey.columns[i];
  const auto shown_name = raw.shown_name(i);
  if (map.ignores(header.name) || map.ignores(shown_name)) return left_out(i, "ignored by the column map");
  const auto* mapped = map.of(header.name);
  if (!mapped) mapped = map.of(shown_name);
  if (survey.samples() == 0) return left_out(i, "no values");
  if (mapped) return settled(i, mapped->target, "by the column map");
  if (is_recording_column(header.name)) return settled(i, header.name, "by its name");
  auto named = named_column(header.name, header.units);
  PlannedColumn column{.source = i, .quantity = named.quantity, .unit = named.unit, .side = named.side};
  column.rudder_positive = std::move(named.rudder_positive);
  if (!column.quantity) return column;
  column.why = facts_of(*column.quantity).shown;
  const bool of_text = survey.numbers == 0 && !has_sides(survey, raw.rules[i]) &&
                       facts_of(*column.quantity).measure != Measure::time && column.quantity != Quantity::date &&
                       column.quantity != Quantity::latitude && column.quantity != Quantity::longitude;
  if (of_text) column.quantity.reset(), column.why += " by its name, but of text";
  return column;
}

void require_map_columns(const RawTables& raw, const ColumnMap& map) {
  const auto is_there = [&](const std::string& name) {
    for (std::size_t i = 0; i < raw.columns(); ++i)
      if (name == raw.tables.front().header[i].name || name == raw.shown_name(i)) return true;
    return false;
  };
  for (const auto* list : {&map.columns, &map.ignored})
    for (const auto& column : *list)
      if (!is_there(column.source))
        throw FileError(column.place, fmt::format("the files have no column \"{}\"", shown(column.source)));
}

bool is(const PlannedColumn& column, Quantity quantity) { return !column.is_left_out && column.quantity == quantity; }

bool has(const std::vector<PlannedColumn>& columns, Quantity quantity) {
  return std::ranges::any_of(columns, [&](const auto& c) { return is(c, quantity); });
}

std::string map_line(const RawTables& raw, const PlannedColumn& column, std::string_view target) {
  return fmt::format("[columns] \"{}\" = \"{}\"", shown(raw.tables.front().header[column.source].name), target);
}

/// Kept as it is.
void keep(PlannedColumn& column, std::string why) {
  column.quantity.reset();
  column.target.clear();
  column.why = std::move(why);
}

/// "n" is the shaft speed in papers, and north beside an east.
void settle_n(const RawTables& raw, const std::vector<PlannedColumn>& columns, PlannedColumn& c) {
  const bool alone = lower_case(raw.tables.front().header[c.source].name) == "n" && !c.unit;
  if (!alone || has(columns, Quantity::north) || !has(columns, Quantity::east)) return;
  c.quantity = Quantity::north;
  c.why = fmt::format("{}, beside the east", facts_of(Quantity::north).shown);
}

void settle_speed(const RawTables& raw, const std::vector<PlannedColumn>& columns, PlannedColumn& c) {
  if (has(columns, Quantity::log_speed) || has(columns, Quantity::ground_speed))
    return keep(c, "a speed, through the water or over ground is not said");
  const auto other = map_line(raw, c, c.unit && c.unit->si == 1.0 ? "stw_m_s" : "stw_kn");
  c.quantity = Quantity::ground_speed;
  c.why = fmt::format("speed, over ground as the name does not say; {} in the column map if through the water", other);
}

void settle_magnetic(const std::vector<PlannedColumn>& columns, PlannedColumn& c) {
  if (has(columns, Quantity::heading)) return keep(c, "magnetic heading, beside another heading");
  c.quantity = Quantity::heading;
  c.why = "magnetic heading, the only one: its zero is magnetic north";
}

/// Kept, as the name says too little; the line of the column map tells more.
void keep_open(const RawTables& raw, PlannedColumn& c, std::string_view what, std::string_view target) {
  keep(c, fmt::format("{} is not said; {} in the column map takes it", what, map_line(raw, c, target)));
}

/// Names that leave open which of two quantities is meant.
void settle_unsaid(const RawTables& raw, std::vector<PlannedColumn>& columns) {
  for (auto& c : columns) {
    if (!c.quantity || c.is_left_out || c.is_settled) continue;
    switch (*c.quantity) {
      case Quantity::shaft_speed: settle_n(raw, columns, c); break;
      case Quantity::speed_unsaid: settle_speed(raw, columns, c); break;
      case Quantity::magnetic_heading: settle_magnetic(columns, c); break;
      case Quantity::course_unsaid: keep_open(raw, c, "a course, of the bow or over ground", "cog_deg"); break;
      case Quantity::wind_speed_unsaid: keep_open(raw, c, "a wind, true or relative", "wind_speed_m_s"); break;
      case Quantity::wind_from_unsaid: keep_open(raw, c, "a wind, true or relative", "wind_from_deg"); break;
      case Quantity::relative_wind_speed:
      case Quantity::relative_wind_angle: keep(c, "relative wind, which recordings have no column for"); break;
      default: break;
    }
  }
}

bool is_sum(Quantity q) { return q == Quantity::thrust || q == Quantity::torque; }

/// The two sides of one quantity as one.
void join_sides(const RawTables& raw, PlannedColumn& port, PlannedColumn& starboard) {
  const bool port_first = port.source < starboard.source;
  auto& first = port_first ? port : starboard;
  auto& second = port_first ? starboard : port;
  first.twin = second.source;
  first.why = fmt::format("{}, {} with {}", facts_of(*first.quantity).shown, is_sum(*first.quantity) ? "sum" : "mean",
                          raw.shown_name(second.source));
  second.why = fmt::format("part of {}", raw.shown_name(first.source));
  second.is_left_out = true;
}

void choose_of(const RawTables& raw, std::vector<PlannedColumn*>& same) {
  const auto of_side = [&](ShipSide side) {
    const auto found = std::ranges::find(same, side, [](const auto* c) { return c->side; });
    return found == same.end() ? nullptr : *found;
  };
  const auto settled_one = std::ranges::find_if(same, [](const auto* c) { return c->is_settled; });
  auto* chosen = settled_one != same.end() ? *settled_one : of_side(ShipSide::none);
  auto *port = of_side(ShipSide::port), *starboard = of_side(ShipSide::starboard);
  if (!chosen && port && starboard && same.size() == 2) return join_sides(raw, *port, *starboard);
  const auto samples = [&](const auto* c) { return raw.survey.columns[c->source].samples(); };
  if (settled_one == same.end() && (!chosen || same.size() > 1))
    for (auto* c : same)
      if ((!chosen || c->side == chosen->side) && (!chosen || samples(c) > samples(chosen))) chosen = c;
  for (auto* c : same)
    if (c != chosen && c->is_settled)
      throw FileError(raw.header_place(c->source),
                      fmt::format("{} and {} both give the {}; ignore = [\"...\"] in the column map "
                                  "leaves one out",
                                  shown(raw.shown_name(chosen->source)), shown(raw.shown_name(c->source)),
                                  facts_of(*c->quantity).shown));
    else if (c != chosen)
      keep(*c,
           fmt::format("{}, as {} is, which is taken", facts_of(*c->quantity).shown, raw.shown_name(chosen->source)));
}

}  // namespace

FilePlace RawTables::header_place(std::size_t column) const {
  const auto& [name, units, place] = tables.front().header[column];
  return {tables.front().file, place.line, place.column};
}

std::vector<PlannedColumn> named_columns(const RawTables& raw, const ColumnMap& map) {
  require_map_columns(raw, map);
  std::vector<PlannedColumn> columns;
  for (std::size_t i = 0; i < raw.columns(); ++i) columns.push_back(planned_column(raw, i, map));
  settle_unsaid(raw, columns);
  return columns;
}

void choose_among_equals(const RawTables& raw, std::vector<PlannedColumn>& columns) {
  for (std::size_t q = static_cast<std::size_t>(Quantity::heading); q <= static_cast<std::size_t>(Quantity::depth);
       ++q) {
    std::vector<PlannedColumn*> same;
    for (auto& c : columns)
      if (is(c, static_cast<Quantity>(q))) same.push_back(&c);
    if (same.size() > 1) choose_of(raw, same);
  }
}

void choose_position(std::vector<PlannedColumn>& columns) {
  const auto all = [&](Quantity one, Quantity other) { return has(columns, one) && has(columns, other); };
  const auto is_settled = [](const auto& c) {
    return c.is_settled && (is(c, Quantity::north) || is(c, Quantity::east));
  };
  const bool degrees = all(Quantity::latitude, Quantity::longitude) && std::ranges::none_of(columns, is_settled);
  const bool metres = has(columns, Quantity::north) || has(columns, Quantity::east);
  for (auto& c : columns) {
    if (!degrees && (is(c, Quantity::latitude) || is(c, Quantity::longitude)))
      keep(c, metres ? "a position, beside another in metres" : "half of a position");
    if (degrees && (is(c, Quantity::north) || is(c, Quantity::east)))
      keep(c, "a position, beside latitude and longitude");
  }
}

void require_heading_and_rudder(const RawTables& raw, const std::vector<PlannedColumn>& columns) {
  std::string others;
  for (const auto& c : columns)
    if (!c.quantity && !c.is_left_out && others.size() < 120)
      others += fmt::format("{}\"{}\"", others.empty() ? "" : ", ", shown(raw.shown_name(c.source)));
  auto open = others.empty() ? std::string{} : fmt::format("; not understood: {}", others);
  for (const auto& c : columns)
    if (c.is_left_out && raw.survey.columns[c.source].samples() == 0)
      open += fmt::format("; \"{}\" has no values", shown(raw.shown_name(c.source)));
  if (!has(columns, Quantity::heading))
    throw FileError(raw.header_place(0),
                    fmt::format("no column is known as the heading{}; [columns] \"...\" = \"psi_deg\" "
                                "in the column map names it",
                                open));
  if (!has(columns, Quantity::rudder) && !has(columns, Quantity::rudder_order))
    throw FileError(raw.header_place(0), fmt::format("no column is known as the rudder angle{}; [columns] \"...\" = "
                                                     "\"delta_deg\" in the column map names it",
                                                     open));
}

namespace {

/// "S 10.5", "10.5 stbd", "P10": starboard positive.
std::optional<double> sided_value(std::string_view cell, const NumberRules& rules) {
  const auto first = std::ranges::find_if(cell, is_digit);
  const auto last = std::find_if(cell.rbegin(), cell.rend(), is_digit);
  if (first == cell.end()) return std::nullopt;
  const auto before = static_cast<std::size_t>(first - cell.begin()),
             behind = static_cast<std::size_t>(last - cell.rbegin());
  const auto number = number_cell(cell.substr(before, cell.size() - before - behind), rules);
  const auto side = side_named(trimmed(before > 0 ? cell.substr(0, before) : cell.substr(cell.size() - behind)), true);
  if (!number || side == ShipSide::none || (before > 0 && behind > 0)) return std::nullopt;
  return side == ShipSide::starboard ? number->value : -number->value;
}

}  // namespace

bool has_sides(const ColumnSurvey& column, const NumberRules& rules) {
  const auto& sample = column.first_text         ? column.first_text
                       : column.first_other_unit ? column.first_other_unit
                                                 : column.first_number;
  return sample && sided_value(sample->text, rules);
}

CellValue value_in(std::string_view cell, const NumberRules& rules, CellForm form) {
  NumberCell number;
  auto kind = read_cell(cell, rules, number);
  double value = kind == CellKind::number ? number.value : std::numeric_limits<double>::quiet_NaN();
  if (form == CellForm::number || kind == CellKind::missing) return {value, kind};
  if (form == CellForm::sided) {
    if (const auto sided = sided_value(cell, rules)) return {*sided, CellKind::number};
    return {value, value == 0.0 ? kind : CellKind::text};
  }
  if (const auto position = position_cell(cell)) value = position->value, kind = CellKind::number;
  return {form == CellForm::degrees_and_minutes ? from_degrees_and_minutes(value) : value, kind};
}

std::vector<double> values_of(const RawTables& raw, const PlannedColumn& column) {
  std::vector<double> values;
  values.reserve(raw.survey.rows);
  for (const auto& table : raw.tables) {
    SampleRows rows(table);
    while (rows.next())
      values.push_back(value_in(rows.cells()[column.source], raw.rules[column.source], column.form).value);
  }
  return values;
}

}  // namespace swayaw::core::detail
