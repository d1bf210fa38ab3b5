#pragma once

#include <optional>
#include <string_view>

namespace swayaw::inline core::detail {

/// Latitude or longitude as a cell shows it.
struct PositionCell {
  double value;      ///< in degrees, or in degrees and minutes like 5332.123; south and west negative
  int parts;         ///< numbers in the cell: degrees, minutes, seconds
  char side = '\0';  ///< N, S, E or W, where it is written
};

/// 53°32.123'N, N 53 32 07.4, 53-32.123N, 5332.123N, 53.5353.
std::optional<PositionCell> position_cell(std::string_view cell);

/// 5332.123, degrees and minutes in one number, in degrees.
double from_degrees_and_minutes(double value);

}  // namespace swayaw::core::detail
