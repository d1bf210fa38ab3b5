#pragma once

#include <optional>

#include "swayaw/core/recording.hpp"

/// Value and rate of a recorded quantity from the samples around a time. Not installed.
namespace swayaw::inline nonlinear::detail {

struct ValueAndRate {
  double value;
  double rate;  ///< per second
};

/// Least-squares polynomial through the samples of a channel in [from, to], taken at `time`.
///
/// @param degree  1 or 2; lowered to one less than the samples, of which two are joined
/// @return nothing when no sample lies there; rate 0 when only one does
std::optional<ValueAndRate> local_fit(const Recording& run, Channel channel, double time, double from, double to,
                                      int degree);

}  // namespace swayaw::nonlinear::detail
