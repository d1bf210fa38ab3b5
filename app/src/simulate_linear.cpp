#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input.hpp"
#include "linear_output.hpp"
#include "page_writing.hpp"
#include "simulate_files.hpp"
#include "simulate_output.hpp"
#include "simulate_page.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- how far the equations hold

void warn_of_drift(const LinearShip& ship, double drift) {
  if (std::abs(drift) <= largest_linear_drift) return;
  say_aside(
      "swayaw: {}: she reaches a drift angle of {:.1f} deg; beyond {:.0f} deg linear equations mean nothing, as "
      "the cubic forces that they leave out are as large as the rest. A nonlinear ship tells this manoeuvre\n",
      ship.name, std::abs(degrees(drift)), degrees(largest_linear_drift));
}

/// Largest drift angle of a zigzag; 0 for a ship whose drift is not known.
double largest_drift(const Recording& run) {
  double largest = 0.0;
  const auto u = run[Channel::u], v = run[Channel::v];
  for (std::size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(std::atan2(-v[i], u[i])));
  return largest;
}

// ---------------------------------------------------------------- zigzag

/// A zigzag and the times of its rudder orders, the last of which may have no heading peak yet.
struct Run {
  LinearZigzagOrder order;
  LinearZigzag<double> zigzag;
  std::vector<double> execute;  ///< [s], without the first order at 0
  PrimeScale scale;

  double seconds(double s) const { return s * scale.L / scale.U; }

  std::optional<double> period() const {
    const auto n = execute.size();
    return n >= 3 ? std::optional(execute[n - 1] - execute[n - 3]) : std::nullopt;
  }
};

Run run_of(const LinearShip& ship, const SimulateArguments& a) {
  const double speed = speed_of(ship, a.speed);
  Run run{linear_order(ship, a.zigzag, a.first, speed), {}, {}, prime_scale(ship, speed)};
  run.order.reversals = a.duration ? std::numeric_limits<std::size_t>::max() : 4;
  run.order.longest = a.duration ? *a.duration * speed / ship.particulars.L : 200.0;
  run.zigzag = linear_zigzag(yaw_coefficients(ship), run.order);
  for (const auto& leg : run.zigzag.legs)
    if (leg.end == LegEnd::heading) run.execute.push_back(run.seconds(leg.from + leg.length));
  return run;
}

/// The zigzag as one of a nonlinear ship, without a time series.
Zigzag in_seconds(const Run& run) {
  Zigzag zigzag{.reversals = {},
                .period = run.period(),
                .initial_turning = {},
                .approach_speed = run.scale.U,
                .propulsion = {},
                .run = {}};
  if (!run.execute.empty()) zigzag.initial_turning = run.execute.front() * run.scale.U;
  for (const double time : run.execute) zigzag.reversals.push_back({.time = time, .peak_time = {}, .overshoot = {}});
  for (std::size_t k = 0; k < std::min(run.zigzag.reversals.size(), run.execute.size()); ++k) {
    zigzag.reversals[k].peak_time = run.seconds(run.zigzag.reversals[k].peak);
    zigzag.reversals[k].overshoot = run.zigzag.reversals[k].overshoot;
  }
  return zigzag;
}

ZigzagOrder order_of(const Run& run) { return {run.order.rudder, run.order.heading, run.order.first}; }

/// What the zigzag tells of the IMO criteria.
std::vector<Criterion> criteria_of(const Run& run) { return criteria_of(in_seconds(run), order_of(run), run.scale.L); }

Json zigzag_json(const Run& run) {
  Json execute = Json::array({0.0}), peaks = Json::array(), overshoots = Json::array();
  for (const double time : run.execute) execute.push_back(time);
  for (const auto& reversal : run.zigzag.reversals) {
    peaks.push_back(run.seconds(reversal.peak));
    overshoots.push_back(degrees(reversal.overshoot));
  }
  const Json turning = run.execute.empty() ? Json(nullptr) : number(run.execute.front() * run.scale.U);
  return {{"schema", "swayaw.zigzag/1"},
          {"manoeuvre", name_of(ZigzagAngles{run.order.rudder, run.order.heading})},
          {"first", name_of(run.order.first)},
          {"approach_speed_m_s", run.scale.U},
          {"rev_s", nullptr},
          {"execute_s", std::move(execute)},
          {"peak_s", std::move(peaks)},
          {"overshoot_deg", std::move(overshoots)},
          {"period_s", number(run.period())},
          {"initial_turning_m", turning},
          {"criteria", criteria_json(criteria_of(run))}};
}

void print_zigzag(const LinearShip& ship, const Run& run) {
  say("{}: {} first {}, {:.4g} m/s\n", ship.name, name_of(ZigzagAngles{run.order.rudder, run.order.heading}),
      name_of(run.order.first), run.scale.U);
  say("  {:<10}{:>12}{:>12}{:>16}\n", "reversal", "at s", "peak s", "overshoot deg");
  for (std::size_t k = 0; k < run.execute.size(); ++k) {
    say("  {:<10}{:>12.3f}", k + 1, run.execute[k]);
    if (k < run.zigzag.reversals.size())
      say("{:>12.3f}{:>16.3f}\n", run.seconds(run.zigzag.reversals[k].peak),
          degrees(run.zigzag.reversals[k].overshoot));
    else say("{:>12}{:>16}\n", "-", "-");
  }
  if (run.period()) say("  period of the last cycle {:.2f} s\n", *run.period());
  if (run.execute.empty()) say("  the heading never reached the switch angle\n");
  print_criteria(criteria_of(run));
}

