#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "swayaw/linear/batch.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

/// Many ships at once, in calm water: over SIMD packs with the instruction set of the processor that runs the program,
/// and over all cores. What comes of a ship does not depend on the others, nor on the number of threads.
namespace swayaw::inline nonlinear {

/// As in ManoeuvreOptions, for every ship.
struct ZigzagBatchOptions {
  std::size_t reversals = 4;       ///< after whose overshoots a ship ends, at most 255
  std::optional<double> speed;     ///< approach speed [m/s]; of each ship her service speed unless given
  std::optional<double> rev;       ///< shaft speed [1/s]; of each ship that of self-propulsion unless given
  std::optional<double> duration;  ///< [s]; 200 L/U unless given
  double tolerance = 1e-7;         ///< error of an integration step: speeds over U, angles in rad
  BatchOptions batch;              ///< threads and instruction set
};

/// How the zigzag of one ship of many ended.
enum class ZigzagEnd : unsigned char {
  complete,       ///< after the last overshoot asked for
  time_over,      ///< before
  unbounded,      ///< the motion grew so fast that no step could follow it
  no_propulsion,  ///< she cannot propel herself at the approach speed
};

/// In one line for a report.
std::string_view in_words(ZigzagEnd end);

/// Reversals of many zigzags; what a ship did not reach is not a number.
struct ZigzagBatch {
  std::size_t ships = 0;
  std::size_t reversals = 0;         ///< asked for
  std::vector<double> time;          ///< when the heading reaches the switch angle [s], [reversal · ships + ship]
  std::vector<double> peak_time;     ///< when the yaw rate passes zero [s]
  std::vector<double> overshoot;     ///< heading peak beyond the switch angle [rad]
  std::vector<unsigned char> count;  ///< overshoots of each ship
  std::vector<ZigzagEnd> end;        ///< of each ship

  std::size_t at(std::size_t reversal, std::size_t ship) const { return reversal * ships + ship; }
};

/// The zigzag of every ship, about as near to the exact one as that of `zigzag` at the same tolerance
/// (bench/README.md). The track is not followed, so it does not shorten the steps either.
///
/// @throws std::domain_error  if an angle is not positive or beyond the largest of one of the ships, the number of
/// reversals is 0 or
///                            over 255, or the instruction set is not available
ZigzagBatch zigzag_batch(std::span<const MmgShip<double>> ships, const ZigzagOrder& order,
                         const ZigzagBatchOptions& options = {});

}  // namespace swayaw::nonlinear
