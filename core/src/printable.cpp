#include "swayaw/core/detail/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace swayaw::inline core::detail {
namespace {

/// A character at the front of a text; size 0: the first byte is not UTF-8.
struct Character {
  char32_t code = 0;
  std::size_t size = 0;
};

Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return {};
  char32_t code = byte(0) & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};  // a shorter form would do: not UTF-8
  const bool half_a_character = code >= 0xD800 && code < 0xE000;
  return code < least[size] || half_a_character || code > 0x10FFFF ? Character{} : Character{code, size};
}

struct Codes {
  char32_t first, last;
};

/// Characters that act rather than show: controls; marks of direction, of no width, of the ends of lines and
/// paragraphs, of byte order, of annotations. Four digits tell each.
constexpr std::array<Codes, 10> acting{{{0x00, 0x1F},
                                        {0x7F, 0x9F},
                                        {0x61C, 0x61C},
                                        {0x200B, 0x200B},
                                        {0x200E, 0x200F},
                                        {0x2028, 0x202E},
                                        {0x2060, 0x2060},
                                        {0x2066, 0x206F},
                                        {0xFEFF, 0xFEFF},
                                        {0xFFF9, 0xFFFB}}};

bool acts(char32_t code) {
  return std::ranges::any_of(acting, [&](Codes codes) { return codes.first <= code && code <= codes.last; });
}

bool is_plain(char c) { return c >= 0x20 && c < 0x7F; }

}  // namespace

std::string printable(std::string_view text, Lines lines) {
  if (std::ranges::all_of(text, is_plain)) return std::string(text);
  std::string shown;
  auto to = std::back_inserter(shown);
  while (!text.empty()) {
    const auto [code, size] = first_of(text);
    const bool kept = code == '\t' || (code == '\n' && lines == Lines::many);
    if (size > 0 && (kept || !acts(code))) shown += text.substr(0, size);
    else if (size == 0) fmt::format_to(to, "\\x{:02x}", static_cast<unsigned char>(text.front()));
    else fmt::format_to(to, "\\u{:04x}", static_cast<unsigned>(code));
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return shown;
}

}  // namespace swayaw::core::detail
