#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/channel.hpp"
#include "swayaw/core/motion.hpp"

/// Everything that is known of a channel, in one row: its names, what kind of quantity it is, its columns in recording
/// files with the SI value of their units, and what it shows of the motion of a ship. A new channel is a row here, in
/// the order of the enumerators.
namespace swayaw::inline core {

/// What an instrument at a point of the ship can look at.
template <class S = double>
struct Kinematics {
  ShipState<S> state;      ///< position of the point, heading, motion of midship through the water
  PlanarMotion<S> ground;  ///< velocity of the point over ground in body axes
  S phi{};                 ///< heel, starboard side down [rad]
};

namespace detail {

inline constexpr double degree = pi / 180.0;
inline constexpr double knot = 1852.0 / 3600.0;

/// A channel that shows no motion: controls, weather.
struct NoMotion {};

/// A column name and the SI value of its unit.
struct UnitColumn {
  std::string_view name{};
  double si = 1.0;
};

/// Columns of a channel, that in SI first.
struct UnitColumns {
  UnitColumn first{}, second{}, third{};
};

template <Channel Which, class Observer>
struct ChannelRow {
  static constexpr Channel channel = Which;
  std::string_view name;
  std::string_view words;  ///< what sentences call it
  Dimension dimension;
  UnitColumns columns;
  Observer observer;
};

template <Channel Which, class Observer = NoMotion>
constexpr ChannelRow<Which, Observer> row(std::string_view name, std::string_view words, Dimension dimension,
                                          UnitColumns columns, Observer observer = {}) {
  return {name, words, dimension, columns, observer};
}

/// Rows, one after the other; std::tuple would take the compiler half a second wherever a ship is.
template <class... Row>
struct ChannelRows : Row... {};

template <class... Row>
ChannelRows(Row...) -> ChannelRows<Row...>;

inline constexpr ChannelRows channel_table{
    row<Channel::x>("x", "positions", Dimension::length, {{"x_m"}}, [](const auto& k) { return k.state.x; }),
    row<Channel::y>("y", "y", Dimension::length, {{"y_m"}}, [](const auto& k) { return k.state.y; }),
    row<Channel::psi>("psi", "heading", Dimension::bearing, {{"psi_rad"}, {"psi_deg", degree}},
                      [](const auto& k) { return k.state.psi; }),
    row<Channel::u>("u", "speed through the water", Dimension::speed, {{"u_m_s"}, {"u_kn", knot}},
                    [](const auto& k) { return k.state.motion.u; }),
    row<Channel::v>("v", "sway", Dimension::speed, {{"v_m_s"}, {"v_kn", knot}},
                    [](const auto& k) { return k.state.motion.v; }),
    row<Channel::u_ground>("ug", "speed over ground", Dimension::speed, {{"ug_m_s"}, {"ug_kn", knot}},
                           [](const auto& k) { return k.ground.u; }),
    row<Channel::v_ground>("vg", "sway over ground", Dimension::speed, {{"vg_m_s"}, {"vg_kn", knot}},
                           [](const auto& k) { return k.ground.v; }),
    row<Channel::speed_through_water>("stw", "log", Dimension::speed, {{"stw_m_s"}, {"stw_kn", knot}},
                                      [](const auto& k) { return k.state.motion.u; }),
    row<Channel::speed_over_ground>("sog", "sog", Dimension::speed, {{"sog_m_s"}, {"sog_kn", knot}},
                                    [](const auto& k) { return speed(k.ground); }),
    row<Channel::course_over_ground>("cog", "course over ground", Dimension::bearing,
                                     {{"cog_rad"}, {"cog_deg", degree}},
                                     [](const auto& k) { return k.state.psi + angle_of(k.ground.v, k.ground.u); }),
    row<Channel::r>("r", "yaw rate", Dimension::yaw_rate,
                    {{"r_rad_s"}, {"r_deg_s", degree}, {"r_deg_min", degree / 60.0}},
                    [](const auto& k) { return k.state.motion.r; }),
    row<Channel::delta>("delta", "rudder", Dimension::angle, {{"delta_rad"}, {"delta_deg", degree}}),
    row<Channel::delta_order>("delta_order", "rudder order", Dimension::angle,
                              {{"delta_order_rad"}, {"delta_order_deg", degree}}),
    row<Channel::rev>("rev", "shaft speed", Dimension::other, {{"rev_s"}, {"rev_rpm", 1.0 / 60.0}}),
    row<Channel::thrust>("thrust", "thrust", Dimension::other, {{"thrust_N"}, {"thrust_kN", 1000.0}}),
    row<Channel::torque>("torque", "torque", Dimension::other, {{"torque_N_m"}, {"torque_kN_m", 1000.0}}),
    row<Channel::phi>("phi", "heel", Dimension::angle, {{"phi_rad"}, {"phi_deg", degree}},
                      [](const auto& k) { return k.phi; }),
    row<Channel::wind_speed>("wind_speed", "wind speed", Dimension::speed,
                             {{"wind_speed_m_s"}, {"wind_speed_kn", knot}}),
    row<Channel::wind_from>("wind_from", "wind direction", Dimension::bearing,
                            {{"wind_from_rad"}, {"wind_from_deg", degree}}),
    row<Channel::depth>("depth", "water depth", Dimension::length, {{"depth_m"}}),
};

template <class... Row>
constexpr bool are_in_order(const ChannelRows<Row...>&) {
  constexpr std::array channels{Row::channel...};
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (channels[i] != static_cast<Channel>(i)) return false;
  return channels.size() == channel_count;
}

static_assert(are_in_order(channel_table), "one row for each enumerator, in their order");

/// f(row of the channel), for each channel in an array.
template <class F>
constexpr auto of_each_channel(F&& f) {
  return [&]<class... Row>(const ChannelRows<Row...>& rows) {
    return std::array{f(static_cast<const Row&>(rows))...};
  }(channel_table);
}

template <class S>
using Observer = S (*)(const Kinematics<S>&);

/// Observers of all channels; nullptr for those that show no motion.
template <class S>
inline constexpr auto observers = of_each_channel([](const auto& row) -> Observer<S> {
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(row.observer)>, NoMotion>) return nullptr;
  else return [](const Kinematics<S>& k) -> S { return std::remove_cvref_t<decltype(row.observer)>{}(k); };
});

}  // namespace detail

/// What a perfect instrument shows; the channel must be one of motion.
template <class S>
S observe(Channel channel, const Kinematics<S>& k) {
  return detail::observers<S>[index_of(channel)](k);
}

}  // namespace swayaw::core
