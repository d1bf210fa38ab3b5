#include "measured_surroundings.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "swayaw/nonlinear/surroundings/recorded_surroundings.hpp"
#include "terminal.hpp"

namespace swayaw::app {

Recording without(Recording run, const Ignored& ignored) {
  if (ignored.wind)
    for (const auto channel : {Channel::wind_speed, Channel::wind_from}) run.channels[index_of(channel)].clear();
  if (ignored.depth) {
    run.facts.water_depth.reset();
    run.channels[index_of(Channel::depth)].clear();
  }
  return run;
}

void tell_in_vain(const Ship& ship, std::span<const Recording> runs) {
  for (const auto& run : runs)
    for (const auto& words : measured_in_vain(ship, run)) say_aside("swayaw: {}: {}\n", run.name, words);
}

}  // namespace swayaw::app