void write_zigzag_page(const LinearShip& ship, const Run& run, const SimulateArguments& a) {
  auto zigzag = in_seconds(run);
  const auto s = sailed(ship, run.scale.U, a);
  if (has_coefficients(ship)) zigzag.run = zigzag_recording(ship, run.zigzag, run.order, run.scale.U, a.step);
  auto page = zigzag_page(zigzag, order_of(run), s);
  if (has_coefficients(ship)) tell_drift(page, largest_drift(zigzag.run), s.units);
  write_page(a.report.file, html(page));
}

void simulate_zigzag(const LinearShip& ship, const SimulateArguments& a) {
  const auto run = run_of(ship, a);
  if (has_coefficients(ship))
    warn_of_drift(ship, largest_drift(zigzag_recording(ship, run.zigzag, run.order, run.scale.U, std::nullopt)));
  if (wants_files(a)) write_files(zigzag_recording(ship, run.zigzag, run.order, run.scale.U, a.step), a);
  if (a.report.wanted()) write_zigzag_page(ship, run, a);
  if (a.json) print_document(zigzag_json(run));
  else print_zigzag(ship, run);
}

// ---------------------------------------------------------------- steady turn

/// beta = Kb delta, omega' = Kw delta.
struct LinearTurn {
  double drift;     ///< [rad]
  double yaw_rate;  ///< [rad/s]
  double diameter;  ///< 2U/|r| [m]
};

/// @throws Refusal  if the ship does not settle
LinearTurn linear_turn(const LinearShip& ship, double delta, double speed) {
  const auto h = transfer_functions(ship);
  if (!(h.e0 > 0.0 && h.e1 > 0.0))
    throw Refusal(fmt::format("the ship is {}; she settles in no steady turn", stability_words(h)));
  const double omega = h.nw0 / h.e0 * delta, L = ship.particulars.L;
  return {h.nb0 / h.e0 * delta, omega * speed / L, 2.0 * L / std::abs(omega)};
}

Json turn_json(const LinearTurn& t, const SimulateArguments& a, double speed) {
  return {{"schema", "swayaw.turn/1"},
          {"manoeuvre", fmt::format("turn {:.6g}", *a.turn)},
          {"first", a.first},
          {"approach_speed_m_s", speed},
          {"rev_s", nullptr},
          {"advance_m", nullptr},
          {"transfer_m", nullptr},
          {"tactical_diameter_m", nullptr},
          {"final_diameter_m", number(t.diameter)},
          {"time_90_s", nullptr},
          {"time_180_s", nullptr},
          {"initial_turning_m", nullptr},
          {"final_speed_m_s", speed},
          {"final_drift_rad", number(t.drift)},
          {"final_yaw_rate_rad_s", number(t.yaw_rate)},
          {"criteria", Json::array()}};
}

Page turn_page(const LinearTurn& t, const SimulateArguments& a, const Sailed& s) {
  const auto diameter = s.units.length(t.diameter), rate = s.units.yaw_rate(t.yaw_rate);
  Page page{.kicker = fmt::format("Steady turn with {} of rudder to {}", s.units.ordered(radians(*a.turn)), a.first),
            .title = {},
            .headline = fmt::format("By linear equations the steady turn is {} across, at {}.", diameter, rate)};
  tell_drift(page, t.drift, s.units);
  page.table = PageTable{
      .caption = {},
      .columns = {"", "Value"},
      .rows = {{"final diameter", diameter}, {"final yaw rate", rate}, {"final drift angle", s.units.angle(t.drift)}}};
  return completed(std::move(page), s);
}

void simulate_turn(const LinearShip& ship, const SimulateArguments& a) {
  if (wants_files(a))
    throw Refusal(fmt::format("the turn of a linear ship is known by its steady values only: no {}",
                              a.out.empty() ? "track for --svg" : "time series for --out"));
  const double angle = radians(*a.turn), speed = speed_of(ship, a.speed);
  require_rudder(angle, ship.steering_gear);
  const auto turn = linear_turn(ship, rudder_sign(side_named(a.first)) * angle, speed);
  warn_of_drift(ship, turn.drift);
  if (a.report.wanted()) write_page(a.report.file, html(turn_page(turn, a, sailed(ship, speed, a))));
  if (a.json) {
    print_document(turn_json(turn, a, speed));
    return;
  }
  say("{}: turn {:.6g} to {}, {:.4g} m/s held, steady values of the linear equations\n", ship.name, *a.turn, a.first,
      speed);
  say("  {:<20}{:>12.2f} m{:>10.3f} L\n", "final diameter", turn.diameter, turn.diameter / ship.particulars.L);
  say("  {:<20}{:>12.2f} deg\n", "final drift angle", degrees(turn.drift));
  say("  {:<20}{:>12.4f} deg/s\n", "final yaw rate", degrees(turn.yaw_rate));
}

}  // namespace

void simulate_linear(const LinearShip& ship, const SimulateArguments& a) {
  if (a.rev || a.thrust || a.forces) throw Refusal("a linear ship has no propulsion and no parts with forces");
  if (!a.turn && a.zigzag.empty())
    throw Refusal(
        "the yaw rate of a linear ship is proportional to the rudder angle at any angle: of her --zigzag and --turn "
        "tell all, other manoeuvres need a nonlinear ship");
  if (a.turn) simulate_turn(ship, a);
  else simulate_zigzag(ship, a);
}

}  // namespace swayaw::app
