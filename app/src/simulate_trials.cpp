#include "simulate_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input.hpp"
#include "simulate_criteria.hpp"
#include "simulate_files.hpp"
#include "simulate_output.hpp"
#include "simulate_trials_page.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"
#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"
#include "swayaw/nonlinear/manoeuvres/spiral.hpp"
#include "swayaw/nonlinear/manoeuvres/steady_run_in_wind.hpp"
#include "swayaw/nonlinear/manoeuvres/williamson_turn.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

/// As asked, else the usual angle or the ship's largest [rad].
double rudder_of(const Ship& ship, const SimulateArguments& a, double usual_deg) {
  return a.rudder ? radians(*a.rudder) : std::min(radians(usual_deg), steering_gear(ship).max_angle);
}

template <class Range, class Value>
Json column(const Range& rows, Value&& value) {
  Json list = Json::array();
  for (const auto& row : rows) list.push_back(value(row));
  return list;
}

void print_head(const Ship& ship, std::string_view manoeuvre, double speed, const Controls<double>& propulsion) {
  say("{}: {}, approach {:.4g} m/s, {}\n", ship.name, manoeuvre, speed, propulsion_text(ship, propulsion));
}

// ---------------------------------------------------------------- spirals

template <class Point>
Json motions_json(const std::vector<Point>& points) {
  return {{"delta_rad", column(points, [](const Point& p) { return number(p.delta); })},
          {"r_rad_s", column(points, [](const Point& p) { return number(p.motion.r); })},
          {"u_m_s", column(points, [](const Point& p) { return number(p.motion.u); })},
          {"v_m_s", column(points, [](const Point& p) { return number(p.motion.v); })}};
}

Json way_json(const std::vector<SpiralPoint>& points) {
  Json json = motions_json(points);
  json["held_s"] = column(points, [](const SpiralPoint& p) { return number(p.held); });
  json["settled"] = column(points, [](const SpiralPoint& p) { return p.settled; });
  return json;
}

Json curve_json(const std::vector<SteadyTurn>& curve) {
  Json json = motions_json(curve);
  json["stable"] = column(curve, [](const SteadyTurn& p) { return p.stable; });
  return json;
}

template <class Loop>
Json loop_json(const std::optional<Loop>& loop) {
  if (!loop) return nullptr;
  return {{"width_rad", loop->width}, {"height_rad_s", loop->height}};
}

Json spiral_json(const Ship& ship, const Spiral& s, const SpiralOrder& order) {
  Json json{{"schema", "swayaw.spiral/1"},
            {"manoeuvre", fmt::format("spiral {:.6g}", degrees(order.largest))},
            {"first", name_of(order.first)},
            {"approach_speed_m_s", s.approach_speed},
            {"down", way_json(s.down)},
            {"up", way_json(s.up)},
            {"loop", loop_json(s.loop)},
            {"curve", curve_json(s.curve)},
            {"instability_loop", loop_json(s.exact)}};
  add_propulsion(json, ship, s.propulsion);
  return json;
}

std::string yaw_rate_cell(const SpiralPoint& p) {
  return fmt::format("{:.5f}{}", degrees(p.motion.r), p.settled ? " " : "*");
}

void print_loop(std::string_view name, const std::optional<InstabilityLoop>& loop) {
  if (loop) say("  {}: {:.3f} deg wide, {:.5f} deg/s high\n", name, degrees(loop->width), degrees(loop->height));
  else say("  {}: none\n", name);
}

void print_loop(std::string_view name, const std::optional<SpiralLoop>& loop, double step) {
  if (loop)
    say("  {}: {:.3f} to {:.3f} deg wide, {:.5f} deg/s high\n", name, degrees(loop->width),
        degrees(loop->width + 2.0 * step), degrees(loop->height));
  else say("  {}: none\n", name);
}

