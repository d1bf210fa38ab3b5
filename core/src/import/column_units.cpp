#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "column_kinematics.hpp"
#include "column_plan.hpp"
#include "position_cell.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/channel.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr double turn_rad = 2.0 * pi;

/// The column of recordings that has the unit, else the one in SI.
struct Target {
  std::string column;
  double factor;
};

Target target_of(Quantity quantity, const Unit& unit) {
  const std::string name(facts_of(quantity).column);
  if (quantity == Quantity::latitude || quantity == Quantity::longitude) return {name + "_deg", unit.si / radians(1.0)};
  if (!unit.suffix.empty() && column_named(name + std::string(unit.suffix)))
    return {name + std::string(unit.suffix), 1.0};
  return {std::string(column_name(*channel_named(name))), unit.si};
}

class UnitChooser {
 public:
  UnitChooser(const RawTables& raw, std::vector<PlannedColumn>& columns, const std::vector<double>& time)
      : raw_(raw), columns_(columns), time_(time) {}

  void run() {
    for (auto& c : columns_)
      if (is_channel(c)) take_written_unit(c);
    for (auto& c : columns_)
      if (is_channel(c) && !c.unit) c.unit = of_own_values(c);
    // twice, as one column may wait for another
    for (int round = 0; round < 2; ++round)
      for (auto& c : columns_)
        if (is_channel(c) && !c.unit) c.unit = of_other_columns(c);
    for (auto& c : columns_)
      if (is_channel(c)) settle(c);
  }

 private:
  const ColumnSurvey& survey(const PlannedColumn& c) const { return raw_.survey.columns[c.source]; }
  static Measure measure(const PlannedColumn& c) { return facts_of(*c.quantity).measure; }
  static bool is_position(const PlannedColumn& c) {
    return c.quantity == Quantity::latitude || c.quantity == Quantity::longitude;
  }
  static bool is_bearing(const PlannedColumn& c) {
    return c.quantity == Quantity::heading || c.quantity == Quantity::course || c.quantity == Quantity::wind_from;
  }
  /// Whether the column becomes one of a recording's, time apart.
  static bool is_channel(const PlannedColumn& c) {
    return c.quantity && !c.is_left_out && *c.quantity != Quantity::time && *c.quantity != Quantity::date &&
           !facts_of(*c.quantity).column.empty();
  }
  std::string shown_name(const PlannedColumn& c) const { return shown(raw_.shown_name(c.source)); }

  [[noreturn]] void fail(const ShownCell& cell, std::string_view what) const {
    throw FileError({cell.file, cell.place.line, cell.place.column}, what);
  }

  static void keep(PlannedColumn& c, std::string why) {
    c.quantity.reset();
    c.target.clear();
    c.why = std::move(why);
  }

  // -------------------------------------------------------------- written units

  void take_written_unit(PlannedColumn& c) {
    if (is_position(c)) return take_position(c);
    const bool rudder = c.quantity == Quantity::rudder || c.quantity == Quantity::rudder_order;
    if (rudder && has_sides(survey(c), raw_.rules[c.source])) return take_sides(c);
    if (survey(c).texts > 0)
      fail(*survey(c).first_text,
           fmt::format("\"{}\" in column {} is not a number", survey(c).first_text->text, shown_name(c)));
    take_unit_of_cells(c);
    if (c.is_settled) return;
    if (c.unit && c.unit->measure != measure(c))
      keep(c, fmt::format("{} by its name, but in {}", facts_of(*c.quantity).shown, c.unit->shown));
  }

  /// "S 10.5" and "P 3": angles with the letter of their side.
  void take_sides(PlannedColumn& c) {
    c.form = CellForm::sided;
    c.rudder_positive = "starboard";
    if (!c.unit) c.unit = unit_named("deg");
    c.why += ", starboard positive by the letters of its cells";
  }

  /// "12.5 kn": the unit behind all numbers, which must be that of the name if that has one.
  void take_unit_of_cells(PlannedColumn& c) const {
    const auto& s = survey(c);
    const auto& odd = s.first_other_unit ? s.first_other_unit : s.first_number;
    const auto unit = unit_named(s.unit);
    const bool same = c.unit ? unit && unit->si == c.unit->si : unit.has_value();
    if (s.unit.empty() && !s.first_other_unit) return;
    if (s.first_other_unit || !same)
      fail(*odd,
           fmt::format("\"{}\" in column {} is not a number in the unit of the column", odd->text, shown_name(c)));
    if (!c.unit) c.why += ", unit by its cells";
    c.unit = unit;
  }

