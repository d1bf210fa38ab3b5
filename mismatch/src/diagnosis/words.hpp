#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

/// Numbers in sentences for users.
namespace swayaw::inline mismatch::detail {

/// In two digits, from 10 on without decimals: 0.034, 3.4, 103.
inline std::string in_two_digits(double value) {
  return std::abs(value) < 10.0 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}

}  // namespace swayaw::inline mismatch::detail
