#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Air and water of a run as they were measured: the columns of the true wind, the depth of the water.
namespace swayaw::inline nonlinear {

/// Velocity of the air over ground, to the north and the east [m/s], from a time on.
struct WindPiece {
  double time;  ///< [s]; of the first piece of a run −infinity, and the last one never ends
  double north, east;
};

/// Recorded wind is averaged over no longer than this, in L/U: as long as the steps of the filter. Longer pieces cost
/// as much and tell less; docs/wind.md has the measurement.
inline constexpr double wind_averaging = 0.0625;

/// The measured wind of a run as it acts on a ship: constant pieces, which begin at samples of the run, each the mean
/// of the velocity vector over it. Across missing samples the vector goes in a straight line. What the instruments of
/// the ship did to the two columns is undone first.
///
/// Empty where the run has no wind, or the ship shows the wind nothing.
std::vector<WindPiece> recorded_wind(const Ship& ship, const Recording& run);

/// Those that blow between two times.
std::span<const WindPiece> wind_between(std::span<const WindPiece> wind, double from, double to);

/// The wind at a time of which a recorded one is a part.
/// @param rest  wind and current without it
Surroundings<double> with_recorded_wind(Surroundings<double> rest, const WindPiece& recorded);

/// Depth of the water of a run [m]: what its file says, else the median of the sounder.
std::optional<double> recorded_depth(const Recording& run);

/// Depth over draught beyond which the sway force by drift differs by less than 1 % from that of deep water
/// (shallow_water_factors).
inline constexpr double deep_water = 6.0;

/// The ship in water of that depth; nothing where that makes no difference: the depth is not known or great, her own
/// effects tell another one, or her model has no place for it.
std::optional<Ship> in_depth(const Ship& ship, const std::optional<double>& depth);

/// What was measured of wind and depth in a run and cannot act on the ship, in words for the user; empty if nothing.
std::vector<std::string> measured_in_vain(const Ship& ship, const Recording& run);

}  // namespace swayaw::nonlinear
