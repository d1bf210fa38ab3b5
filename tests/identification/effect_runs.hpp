#pragma once

#include "../nonlinear/random_effects.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

/// Ships of every model that an effect may act on, and what they sail.
namespace swayaw::test {

template <class Model>
Ship sailing_ship() {
  if constexpr (std::is_same_v<Model, MmgShip<double>>) return with_areas(mmg(kvlcc2_l7()));
  else if constexpr (std::is_same_v<Model, PiShip<double>>) return with_areas(pi_ship("wpcc_pi"));
  else if constexpr (std::is_same_v<Model, PuShip<double>>) return with_areas(wpcc_pu());
  else return with_areas(mariner());
}

inline Recording zigzag_of(const Ship& ship) {
  const double time_unit = time_unit_of(ship);
  return zigzag(ship, {.rudder = radians(20), .heading = radians(20)},
                {.duration = 12.0 * time_unit, .step = 0.01 * time_unit})
      .run;
}

/// Calls f(id, ship) for each effect that the ship can have, the ship with it; of a size by chance.
template <class F>
void for_each_effect(const Ship& bare, unsigned seed, F&& f) {
  RandomEffects effects(seed);
  for (const auto id : effect_ids())
    if (const auto effect = effects.of_kind(id, bare)) f(id, with_effect(bare, *effect));
}

}  // namespace swayaw::test
