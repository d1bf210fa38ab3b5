#include "swayaw/linear/loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "commands.hpp"
#include "input.hpp"
#include "linear_output.hpp"
#include "page_writing.hpp"
#include "swayaw/app/report.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/linear/batch.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

constexpr std::size_t shown_overshoots = 6;

/// The loop of a ship and how she came to it.
struct Finding {
  LinearZigzagOrder order;
  double speed;
  LimitCycle cycle;
  LoopMeasures<double> loop;
  std::optional<LoopSensitivity> sensitivity;
  std::vector<std::string> warnings;
};

/// Whether the inverse formulas give the ship back, so that T3b and T3w can be varied.
bool has_inverse(const SwayYawCoefficients<double>& m, const SteeringIndices<double>& i) {
  const auto again = coefficients_from(i);
  const auto list = m.parameters();
  return std::ranges::all_of(
      list, [&](const auto& p) { return std::abs(again.*p.member - m.*p.member) <= 1e-6 * std::abs(m.*p.member); });
}

/// The first few of a list of angles.
std::vector<double> first_in_degrees(std::vector<double> angles) {
  angles.resize(std::min(angles.size(), shown_overshoots));
  return in_degrees(std::move(angles));
}

std::vector<double> overshoots_deg(const std::vector<LinearReversal<double>>& reversals) {
  std::vector<double> angles;
  for (const auto& r : reversals) angles.push_back(r.overshoot);
  return first_in_degrees(std::move(angles));
}

/// Where no coupled equations follow from the indices, beta = (Kb/Kw) omega' all along: the loop is a line.
LoopMeasures<double> line_of(const SteeringIndices<double>& i, const LoopMeasures<double>& yaw) {
  LoopMeasures<double> line{};
  line.length = std::numeric_limits<double>::quiet_NaN();  // an ellipse of no area
  line.inclination = i.Kb == 0.0 ? 0.5 * pi : std::atan(i.Kw / i.Kb);
  line.omega_max = yaw.omega_max;
  line.beta_max = std::abs(i.Kb / i.Kw) * yaw.omega_max;
  return line;
}

/// What a reader of the parameters should know.
std::vector<std::string> warnings_of(const LinearShip& ship, const Finding& f) {
  std::vector<std::string> warnings;
  if (!has_coefficients(ship))
    warnings.push_back(
        "drift is proportional to yaw in this ship (T3b = T3w, or Kb = 0): the loop is a line, without sensitivities");
  else if (!f.sensitivity)
    warnings.push_back(
        "no sensitivities: T3b and T3w cannot be varied in this ship (T3b = T3w, Kb = 0, Kw = 0, or a neutral ship)");
  if (!f.cycle.settled)
    warnings.push_back(fmt::format("the zigzag still changes after {} reversals: the loop is that of its last cycle",
                                   f.cycle.zigzag.reversals.size()));
  return warnings;
}

/// @throws Refusal  if the zigzag has no full cycle
Finding finding_of(const LinearShip& ship, const LoopArguments& a) {
  const double speed = speed_of(ship, a.speed);
  const auto order = linear_order(ship, a.zigzag, a.first, speed);
  const auto m = yaw_coefficients(ship);
  const auto i = indices(ship);
  auto cycle = limit_cycle(m, order);
  const auto loop = drift_yaw_loop(m, cycle.zigzag);
  if (!loop)
    throw Refusal(fmt::format("the zigzag comes to {} reversals only: a loop needs 3 (the ship is {})",
                              cycle.zigzag.reversals.size(), stability_words(transfer_functions(m))));
  Finding finding{order, speed, std::move(cycle), *loop, {}, {}};
  if (!has_coefficients(ship)) finding.loop = line_of(i, *loop);
  else if (has_inverse(m, i)) finding.sensitivity = loop_sensitivity(i, order);
  finding.warnings = warnings_of(ship, finding);
  return finding;
}

// ---------------------------------------------------------------- JSON

Json measures_json(const LoopMeasures<double>& m) {
  return {{"area", number(m.area)},
          {"length", number(m.length)},
          {"width", number(m.width)},
          {"inclination_rad", number(m.inclination)},
          {"beta_max_rad", number(m.beta_max)},
          {"omega_max", number(m.omega_max)},
          {"omega_at_beta_zero", number(m.omega_at_beta_zero)},
          {"beta_at_omega_zero_rad", number(m.beta_at_omega_zero)},
          {"distance_from_line", number(m.distance_from_line)}};
}

