#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

#include "swayaw/core/detail/toml_depth.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/core/refusal.hpp"

/// TOML files, every mistake told with its place. Not installed.
namespace swayaw::inline core::detail {

/// @param name  stands for the file in messages
/// @throws FileError  if the text is not TOML, or has keys within keys that no file has
inline toml::table parsed_toml(std::string_view text, const std::filesystem::path& name) {
  if (const auto deep = place_of_deep_key(text)) {
    const auto before = text.substr(0, *deep);
    const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
    throw FileError({name, line, before.size() - (before.rfind('\n') + 1) + 1},
                    fmt::format("a key of more than {} dots", deepest_key));
  }
  try {
    return toml::parse(text, name.string());
  } catch (const toml::parse_error& error) {
    const auto place = error.source().begin;
    throw FileError({name, place.line, place.column}, error.description());
  }
}

/// What a value in a range must be, in words.
inline std::string requirement(const Range& range) {
  if (range.not_zero) return "must not be 0";
  if (range.low == 0.0 && std::isinf(range.high)) return range.above_low ? "must be positive" : "must not be negative";
  if (range.above_low) return fmt::format("must be above {} and not above {}", range.low, range.high);
  return fmt::format("must lie between {} and {}", range.low, range.high);
}

/// A parsed file.
class TomlText {
 public:
  TomlText(const toml::table& root, const std::filesystem::path& file) : root_(root), file_(file) {}

  const toml::table& root() const { return root_; }

  [[noreturn]] void fail(const toml::source_position& place, std::string_view what) const {
    throw FileError({file_, place.line, place.column}, what);
  }
  [[noreturn]] void fail(const toml::node& node, std::string_view what) const { fail(node.source().begin, what); }

  /// @param name  of the value in messages
  double number(const toml::node& node, std::string_view name, const Range& range = any_number) const {
    const auto value = node.value<double>();
    if (!value || !node.is_number() || !std::isfinite(*value)) fail(node, fmt::format("{} must be a number", name));
    if (!range.contains(*value)) fail(node, fmt::format("{} {}, got {}", name, requirement(range), *value));
    return *value;
  }

  std::string text(const toml::node& node, std::string_view name) const {
    if (const auto value = node.value_exact<std::string>()) return *value;
    fail(node, fmt::format("{} must be a text in quotes", name));
  }

 private:
  const toml::table& root_;
  const std::filesystem::path& file_;
};

}  // namespace swayaw::core::detail
