#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "swayaw/core/channel.hpp"
#include "units.hpp"

namespace swayaw::inline core::detail {

/// What a column of a raw file can be.
enum class Quantity {
  time,
  date,
  heading,
  magnetic_heading,
  course,
  course_unsaid,
  yaw_rate,
  rudder,
  rudder_order,
  log_speed,
  ground_speed,
  speed_unsaid,
  latitude,
  longitude,
  north,
  east,
  surge,
  sway,
  ground_surge,
  ground_sway,
  shaft_speed,
  thrust,
  torque,
  roll,
  wind_speed,
  wind_from,
  wind_speed_unsaid,
  wind_from_unsaid,
  relative_wind_speed,
  relative_wind_angle,
  depth,
};

/// What is known of a quantity, in one row.
struct QuantityFacts {
  std::string_view shown;   ///< to people: "heading"
  std::string_view column;  ///< of the recording without its unit: "psi"; empty where none holds it
  Measure measure;
  double most;  ///< no sample is larger, in SI; 0: not known
};

const QuantityFacts& facts_of(Quantity quantity);

/// Side of the ship that a column is about.
enum class ShipSide { none, port, starboard };

/// The side that a word such as "stbd" or "Bb" names, or a letter where those may.
ShipSide side_named(std::string_view word, bool letters = false);

/// What the name of a column tells.
struct NamedColumn {
  std::optional<Quantity> quantity;
  std::optional<Unit> unit;
  ShipSide side = ShipSide::none;
  std::string rudder_positive = {};      ///< "port" or "starboard", of a name such as "Rudder [deg, stbd +]"
  std::optional<int> zone_minutes = {};  ///< of a name such as "UTC" or "Time (UTC+2)", east of UTC
};

/// @param name   "Kurs ü. Grund [°]"
/// @param units  cell of a row of units below it; empty if there is none
NamedColumn named_column(std::string_view name, std::string_view units);

/// The side named as positive in a text such as "stbd +" or "StB positiv"; empty if none is.
std::string positive_side_in(std::string_view text);

}  // namespace swayaw::core::detail
