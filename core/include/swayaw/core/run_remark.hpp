#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "swayaw/core/recording.hpp"

/// Run keys that say where and when a run was.
namespace swayaw::inline core {

/// The text of a run key that the samples do not hang on, without quotes; empty if the run has none.
std::string remark_of(const Recording& run, std::string_view key);

/// Seconds since 1970 UTC at which the time of a run is 0, by its key `start_utc`; nothing where that is not there or
/// no date with a time.
std::optional<double> start_utc(const Recording& run);

}  // namespace swayaw::core
