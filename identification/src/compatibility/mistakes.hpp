#pragma once

#include <vector>

#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification::detail {

/// Units, signs and orders that are not what the columns say, by what the ship does. Coarse: a factor of 1.9 or a
/// mirror image is looked for, not a per cent.
std::vector<InstrumentError> mistakes_of(const Recording& run);

/// The run as it would be without them.
Recording without(Recording run, std::span<const InstrumentError> mistakes);

}  // namespace swayaw::identification::detail
