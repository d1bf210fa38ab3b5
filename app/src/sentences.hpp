#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What sentences on pages are made of.
namespace swayaw::app {

/// With a capital in front.
inline std::string capital(std::string_view words) {
  std::string text(words);
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// "added mass" of "added_mass".
inline std::string in_words(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// "a, b and c"
inline std::string listed(std::span<const std::string> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

/// The same with no more than so many: "a, b and 7 more".
inline std::string listed(std::span<const std::string> words, std::size_t most) {
  if (words.size() <= most) return listed(words);
  std::vector<std::string> first(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(most));
  first.push_back(std::to_string(words.size() - most) + " more");
  return listed(first);
}

/// "1 run", "3 runs"
inline std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

/// "second" of 2
inline std::string ordinal(std::size_t place) {
  constexpr std::array names{"first", "second", "third", "fourth", "fifth", "sixth"};
  return place > 0 && place <= names.size() ? names[place - 1] : std::to_string(place) + "th";
}

}  // namespace swayaw::app
