#pragma once

#include <string>
#include <string_view>

#include "swayaw/mismatch/diagnose.hpp"

/// The verdict in words. Not installed.
namespace swayaw::inline mismatch::detail {

/// What an effect is called in sentences.
std::string_view phrase(std::string_view id);

/// What an effect without a name goes with: where it acts, and with which motions or when.
std::string unknown_depends_on(const Diagnosis& d);

std::string words_of(const Diagnosis& d);

}  // namespace swayaw::mismatch::detail
