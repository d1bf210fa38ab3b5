#include <fmt/format.h>

#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "linear_output.hpp"
#include "simulate_files.hpp"
#include "simulate_output.hpp"
#include "simulate_page.hpp"
#include "simulate_trials.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- zigzag

void print_zigzag(const Ship& ship, const Zigzag& z) {
  say("{}: {}, approach {:.4g} m/s, {}\n", ship.name, z.run.facts.manoeuvre, z.approach_speed,
      propulsion_text(ship, z.propulsion));
  say("  {:<10}{:>12}{:>12}{:>16}\n", "reversal", "at s", "peak s", "overshoot deg");
  for (std::size_t i = 0; i < z.reversals.size(); ++i) {
    const auto& r = z.reversals[i];
    say("  {:<10}{:>12.3f}", i + 1, r.time);
    if (r.overshoot) say("{:>12.3f}{:>16.3f}\n", *r.peak_time, degrees(*r.overshoot));
    else say("{:>12}{:>16}\n", "-", "-");
  }
  if (z.period) say("  period of the last cycle {:.2f} s\n", *z.period);
  if (z.initial_turning) say("  way made at the first reversal {:.2f} L\n", *z.initial_turning / length(ship));
  if (z.reversals.empty()) say("  the heading never reached the switch angle\n");
}

void run_zigzag(const Ship& ship, const SimulateArguments& a) {
  const auto [rudder, heading] = zigzag_angles(a.zigzag);
  const ZigzagOrder order{.rudder = rudder, .heading = heading, .first = side_named(a.first)};
  auto result = zigzag(ship, order, options_of(a));
  write_run(result.run, ship, a);
  write_page_of(ship, result.approach_speed, result.propulsion, a,
                [&](const Sailed& s) { return zigzag_page(result, order, s); });
  if (a.json) print_document(zigzag_json(ship, result, order));
  else print_zigzag(ship, result);
  if (!a.json) print_criteria(criteria_of(result, order, length(ship)));
}

// ---------------------------------------------------------------- turning circle

void print_circle(const Ship& ship, const TurningCircle& c) {
  const double L = length(ship);
  say("{}: {}, approach {:.4g} m/s, {}\n", ship.name, c.run.facts.manoeuvre, c.approach_speed,
      propulsion_text(ship, c.propulsion));
  print_length("advance", c.advance, L);
  print_length("transfer", c.transfer, L);
  print_length("tactical diameter", c.tactical_diameter, L);
  print_length("way to 10 deg", c.initial_turning, L);
  if (c.time_90) say("  {:<20}{:>12.2f} s\n", "time to 90 deg", *c.time_90);
  if (c.time_180) say("  {:<20}{:>12.2f} s\n", "time to 180 deg", *c.time_180);
  if (c.way_lost) return say("  no steady turn: the ship no longer moves ahead at {:.1f} s\n", *c.way_lost);
  if (!c.steady) return say("  no steady turn was found\n");
  print_length("final diameter", c.final_diameter, L);
  say("  {:<20}{:>12.4f} m/s, {:.0f} % of the approach\n", "final speed", speed(*c.steady),
      100.0 * speed(*c.steady) / c.approach_speed);
  say("  {:<20}{:>12.2f} deg\n", "final drift angle", degrees(drift_angle(*c.steady)));
  say("  {:<20}{:>12.4f} deg/s\n", "final yaw rate", degrees(c.steady->r));
}

void run_circle(const Ship& ship, const SimulateArguments& a) {
  const TurnOrder order{.rudder = radians(*a.turn), .side = side_named(a.first)};
  auto result = turning_circle(ship, order, options_of(a));
  write_run(result.run, ship, a);
  write_page_of(ship, result.approach_speed, result.propulsion, a,
                [&](const Sailed& s) { return circle_page(ship, result, order, s); });
  if (a.json) print_document(circle_json(ship, result, order));
  else print_circle(ship, result);
  if (!a.json) print_criteria(criteria_of(result, order, length(ship), turning_rudder(ship)));
}

}  // namespace

void simulate(const SimulateArguments& a) {
  const AnyShip any = load_ship(a.ship);
  if (const auto* linear = std::get_if<LinearShip>(&any)) return simulate_linear(*linear, a);
  const auto& ship = std::get<Ship>(any);
  if (!a.zigzag.empty()) run_zigzag(ship, a);
  else if (a.turn) run_circle(ship, a);
  else run_trial(ship, a);
}

}  // namespace swayaw::app
