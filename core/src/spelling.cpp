#include "swayaw/core/detail/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace swayaw::inline core::detail {
namespace {

/// Insertions, deletions and replacements that turn one word into the other (Levenshtein).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The word most like `typed`, or nothing when none is near.
std::string_view nearest_word(std::string_view typed, std::span<const std::string_view> words) {
  const auto nearest = std::ranges::min_element(words, {}, [&](std::string_view word) { return edits(typed, word); });
  if (nearest == words.end() || edits(typed, *nearest) > std::max<std::size_t>(2, typed.size() / 3)) return {};
  return *nearest;
}

}  // namespace

std::string did_you_mean(std::string_view typed, std::span<const std::string_view> words) {
  const auto nearest = nearest_word(typed, words);
  return nearest.empty() ? std::string{} : fmt::format("; did you mean \"{}\"?", nearest);
}

}  // namespace swayaw::inline core::detail
