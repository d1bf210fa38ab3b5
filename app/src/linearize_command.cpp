#include <fmt/format.h>

#include "commands.hpp"
#include "input.hpp"
#include "linear_model_mat.hpp"
#include "linear_output.hpp"
#include "swayaw/nonlinear/equilibria.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

/// The fastest stable turn at that rudder angle, or the fastest if none is stable.
OperatingPoint steady_turn(const Ship& ship, const Controls<double>& controls) {
  const auto turns = steady_turns(ship, controls);
  const auto better = [](const SteadyMotion& x, const SteadyMotion& y) {
    return x.stable != y.stable ? y.stable : speed(x.motion) < speed(y.motion);
  };
  if (turns.empty())
    throw Refusal(fmt::format("the ship has no steady turn at a rudder angle of {:.6g} deg", degrees(controls.delta)));
  return {std::ranges::max_element(turns, better)->motion, controls};
}

/// Whether a speed and another drive than self-propulsion are given: a motion that is not steady.
bool is_transient(const LinearizeArguments& a) { return a.speed && (a.rev || a.thrust); }

/// As asked: straight ahead, or in a steady turn.
/// @throws Refusal  if a steady turn is asked for at a speed that it does not have
OperatingPoint point_of(const Ship& ship, const LinearizeArguments& a) {
  const auto driven = propulsion(ship, a.speed.value_or(service_speed(ship)), a.rev, a.thrust);
  if (a.rudder && is_transient(a))
    throw Refusal("--rudder asks for the steady turn, whose speed follows from --rev or --thrust: leave out --speed");
  if (is_transient(a)) return {{*a.speed, 0.0, 0.0}, driven};
  if (a.rudder) return steady_turn(ship, with_rudder(driven, radians(*a.rudder)));
  return a.rev || a.thrust ? straight_course(ship, driven)
                           : straight_course(ship, a.speed.value_or(service_speed(ship)));
}

// ---------------------------------------------------------------- JSON

Json point_json(const OperatingPoint& point) {
  const auto& [m, c] = point;
  Json json{{"u_m_s", m.u}, {"v_m_s", m.v}, {"r_rad_s", m.r}, {"delta_rad", c.delta}};
  if (c.by_thrust) json["thrust_N"] = c.thrust.port + c.thrust.starboard;
  else json["rev_s"] = c.rev;
  return json;
}

Json sname_json(const Linearization& linear) {
  const auto d = sname(linear);
  return {{"system", "force 0.5 rho L^2 U^2, moment 0.5 rho L^3 U^2"},
          {"Y_v", d.Y_v},
          {"Y_r", d.Y_r},
          {"Y_delta", d.Y_delta},
          {"N_v", d.N_v},
          {"N_r", d.N_r},
          {"N_delta", d.N_delta},
          {"m", d.m},
          {"x_G", d.x_G},
          {"I_z", d.I_z},
          {"Y_vdot", d.Y_vdot},
          {"Y_rdot", d.Y_rdot},
          {"N_vdot", d.N_vdot},
          {"N_rdot", d.N_rdot}};
}

Json parts_json(const Linearization& linear) {
  Json parts = Json::object();
  for (const auto& part : linear.parts) parts[part.name] = coefficients_json(sway_yaw(part.derivatives, linear.scale));
  return parts;
}

Json poles_json(const Linearization& linear) {
  Json poles = Json::array();
  for (const auto& pole : linear.poles)
    poles.push_back({{"real_per_s", pole.real()}, {"imaginary_per_s", pole.imag()}});
  return poles;
}

Json document_of(const Ship& ship, const Linearization& linear) {
  Json json = indices_json(linear_ship(ship, linear), linear.scale.U);
  json["sname"] = sname_json(linear);
  json["parts"] = parts_json(linear);
  json["operating_point"] = point_json(linear.point);
  json["poles"] = poles_json(linear);
  return json;
}

/// Both sides, where they differ.
void add_sides(Json& json, const Ship& ship, const OperatingPoint& point) {
  for (const Side side : {Side::port, Side::starboard})
    json[std::string(name_of(side))] = document_of(ship, linearize_transient(ship, point, side));
}

LinearizedSides both_sides(const Ship& ship, const Linearization& mean) {
  const auto on = [&](Side side) { return linearize_transient(ship, mean.point, side); };
  return {mean, on(Side::port), on(Side::starboard)};
}

// ---------------------------------------------------------------- text

void print_parts(const Linearization& linear) {
  say("\n");
  print_coefficient_names();
  for (const auto& part : linear.parts) print_coefficients(part.name, sway_yaw(part.derivatives, linear.scale));
  print_coefficients("whole", sway_yaw(linear.whole, linear.scale));
}

void print_text(const Ship& ship, const Linearization& linear, std::string_view of_what) {
  const auto& [m, c] = linear.point;
  say("{}{}\n", ship.name, of_what);
  say("Small motions about u {:.5g} m/s, v {:.4g} m/s, r {:.4g} deg/s, delta {:.4g} deg.\n", m.u, m.v, degrees(m.r),
      degrees(c.delta));
  const auto slim = linear_ship(ship, linear);
  say("The ship is {}.\n\n", stability_words(transfer_functions(slim)));
  print_index_table(slim, linear.scale.U);
  print_parts(linear);
}

}  // namespace

void linearize(const LinearizeArguments& a) {
  const Ship ship = load_nonlinear_ship(a.ship);
  const auto point = point_of(ship, a);
  const bool kink = a.side.empty() && has_kink(ship, point);
  const auto side = a.side.empty() ? std::nullopt : std::optional(side_named(a.side));
  const auto linear = is_transient(a) ? linearize_transient(ship, point, side) : linearize(ship, point, side);
  if (!a.out.empty())
    write_linear_model(a.out, ship, kink ? both_sides(ship, linear) : LinearizedSides{linear, {}, {}});
  if (a.json) {
    Json json{{"schema", "swayaw.linearization/1"}};
    json.update(document_of(ship, linear));
    if (kink) add_sides(json, ship, point);
    print_document(json);
    return;
  }
  if (is_transient(a))
    say_aside("swayaw: {}: about a speed that this propulsion does not keep; the numbers hold near it\n", ship.name);
  print_text(ship, linear, kink ? ", mean of turns to both sides" : "");
  if (!kink) return;
  for (const Side each : {Side::port, Side::starboard}) {
    say("\n");
    print_text(ship, linearize_transient(ship, point, each), fmt::format(", turning to {}", name_of(each)));
  }
}

}  // namespace swayaw::app