Json derivatives_json(const LoopMeasures<double>& m, double period, const std::vector<double>& overshoots) {
  Json json = measures_json(m);
  json["period"] = number(period);
  json["overshoot_deg"] = parameters(first_in_degrees(overshoots));
  json["limit_overshoot_deg"] = number(degrees(overshoots.back()));
  return json;
}

Json sensitivity_json(const std::optional<LoopSensitivity>& s) {
  if (!s) return nullptr;
  return {{"T3b", derivatives_json(s->by_T3b, s->period_by_T3b, s->overshoot_by_T3b)},
          {"T3w", derivatives_json(s->by_T3w, s->period_by_T3w, s->overshoot_by_T3w)}};
}

Json document_of(const LinearShip& ship, const Finding& f) {
  const auto& reversals = f.cycle.zigzag.reversals;
  const double period = f.cycle.zigzag.period().value();
  Json json{{"schema", "swayaw.loop/1"},
            {"ship", ship.name},
            {"manoeuvre", name_of(ZigzagAngles{f.order.rudder, f.order.heading})},
            {"first", name_of(f.order.first)},
            {"speed_m_s", f.speed},
            {"rudder_rate_rad_per_length", f.order.rate}};
  json.update(measures_json(f.loop));
  json["overshoot_deg"] = parameters(overshoots_deg(reversals));
  json["limit_overshoot_deg"] = number(degrees(reversals.back().overshoot));
  json["period"] = number(period);
  json["period_s"] = number(period * ship.particulars.L / f.speed);
  json["settled"] = f.cycle.settled;
  json["reversals"] = reversals.size();
  json["sensitivity"] = sensitivity_json(f.sensitivity);
  json["warnings"] = f.warnings;
  return json;
}

// ---------------------------------------------------------------- curves

/// Points along legs of the zigzag, as columns.
struct Curves {
  std::vector<double> s, psi, beta, omega, delta;
};

/// Points of the legs from one to another.
Curves curves_of(const LinearShip& ship, const std::vector<Leg<double>>& legs, std::size_t first, std::size_t last) {
  constexpr int points = 24;
  const LinearResponse<double> response(yaw_coefficients(ship));
  const auto i = indices(ship);
  const bool coupled = has_coefficients(ship);
  Curves c;
  for (std::size_t n = first; n < last; ++n) {
    for (int k = 0; k <= points; ++k) {
      const double s = legs[n].length * k / points;
      const auto x = state_after(response, legs[n].start, legs[n].rudder, s);
      c.s.push_back(legs[n].from + s);
      c.psi.push_back(x.psi);
      c.beta.push_back(coupled ? x.beta : i.Kb / i.Kw * x.omega);
      c.omega.push_back(x.omega);
      c.delta.push_back(legs[n].rudder.value + legs[n].rudder.rate * s);
    }
  }
  return c;
}

/// The zigzag from straight ahead, its first few reversals.
Curves approach_of(const LinearShip& ship, const Finding& f) {
  const auto& [r, legs] = f.cycle.zigzag;
  return curves_of(ship, legs, 0, r[std::min<std::size_t>(r.size(), 7) - 1].leg);
}

/// The last full cycle.
Curves cycle_of(const LinearShip& ship, const Finding& f) {
  const auto& [r, legs] = f.cycle.zigzag;
  return curves_of(ship, legs, r[r.size() - 3].leg, r.back().leg);
}

std::string_view cycle_words(const Finding& f) { return f.cycle.settled ? "limit cycle" : "last cycle"; }

std::string manoeuvre_words(const Finding& f) {
  return fmt::format("{} first {}", name_of(ZigzagAngles{f.order.rudder, f.order.heading}), name_of(f.order.first));
}

// ---------------------------------------------------------------- page

Json curves_json(const Curves& c) {
  return {{"s", parameters(c.s)},
          {"psi_rad", parameters(c.psi)},
          {"beta_rad", parameters(c.beta)},
          {"omega", parameters(c.omega)},
          {"delta_rad", parameters(c.delta)}};
}

std::vector<double> around(double value) {
  std::vector<double> values;
  for (int k = 0; k < 33; ++k) values.push_back(value * (0.25 + 0.0625 * k));
  return values;
}

template <class Get>
Json grid_json(const T3Map& map, Get&& get) {
  Json rows_of_map = Json::array();
  for (std::size_t w = 0; w < map.T3w.size(); ++w) {
    Json row = Json::array();
    for (std::size_t b = 0; b < map.T3b.size(); ++b) row.push_back(number(get(map.at(b, w))));
    rows_of_map.push_back(std::move(row));
  }
  return rows_of_map;
}

