#pragma once

#include <string>

#include "swayaw/mismatch/diagnose.hpp"

/// The verdict in words. Not installed.
namespace swayaw::inline mismatch::detail {

/// What an effect without a name goes with: where it acts, and with which motions or when.
std::string unknown_depends_on(const Diagnosis& d);

std::string words_of(const Diagnosis& d);

}  // namespace swayaw::mismatch::detail
