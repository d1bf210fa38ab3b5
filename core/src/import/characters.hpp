#pragma once

namespace swayaw::inline core::detail {

/// In ASCII, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace swayaw::core::detail