  /// Degrees, degrees and minutes in text, or both in one number.
  void take_position(PlannedColumn& c) {
    const auto& s = survey(c);
    if (s.texts > 0 || !s.unit.empty()) c.form = CellForm::position;
    if (!c.unit || c.unit->measure != Measure::angle) c.unit = unit_named("deg");
    take_hemisphere(c);
    bool minutes = false;
    for (const auto& other : columns_)
      if (is_channel(other) && is_position(other)) minutes = minutes || is_in_minutes(other);
    if (minutes) c.form = CellForm::degrees_and_minutes;
    if (minutes) c.why += ", degrees and minutes";
  }

  /// A column of N and S, or E and W, behind that of the numbers.
  void take_hemisphere(PlannedColumn& c) {
    if (c.source + 1 >= columns_.size() || c.form == CellForm::position) return;
    auto& next = columns_[c.source + 1];
    const auto& s = survey(next);
    const auto* text = s.numbers == 0 && s.first_text ? &s.first_text->text : nullptr;
    const std::string_view sides = c.quantity == Quantity::latitude ? "NS" : "EW";
    if (!text || text->size() != 1 || sides.find(*text) == std::string_view::npos || next.is_settled) return;
    c.hemisphere = next.source;
    c.form = CellForm::position;
    next.is_left_out = true;
    next.why = fmt::format("side of {}", shown_name(c));
  }

  /// Latitudes beyond 90 and longitudes beyond 360 are 5332.123, degrees and minutes in one.
  bool is_in_minutes(const PlannedColumn& c) const {
    const double most = c.quantity == Quantity::latitude ? 90.0 : 360.0;
    if (survey(c).numbers > 0) return survey(c).largest() > most;
    const auto& text = survey(c).first_text;
    const auto found = text ? position_cell(text->text) : std::nullopt;
    return found && found->parts == 1 && std::abs(found->value) > most;
  }

  // -------------------------------------------------------------- units by values

  std::optional<Unit> decided(PlannedColumn& c, std::string_view unit, std::string_view by) {
    c.why += fmt::format(", {} {}", unit, by);
    return unit_named(unit);
  }

  std::optional<Unit> of_own_values(PlannedColumn& c) {
    const auto& s = survey(c);
    if (measure(c) == Measure::length) return decided(c, "m", "as no unit is written");
    if (c.quantity == Quantity::shaft_speed && s.largest() > facts_of(*c.quantity).most)
      return decided(c, "rpm", "by its values");
    if (measure(c) != Measure::angle) return std::nullopt;
    if (!is_bearing(c)) {
      // an angle of a part of the ship is below a right angle
      constexpr double right_angle = 0.5 * pi;
      return s.largest() > right_angle * 1.01 ? decided(c, "deg", "by its values") : std::nullopt;
    }
    // a heading that passes north tells the turn that it counts to
    const bool of_rad = s.least > -turn_rad && s.most < 1.001 * turn_rad && s.longest_step > 0.8 * turn_rad;
    if (of_rad) return decided(c, "rad", "as it passes north");
    constexpr double six_turns_rad = 6.0 * turn_rad;  // more than any manoeuvre turns
    return s.largest() > six_turns_rad ? decided(c, "deg", "by its values") : std::nullopt;
  }

  const PlannedColumn* column_of(Quantity quantity) const {
    const auto found =
        std::ranges::find_if(columns_, [&](const auto& c) { return is_channel(c) && c.quantity == quantity; });
    return found == columns_.end() ? nullptr : &*found;
  }

  std::optional<Unit> of_other_columns(PlannedColumn& c) {
    if (c.quantity == Quantity::yaw_rate || c.quantity == Quantity::heading)
      if (auto unit = of_kinematics(c)) return unit;
    if (measure(c) == Measure::speed && c.quantity != Quantity::wind_speed) return of_speeds(c);
    if (measure(c) == Measure::angle) return of_other_angles(c);
    return std::nullopt;
  }

  /// dψ/dt = r holds in one pair of units only; a wrong scale of an instrument is less than a quarter.
  std::optional<Unit> of_kinematics(PlannedColumn& c) {
    const auto *psi = column_of(Quantity::heading), *r = column_of(Quantity::yaw_rate);
    if (!psi || !r || time_.size() < 3) return std::nullopt;
    const bool heading_asked = &c == psi;
    const auto known = heading_asked ? r->unit : psi->unit;
    if (!known) return std::nullopt;
    const auto psi_values = values_of(raw_, *psi), r_values = values_of(raw_, *r);
    const std::string_view candidates[] = {heading_asked ? "deg" : "deg/s", heading_asked ? "rad" : "deg/min",
                                           heading_asked ? "rad" : "rad/s"};
    for (const auto name : candidates) {
      const auto unit = unit_named(name);
      const auto& psi_unit = heading_asked ? unit : known;
      const auto ratio = yaw_rate_ratio(time_, psi_values, turn_rad / psi_unit->si, r_values);
      if (!ratio) continue;
      const double r_si = heading_asked ? known->si : unit->si;
      if (const double scale = *ratio * r_si / psi_unit->si; scale > 0.75 && scale < 1.25)
        return decided(c, unit->shown,
                       heading_asked ? "as it changes with the yaw rate" : "as the heading changes with it");
    }
    return std::nullopt;
  }

