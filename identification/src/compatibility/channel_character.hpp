#pragma once

#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification::detail {

/// Rounding, fixes, noise and outliers of a channel that has samples.
ChannelCharacter character_of(const Recording& run, Channel channel);

/// The run without outliers and without the samples that were interpolated between fixes.
Recording measured_samples(Recording run, std::span<const ChannelCharacter> characters);

}  // namespace swayaw::identification::detail
