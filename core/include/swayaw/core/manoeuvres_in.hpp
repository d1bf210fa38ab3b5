#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"

/// The manoeuvres of a long log, found by rudder and heading.
namespace swayaw::inline core {

/// A stretch of a recording in which one manoeuvre is sailed, with its approach and what follows until the heading is
/// steady.
struct ManoeuvrePiece {
  double begin;                   ///< [s], time of the recording
  double end;                     ///< [s]
  std::string manoeuvre;          ///< "zigzag 10/10", "turn 35", "spiral 25", "pull-out 20", "steady run", "speed run"
  std::optional<double> execute;  ///< first rudder order [s]; nothing for steady runs
  std::string why;                ///< how it was recognised, one line: side, angles as measured, reversals
};

/// What is sailed in a recording, in order of time. Pieces do not overlap, but a pull-out begins in its turn.
///
/// zigzag D/H   the rudder is held at ±D three times or more and reversed whenever the heading is ±H off the approach
/// turn D       the rudder is held at D while the heading turns by 180 deg or more, from an approach without rudder
/// spiral D     the rudder is held at five angles or more, one after the other, across amidships
/// pull-out D   the rudder goes from a turn at D to amidships and stays there
/// steady run   heading within 2 deg and speed within 3 % for 3 min or more
/// speed run    two steady runs one after the other on opposite headings, with the same shaft speed if it is known
///
/// Angles are rounded to those that are usual in trials (5, 10, 15 … deg) where they are near, else to whole degrees;
/// `why` has them as measured. The sign of the rudder does not matter. The ordered angle is looked at if it is there,
/// else the actual one. Samples may be missing.
std::vector<ManoeuvrePiece> manoeuvres_in(const Recording& run);

/// The piece as a recording of its own: time from 0 at its first sample, the manoeuvre and the time of its execution
/// among the facts, start_utc later by what was cut.
/// @throws std::domain_error  if no sample lies in the piece
Recording piece_of(const Recording& run, const ManoeuvrePiece& piece);

/// "DIR/run_2_zigzag_10_10.csv", of the second piece of what would be written to "DIR/run.csv".
std::filesystem::path file_of_piece(const std::filesystem::path& out, std::size_t number, const ManoeuvrePiece& piece);

}  // namespace swayaw::core
