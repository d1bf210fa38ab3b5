#include "terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace swayaw::app {
namespace {

/// Columns that a text takes: UTF-8 beyond ASCII counts once.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Where a line goes on: below its last column that leaves room for words.
std::size_t indent_of(std::string_view line, std::size_t columns) {
  constexpr std::size_t room = 24;
  const auto first = std::min(line.find_first_not_of(' '), line.size());
  auto indent = first;
  for (auto gap = line.find("  ", first); gap != std::string_view::npos; gap = line.find("  ", gap)) {
    gap = line.find_first_not_of(' ', gap);
    const auto column = width_of(line.substr(0, gap));
    if (gap == std::string_view::npos || column + room > columns) break;
    indent = column;
  }
  return indent;
}

}  // namespace

int terminal_columns() {
  constexpr int usual = 80;
  if (::isatty(STDOUT_FILENO) != 1) return 0;
  winsize size{};
  const bool told = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20;
  return told ? size.ws_col : usual;
}

std::string folded(std::string_view words, int columns, std::size_t indent) {
  if (columns <= 0) return std::string(words);
  std::string text;
  std::size_t used = 0;
  while (!words.empty()) {
    const auto end = std::min(words.find(' ', words.find_first_not_of(' ')), words.size());
    const auto word = words.substr(0, end);
    if (used > indent && used + width_of(word) > static_cast<std::size_t>(columns)) {
      text += "\n" + std::string(indent, ' ');
      used = indent + width_of(word) - 1;
      text += word.substr(word.find_first_not_of(' '));
    } else {
      text += word;
      used += width_of(word);
    }
    words.remove_prefix(end);
  }
  return text;
}

std::string fitted(std::string_view line, int columns) {
  line = line.substr(0, line.find_last_not_of(' ') + 1);
  const auto wide = static_cast<std::size_t>(std::max(columns, 0));
  return wide == 0 || width_of(line) <= wide ? std::string(line) : folded(line, columns, indent_of(line, wide));
}

void print_fitted(std::string_view told) {
  static std::string line;  // until it ends
  const auto inert = core::detail::printable(told, core::detail::Lines::many);
  std::string_view text = inert;
  for (auto end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    line += text.substr(0, end);
    fmt::print("{}\n", fitted(line, terminal_columns()));
    line.clear();
    text.remove_prefix(end + 1);
  }
  line += text;
}

void print_aside(std::string_view text) {
  fmt::print(stderr, "{}", core::detail::printable(text, core::detail::Lines::many));
}

}  // namespace swayaw::app
