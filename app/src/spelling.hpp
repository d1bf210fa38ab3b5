#pragma once

#include <span>
#include <string_view>

namespace swayaw::app {

/// The word most like `typed`, or nothing when none is near.
std::string_view nearest_word(std::string_view typed, std::span<const std::string_view> words);

}  // namespace swayaw::app
