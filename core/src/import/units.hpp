#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace swayaw::inline core::detail {

/// What a unit measures, as far as recordings know it.
enum class Measure { angle, yaw_rate, speed, length, frequency, time, force, moment, none };

/// A unit as people write it.
struct Unit {
  std::string_view written;  ///< in small letters where its size does not matter
  Measure measure;
  double si;                ///< value of one in SI and radians
  std::string_view suffix;  ///< of the recording's columns, "_deg"; empty where no column has the unit
  std::string_view shown;   ///< to people
};

/// The unit of a text such as "°", "deg/min", "kts", "1/min", without brackets.
std::optional<Unit> unit_named(std::string_view text);

/// The two units that a measure is most often in.
std::array<std::string_view, 2> usual_units(Measure measure);

/// The unit of a column of recordings: "psi_deg".
std::optional<Unit> unit_of_column(std::string_view column);

}  // namespace swayaw::core::detail
