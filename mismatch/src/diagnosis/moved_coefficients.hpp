#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "../search/search.hpp"

/// Coefficients of the baseline that a fit moves, and what they come to. Not installed.
namespace swayaw::inline mismatch::detail {

/// Parameters of the baseline that the final fit moves by more than two of their deviations.
std::vector<BaselineShift> shifts_of(const Trial& trial, const Point& point);

/// How much of the rudder is left when its coefficients move; nothing where her model does not tell.
std::optional<double> rudder_left(const Ship& given, const Ship& moved);

/// The part whose coefficients, moved alone, bring most of what all of them bring, which must be half of the
/// discrepancy itself.
/// @param train  errors of the runs used, by the model as given
std::optional<MovedPart> moved_part(const Trial& trial, const Point& point, const Discrepancy& all, const Ship& given,
                                    const std::vector<RunErrors>& train, std::span<const Recording> runs);

}  // namespace swayaw::mismatch::detail
