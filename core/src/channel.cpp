#include "swayaw/core/channel.hpp"

#include <algorithm>
#include <vector>

#include "swayaw/core/channel_table.hpp"

namespace swayaw::inline core {
namespace {

constexpr auto names = detail::of_each_channel([](const auto& row) { return row.name; });
constexpr auto plain_names = detail::of_each_channel([](const auto& row) { return row.words; });
constexpr auto dimensions = detail::of_each_channel([](const auto& row) { return row.dimension; });
constexpr auto units = detail::of_each_channel([](const auto& row) { return row.columns; });

/// The columns of all channels, one after the other.
std::vector<Column> all_columns() {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < channel_count; ++i)
    for (const auto& c : {units[i].first, units[i].second, units[i].third})
      if (!c.name.empty()) columns.push_back({c.name, static_cast<Channel>(i), c.si});
  return columns;
}

std::vector<Channel> all_that_show_motion() {
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < channel_count; ++i)
    if (shows_motion(static_cast<Channel>(i))) channels.push_back(static_cast<Channel>(i));
  return channels;
}

}  // namespace

Dimension dimension_of(Channel channel) { return dimensions[index_of(channel)]; }

bool is_direction(Channel channel) { return dimension_of(channel) == Dimension::bearing; }

bool shows_motion(Channel channel) { return detail::observers<double>[index_of(channel)] != nullptr; }

std::span<const Channel> motion_channels() {
  static const auto channels = all_that_show_motion();
  return channels;
}

double unit_of(Channel channel, double L, double U) {
  switch (dimension_of(channel)) {
    case Dimension::length: return L;
    case Dimension::speed: return U;
    case Dimension::yaw_rate: return U / L;
    default: return 1.0;
  }
}

std::span<const Column> known_columns() {
  static const auto columns = all_columns();
  return columns;
}

std::optional<Column> column_named(std::string_view name) {
  const auto found = std::ranges::find(known_columns(), name, &Column::name);
  return found == known_columns().end() ? std::nullopt : std::optional(*found);
}

std::string_view column_name(Channel channel) { return units[index_of(channel)].first.name; }

std::string_view short_name(Channel channel) { return names[index_of(channel)]; }

std::string_view plain_name(Channel channel) { return plain_names[index_of(channel)]; }

std::optional<Channel> channel_named(std::string_view name) {
  if (const auto found = std::ranges::find(names, name); found != names.end())
    return static_cast<Channel>(found - names.begin());
  const auto column = column_named(name);
  return column ? std::optional(column->channel) : std::nullopt;
}

}  // namespace swayaw::core
