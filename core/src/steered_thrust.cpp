#include "swayaw/core/steered_thrust.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace swayaw::inline core {
namespace {

/// Letters only and small, so that "Z-drive", "z_drive" and "zdrive" are one.
std::string letters_of(std::string_view words) {
  std::string letters;
  for (const char c : words)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

/// Parts of longer words, and whole words.
constexpr std::array<std::string_view, 10> within{"azimuth", "azipod",    "podded",    "poddrive", "zdrive",
                                                  "voith",   "schneider", "cycloidal", "waterjet", "steerablethruster"};
constexpr std::array<std::string_view, 4> whole{"pod", "pods", "vsp", "asd"};

}  // namespace

bool names_steered_thrust(std::string_view words) {
  const auto letters = letters_of(words);
  return std::ranges::any_of(within, [&](std::string_view w) { return letters.find(w) != std::string::npos; }) ||
         std::ranges::count(whole, letters) > 0;
}

}  // namespace swayaw::core
