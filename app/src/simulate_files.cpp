#include "simulate_files.hpp"

#include <fmt/format.h>

#include "input.hpp"
#include "plot.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"

namespace swayaw::app {
namespace {

std::vector<double> values_of(const Recording& run, Channel channel) {
  return {run[channel].begin(), run[channel].end()};
}

Panel heading_and_rudder(const Recording& run) {
  return {.x = {"Time", "s"},
          .y = {"Heading, rudder", "deg"},
          .curves = {{"heading", run.time, in_degrees(values_of(run, Channel::psi)), {ink::heading}},
                     {"rudder, to port", run.time, in_degrees(values_of(run, Channel::delta)), {ink::rudder, 1.4}}}};
}

Panel track(const Recording& run) {
  return {.x = {"East", "m"},
          .y = {"North", "m"},
          .curves = {{"track of midship", values_of(run, Channel::y), values_of(run, Channel::x), {ink::drift}}},
          .same_scale = true};
}

}  // namespace

void write_files(const Recording& run, const SimulateArguments& a) {
  std::string svg;
  if (!a.svg.empty())
    svg = svg_of({fmt::format("{}: {}", run.name, run.facts.manoeuvre),
                  {a.turn || a.williamson ? track(run) : heading_and_rudder(run)}});
  if (!a.out.empty()) write_recording(run, a.out);
  if (!a.svg.empty()) write_text(a.svg, svg);
}

void write_run(Recording& run, const Ship& ship, const SimulateArguments& a) {
  if (a.forces) add_forces(run, ship);
  write_files(run, a);
}

}  // namespace swayaw::app
