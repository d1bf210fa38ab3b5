#include "swayaw/core/detail/toml_depth.hpp"

#include <algorithm>

namespace swayaw::inline core::detail {
namespace {

/// The first byte behind a text in quotes, which begins at `at`.
std::size_t end_of_text(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const bool long_text = toml.substr(at, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  const std::size_t quotes = long_text ? 3 : 1;
  for (std::size_t i = at + quotes; i < toml.size(); ++i) {
    if (toml[i] == '\\' && quote == '"') ++i;
    else if (toml[i] == '\n' && !long_text) return i;  // an error that toml++ tells
    else if (toml.substr(i, quotes) == toml.substr(at, quotes)) {
      i += quotes;
      for (int more = 0; long_text && more < 2 && i < toml.size() && toml[i] == quote; ++more) ++i;
      return i;
    }
  }
  return toml.size();
}

}  // namespace

std::optional<std::size_t> place_of_deep_key(std::string_view toml) {
  constexpr std::string_view ends_of_keys = "\n=,[]{}";
  std::size_t dots = 0;
  for (std::size_t i = 0; i < toml.size();) {
    const char c = toml[i];
    if (c == '#') i = std::min(toml.find('\n', i), toml.size());
    else if (c == '"' || c == '\'') i = end_of_text(toml, i);
    else if (c == '.' && ++dots > deepest_key) return i;
    else {
      if (ends_of_keys.find(c) != std::string_view::npos) dots = 0;
      ++i;
    }
  }
  return std::nullopt;
}

}  // namespace swayaw::core::detail