  double mean_size(const PlannedColumn& c) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (const double value : values_of(raw_, c))
      if (std::isfinite(value)) sum += std::abs(value), ++count;
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }

  /// A speed of known unit, or the speed along the track [m/s].
  std::optional<double> reference_speed() const {
    for (const auto q : {Quantity::ground_speed, Quantity::log_speed, Quantity::surge, Quantity::ground_surge})
      if (const auto* c = column_of(q); c && c->unit) return mean_size(*c) * c->unit->si;
    const auto *lat = column_of(Quantity::latitude), *lon = column_of(Quantity::longitude);
    const auto *x = column_of(Quantity::north), *y = column_of(Quantity::east);
    if (lat && lon) return track_speed(time_, values_of(raw_, *lat), values_of(raw_, *lon), true);
    if (x && y && x->unit && y->unit) return track_speed(time_, values_of(raw_, *x), values_of(raw_, *y), false);
    return std::nullopt;
  }

  /// Knots and metres a second differ by 1.94; current and drift by less than a quarter where the unit can be told.
  std::optional<Unit> of_speeds(PlannedColumn& c) {
    const auto reference = reference_speed();
    if (!reference || c.quantity == Quantity::sway || c.quantity == Quantity::ground_sway) return same_as_surge(c);
    const double mean = mean_size(c);
    for (const std::string_view name : {"kn", "m/s"})
      if (const double scale = mean * unit_named(name)->si / *reference; scale > 0.75 && scale < 1.25)
        return decided(c, name, "as other speeds and the track show");
    return std::nullopt;
  }

  std::optional<Unit> same_as_surge(PlannedColumn& c) {
    const auto* surge = column_of(c.quantity == Quantity::sway ? Quantity::surge : Quantity::ground_surge);
    return surge && surge != &c && surge->unit ? decided(c, surge->unit->shown, "as the forward velocity")
                                               : std::nullopt;
  }

  /// Angles of one file have one unit, where the values allow it: a rudder below 1.6 is in rad if the heading is,
  /// a roll follows all others. A rudder below 1.6 beside a heading in degrees stays open.
  std::optional<Unit> of_other_angles(PlannedColumn& c) {
    const auto* other_rudder = c.quantity == Quantity::rudder         ? column_of(Quantity::rudder_order)
                               : c.quantity == Quantity::rudder_order ? column_of(Quantity::rudder)
                                                                      : nullptr;
    if (other_rudder && other_rudder->unit) return decided(c, other_rudder->unit->shown, "as the other rudder angle");
    bool deg = false, rad = false;
    for (const auto& other : columns_)
      if (&other != &c && is_channel(other) && measure(other) == Measure::angle && !is_position(other) && other.unit)
        (other.unit->si == 1.0 ? rad : deg) = true;
    if (deg == rad) return std::nullopt;
    if (rad) return survey(c).largest() < 2.0 * turn_rad ? decided(c, "rad", "as other angles are") : std::nullopt;
    const bool rudder = c.quantity == Quantity::rudder || c.quantity == Quantity::rudder_order;
    const bool may_be_rad = rudder || (is_bearing(c) && survey(c).largest() <= turn_rad);
    return may_be_rad ? std::nullopt : decided(c, "deg", "as other angles are");
  }

  // -------------------------------------------------------------- what comes of it

  void settle(PlannedColumn& c) {
    if (!c.unit) refuse_open_unit(c);
    auto [target, factor] = target_of(*c.quantity, *c.unit);
    if (!c.is_settled) c.target = std::move(target), c.factor = factor;
    require_sense(raw_, c);
  }

  [[noreturn]] void refuse_open_unit(const PlannedColumn& c) const {
    const auto [one, other] = usual_units(measure(c));
    const auto first = target_of(*c.quantity, *unit_named(one)), second = target_of(*c.quantity, *unit_named(other));
    const auto name = shown(raw_.tables.front().header[c.source].name);
    throw FileError(
        raw_.header_place(c.source),
        fmt::format("{} is {} without a unit, and its values up to {:.4g} may be {} or {}; [columns] \"{}\" = "
                    "\"{}\" or \"{}\" in the column map settles it",
                    shown_name(c), facts_of(*c.quantity).shown, survey(c).largest(), unit_named(one)->shown,
                    unit_named(other)->shown, name, first.column, second.column));
  }

  const RawTables& raw_;
  std::vector<PlannedColumn>& columns_;
  const std::vector<double>& time_;
};

}  // namespace

void choose_units(const RawTables& raw, std::vector<PlannedColumn>& columns, const std::vector<double>& time) {
  UnitChooser(raw, columns, time).run();
}

}  // namespace swayaw::core::detail
