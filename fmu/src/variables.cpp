#include "variables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "swayaw/core/refusal.hpp"

namespace swayaw::fmu {
namespace {

/// Whether she is driven at a shaft speed; else at a thrust, or by her polynomial, whose thrust is not told.
bool at_shaft_speed(const swayaw_ship& ship) { return value_of(ship, "rev_s") != 0.0; }

/// Whether the ship file tells what she shows the wind; the ship is changed.
bool takes_wind(swayaw_ship& ship) { return swayaw_set(&ship, "wind_speed_m_s", 1.0) == 0; }

bool is_absent(const swayaw_ship& ship, const swayaw_quantity& quantity, bool windage) {
  const std::string_view name = quantity.name;
  if (name == "rev_s") return !at_shaft_speed(ship);
  if (name.starts_with("wind_")) return !windage;
  return std::isnan(value_of(ship, quantity.name));
}

Causality causality_of(const swayaw_ship& ship, const swayaw_quantity& quantity) {
  const std::string_view name = quantity.name;
  if (name == "time_s") return Causality::independent;
  if (name == "thrust_N" && at_shaft_speed(ship)) return Causality::output;
  return quantity.kind == SWAYAW_ORDER ? Causality::input : Causality::output;
}

void add_quantities(std::vector<Variable>& variables, const std::string& ship) {
  const auto handle = open_ship(ship, 0.0), blown = open_ship(ship, 0.0);
  const bool windage = takes_wind(*blown);
  for (int i = 0; const auto* q = swayaw_quantity_at(i); ++i) {
    if (is_absent(*handle, *q, windage)) continue;
    const auto type = std::string_view(q->name) == "validity" ? Type::integer : Type::real;
    variables.push_back({static_cast<unsigned>(i), q->name, type, causality_of(*handle, *q), q->unit, q->description,
                         value_of(*handle, q->name)});
  }
}

void add_start(std::vector<Variable>& variables, const std::string& ship) {
  const auto add = [&](Reference reference, std::string name, std::string unit, std::string description, double start) {
    variables.push_back(
        {reference, std::move(name), Type::real, Causality::parameter, std::move(unit), std::move(description), start});
  };
  variables.push_back({ship_file, "ship_file", Type::string, Causality::parameter, "1",
                       "ship file in the folder resources", 0.0, std::string(default_ship_file)});
  add(start_speed, "start.speed_m_s", "m/s", "speed at the start, straight ahead through the water",
      value_of(*open_ship(ship, 0.0), "u_m_s"));
  add(start_x, "start.x_m", "m", "place at the start, northward", 0.0);
  add(start_y, "start.y_m", "m", "place at the start, eastward", 0.0);
  add(start_psi, "start.psi_rad", "rad", "heading at the start, clockwise from north", 0.0);
}

}  // namespace

ShipHandle open_ship(const std::string& ship, double speed) {
  ShipHandle handle(swayaw_open(ship.c_str(), speed));
  if (!handle) throw Refusal(swayaw_error());
  return handle;
}

double value_of(const swayaw_ship& ship, const std::string& name) {
  double value;
  if (swayaw_get(&ship, name.c_str(), &value) != 0) throw Refusal(swayaw_error());
  return value;
}

std::vector<Variable> variables_of(const std::string& ship) {
  std::vector<Variable> variables;
  add_quantities(variables, ship);
  add_start(variables, ship);
  variables.push_back({valid, "valid", Type::boolean, Causality::output, "1", "whether the force model holds"});
  variables.push_back({why, "why", Type::string, Causality::output, "1", "else what carries it on"});
  return variables;
}

std::string guid_of(std::string_view ship_text, const std::vector<Variable>& variables) {
  // FNV-1a of 64 bits
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto take = [&](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  };
  take(ship_text);
  for (const auto& v : variables) take(fmt::format("{} {} {}\n", v.reference, v.name, static_cast<int>(v.causality)));
  return fmt::format("{{swayaw-{:016x}}}", hash);
}

}  // namespace swayaw::fmu
