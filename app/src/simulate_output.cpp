#include "simulate_output.hpp"

#include <fmt/format.h>

#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::app {
namespace {

std::string_view verdict(const Criterion& c) {
  if (!c.pass) return "not judged";
  return *c.pass ? "pass" : "fail";
}

}  // namespace

ManoeuvreOptions options_of(const SimulateArguments& a) {
  return {.speed = a.speed,
          .rev = a.rev,
          .thrust = a.thrust,
          .duration = a.duration,
          .step = a.step,
          .tolerance = a.tolerance};
}

std::string propulsion_text(const Ship& ship, const Controls<double>& c) {
  if (!c.by_thrust && !takes_shaft_speed(ship)) return "propulsion held";
  if (!c.by_thrust) return fmt::format("shaft {:.5g} 1/s", c.rev);
  return fmt::format("thrust {:.5g} N", c.thrust.port + c.thrust.starboard);
}

void add_propulsion(Json& json, const Ship& ship, const Controls<double>& c) {
  if (c.by_thrust) json["thrust_N"] = c.thrust.port + c.thrust.starboard;
  else if (takes_shaft_speed(ship)) json["rev_s"] = c.rev;
}

Json criteria_json(const std::vector<Criterion>& criteria) {
  Json list = Json::array();
  for (const auto& c : criteria)
    list.push_back({{"name", c.name},
                    {"side", name_of(c.side)},
                    {"value", number(c.value)},
                    {"limit", c.limit},
                    {"unit", c.unit},
                    {"pass", c.pass ? Json(*c.pass) : Json(nullptr)}});
  return list;
}

void print_criteria(const std::vector<Criterion>& criteria) {
  if (criteria.empty()) return;
  fmt::print("  {:<24}{:<12}{:>12}{:>10}  {:<5}{}\n", "MSC.137(76)", "to", "value", "limit", "", "verdict");
  for (const auto& c : criteria) {
    const auto value = c.value ? fmt::format("{:.3f}", *c.value) : std::string("not reached");
    fmt::print("  {:<24}{:<12}{:>12}{:>10.3f}  {:<5}{}\n", c.name, name_of(c.side), value, c.limit, c.unit, verdict(c));
  }
}

void print_length(std::string_view name, const std::optional<double>& metres, double L) {
  if (metres) fmt::print("  {:<20}{:>12.2f} m{:>10.3f} L\n", name, *metres, *metres / L);
  else fmt::print("  {:<20}{:>12}\n", name, "not reached");
}

}  // namespace swayaw::app
