#pragma once

#include <string>
#include <string_view>

#include "swayaw/mismatch/diagnose.hpp"

/// The verdict in words. Not installed.
namespace swayaw::inline mismatch::detail {

/// What an effect is called in sentences.
std::string_view phrase(std::string_view id);

std::string words_of(const Diagnosis& d);

}  // namespace swayaw::mismatch::detail
