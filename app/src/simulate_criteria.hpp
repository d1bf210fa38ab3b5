#pragma once

#include <string>
#include <vector>

#include "simulate_page.hpp"

/// The criteria of MSC.137(76) in words.
namespace swayaw::app {

/// Below this length the criteria do not count [m].
inline constexpr double smallest_judged_ship = 100.0;

/// The rudder angle of the zigzag that tells it [deg]; 0 for the turning circle.
int zigzag_of(const Criterion& criterion);

/// Whether some of them are of turns to port and some to starboard.
bool has_sides(const std::vector<Criterion>& criteria);

/// The criterion that is nearest to its limit, or furthest beyond it; one that was not reached before all.
/// @param criteria  at least one
const Criterion& tightest(const std::vector<Criterion>& criteria);

/// One row for each: value, limit, margin, verdict.
PageTable criteria_table(const std::vector<Criterion>& criteria, const Sailed& s);

/// "… passes all 12 steering criteria …" or "… fails 1 of 12 …", the failing ones with value and limit.
std::string judgement(const std::vector<Criterion>& criteria, const Sailed& s);

/// The same with every value and limit, for a few criteria.
std::string full_judgement(const std::vector<Criterion>& criteria, const Sailed& s);

/// Good or bad; to be looked at where the criteria do not count for this ship or this weather, or are not all told.
Tone tone_of(const std::vector<Criterion>& criteria, const Sailed& s);

/// Whether she passes, by how much, and whether the criteria count for her.
std::vector<PageAnswer> answers_of(const std::vector<Criterion>& criteria, const Sailed& s);

}  // namespace swayaw::app
