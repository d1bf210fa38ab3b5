#pragma once

#include <string_view>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/controls.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Which motions and controls a force model answers for. docs/simulation.md has the table.
///
/// The models are polynomials in v/U and rL/U with a propeller in its first quadrant: they hold for way ahead and a
/// shaft that turns ahead. Whatever asks for one force, or begins a simulation, refuses the rest in words; the
/// Simulator, which must go on, carries the forces on by a rule of its own and tells so.
namespace swayaw::inline nonlinear {

enum class Validity {
  valid,
  not_a_number,       ///< a number of the motion or the controls is missing or infinite
  no_way_ahead,       ///< u ≤ 0
  turns_on_the_spot,  ///< |r| L/U beyond largest_yaw_rate
  shaft_astern,       ///< a shaft speed below 0, where no thrust is given
};

/// |r| L/U beyond which cubic terms of it mean nothing: the ships of ships/ reach at most 1.8 in turns with 35 deg of
/// rudder.
inline constexpr double largest_yaw_rate = 10.0;

/// u over the service speed below which forces of any model are little known: the thrust is then 95 to 98 % of that at
/// bollard pull. The ships of ships/ keep 0.22 and more in turns with 35 deg of rudder.
inline constexpr double least_way = 0.1;

/// "the shaft turns astern, and the thrust is known for a shaft that turns ahead", alike; empty for valid.
std::string_view words_for(Validity validity);

/// Whether a model of that length answers for a motion through the water.
Validity validity_of(const PlanarMotion<double>& motion, const Controls<double>& controls, double L);

/// @throws Refusal  with the words and the number
void require_valid(const PlanarMotion<double>& motion, const Controls<double>& controls, double L);
void require_valid(const Ship& ship, const PlanarMotion<double>& motion, const Controls<double>& controls);

}  // namespace swayaw::nonlinear
