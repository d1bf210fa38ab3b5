#include <fmt/format.h>

#include <array>
#include <charconv>
#include <map>
#include <string>

#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

using Numbers = std::map<std::string, double, std::less<>>;

constexpr std::array<std::string_view, 9> known_keys{"u",   "v",      "r",           "delta",           "psi",
                                                     "rev", "thrust", "thrust_port", "thrust_starboard"};

/// "u=0.96,v=0.05" as parameters.
Numbers numbers_of(std::string_view text) {
  Numbers parameters;
  while (!text.empty()) {
    const auto comma = text.find(',');
    const auto item = text.substr(0, comma);
    const auto equals = item.find('=');
    if (equals == std::string_view::npos)
      throw Refusal(fmt::format("--state: \"{}\" is not of the form key=number", item));
    const auto key = item.substr(0, equals), value = item.substr(equals + 1);
    if (std::ranges::count(known_keys, key) == 0)
      throw Refusal(fmt::format("--state: {} is not known (known: {})", key, fmt::join(known_keys, ", ")));
    double number = 0.0;
    const auto end = std::from_chars(value.data(), value.data() + value.size(), number);
    if (end.ec != std::errc{} || end.ptr != value.data() + value.size() || !std::isfinite(number))
      throw Refusal(fmt::format("--state: {} must be a number, got \"{}\"", key, value));
    if (!parameters.emplace(key, number).second) throw Refusal(fmt::format("--state: {} is given twice", key));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  if (!parameters.contains("u")) throw Refusal("--state: u is missing");
  return parameters;
}

double value_of_key(const Numbers& parameters, std::string_view key) {
  const auto found = parameters.find(key);
  return found == parameters.end() ? 0.0 : found->second;
}

/// Shaft speed or thrust of the state; without either the ship's self-propulsion at service speed.
Controls<double> controls_of(const Ship& ship, const Numbers& n) {
  const double delta = value_of_key(n, "delta");
  const bool one = n.contains("thrust"), each = n.contains("thrust_port") || n.contains("thrust_starboard"),
             rev = n.contains("rev");
  if (one + each + rev > 1) throw Refusal("--state: give one of rev, thrust, and thrust_port with thrust_starboard");
  if (each && !(n.contains("thrust_port") && n.contains("thrust_starboard")))
    throw Refusal("--state: thrust_port and thrust_starboard go together");
  const auto given = [](bool there) { return there ? std::optional(0.0) : std::nullopt; };
  require_drive(ship.model, given(rev), given(one || each));
  if (rev) return {.delta = delta, .rev = value_of_key(n, "rev")};
  if (each)
    return {.delta = delta,
            .thrust = {value_of_key(n, "thrust_port"), value_of_key(n, "thrust_starboard")},
            .by_thrust = true};
  const double half = 0.5 * value_of_key(n, "thrust");
  if (one) return {.delta = delta, .thrust = {half, half}, .by_thrust = true};
  return with_rudder(self_propulsion(ship, service_speed(ship)), delta);
}

Json force_json(const PlanarForce<double>& f) { return {{"X", number(f.X)}, {"Y", number(f.Y)}, {"N", number(f.N)}}; }

Json document_of(const ForceBreakdown& split) {
  Json parts = Json::object();
  for (const auto& part : split.parts) parts[std::string(part.name)] = force_json(part.force);
  const auto& a = split.acceleration;
  return {{"schema", "swayaw.forces/1"},
          {"parts", std::move(parts)},
          {"total", force_json(split.total)},
          {"acceleration", {{"u", number(a.u)}, {"v", number(a.v)}, {"r", number(a.r)}}}};
}

void print_row(std::string_view name, const PlanarForce<double>& f) {
  say("  {:<24}{:>14.6g}{:>14.6g}{:>14.6g}\n", name, f.X, f.Y, f.N);
}

void print_text(const Ship& ship, const ForceBreakdown& split) {
  say("{}\n  {:<24}{:>14}{:>14}{:>14}\n", ship.name, "about midship", "X N", "Y N", "N N m");
  for (const auto& part : split.parts) print_row(part.name, part.force);
  print_row("total", split.total);
  const auto& a = split.acceleration;
  say("  {:<24}{:>14.6g}{:>14.6g}{:>14.6g}\n", "acceleration m/s2, rad/s2", a.u, a.v, a.r);
}

}  // namespace

void forces(const ForcesArguments& a) {
  const Ship ship = load_nonlinear_ship(a.ship);
  const auto n = numbers_of(a.state);
  const ShipState<double> state{
      0.0, 0.0, value_of_key(n, "psi"), {value_of_key(n, "u"), value_of_key(n, "v"), value_of_key(n, "r")}};
  const auto split = force_breakdown(ship, state, controls_of(ship, n));
  if (a.json) print_document(document_of(split));
  else print_text(ship, split);
}

}  // namespace swayaw::app