void print_spiral(const Ship& ship, const Spiral& s, double step) {
  print_head(ship, s.run.facts.manoeuvre, s.approach_speed, s.propulsion);
  say("  {:>12}{:>18}{:>18}\n", "rudder deg", "way out deg/s", "way back deg/s");
  for (std::size_t i = 0; i < s.down.size(); ++i)
    say("  {:>12.3f}{:>18}{:>18}\n", degrees(s.down[i].delta), yaw_rate_cell(s.down[i]),
        yaw_rate_cell(s.up[s.up.size() - 1 - i]));
  const auto all_settled = [](const auto& way) { return std::ranges::all_of(way, &SpiralPoint::settled); };
  if (!all_settled(s.down) || !all_settled(s.up)) say("  * not steady when the wait ended\n");
  print_loop("loop of the spiral", s.loop, step);
  print_loop("loop of the steady turns", s.exact);
}

void run_spiral(const Ship& ship, const SimulateArguments& a) {
  const SpiralOrder order{.largest = rudder_of(ship, a, 25.0),
                          .step = radians(a.rudder_step),
                          .first = side_named(a.first),
                          .settling = {}};
  auto options = options_of(a);
  options.sampled = wants_files(a);
  auto result = spiral(ship, order, options);
  write_run(result.run, ship, a);
  write_page_of(ship, result.approach_speed, result.propulsion, a,
                [&](const Sailed& s) { return spiral_page(result, order, s); });
  if (a.json) print_document(spiral_json(ship, result, order));
  else print_spiral(ship, result, order.step);
}

Json reverse_json(const Ship& ship, const ReverseSpiral& s, double largest) {
  const auto of_turn = [&](auto&& value) {
    return column(s.points, [&](const HeldYawRate& p) { return p.turn ? Json(value(*p.turn)) : Json(nullptr); });
  };
  Json json{{"schema", "swayaw.reverse_spiral/1"},
            {"manoeuvre", fmt::format("reverse spiral {:.6g}", degrees(largest))},
            {"approach_speed_m_s", s.approach_speed},
            {"r_rad_s", column(s.points, [](const HeldYawRate& p) { return number(p.r); })},
            {"delta_rad", of_turn([](const SteadyTurn& t) { return t.delta; })},
            {"u_m_s", of_turn([](const SteadyTurn& t) { return t.motion.u; })},
            {"v_m_s", of_turn([](const SteadyTurn& t) { return t.motion.v; })},
            {"stable", of_turn([](const SteadyTurn& t) { return t.stable; })}};
  add_propulsion(json, ship, s.propulsion);
  return json;
}

void run_reverse_spiral(const Ship& ship, const SimulateArguments& a) {
  const ReverseSpiralOrder order{.largest = rudder_of(ship, a, 25.0)};
  const auto result = reverse_spiral(ship, order, options_of(a));
  write_page_of(ship, result.approach_speed, result.propulsion, a,
                [&](const Sailed& s) { return reverse_spiral_page(result, order, s); });
  if (a.json) {
    print_document(reverse_json(ship, result, order.largest));
    return;
  }
  print_head(ship, "reverse spiral", result.approach_speed, result.propulsion);
  say("  {:>16}{:>14}\n", "yaw rate deg/s", "rudder deg");
  for (const auto& [r, turn] : result.points) {
    if (turn)
      say("  {:>16.5f}{:>14.4f}{}\n", degrees(r), degrees(turn->delta),
          turn->stable ? "" : "  unstable with the rudder fixed");
    else say("  {:>16.5f}{:>14}\n", degrees(r), "beyond");
  }
}

// ---------------------------------------------------------------- pull-out

Json side_json(const PullOutSide& s) {
  return {{"execute_s", s.execute},
          {"turning_yaw_rate_rad_s", s.turning},
          {"turning_settled", s.turning_settled},
          {"residual_yaw_rate_rad_s", s.residual},
          {"settled", s.settled},
          {"fall_time_s", number(s.fall_time)},
          {"decay_time_s", number(s.decay_time)},
          {"linear_T1_s", number(s.T1)}};
}

bool is_steady(const PullOutSide& s) { return s.settled && s.turning_settled; }

void print_side(std::string_view name, const PullOutSide& s) {
  const auto seconds = [](const std::optional<double>& t) { return t ? fmt::format("{:.2f}", *t) : std::string("-"); };
  say("  {:<10}{:>14.5f}{:>16.5f}{:>12}{:>12}{:>12}{}\n", name, degrees(s.turning), degrees(s.residual),
      seconds(s.fall_time), seconds(s.decay_time), seconds(s.T1), is_steady(s) ? "" : " *");
}

