#include "swayaw/core/channel.hpp"

#include <algorithm>

#include "swayaw/core/angle.hpp"

namespace swayaw {
namespace {

constexpr double degree = pi / 180.0;
constexpr double knot = 1852.0 / 3600.0;
constexpr double minute = 60.0;

constexpr Column columns[] = {
    {"x_m", Channel::x, 1.0},
    {"y_m", Channel::y, 1.0},
    {"psi_rad", Channel::psi, 1.0},
    {"psi_deg", Channel::psi, degree},
    {"u_m_s", Channel::u, 1.0},
    {"u_kn", Channel::u, knot},
    {"v_m_s", Channel::v, 1.0},
    {"v_kn", Channel::v, knot},
    {"ug_m_s", Channel::u_ground, 1.0},
    {"ug_kn", Channel::u_ground, knot},
    {"vg_m_s", Channel::v_ground, 1.0},
    {"vg_kn", Channel::v_ground, knot},
    {"stw_m_s", Channel::speed_through_water, 1.0},
    {"stw_kn", Channel::speed_through_water, knot},
    {"sog_m_s", Channel::speed_over_ground, 1.0},
    {"sog_kn", Channel::speed_over_ground, knot},
    {"cog_rad", Channel::course_over_ground, 1.0},
    {"cog_deg", Channel::course_over_ground, degree},
    {"r_rad_s", Channel::r, 1.0},
    {"r_deg_s", Channel::r, degree},
    {"r_deg_min", Channel::r, degree / minute},
    {"delta_rad", Channel::delta, 1.0},
    {"delta_deg", Channel::delta, degree},
    {"delta_order_rad", Channel::delta_order, 1.0},
    {"delta_order_deg", Channel::delta_order, degree},
    {"rev_s", Channel::rev, 1.0},
    {"rev_rpm", Channel::rev, 1.0 / minute},
    {"thrust_N", Channel::thrust, 1.0},
    {"thrust_kN", Channel::thrust, 1000.0},
    {"torque_N_m", Channel::torque, 1.0},
    {"torque_kN_m", Channel::torque, 1000.0},
    {"phi_rad", Channel::phi, 1.0},
    {"phi_deg", Channel::phi, degree},
    {"wind_speed_m_s", Channel::wind_speed, 1.0},
    {"wind_speed_kn", Channel::wind_speed, knot},
    {"wind_from_rad", Channel::wind_from, 1.0},
    {"wind_from_deg", Channel::wind_from, degree},
};

}  // namespace

std::span<const Column> known_columns() { return columns; }

std::optional<Column> column_named(std::string_view name) {
  const auto found = std::ranges::find(columns, name, &Column::name);
  if (found == std::end(columns)) return std::nullopt;
  return *found;
}

std::string_view column_name(Channel channel) { return std::ranges::find(columns, channel, &Column::channel)->name; }

namespace {

/// In the order of the channels.
constexpr std::array<std::string_view, channel_count> short_names{
    "x", "y",     "psi",         "u",   "v",      "ug",     "vg",  "stw",        "sog",      "cog",
    "r", "delta", "delta_order", "rev", "thrust", "torque", "phi", "wind_speed", "wind_from"};

}  // namespace

std::string_view short_name(Channel channel) { return short_names[index_of(channel)]; }

std::optional<Channel> channel_named(std::string_view name) {
  const auto found = std::ranges::find(short_names, name);
  if (found != short_names.end()) return static_cast<Channel>(found - short_names.begin());
  const auto column = column_named(name);
  return column ? std::optional(column->channel) : std::nullopt;
}

}  // namespace swayaw