Json map_json(const SteeringIndices<double>& i, const LinearZigzagOrder& order) {
  const auto map = t3_map(i, order, around(i.T3b), around(i.T3w));
  return {{"T3b", parameters(map.T3b)},
          {"T3w", parameters(map.T3w)},
          {"measures",
           {{"area", grid_json(map, [](const T3Point& p) { return p.area; })},
            {"beta_max_rad", grid_json(map, [](const T3Point& p) { return p.beta_max; })},
            {"omega_max", grid_json(map, [](const T3Point& p) { return p.omega_max; })},
            {"omega_at_beta_zero", grid_json(map, [](const T3Point& p) { return p.omega_at_beta_zero; })},
            {"period", grid_json(map, [](const T3Point& p) { return p.period; })},
            {"first_overshoot_deg", grid_json(map, [](const T3Point& p) { return degrees(p.overshoot1); })},
            {"second_overshoot_deg", grid_json(map, [](const T3Point& p) { return degrees(p.overshoot2); })}}}};
}

Json indices_json(const LinearShip& ship) {
  const auto i = indices(ship);
  Json json{{"T3b", number(i.T3b)},
            {"T3w", number(i.T3w)},
            {"Kb", number(i.Kb)},
            {"Kw", number(i.Kw)},
            {"T_b", number(first_order_drift(i).T)},
            {"T_w", number(first_order_yaw(i).T)}};
  if (const auto T = time_constants(transfer_functions(i))) {
    json["T1"] = number(T->T1);
    json["T2"] = number(T->T2);
  }
  return json;
}

/// What the plots of the page show.
Json page_data(const LinearShip& ship, const Finding& f) {
  const auto i = indices(ship);
  Json measures = measures_json(f.loop);
  measures["period"] = number(f.cycle.zigzag.period().value());
  return {{"version", version()},
          {"indices", indices_json(ship)},
          {"slope", number(i.Kw / i.Kb)},
          {"loop", std::move(measures)},
          {"overshoot_deg", parameters(overshoots_deg(f.cycle.zigzag.reversals))},
          {"sensitivity", sensitivity_json(f.sensitivity)},
          {"zigzag", curves_json(approach_of(ship, f))},
          {"cycle", curves_json(cycle_of(ship, f))},
          {"map", f.sensitivity ? map_json(i, f.order) : Json(nullptr)}};
}

// ---------------------------------------------------------------- plot

double reach(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double x : values) largest = std::max(largest, std::abs(x));
  return largest;
}

/// beta = nb0 t, omega' = nw0 t, since Kb/Kw = nb0/nw0, as far as the cycle goes in one of the two.
Curve first_order_line(const SwayYawTransfer<double>& h, const Curves& cycle) {
  const double t = std::fmin(reach(cycle.beta) / std::abs(h.nb0), reach(cycle.omega) / std::abs(h.nw0));
  return {"first-order line", in_degrees({-h.nb0 * t, h.nb0 * t}), {-h.nw0 * t, h.nw0 * t}, {ink::line, 1.4, true}};
}

Plot loop_plot(const LinearShip& ship, const Finding& f) {
  const auto approach = approach_of(ship, f), cycle = cycle_of(ship, f);
  return {fmt::format("{}: {}", ship.name, manoeuvre_words(f)),
          {{.x = {"Drift angle", "deg"},
            .y = {"Yaw rate ω′", ""},
            .curves = {first_order_line(transfer_functions(ship), cycle),
                       {"from straight ahead", in_degrees(approach.beta), approach.omega, {ink::faint, 1.2}},
                       {std::string(cycle_words(f)), in_degrees(cycle.beta), cycle.omega, {ink::yaw, 2.4}}}}}};
}

// ---------------------------------------------------------------- first screen

/// How much more of T3b or T3w the page tells the effect of.
constexpr double more = 0.1;

/// A measure of the loop or the zigzag, what it is in the units of the page, and its derivatives.
struct Told {
  std::string name, value;
  double number, by_T3b, by_T3w;
};

