#pragma once

#include <span>

#include "../search/search.hpp"

/// What is missing, all in all. Not installed.
namespace swayaw::inline mismatch::detail {

bool is_nameless(const FoundEffect& e);

/// Whether an effect pushes from one side of the earth as a wind does, and no wind could be tried, since the file does
/// not tell what the ship shows it. Of R/V Gunnerus without windage waves were found in a sheltered fjord.
bool may_be_a_wind(const Ship& ship, const Effect& effect);

/// What may be a wind is told as one of two: nothing tells them apart, and a wind is as likely as waves.
void put_wind_beside_waves(Diagnosis& d, const Ship& ship);

/// Whether waves move the ship in half of the runs: then a force that follows nothing may be theirs. Of twelve
/// simulated ships in waves of 0.12 to 0.35 deg of yaw with nothing else hidden five had a process noise of 5 to 15
/// times the ordinary, which none had in calm water. Waves do not count in the errors of replays.
bool is_in_waves(const Diagnosis& d);

/// In replays of which quantity it shows that something is missing: the yaw rate, or the heading where waves move the
/// ship, for waves so long that they are not told from her manoeuvre are a seventh of the yaw rate, but hardly turn
/// her.
Quantity judged_by(const Diagnosis& d);

/// Whether the form is larger than any.
bool has_large_form(std::span<const ForceBudget> budget);

DiagnosisVerdict verdict_of(const Diagnosis& d, bool on_board);

}  // namespace swayaw::mismatch::detail
