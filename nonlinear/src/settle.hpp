#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "event_stepper.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/settling.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Stepper until nothing changes but place and heading. Not installed.
namespace swayaw {

/// @throws Refusal  for a ship in wind or waves, whose turns never become steady
inline void require_calm(const Ship& ship, std::string_view manoeuvre) {
  const auto blows = [](const Effect& e) { return place_of(e) == EffectPlace::air && !is_null(e); };
  const auto drifts = [](const Effect& e) { return std::holds_alternative<WaveDrift<>>(e) && !is_null(e); };
  const auto turns_with = [](const Effect& e) {
    return std::holds_alternative<UnknownForce<>>(e) && std::get<UnknownForce<>>(e).goes_with_heading_or_time();
  };
  if (std::ranges::any_of(ship.effects, turns_with))
    throw Refusal(
        fmt::format("no turn is steady under a force that goes with the heading or the time, which the {} waits for; "
                    "take \"unknown\" out of the ship file",
                    manoeuvre));
  if (std::ranges::any_of(ship.effects, drifts))
    throw Refusal(fmt::format(
        "no turn is steady in waves, which the {} waits for; take wave_drift out of the ship file", manoeuvre));
  if (ship.surroundings.windy || std::ranges::any_of(ship.effects, blows))
    throw Refusal(fmt::format("no turn is steady in wind, which the {} waits for; take the wind out of the ship file",
                              manoeuvre));
}

/// Largest acceleration over U²/L, of yaw over U²/L².
inline double acceleration_size(const StateVector<double>& rate, double L, double U) {
  return std::max({std::abs(rate[3]), std::abs(rate[4]), std::abs(rate[5]) * L}) * L / (U * U);
}

/// Integrates one ship length after another until the motion is steady. @return whether it became so
///
/// At the end of each length all three accelerations must be small, so the turning point of a swing does not count.
template <class Stepper>
bool settle(Stepper& stepper, const Settling& settling, double L, double U) {
  const double end = stepper.time() + settling.longest * L / U;
  while (stepper.time() < end) {
    stepper.advance(std::min(end, stepper.time() + L / U));
    if (acceleration_size(stepper.rates_now(), L, U) < settling.tolerance) return true;
  }
  return false;
}

}  // namespace swayaw