std::vector<Told> told_of(const Finding& f, const UserUnits& units, double L) {
  const auto& m = f.loop;
  const auto s = f.sensitivity.value_or(LoopSensitivity{});
  const double U_over_L = f.speed / L, overshoot = f.cycle.zigzag.reversals.front().overshoot,
               period = f.cycle.zigzag.period().value();
  const double overshoot_by_T3w = f.sensitivity ? s.overshoot_by_T3w.front() : 0.0;
  return {
      {"first overshoot", units.angle(overshoot), overshoot, 0.0, overshoot_by_T3w},
      {"period", units.time(period / U_over_L), period, s.period_by_T3b, s.period_by_T3w},
      {"area of the loop", with_error(m.area) + " rad", m.area, s.by_T3b.area, s.by_T3w.area},
      {"width over length", percent_of(m.width / m.length), m.width / m.length,
       (s.by_T3b.width - m.width / m.length * s.by_T3b.length) / m.length,
       (s.by_T3w.width - m.width / m.length * s.by_T3w.length) / m.length},
      {"largest drift angle", units.angle(m.beta_max), m.beta_max, s.by_T3b.beta_max, s.by_T3w.beta_max},
      {"largest yaw rate", units.yaw_rate(m.omega_max * U_over_L), m.omega_max, s.by_T3b.omega_max, s.by_T3w.omega_max},
      {"yaw rate without drift", units.yaw_rate(m.omega_at_beta_zero * U_over_L), m.omega_at_beta_zero,
       s.by_T3b.omega_at_beta_zero, s.by_T3w.omega_at_beta_zero},
      {"drift angle without yaw", units.angle(m.beta_at_omega_zero), m.beta_at_omega_zero, s.by_T3b.beta_at_omega_zero,
       s.by_T3w.beta_at_omega_zero}};
}

/// "+6.6 %" of the value, of a change by ten per cent of T3; "0" where only rounding is left.
std::string change_words(double derivative, double T3, double value) {
  const double share = more * T3 * derivative / value;
  if (!std::isfinite(share)) return "-";
  if (std::abs(share) < 1e-9) return "0";
  return (share > 0.0 ? "+" : "") + percent_of(share);
}

PageTable measures_table(const LinearShip& ship, const Finding& f, const UserUnits& units) {
  PageTable table{.caption = fmt::format("Loop of the {}", cycle_words(f)), .columns = {"", "Value"}, .rows = {}};
  const auto i = indices(ship);
  if (f.sensitivity)
    for (const char* name : {"T3b", "T3w"})
      table.columns.push_back(fmt::format("{} more of {}", percent_of(more), name));
  for (const auto& [name, value, number, by_T3b, by_T3w] : told_of(f, units, ship.particulars.L)) {
    table.rows.push_back({name, value});
    if (!f.sensitivity) continue;
    table.rows.back().emplace_back(change_words(by_T3b, i.T3b, number));
    table.rows.back().emplace_back(change_words(by_T3w, i.T3w, number));
  }
  return table;
}

std::vector<PageAnswer> answers_about_T3(const LinearShip& ship, const Finding& f, const UserUnits& units) {
  if (!f.sensitivity) return {{"What do T3b and T3w do to it?", f.warnings.empty() ? "-" : f.warnings.front()}};
  const auto i = indices(ship);
  const auto& s = *f.sensitivity;
  const auto area_by_T3b = change_words(s.by_T3b.area, i.T3b, f.loop.area),
             area_by_T3w = change_words(s.by_T3w.area, i.T3w, f.loop.area);
  const double overshoot = more * i.T3w * s.overshoot_by_T3w.front();
  return {
      {"What does T3w do?", fmt::format("{} more of it ({}) changes the first overshoot by {} and the area of the "
                                        "loop by {}",
                                        percent_of(more), with_error(i.T3w), units.angle(overshoot), area_by_T3w)},
      {"What does T3b do?", fmt::format("{} more of it ({}) changes the area of the loop by {} and no overshoot: only "
                                        "recorded drift tells T3b",
                                        percent_of(more), with_error(i.T3b), area_by_T3b)}};
}

/// What the page says first.
Page first_screen(const LinearShip& ship, const Finding& f, const LoopArguments& a) {
  const double L = ship.particulars.L, period = f.cycle.zigzag.period().value();
  const UserUnits units(a.report.si, L);
  const bool line = !has_coefficients(ship);
  Page page{
      .kicker = "Drift–yaw loop of the " + manoeuvre_words(f),
      .title = ship.name,
      .headline = line ? "Drift goes with yaw all along: the loop is a line, and T3b and T3w cannot be told apart."
                       : fmt::format("Yaw over drift draws a loop {} as wide as long. T3b and T3w make it; a ship of "
                                     "first order would draw a line.",
                                     percent_of(f.loop.width / f.loop.length)),
      .tone = !f.cycle.settled ? Tone::look : Tone::neutral,
      .answers = answers_about_T3(ship, f, units)};
  page.answers.push_back({"How long is a cycle?",
                          fmt::format("{} ship lengths, {}", with_error(period), units.time(period * L / f.speed))});
  tell_drift(page, f.loop.beta_max, units);
  page.picture =
      picture_of(loop_plot(ship, f), "Yaw rate over drift angle in the zigzag, with the first-order line.",
                 fmt::format("From straight ahead into the {}. Dashed: a ship of first order.", cycle_words(f)), units);
  page.picture->numbers.reset();  // its curves go back and forth
  page.table = measures_table(ship, f, units);
  page.assumed = {fmt::format("The ship is as {} says, given by {}.", a.ship.string(), form_words(ship)),
                  fmt::format("Linear equations at {}, which is held; deep water and calm.", units.speed(f.speed)),
                  "Effects of T3b and T3w are by derivative, the other indices held."};
  page.assumed.insert(page.assumed.end(), f.warnings.begin(), f.warnings.end());
  return page;
}

