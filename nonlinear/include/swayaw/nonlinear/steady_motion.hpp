#pragma once

#include <optional>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/controls.hpp"
#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::inline nonlinear {

/// Shaft speed at which thrust carries the ship straight ahead at that speed [1/s].
///
///     (1 − t_P) ρ D² (k_0 n²D² + k_1 nD u_P + k_2 u_P²) = ½ρLdU² R_0' − push,   u_P = (1 − w_P0) U
///
/// @param push  of whatever else acts on her, positive ahead [N]
/// @throws std::domain_error  if the speed is not positive
/// @throws Refusal            if no shaft speed balances the resistance
double self_propulsion_rev(const MmgShip<double>& ship, double speed, double push = 0.0);

/// Rudder amidships and what carries the ship straight ahead at that speed: a shaft speed, or for a model that knows
/// only thrust, a thrust.
/// @param push  as above; the polynomial of an Abkowitz ship holds its own propulsion, whatever else acts
/// @throws as self_propulsion_rev does
Controls<double> self_propulsion(const MmgShip<double>& ship, double speed, double push = 0.0);
Controls<double> self_propulsion(const AbkowitzShip<double>& ship, double speed, double push = 0.0);

/// The same for a ship with her effects: what hangs on her and drags, all the time and on every heading, is carried
/// too.
Controls<double> self_propulsion(const Ship& ship, double speed);

/// Whether the model computes its thrust from the shaft speed.
bool takes_shaft_speed(const MmgShip<double>& ship);
bool takes_shaft_speed(const AbkowitzShip<double>& ship);
bool takes_shaft_speed(const Ship& ship);

/// Checks that the ship can be driven so.
/// @throws Refusal  if a shaft speed or a thrust is given to a model whose propulsion is part of its polynomial, or a
/// shaft speed
///                  to one without an open-water curve
void require_drive(const ShipModel& model, const std::optional<double>& rev, const std::optional<double>& thrust);

/// Rudder amidships and the thrust [N] or shaft speed [1/s] that is given, else self-propulsion at that speed.
/// @throws as require_drive and self_propulsion do
/// @throws std::domain_error  if the shaft speed is not positive
Controls<double> propulsion(const ShipModel& model, double speed, const std::optional<double>& rev,
                            const std::optional<double>& thrust);

/// The same for a ship with her effects.
Controls<double> propulsion(const Ship& ship, double speed, const std::optional<double>& rev,
                            const std::optional<double>& thrust);

/// A steady motion: nothing changes but the place and the heading.
struct SteadyMotion {
  PlanarMotion<double> motion;
  bool stable;  ///< a small disturbance dies out
};

/// The steady motion that Newton's method finds from `guess` at constant controls,
/// du/dt = dv/dt = dr/dt = 0, with exact derivatives. Effects of the ship act, but for wind, waves and instruments; the
/// rudder angle is that of the rudder.
///
/// @return nothing when it does not converge to a motion ahead
std::optional<SteadyMotion> steady_motion(const Ship& ship, const Controls<double>& controls,
                                          const PlanarMotion<double>& guess);

}  // namespace swayaw::nonlinear