void run_pull_out(const Ship& ship, const SimulateArguments& a) {
  const PullOutOrder order{.rudder = radians(*a.pullout), .settling = {}};
  auto result = pull_out(ship, order, options_of(a));
  const auto& [port, starboard] = result.sides;
  write_run(side_named(a.first) == Side::port ? result.sides.port.run : result.sides.starboard.run, ship, a);
  write_page_of(ship, result.approach_speed, result.propulsion, a,
                [&](const Sailed& s) { return pull_out_page(result, order, s); });
  if (a.json) {
    Json json{{"schema", "swayaw.pullout/1"},
              {"manoeuvre", fmt::format("pullout {:.6g}", *a.pullout)},
              {"approach_speed_m_s", result.approach_speed},
              {"port", side_json(port)},
              {"starboard", side_json(starboard)}};
    add_propulsion(json, ship, result.propulsion);
    print_document(json);
  } else {
    print_head(ship, fmt::format("pullout {:.6g}", *a.pullout), result.approach_speed, result.propulsion);
    say("  {:<10}{:>14}{:>16}{:>12}{:>12}{:>12}\n", "from", "turning deg/s", "residual deg/s", "fall s", "decay s",
        "T1 s");
    print_side("starboard", starboard);
    print_side("port", port);
    if (!is_steady(port) || !is_steady(starboard)) say("  * not steady when the wait ended\n");
  }
}

// ---------------------------------------------------------------- Williamson turn

Json place_json(const std::optional<TrackPlace>& p) {
  if (!p) return nullptr;
  return {{"time_s", p->time}, {"along_m", p->along}, {"offset_m", p->offset}};
}

Json williamson_json(const Ship& ship, const WilliamsonTurn& w, const WilliamsonOrder& order) {
  Json json{
      {"schema", "swayaw.williamson/1"},        {"manoeuvre", fmt::format("williamson {:.6g}", degrees(order.rudder))},
      {"first", name_of(order.first)},          {"approach_speed_m_s", w.approach_speed},
      {"shifted", place_json(w.shifted)},       {"amidships", place_json(w.amidships)},
      {"reciprocal", place_json(w.reciprocal)}, {"way_m", number(w.way)},
      {"final_heading_rad", w.heading},         {"final_yaw_rate_rad_s", w.yaw_rate}};
  add_propulsion(json, ship, w.propulsion);
  return json;
}

void print_place(std::string_view name, const std::optional<TrackPlace>& p, double L) {
  if (!p) say("  {:<24}{:>10}\n", name, "not reached");
  else say("  {:<24}{:>10.2f}{:>12.2f}{:>12.2f}{:>10.3f}\n", name, p->time, p->along, p->offset, p->offset / L);
}

void run_williamson(const Ship& ship, const SimulateArguments& a) {
  const double L = length(ship);
  const WilliamsonOrder order{.rudder = rudder_of(ship, a, 35.0), .first = side_named(a.first)};
  auto result = williamson_turn(ship, order, options_of(a));
  write_run(result.run, ship, a);
  write_page_of(ship, result.approach_speed, result.propulsion, a,
                [&](const Sailed& s) { return williamson_page(result, order, s); });
  if (a.json) {
    print_document(williamson_json(ship, result, order));
    return;
  }
  print_head(ship, result.run.facts.manoeuvre, result.approach_speed, result.propulsion);
  say("  {:<24}{:>10}{:>12}{:>12}{:>10}\n", "", "at s", "along m", "offset m", "offset L");
  print_place("rudder to the other side", result.shifted, L);
  print_place("rudder amidships", result.amidships, L);
  print_place("reciprocal heading", result.reciprocal, L);
  if (result.way) print_length("way made", result.way, L);
  if (!result.reciprocal) say("  the heading had changed by {:.2f} deg at the end\n", degrees(result.heading));
}

// ---------------------------------------------------------------- straight run in wind

