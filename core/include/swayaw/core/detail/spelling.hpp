#pragma once

#include <span>
#include <string>
#include <string_view>

/// What was probably meant by a word that is not known.
namespace swayaw::inline core::detail {

/// `; did you mean "effect"?`, or nothing when no word is near.
std::string did_you_mean(std::string_view typed, std::span<const std::string_view> words);

}  // namespace swayaw::inline core::detail
