#include "recorded_inputs.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
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

void tell_propulsion(const Ship& ship, std::span<const Recording> runs) {
  if (const auto words = assumed_propulsion(ship, runs); !words.empty()) say_aside("swayaw: {}\n", words);
}

std::string drivers(const Ship& ship, const Recording& run) {
  if (std::holds_alternative<AbkowitzShip<double>>(ship.model)) return "the recorded rudder";
  const bool by_shaft = takes_shaft_speed(ship), recorded = tells_propulsion(ship, run);
  const std::string_view propulsion = by_shaft && (run.has(Channel::rev) || !recorded) ? "shaft speed" : "thrust";
  if (recorded) return fmt::format("the recorded rudder and {}", propulsion);
  return fmt::format("the recorded rudder and, as none was recorded, the {} that carries her settled at the start",
                     propulsion);
}

}  // namespace swayaw::app
