#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace swayaw::inline core::detail {

using Microseconds = std::int64_t;
inline constexpr Microseconds second_us = 1'000'000, hour_us = 3600 * second_us, day_us = 24 * hour_us;

enum class DateOrder { day_month_year, month_day_year, year_month_day };

/// Three numbers of a date as they are written, and what the writing itself tells of their order.
struct WrittenDate {
  std::array<int, 3> parts;
  std::optional<DateOrder> order = {};  ///< known of 2024-03-12, 12.03.2024 and 12 Mar 2024, not of 3/12/2024
};

/// What a cell says of time: a date, a clock time, or both.
struct TimeCell {
  std::optional<WrittenDate> date;
  std::optional<Microseconds> clock;  ///< of the day
  std::optional<int> zone_minutes;    ///< east of UTC
};

/// hh:mm, hh:mm:ss.fff with AM or PM; d.m.y, m/d/y, y-m-d, 12 Mar 2024; both with blank or T between; Z, UTC, +02:00.
std::optional<TimeCell> time_cell(std::string_view cell);

/// Days since 1970; nothing where there is no such day.
std::optional<std::int64_t> day_of(const WrittenDate& date, DateOrder order);

/// "Z", "UTC", "+02:00", "-0530": minutes east of UTC.
std::optional<int> zone_named(std::string_view text);

/// "2024-03-12T10:00:00.5Z" of microseconds since 1970 in UTC.
std::string iso_utc(Microseconds time);

}  // namespace swayaw::core::detail
