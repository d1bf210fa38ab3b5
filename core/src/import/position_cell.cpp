#include "position_cell.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "characters.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

/// N, S, E, W or the German O for east, or nothing.
char side_of(char c) {
  switch (c) {
    case 'N':
    case 'n': return 'N';
    case 'S':
    case 's': return 'S';
    case 'E':
    case 'e':
    case 'O':
    case 'o': return 'E';
    case 'W':
    case 'w': return 'W';
    default: return '\0';
  }
}

/// A number at the front, with a decimal point or comma; it is taken off.
std::optional<double> take_number(std::string_view& text) {
  std::array<char, 24> digits;
  std::size_t count = 0;
  for (bool mark = false; count < text.size() && count < digits.size(); ++count) {
    const char c = text[count];
    const bool is_mark = !mark && (c == '.' || c == ',') && count + 1 < text.size() && is_digit(text[count + 1]);
    if (!is_digit(c) && !is_mark) break;
    mark = mark || is_mark;
    digits[count] = is_mark ? '.' : c;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + count, value);
  if (error != std::errc{} || end != digits.data() + count) return std::nullopt;
  text.remove_prefix(count);
  return value;
}

/// Marks between degrees, minutes and seconds.
bool take_mark(std::string_view& text) {
  for (const std::string_view mark : {"\xC2\xB0", "\xC2\xBA", "\xE2\x80\xB2", "\xE2\x80\xB3", "\xE2\x80\x99",
                                      "\xE2\x80\x9D", "\xC2\xB4", "deg", "'", "\"", " ", "-", ":", "d", "m"})
    if (text.starts_with(mark)) return text.remove_prefix(mark.size()), true;
  return false;
}

}  // namespace

std::optional<PositionCell> position_cell(std::string_view cell) {
  PositionCell found{.value = 0.0, .parts = 0};
  double sign = 1.0, size = 1.0;
  cell = trimmed(cell);
  if (cell.starts_with('-') || cell.starts_with('+')) sign = cell.front() == '-' ? -1.0 : 1.0, cell.remove_prefix(1);
  while (!cell.empty()) {
    if (is_digit(cell.front())) {
      const auto number = take_number(cell);
      // degrees + minutes/60 + seconds/3600
      if (!number || found.parts == 3 || (found.parts > 0 && *number >= 60.0)) return std::nullopt;
      found.value += *number * size;
      size /= 60.0;
      ++found.parts;
    } else if (const char side = side_of(cell.front()); side != '\0' && found.side == '\0') {
      found.side = side;
      cell.remove_prefix(1);
    } else if (!take_mark(cell)) return std::nullopt;
  }
  if (found.parts == 0 || (found.side == '\0' && found.parts == 1 && size == 1.0)) return std::nullopt;
  if (found.side == 'S' || found.side == 'W') sign = -sign;
  found.value *= sign;
  return found;
}

double from_degrees_and_minutes(double value) {
  // dddmm.mmm: degrees are the hundreds
  const double whole = std::trunc(value / 100.0);
  return whole + (value - 100.0 * whole) / 60.0;
}

}  // namespace swayaw::core::detail
