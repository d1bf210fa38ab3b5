#include "simulate_output.hpp"

#include <fmt/format.h>

#include "input.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "terminal.hpp"

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

Json zigzag_json(const Ship& ship, const Zigzag& z, const ZigzagOrder& order) {
  Json execute = Json::array({0.0}), peaks = Json::array(), overshoots = Json::array();
  for (const auto& reversal : z.reversals) {
    execute.push_back(reversal.time);
    if (!reversal.overshoot) continue;
    peaks.push_back(*reversal.peak_time);
    overshoots.push_back(degrees(*reversal.overshoot));
  }
  Json json{{"schema", "swayaw.zigzag/1"},
            {"manoeuvre", name_of(ZigzagAngles{order.rudder, order.heading})},
            {"first", name_of(order.first)},
            {"approach_speed_m_s", z.approach_speed},
            {"execute_s", std::move(execute)},
            {"peak_s", std::move(peaks)},
            {"overshoot_deg", std::move(overshoots)},
            {"period_s", number(z.period)},
            {"initial_turning_m", number(z.initial_turning)}};
  add_propulsion(json, ship, z.propulsion);
  json["criteria"] = criteria_json(criteria_of(z, order, length(ship)));
  return json;
}

Json circle_json(const Ship& ship, const TurningCircle& c, const TurnOrder& order) {
  const bool steady = c.steady.has_value();
  Json json{{"schema", "swayaw.turn/1"},
            {"manoeuvre", fmt::format("turn {:.6g}", degrees(order.rudder))},
            {"first", name_of(order.side)},
            {"approach_speed_m_s", c.approach_speed},
            {"advance_m", number(c.advance)},
            {"transfer_m", number(c.transfer)},
            {"tactical_diameter_m", number(c.tactical_diameter)},
            {"final_diameter_m", number(c.final_diameter)},
            {"time_90_s", number(c.time_90)},
            {"time_180_s", number(c.time_180)},
            {"initial_turning_m", number(c.initial_turning)},
            {"final_speed_m_s", steady ? number(speed(*c.steady)) : Json(nullptr)},
            {"final_drift_rad", steady ? number(drift_angle(*c.steady)) : Json(nullptr)},
            {"final_yaw_rate_rad_s", steady ? number(c.steady->r) : Json(nullptr)}};
  add_propulsion(json, ship, c.propulsion);
  json["criteria"] = criteria_json(criteria_of(c, order, length(ship), turning_rudder(ship)));
  return json;
}

void print_criteria(const std::vector<Criterion>& criteria) {
  if (criteria.empty()) return;
  say("  {:<24}{:<12}{:>12}{:>10}  {:<5}{}\n", "MSC.137(76)", "to", "value", "limit", "", "verdict");
  for (const auto& c : criteria) {
    const auto value = c.value ? fmt::format("{:.3f}", *c.value) : std::string("not reached");
    say("  {:<24}{:<12}{:>12}{:>10.3f}  {:<5}{}\n", c.name, name_of(c.side), value, c.limit, c.unit, verdict(c));
  }
}

void print_length(std::string_view name, const std::optional<double>& metres, double L) {
  if (metres) say("  {:<20}{:>12.2f} m{:>10.3f} L\n", name, *metres, *metres / L);
  else say("  {:<20}{:>12}\n", name, "not reached");
}

}  // namespace swayaw::app
