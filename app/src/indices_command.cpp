#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "commands.hpp"
#include "indices_page.hpp"
#include "input.hpp"
#include "linear_model_mat.hpp"
#include "linear_output.hpp"
#include "page_writing.hpp"
#include "plot.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/linear/frequency_response.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What is printed of a ship; not a number where there is nothing.
struct Findings {
  SwayYawTransfer<double> h;
  SteeringIndices<double> i;
  SwayYawCoefficients<double> m;
  TimeConstants<double> T;
  double T_b, T_w;
};

Findings findings_of(const LinearShip& ship) {
  const auto h = transfer_functions(ship);
  const auto i = indices(ship);
  const auto m =
      has_coefficients(ship) ? coefficients(ship) : SwayYawCoefficients<double>{none, none, none, none, none, none};
  return {h,
          i,
          m,
          time_constants(h).value_or(TimeConstants<double>{none, none}),
          first_order_drift(i).T,
          first_order_yaw(i).T};
}

// ---------------------------------------------------------------- JSON

Json dimensional_json(const Findings& f, const PrimeScale& scale) {
  const double t = scale.L / scale.U;
  const auto d = dimensional(f.i, scale);
  const auto c = dimensional(f.m, scale);
  return {{"speed_m_s", scale.U},
          {"T1_s", number(f.T.T1 * t)},
          {"T2_s", number(f.T.T2 * t)},
          {"T1T2_s2", number(d.T1T2_s2)},
          {"T1_plus_T2_s", number(d.T1_plus_T2_s)},
          {"T3b_s", number(d.T3b_s)},
          {"T3w_s", number(d.T3w_s)},
          {"Kb", number(d.Kb)},
          {"K_r_per_s", number(d.Kr_per_s)},
          {"T_b_s", number(f.T_b * t)},
          {"T_w_s", number(f.T_w * t)},
          {"v_v_per_s", number(c.v_v)},
          {"v_r_m_per_s", number(c.v_r)},
          {"v_delta_m_per_s2", number(c.v_delta)},
          {"r_v_per_m_s", number(c.r_v)},
          {"r_r_per_s", number(c.r_r)},
          {"r_delta_per_s2", number(c.r_delta)}};
}

/// With the masses of the hull, or those of a ship whose virtual mass and moment of inertia are 1 and who has no mass
/// of her own.
Json sname_json(const LinearShip& ship, const SwayYawCoefficients<double>& m) {
  SnameDerivatives<double> masses{};
  masses.Y_vdot = masses.N_rdot = -1.0;
  const auto* given = parts(ship);
  if (given) masses = inertia(given->hull);
  const auto d = sname_derivatives(m, masses);
  Json json{{"Y_v", number(d.Y_v)}, {"Y_r", number(d.Y_r)}, {"Y_delta", number(d.Y_delta)},
            {"N_v", number(d.N_v)}, {"N_r", number(d.N_r)}, {"N_delta", number(d.N_delta)}};
  json["system"] = given ? "force 0.5 rho L T U^2, moment 0.5 rho L^2 T U^2" : "accelerations";
  if (given) json.update({{"m", d.m}, {"I_z", d.I_z}, {"Y_vdot", d.Y_vdot}, {"N_rdot", d.N_rdot}});
  return json;
}

Json split_json(const LinearParts<double>& ship) {
  const auto split = coefficients(ship);
  return {{"hull", coefficients_json(split.hull)},
          {"rudder", coefficients_json(split.rudder)},
          {"centrifugal", coefficients_json(split.centrifugal)}};
}

}  // namespace

Json indices_json(const LinearShip& ship, double speed) {
  const auto f = findings_of(ship);
  Json json{{"ship", ship.name}, {"length_m", ship.particulars.L}, {"given", form_words(ship)}};
  json.update(coefficients_json(f.m));
  json.update({{"T1", number(f.T.T1)},
               {"T2", number(f.T.T2)},
               {"T3b", number(f.i.T3b)},
               {"T3w", number(f.i.T3w)},
               {"Kb", number(f.i.Kb)},
               {"Kw", number(f.i.Kw)},
               {"T1T2", number(f.i.T1T2)},
               {"T1_plus_T2", number(f.i.T1_plus_T2)},
               {"T_b", number(f.T_b)},
               {"T_w", number(f.T_w)},
               {"stable", f.h.e0 > 0.0 && f.h.e1 > 0.0},
               {"complex_poles", f.h.e1 * f.h.e1 < 4.0 * f.h.e0}});
  json["dimensional"] = dimensional_json(f, prime_scale(ship, speed));
  json["sname"] = sname_json(ship, f.m);
  if (const auto* given = parts(ship)) json["parts"] = split_json(*given);
  json["condition_number"] = number(condition_number(f.m));
  const auto steering = steering_of(ship, speed);
  json["to_starboard"] = {{"K", number(steering.K_prime)}, {"T", number(steering.T_prime)}};
  json["dimensional"]["K_to_starboard_per_s"] = number(steering.K_per_s);
  return json;
}

