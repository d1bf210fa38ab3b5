#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../search/search.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// What to sail next, and what these runs would have shown. Not installed.
namespace swayaw::inline mismatch::detail {

/// The manoeuvre of a menu that tells the last finding best from its rivals, per minute; from the best of those that
/// were tried where none is as good.
/// @return nothing where nothing was found, or no manoeuvre can be simulated
std::optional<Advice> next_manoeuvre(const Trial& trial, const Search& search);

/// For each effect of one size, the size at which nine of ten recordings like these would have had it named: its
/// estimate gains the log evidence that detection needs and is larger than the floor of practice. Of wind, stream and
/// waves from where they show least.
std::vector<DetectableSize> detectable_sizes(const Trial& trial, const Search& search,
                                             std::span<const EffectForm> forms, double detection);

}  // namespace swayaw::mismatch::detail