Json straight_json(const Ship& ship, const WindRun& run, const Controls<double>& propulsion) {
  const auto& f = run.wind_force;
  Json json{{"schema", "swayaw.straight_run/1"},
            {"manoeuvre", "straight run"},
            {"course_rad", number(run.course)},
            {"heading_rad", number(run.psi)},
            {"drift_rad", number(drift_angle(run.motion))},
            {"helm_rad", number(run.delta)},
            {"holds", run.holds},
            {"speed_m_s", number(speed(run.motion))},
            {"speed_over_ground_m_s", number(run.speed_over_ground)},
            {"wind_force", {{"X", number(f.X)}, {"Y", number(f.Y)}, {"N", number(f.N)}}}};
  add_propulsion(json, ship, propulsion);
  return json;
}

void run_straight(const Ship& ship, const SimulateArguments& a) {
  const auto around = surroundings_at(ship, 0.0);
  const double approach = a.speed.value_or(service_speed(ship));
  const auto driven = propulsion(ship, approach, a.rev, a.thrust);
  const auto windage = around.windy ? around.windage : Windage<double>{};
  const WindRunOrder order{.direction = radians(*a.straight), .propulsion = driven};
  const auto run = steady_run_in_wind(ship, windage, around.wind, order);
  if (!run)
    throw Refusal(
        fmt::format("no drift and helm keep the ship on course {:.6g} deg in this wind and current", *a.straight));
  write_page_of(ship, approach, driven, a, [&](const Sailed& s) { return straight_page(ship, *run, order, s); });
  if (a.json) {
    print_document(straight_json(ship, *run, driven));
    return;
  }
  print_head(ship, fmt::format("straight run, course {:.6g} deg", *a.straight), approach, driven);
  say("  {:<20}{:>12.3f} deg\n", "heading", degrees(run->psi));
  say("  {:<20}{:>12.3f} deg\n", "drift angle", degrees(drift_angle(run->motion)));
  say("  {:<20}{:>12.3f} deg to {}{}\n", "helm", std::abs(degrees(run->delta)), run->delta > 0.0 ? "port" : "starboard",
      run->holds ? "" : ", beyond the ship's largest: she cannot hold this course");
  say("  {:<20}{:>12.4f} m/s through the water, {:.4f} m/s over ground\n", "speed", speed(run->motion),
      run->speed_over_ground);
  say("  {:<20}X {:.5g} N, Y {:.5g} N, N {:.5g} N m\n", "wind", run->wind_force.X, run->wind_force.Y,
      run->wind_force.N);
}

// ---------------------------------------------------------------- IMO criteria

void run_imo(const Ship& ship, const SimulateArguments& a) {
  const auto result = imo_criteria(ship, options_of(a));
  write_page_of(ship, result.speed, result.propulsion, a,
                [&](const Sailed& s) { return imo_page(ship, result, options_of(a), s); });
  if (a.json) {
    Json json{{"schema", "swayaw.imo/1"},
              {"manoeuvre", "imo"},
              {"length_m", result.L},
              {"test_speed_m_s", result.speed},
              {"length_over_speed_s", result.L / result.speed},
              {"criteria", criteria_json(result.criteria)},
              {"not_simulated", Json::array({"stopping"})}};
    add_propulsion(json, ship, result.propulsion);
    print_document(json);
    return;
  }
  print_head(ship, fmt::format("steering criteria, L/V {:.3g} s", result.L / result.speed), result.speed,
             result.propulsion);
  print_criteria(result.criteria);
  say("  stopping is not simulated\n");
  if (surroundings_at(ship, 0.0).windy) say("  sailed in the wind of the ship file; the criteria are for calm\n");
  if (result.L < smallest_judged_ship)
    say("  the criteria are for ships of 100 m and more; the limits of a scale model's L/V are not those of her "
        "ship\n");
}

}  // namespace

void run_trial(const Ship& ship, const SimulateArguments& a) {
  if (a.spiral) return run_spiral(ship, a);
  if (a.reverse_spiral) return run_reverse_spiral(ship, a);
  if (a.pullout) return run_pull_out(ship, a);
  if (a.straight) return run_straight(ship, a);
  if (a.williamson) return run_williamson(ship, a);
  return run_imo(ship, a);
}

}  // namespace swayaw::app
