#pragma once

#include <optional>
#include <string>
#include <vector>

#include "column_map.hpp"
#include "column_names.hpp"
#include "survey.hpp"
#include "table_layout.hpp"
#include "times.hpp"

namespace swayaw::inline core::detail {

/// How the cells of a column are written.
enum class CellForm {
  number,
  sided,  ///< "S 10.5", "10 stbd": starboard positive
  position,
  degrees_and_minutes,
};

/// What one column of the raw files becomes.
struct PlannedColumn {
  std::size_t source;
  std::optional<Quantity> quantity = {};
  std::optional<Unit> unit = {};
  ShipSide side = ShipSide::none;
  std::string rudder_positive = {};  ///< as its name says
  std::string target = {};           ///< column of the recording; empty where it is kept as it is, or left out
  bool is_settled = false;           ///< by the column map, or by the name of a recording's column
  bool is_left_out = false;
  double factor = 1.0;  ///< value of one in the unit of the target
  CellForm form = CellForm::number;
  std::optional<std::size_t> twin = {};        ///< source of the other side: the mean, of forces and moments the sum
  std::optional<std::size_t> hemisphere = {};  ///< source of N and S, or E and W
  std::string why = {};
};

/// Everything that is known of the raw files before their rows are written.
struct RawTables {
  std::vector<RawTable> tables;  ///< with the same columns
  Survey survey;
  std::vector<NumberRules> rules;  ///< of each column

  std::size_t columns() const { return tables.front().header.size(); }
  std::string shown_name(std::size_t column) const { return tables.front().shown_name(column); }
  FilePlace header_place(std::size_t column) const;
};

/// What the columns are, by the column map, by the names of recordings' columns, and by all other names.
/// @throws FileError  where heading or rudder are not there, or the column map names a column that is not
std::vector<PlannedColumn> named_columns(const RawTables& raw, const ColumnMap& map);

/// Columns that may tell the time, the most telling first.
/// @throws FileError  if none does
std::vector<TimeColumns> time_candidates(const RawTables& raw, const std::vector<PlannedColumn>& columns,
                                         const ColumnMap& map);

/// One column for each quantity: the mean of two sides, or the column with most samples.
void choose_among_equals(const RawTables& raw, std::vector<PlannedColumn>& columns);

/// One position: latitude and longitude together, or metres north and east.
void choose_position(std::vector<PlannedColumn>& columns);

/// Refuses a file without heading or rudder.
void require_heading_and_rudder(const RawTables& raw, const std::vector<PlannedColumn>& columns);

/// Target and factor of each column: by name, by units, and by values where these leave no doubt.
/// @param time  of all rows [s]; NaN where a row is left out
/// @throws FileError  where units stay open, or values cannot be what the name says
void choose_units(const RawTables& raw, std::vector<PlannedColumn>& columns, const std::vector<double>& time);

/// Refuses a value that the quantity cannot have: a mark for a missing one, or a wrong name.
void require_sense(const RawTables& raw, const PlannedColumn& column);

/// A number as the column shows it, in degrees where it is a position.
struct CellValue {
  double value;
  CellKind kind;
};
CellValue value_in(std::string_view cell, const NumberRules& rules, CellForm form);

/// Whether cells of the column name the side of an angle.
bool has_sides(const ColumnSurvey& column, const NumberRules& rules);

/// The numbers of a column in all files; NaN where there is none.
std::vector<double> values_of(const RawTables& raw, const PlannedColumn& column);

}  // namespace swayaw::core::detail
