#pragma once

#include <cstddef>

#include "swayaw/core/recording.hpp"

namespace swayaw::inline core::detail {

/// The samples from `first` to before `end` as a recording of its own, on the same clock, with the same facts.
Recording rows_of(const Recording& run, std::size_t first, std::size_t end);

}  // namespace swayaw::core::detail
