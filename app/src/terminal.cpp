#include "terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace swayaw::app {
namespace {

/// Columns that a text takes: UTF-8 beyond ASCII counts once.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
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

void print_words(std::string_view words, std::size_t indent) {
  fmt::print("{}\n", folded(words, terminal_columns(), indent));
}

}  // namespace swayaw::app
