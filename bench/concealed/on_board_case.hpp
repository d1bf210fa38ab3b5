#pragma once

#include "concealed_case.hpp"
#include "on_board_instruments.hpp"

/// Cases as a ship brings them home: instruments as on board, light gusty air in every run, a ship file that is fitted
/// to a ship of another structure and wrong by its confidence. docs/concealed_on_board.md
namespace swayaw::concealed {

/// Cases of all structures and forms of files, with nothing hidden or with something. Every kind is hidden alone
/// equally often, and is equally often the first of two; the second is any other.
std::vector<CasePlan> on_board_plans(bool something_hidden, std::size_t count, std::uint64_t seed);

/// One of them: what is hidden in which ship, and the form of her file.
CasePlan on_board_plan(std::string_view structure, FileForm form, std::vector<std::pair<std::string, Severity>> effects,
                       std::uint64_t seed);

/// Of another ship, on another day, where the first can be given no such case: a twin screw on whom no force without a
/// name was large enough to be noticed, for one.
/// @throws std::domain_error  where none of five ships can
ConcealedCase made_on_board(const CasePlan& plan);

/// Errors of replays by a ship, restarted every two lengths, over those of the same runs with nothing hidden: mean over
/// heading, yaw rate, speed and position. A model that told it all would improve replays by 1 − 1/that.
double detectability(const Ship& file, const std::vector<Recording>& runs, const std::vector<Recording>& calm_runs);

/// A ship with what is hidden, as far as swayaw knows it.
Ship with_label(const Ship& ship, const Label& label);

/// What the truth itself brings beside a file that is wrong elsewhere: the same errors of replays by the file with all
/// else that is hidden, over those with this, too. Replays improve by 1 − 1/that. Two errors may hide each other: a
/// rudder that is weak beside shallow water may improve nothing. Nothing where what is hidden is of a kind that swayaw
/// does not know, or the ship cannot sail the runs.
/// @param labels  all that is hidden
/// @param one     which of them
std::optional<double> replay_gain(const Ship& file, std::span<const Label> labels, std::size_t one,
                                  const std::vector<Recording>& runs);

inline constexpr double noticeable = 1.0 / 0.9;  ///< least detectability of what is hidden: replays gain 10 %
inline constexpr double strongly = 2.0;          ///< from here on it is strong: they gain half

}  // namespace swayaw::concealed