namespace {

// ---------------------------------------------------------------- text

void print_index(std::string_view name, double prime, double dimensional, std::string_view unit,
                 std::string_view words) {
  say("  {:<9}{:>12}{:>13} {:<5} {}\n", name, cell(prime), cell(dimensional), unit, words);
}

void print_indices(const Findings& f, const PrimeScale& scale) {
  const double t = scale.L / scale.U;
  say("  {:<9}{:>12}{:>13}\n", "index", "per L/U", fmt::format("{:.4g} m/s", scale.U));
  print_index("T1", f.T.T1, f.T.T1 * t, "s", "slower mode");
  print_index("T2", f.T.T2, f.T.T2 * t, "s", "faster mode");
  print_index("T1 T2", f.i.T1T2, f.i.T1T2 * t * t, "s2", "");
  print_index("T1 + T2", f.i.T1_plus_T2, f.i.T1_plus_T2 * t, "s", "");
  print_index("T3b", f.i.T3b, f.i.T3b * t, "s", "rudder rate to drift");
  print_index("T3w", f.i.T3w, f.i.T3w * t, "s", "rudder rate to yaw");
  print_index("Kb", f.i.Kb, f.i.Kb, "-", "drift angle by rudder angle");
  print_index("Kw", f.i.Kw, f.i.Kw / t, "1/s", "yaw rate by rudder angle");
  print_index("T_b", f.T_b, f.T_b * t, "s", "first-order drift, T1 + T2 - T3b");
  print_index("T_w", f.T_w, f.T_w * t, "s", "first-order yaw, T1 + T2 - T3w");
  print_index("K", -f.i.Kw, -f.i.Kw / t, "1/s", "yaw rate by rudder to starboard, -Kw");
}

/// Six columns; a name that is longer than its column has a line of its own.
void print_row(std::string_view name, const std::vector<std::string>& cells) {
  constexpr std::size_t width = 18;
  say("  {:<{}}", name, width);
  if (name.size() > width) say("\n{:{}}", "", 2 + width);
  for (const auto& cell : cells) say("{:>10}", cell);
  say("\n");
}

/// The rudder's part of each coefficient in percent of the whole.
void print_rudder_share(const SwayYawCoefficients<double>& rudder, const SwayYawCoefficients<double>& whole) {
  std::vector<std::string> shares;
  for (const auto& p : whole.parameters())
    shares.push_back(fmt::format("{:.0f} %", 100.0 * rudder.*p.member / whole.*p.member));
  print_row("rudder share", shares);
}

void print_equations(const LinearShip& ship, const SwayYawCoefficients<double>& m) {
  say("\n");
  print_coefficient_names();
  if (const auto* given = parts(ship)) {
    const auto split = coefficients(*given);
    print_coefficients("hull", split.hull);
    print_coefficients("rudder", split.rudder);
    print_coefficients("centrifugal", split.centrifugal);
    print_coefficients("whole", m);
    print_rudder_share(split.rudder, m);
  } else {
    print_coefficients("whole", m);
  }
}

}  // namespace

void print_index_table(const LinearShip& ship, double speed) {
  print_indices(findings_of(ship), prime_scale(ship, speed));
}

Steering steering_of(const LinearShip& ship, double speed) {
  const auto i = indices(ship);
  const double T = first_order_yaw(i).T, t = ship.particulars.L / speed;
  return {.K_prime = -i.Kw, .T_prime = T, .K_per_s = -i.Kw / t, .T_s = T * t};
}

void print_steering(const LinearShip& ship, double speed) {
  const auto s = steering_of(ship, speed);
  say("  yaw rate by rudder to starboard: K' = {} ({} 1/s), T' = {} ({} s)\n", cell(s.K_prime), cell(s.K_per_s),
      cell(s.T_prime), cell(s.T_s));
  say("  {}\n", stability_words(transfer_functions(ship)));
}

void print_coefficient_names() { print_row("", {"a1", "b1", "c1", "a2", "b2", "c2"}); }

void print_coefficients(std::string_view name, const SwayYawCoefficients<double>& m) {
  std::vector<std::string> cells;
  for (const auto& p : m.parameters()) cells.push_back(fmt::format("{:.4g}", m.*p.member + 0.0));
  print_row(name, cells);
}

