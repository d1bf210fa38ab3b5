#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "../simulation/ship_stepper.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvres/settling.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Stepper until nothing changes but place and heading. Not installed.
namespace swayaw::inline nonlinear::detail {

/// @throws Refusal  for a ship with effects whose turns never become steady, as in wind or waves
inline void require_calm(const Ship& ship, std::string_view manoeuvre) {
  const auto refuse = [&](std::string_view where, std::string_view what) {
    throw Refusal(fmt::format("no turn is steady {}, which the {} waits for; take {} out of the ship file", where,
                              manoeuvre, what));
  };
  for (const auto& effect : ship.effects)
    if (const auto where = never_steady(effect); !where.empty() && !is_null(effect)) refuse(where, id_of(effect));
  if (ship.surroundings.windy) refuse("in wind", "the wind");
}

/// Largest acceleration over U²/L, of yaw over U²/L².
inline double acceleration_size(const StateVector<double>& rate, double L, double U) {
  return std::max({std::abs(rate[3]), std::abs(rate[4]), std::abs(rate[5]) * L}) * L / (U * U);
}

/// Integrates one ship length after another until the motion is steady. @return whether it became so
///
/// At the end of each length all three accelerations must be small, so the turning point of a swing does not count.
inline bool settle(ShipStepper& stepper, const Settling& settling, double L, double U) {
  const double end = stepper.time() + settling.longest * L / U;
  while (stepper.time() < end) {
    stepper.advance(std::min(end, stepper.time() + L / U));
    if (acceleration_size(stepper.rates_now(), L, U) < settling.tolerance) return true;
  }
  return false;
}

}  // namespace swayaw::nonlinear::detail
