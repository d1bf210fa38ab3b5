#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

/// Not installed.
namespace swayaw::inline core::detail {

/// Dots of a key a.b.c that are read. toml++ 3.3 limits lists and tables within each other to 256, but not keys: it
/// makes a table for each dot and takes them apart by calls within calls, so that a line of a megabyte ends the
/// program. Files of the project have keys of two dots; 256 tables of keys with a hundred fit the stack of a thread.
inline constexpr std::size_t deepest_key = 100;

/// Where the text has a key that is deeper; texts in quotes and remarks do not count.
std::optional<std::size_t> place_of_deep_key(std::string_view toml);

}  // namespace swayaw::core::detail
