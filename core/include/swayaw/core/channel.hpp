#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace swayaw::inline core {

/// What a recording can hold. SI, radians, rudder positive to port; docs/notation.md tells axes and signs.
enum class Channel : std::size_t {
  x,                    ///< midship, earth-fixed, northward [m]
  y,                    ///< midship, earth-fixed, eastward [m]
  psi,                  ///< heading, unwrapped [rad]
  u,                    ///< surge of midship through the water [m/s]
  v,                    ///< sway of midship through the water [m/s]
  u_ground,             ///< surge of midship over ground [m/s]
  v_ground,             ///< sway of midship over ground [m/s]
  speed_through_water,  ///< forward speed from the log [m/s]
  speed_over_ground,    ///< [m/s]
  course_over_ground,   ///< [rad]
  r,                    ///< yaw rate [rad/s]
  delta,                ///< actual rudder angle, positive to port [rad]
  delta_order,          ///< ordered rudder angle, positive to port [rad]
  rev,                  ///< shaft speed [1/s]
  thrust,               ///< shaft thrust [N]
  torque,               ///< shaft torque [N m]
  phi,                  ///< roll, starboard side down positive [rad]
  wind_speed,           ///< true wind [m/s]
  wind_from,            ///< direction the true wind comes from [rad]
  depth,                ///< water depth at the sounder [m]
};

inline constexpr std::size_t channel_count = 20;

constexpr std::size_t index_of(Channel channel) { return static_cast<std::size_t>(channel); }

/// What kind of quantity a channel holds.
enum class Dimension {
  length,
  bearing,  ///< an angle on the earth: compared the short way round
  angle,    ///< of a part of the ship
  speed,
  yaw_rate,
  other,
};

Dimension dimension_of(Channel channel);

/// Whether errors of the channel are taken the short way round.
bool is_direction(Channel channel);

/// Whether the channel shows the motion of the ship, and not what drives her or the weather.
bool shows_motion(Channel channel);

/// The channels that show the motion of the ship.
std::span<const Channel> motion_channels();

/// A change of the channel that matters to a ship of length L at speed U: L, U, U/L, or 1 rad.
double unit_of(Channel channel, double L, double U);

/// A column of a recording file: its name, what it holds, and the SI value of one unit.
struct Column {
  std::string_view name;
  Channel channel;
  double si;
};

/// All columns that are understood; the SI column of a channel comes first.
std::span<const Column> known_columns();

/// The column of that name.
std::optional<Column> column_named(std::string_view name);

/// Name of the SI column of a channel, "psi_rad".
std::string_view column_name(Channel channel);

/// Name of a channel without its unit, "psi".
std::string_view short_name(Channel channel);

/// What sentences call the channel, or the instrument that shows it: "heading", "log".
std::string_view plain_name(Channel channel);

/// The channel of a short name or of a column.
std::optional<Channel> channel_named(std::string_view name);

}  // namespace swayaw::core
