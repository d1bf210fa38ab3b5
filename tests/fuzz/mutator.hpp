#pragma once

#include <random>
#include <span>
#include <string>

namespace swayaw::fuzz {

/// An input made from those of a corpus, always the same for a seed: one is damaged in one to four places. Lines,
/// columns and numbers are known for what they are, so that what comes out is often read and not only refused.
std::string mutated(std::span<const std::string> corpus, bool is_text, unsigned seed);

}  // namespace swayaw::fuzz
