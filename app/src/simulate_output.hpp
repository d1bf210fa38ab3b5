#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "json.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"

/// What the manoeuvres of `swayaw simulate` share in print.
namespace swayaw::app {

ManoeuvreOptions options_of(const SimulateArguments& arguments);

/// "shaft 11.85 1/s", "thrust 11.2 N", or "propulsion held" for a ship without either.
std::string propulsion_text(const Ship& ship, const Controls<double>& controls);

/// Adds rev_s or thrust_N, if the ship has one.
void add_propulsion(Json& json, const Ship& ship, const Controls<double>& controls);

/// [{"name", "side", "value", "limit", "unit", "pass"}, …]
Json criteria_json(const std::vector<Criterion>& criteria);

/// Indices of a zigzag as `simulate --json` prints them.
Json zigzag_json(const Ship& ship, const Zigzag& zigzag, const ZigzagOrder& order);

/// The same of a turning circle.
Json circle_json(const Ship& ship, const TurningCircle& circle, const TurnOrder& order);

/// A table of value, limit and verdict; nothing without criteria.
void print_criteria(const std::vector<Criterion>& criteria);

/// "  advance    23.10 m   3.300 L".
void print_length(std::string_view name, const std::optional<double>& metres, double L);

}  // namespace swayaw::app