void write_report(const LinearShip& ship, const Finding& f, const LoopArguments& a) {
  write_page(a.report.file, loop_page(first_screen(ship, f, a), for_page(page_data(ship, f))));
}

// ---------------------------------------------------------------- text

/// One measure and its derivatives, in the unit that people read.
struct Row {
  std::string_view name;
  std::string_view unit;
  double LoopMeasures<double>::*member;
  double scale = 1.0;
};

constexpr double degree = 180.0 / pi;
constexpr Row rows[] = {
    {"area", "rad", &LoopMeasures<double>::area},
    {"length", "-", &LoopMeasures<double>::length},
    {"width", "-", &LoopMeasures<double>::width},
    {"inclination", "deg", &LoopMeasures<double>::inclination, degree},
    {"largest drift", "deg", &LoopMeasures<double>::beta_max, degree},
    {"largest omega'", "-", &LoopMeasures<double>::omega_max},
    {"omega' at beta = 0", "-", &LoopMeasures<double>::omega_at_beta_zero},
    {"drift at omega' = 0", "deg", &LoopMeasures<double>::beta_at_omega_zero, degree},
    {"off the line", "-", &LoopMeasures<double>::distance_from_line},
};

/// A derivative, 0 where only rounding is left of it.
std::string derivative_cell(double derivative, double value) {
  return std::abs(derivative) < 1e-10 * std::abs(value) ? "0" : cell(derivative);
}

void print_row(std::string_view name, std::string_view unit, double value, double by_T3b, double by_T3w, bool varied) {
  say("  {:<22}{:>11} {:<4}", name, cell(value), unit);
  if (varied) say("{:>13}{:>13}", derivative_cell(by_T3b, value), derivative_cell(by_T3w, value));
  say("\n");
}

void print_text(const LinearShip& ship, const Finding& f) {
  const auto& s = f.sensitivity;
  const auto& reversals = f.cycle.zigzag.reversals;
  say("{}: {} at {:.4g} m/s, the loop of the {}\n", ship.name, manoeuvre_words(f), f.speed, cycle_words(f));
  say("  {:<22}{:>11} {:<4}{}\n", "", "value", "", s ? "      by T3b       by T3w" : "");
  for (const auto& [name, unit, member, scale] : rows)
    print_row(name, unit, f.loop.*member * scale, s ? s->by_T3b.*member * scale : 0.0,
              s ? s->by_T3w.*member * scale : 0.0, s.has_value());
  print_row("period", "L", f.cycle.zigzag.period().value(), s ? s->period_by_T3b : 0.0, s ? s->period_by_T3w : 0.0,
            s.has_value());
  for (std::size_t k = 0; k < std::min(reversals.size(), shown_overshoots); ++k)
    print_row(fmt::format("overshoot {}", k + 1), "deg", degrees(reversals[k].overshoot),
              s ? degrees(s->overshoot_by_T3b[k]) : 0.0, s ? degrees(s->overshoot_by_T3w[k]) : 0.0, s.has_value());
  print_row(fmt::format("overshoot {}", reversals.size()), "deg", degrees(reversals.back().overshoot),
            s ? degrees(s->overshoot_by_T3b.back()) : 0.0, s ? degrees(s->overshoot_by_T3w.back()) : 0.0,
            s.has_value());
}

}  // namespace

void loop(const LoopArguments& a) {
  const auto ship = load_linear_ship(a.ship, a.speed);
  const auto finding = finding_of(ship, a);
  const auto svg = a.svg.empty() ? std::string() : svg_of(loop_plot(ship, finding));  // before anything is written
  for (const auto& warning : finding.warnings) say_aside("swayaw: {}\n", warning);
  if (!a.out.empty())
    write_recording(zigzag_recording(ship, finding.cycle.zigzag, finding.order, finding.speed, {}), a.out);
  if (a.report.wanted()) write_report(ship, finding, a);
  if (!a.svg.empty()) write_text(a.svg, svg);
  if (a.json) print_document(document_of(ship, finding));
  else print_text(ship, finding);
}

}  // namespace swayaw::app
