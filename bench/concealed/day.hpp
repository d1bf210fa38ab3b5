#pragma once

#include <algorithm>
#include <numbers>

#include "random_source.hpp"
#include "true_ship.hpp"

namespace swayaw::concealed {

/// Air and stream of a day, below the practical floors.
struct Day {
  double wind_speed, wind_from, turbulence, gust_memory, current_speed, current_to;

  Concealment calm() const {
    return {.wind_speed = wind_speed, .wind_from = wind_from, .current_speed = current_speed, .current_to = current_to};
  }
};

/// Turbulence with a length of 150 m, at most ten ship lengths of way long.
inline Day day_by_chance(RandomSource& random, const TrueShip& s) {
  Day day{.wind_speed = s.U_0 * random.uniform(0.04, 0.14),
          .wind_from = random.uniform(0.0, 2.0 * std::numbers::pi),
          .turbulence = random.uniform(0.15, 0.35),
          .gust_memory = 0.0,
          .current_speed = s.U_0 * random.uniform(0.002, 0.015),
          .current_to = random.uniform(0.0, 2.0 * std::numbers::pi)};
  day.gust_memory = std::min(10.0, 150.0 / day.wind_speed / s.time_unit());
  return day;
}

}  // namespace swayaw::concealed