namespace {

void print_text(const LinearShip& ship, double speed) {
  const auto f = findings_of(ship);
  say("{}: L = {:.5g} m, given by {}\n", ship.name, ship.particulars.L, form_words(ship));
  say("The ship is {}.\n\n", stability_words(f.h));
  print_indices(f, prime_scale(ship, speed));
  print_equations(ship, f.m);
  if (!has_coefficients(ship)) say("\nNo coupled equations follow from these indices: T3b = T3w, or Kb or Kw = 0.\n");
}

// ---------------------------------------------------------------- plot

/// Whole decades around the corner frequencies of poles and zeros, which are at least a factor of 3 inside.
std::vector<double> frequencies_of(const SwayYawTransfer<double>& h) {
  std::vector<double> corners{std::abs(h.e0 / h.e1), std::sqrt(std::abs(h.e0)), std::abs(h.e1), std::abs(h.nb0 / h.nb1),
                              std::abs(h.nw0 / h.nw1)};
  std::erase_if(corners, [](double x) { return !std::isnormal(x); });
  const auto [low, high] = std::ranges::minmax(corners);
  return logarithmic_frequencies(std::pow(10.0, std::floor(std::log10(low / 3.0))),
                                 std::pow(10.0, std::ceil(std::log10(3.0 * high))), 400);
}

/// Adds the gain and the phase of one motion, where the rudder moves it at all.
void add_motion(Plot& plot, const std::string& name, const RudderTransfer<double>& t,
                const std::vector<double>& frequencies, const Stroke& stroke) {
  if (t.n0 == 0.0 && t.n1 == 0.0) return;
  std::vector<double> gains, phases_deg;
  for (const double nu : frequencies) {
    gains.push_back(gain(t, nu));
    phases_deg.push_back(degrees(phase(t, nu)));
  }
  plot.panels[0].curves.push_back({name, frequencies, std::move(gains), stroke});
  plot.panels[1].curves.push_back({name, frequencies, std::move(phases_deg), stroke});
}

/// @throws Refusal  if the rudder moves the ship in no way
Plot bode_plot(const LinearShip& ship, const SwayYawTransfer<double>& h, double speed) {
  const Axis frequency{"Frequency", "rad per ship length", true};
  Plot plot{
      fmt::format("{}: drift and yaw by rudder, one ship length in {:.4g} s", ship.name, ship.particulars.L / speed),
      {{.x = frequency, .y = {"Gain", "", true}, .curves = {}},
       {.x = frequency, .y = {"Phase", "deg", false, 45.0}, .curves = {}}}};
  const auto frequencies = frequencies_of(h);
  add_motion(plot, "drift angle β / δ", rudder_to_drift(h), frequencies, {ink::drift});
  add_motion(plot, "yaw rate ω′ / δ", rudder_to_yaw(h), frequencies, {ink::yaw});
  if (plot.panels[0].curves.empty())
    throw Refusal("the rudder moves this ship neither in drift nor in yaw: there is nothing to plot");
  return plot;
}

// ---------------------------------------------------------------- sides

SteeringSides sides_of(AnyShip any, const std::optional<double>& speed) {
  if (auto* linear = std::get_if<LinearShip>(&any)) return {std::move(*linear), {}, {}};
  const auto& ship = std::get<Ship>(any);
  say_aside("swayaw: {}: linearized about the straight course\n", ship.name);
  const auto point = straight_course(ship, speed.value_or(service_speed(ship)));
  const auto on = [&](std::optional<Side> side) { return linear_ship(ship, linearize(ship, point, side)); };
  if (!has_kink(ship, point)) return {on(std::nullopt), {}, {}};
  return {on(std::nullopt), on(Side::port), on(Side::starboard)};
}

Json document_of(const SteeringSides& sides, double speed) {
  Json json{{"schema", "swayaw.indices/1"}};
  json.update(indices_json(sides.mean, speed));
  if (sides.port) json["port"] = indices_json(*sides.port, speed);
  if (sides.starboard) json["starboard"] = indices_json(*sides.starboard, speed);
  return json;
}

void print_sides(const SteeringSides& sides, double speed) {
  if (!sides.port) return print_text(sides.mean, speed);
  say("Her forces have a kink straight ahead: rudder, propeller or wake differ between turns to port and to "
      "starboard.\n"
      "First the mean of both, then each.\n\n");
  print_text(sides.mean, speed);
  for (const auto& [side, ship] : {std::pair{Side::port, &*sides.port}, {Side::starboard, &*sides.starboard}}) {
    say("\nturning to {}: she is {}\n", name_of(side), stability_words(transfer_functions(*ship)));
    print_index_table(*ship, speed);
  }
}

}  // namespace

void indices(const IndicesArguments& a) {
  const auto sides = sides_of(load_ship(a.ship), a.speed);
  const double speed = speed_of(sides.mean, a.speed);
  if (!a.svg.empty()) write_text(a.svg, svg_of(bode_plot(sides.mean, transfer_functions(sides.mean), speed)));
  if (a.report.wanted()) write_page(a.report.file, html(indices_page(sides, a.ship.string(), speed, a.report.si)));
  if (!a.out.empty()) write_linear_model(a.out, sides, speed);
  if (a.json) print_document(document_of(sides, speed));
  else print_sides(sides, speed);
}

}  // namespace swayaw::app
