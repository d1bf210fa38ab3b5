#include "indices_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "linear_output.hpp"
#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/linear/response.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

constexpr double step_angle = radians(10.0);  // rudder of the step response, to starboard

/// The units of the page and the time of a ship length [s].
struct Scale {
  UserUnits units;
  double L_over_U;
};

// ---------------------------------------------------------------- stability

bool is_stable(const SwayYawTransfer<double>& h) { return h.e0 > 0.0 && h.e1 > 0.0; }

/// Rate at which a disturbance grows in the long run, per ship length: the largest real part of
///
///     l² + e1 l + e0 = 0
double growth_of(const SwayYawTransfer<double>& h) {
  const auto T = time_constants(h);
  return T ? std::max(-1.0 / T->T1, -1.0 / T->T2) : -0.5 * h.e1;
}

/// "133 s (9.94 ship lengths)"
std::string time_words(double lengths, const Scale& scale) {
  const auto seconds = scale.units.time(lengths * scale.L_over_U);
  return scale.units.si() ? seconds : fmt::format("{} ({} ship lengths)", seconds, with_error(lengths));
}

/// "a disturbance is halved every 92.2 s (6.89 ship lengths)"
std::string growth_words(const SwayYawTransfer<double>& h, const Scale& scale) {
  const double growth = growth_of(h);
  if (growth == 0.0) return "a disturbance neither grows nor dies out";
  const bool swings = h.e1 * h.e1 < 4.0 * h.e0;
  return fmt::format("left alone, a disturbance {} every {}{}", growth < 0.0 ? "is halved" : "doubles",
                     time_words(std::numbers::ln2 / std::abs(growth), scale), swings ? ", in swings" : "");
}

std::string stable_word(const SwayYawTransfer<double>& h) {
  if (is_stable(h)) return "stable";
  return growth_of(h) == 0.0 ? "neutral" : "unstable";
}

bool same_stability(const SteeringSides& s) {
  return !s.port || is_stable(transfer_functions(*s.port)) == is_stable(transfer_functions(*s.starboard));
}

/// "By the rudder she turns with K = 0.342 1/s and T = 124 s."
std::string first_order_words(const LinearShip& ship, const Scale& scale) {
  const auto yaw = first_order_yaw(indices(ship));
  if (!std::isfinite(yaw.K) || !std::isfinite(yaw.T)) return "No first-order indices belong to her.";
  return fmt::format("By the rudder she turns with K = {} 1/s and T = {}.", with_error(-yaw.K / scale.L_over_U),
                     scale.units.time(yaw.T * scale.L_over_U));
}

std::string headline_of(const SteeringSides& s, const Scale& scale) {
  const auto h = transfer_functions(s.mean);
  if (same_stability(s))
    return fmt::format("{} is course {}: {}. {}", s.mean.name, stable_word(h), growth_words(h, scale),
                       first_order_words(s.mean, scale));
  const auto port = transfer_functions(*s.port), starboard = transfer_functions(*s.starboard);
  return fmt::format("{} is course {} towards port and {} towards starboard: her forces differ between the sides.",
                     s.mean.name, stable_word(port), stable_word(starboard));
}

Tone tone_of(const SteeringSides& s) {
  return is_stable(transfer_functions(s.mean)) && same_stability(s) ? Tone::good : Tone::look;
}

std::string stability_answer(const SteeringSides& s, const Scale& scale) {
  const auto answer = [&](const LinearShip& ship) {
    const auto h = transfer_functions(ship);
    return fmt::format("{}: {}", is_stable(h) ? "yes" : "no", growth_words(h, scale));
  };
  if (!s.port) return capital(answer(s.mean));
  return fmt::format("Towards port {}; towards starboard {}", answer(*s.port), answer(*s.starboard));
}

// ---------------------------------------------------------------- answer to the rudder

/// Whether her heading answers in coupled equations, or in a yaw equation that stands by itself.
bool turns(const LinearShip& ship) { return has_coefficients(ship) || indices(ship).Kw != 0.0; }

/// Motion after the rudder has been put to starboard at once, in ship lengths.
LinearState<double> answer_after(const LinearShip& ship, double lengths) {
  const LinearResponse<double> response(yaw_coefficients(ship));
  return state_after(response, {0.0, 0.0, 0.0}, {-step_angle, 0.0}, lengths);
}

std::string quickness_answer(const LinearShip& ship, const Scale& scale) {
  const auto T = first_order_yaw(indices(ship)).T;
  if (!std::isfinite(T) || !turns(ship)) return "She does not turn by the rudder";
  const auto first = fmt::format("{} of rudder change her heading by {} in the first ship length",
                                 scale.units.ordered(step_angle), scale.units.angle(answer_after(ship, 1.0).psi));
  if (!is_stable(transfer_functions(ship))) return first + "; no time constant, as she settles in no turn";
  return fmt::format("T = {}: then 63 % of the final yaw rate is there. {}", time_words(T, scale), first);
}

std::string strength_answer(const LinearShip& ship, double speed, const Scale& scale) {
  const auto steering = steering_of(ship, speed);
  if (!std::isfinite(steering.K_per_s)) return "No yaw rate belongs to a rudder angle";
  const auto gain = fmt::format("K = {} 1/s (K' = {})", with_error(steering.K_per_s), with_error(steering.K_prime));
  if (!is_stable(transfer_functions(ship)))
    return gain + ": in the steady turn, which she does not keep by herself, the rudder is held against it";
  return fmt::format("{}: each degree of rudder gives {} in the end", gain,
                     scale.units.yaw_rate(steering.K_per_s * radians(1.0)));
}

// ---------------------------------------------------------------- table

/// An index in primes and with dimension.
struct IndexRow {
  const char* name;
  double prime, power;  ///< times (L/U)^power
  const char *unit, *meaning;
};

std::vector<IndexRow> rows_of(const LinearShip& ship) {
  const auto i = indices(ship);
  const auto T = time_constants(transfer_functions(ship)).value_or(TimeConstants<double>{missing, missing});
  return {{"T1", T.T1, 1.0, "s", "slower mode; negative: unstable"},
          {"T2", T.T2, 1.0, "s", "faster mode"},
          {"T3w", i.T3w, 1.0, "s", "rudder rate to yaw rate"},
          {"T3b", i.T3b, 1.0, "s", "rudder rate to drift"},
          {"T", first_order_yaw(i).T, 1.0, "s", "yaw of first order, T1 + T2 − T3w"},
          {"T_b", first_order_drift(i).T, 1.0, "s", "drift of first order, T1 + T2 − T3b"},
          {"K", -i.Kw, -1.0, "1/s", "yaw rate by rudder angle, both to starboard"},
          {"Kb", i.Kb, 0.0, "", "drift angle by rudder angle to port"}};
}

std::string dimensional_cell(const IndexRow& row, double L_over_U) {
  const auto value = with_error(row.prime * std::pow(L_over_U, row.power));
  return *row.unit == '\0' || value == "-" ? value : value + " " + row.unit;
}

PageTable table_of(const LinearShip& ship, double speed, const Scale& scale) {
  PageTable table{.caption = "Steering indices",
                  .columns = {"", "At " + scale.units.speed(speed), "In ship lengths", "Meaning"},
                  .rows = {}};
  for (const auto& row : rows_of(ship))
    table.rows.push_back({row.name, dimensional_cell(row, scale.L_over_U), with_error(row.prime), row.meaning});
  return table;
}

/// Both sides beside each other.
PageTable table_of_sides(const LinearShip& port, const LinearShip& starboard, double speed, const Scale& scale) {
  PageTable table{.caption = "Steering indices at " + scale.units.speed(speed),
                  .columns = {"", "To port", "To starboard", "Meaning"},
                  .rows = {}};
  const auto left = rows_of(port), right = rows_of(starboard);
  for (std::size_t i = 0; i < left.size(); ++i)
    table.rows.push_back({left[i].name, dimensional_cell(left[i], scale.L_over_U),
                          dimensional_cell(right[i], scale.L_over_U), left[i].meaning});
  return table;
}

PageSection section_of(const char* side, const LinearShip& ship, double speed, const Scale& scale) {
  return {.title = fmt::format("Turning to {}: course {}", side, stable_word(transfer_functions(ship))),
          .words = {capital(growth_words(transfer_functions(ship), scale)) + "."},
          .tables = {table_of(ship, speed, scale)}};
}

// ---------------------------------------------------------------- picture

/// Ship lengths in which the answer is seen: three time constants, neither few nor many.
double span_of(const LinearShip& ship) {
  const double T = std::abs(first_order_yaw(indices(ship)).T);
  return std::clamp(std::isfinite(T) ? 3.0 * T : 0.0, 5.0, 30.0);
}

Curve answer_curve(const LinearShip& ship, std::string name, double span, const Scale& scale, const Stroke& stroke) {
  constexpr int points = 200;
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .stroke = stroke};
  for (int k = 0; k <= points; ++k) {
    const double s = span * k / points;
    curve.x.push_back(s * scale.L_over_U);
    curve.y.push_back(degrees(answer_after(ship, s).omega) / scale.L_over_U);
  }
  return curve;
}

/// K delta (1 − exp(−s/T))
Curve first_order_curve(const LinearShip& ship, double span, const Scale& scale) {
  const auto yaw = first_order_yaw(indices(ship));
  Curve curve{.name = "first order, K and T", .x = {}, .y = {}, .stroke = {ink::line, 1.6, true}};
  constexpr int points = 100;
  for (int k = 0; k <= points; ++k) {
    const double s = span * k / points;
    curve.x.push_back(s * scale.L_over_U);
    curve.y.push_back(degrees(yaw.K * -step_angle * -std::expm1(-s / yaw.T)) / scale.L_over_U);
  }
  return curve;
}

std::vector<Curve> answer_curves(const SteeringSides& s, const Scale& scale) {
  const double span = span_of(s.port ? *s.starboard : s.mean);
  if (s.port)
    return {answer_curve(*s.starboard, "to starboard", span, scale, {ink::line, 2.2}),
            answer_curve(*s.port, "to port, turned over", span, scale, {"#a8201a", 2.2})};
  return {answer_curve(s.mean, "yaw rate", span, scale, {ink::yaw, 2.4}), first_order_curve(s.mean, span, scale)};
}

std::optional<PagePicture> picture_of_answer(const SteeringSides& s, const Scale& scale) {
  if (!turns(s.mean)) return std::nullopt;
  Panel panel{.x = {.quantity = "Time from the order", .unit = "s"},
              .y = {.quantity = "Yaw rate", .unit = "deg/s"},
              .curves = answer_curves(s, scale)};
  const auto order = fmt::format("{:g} deg of rudder", degrees(step_angle));
  return picture_of({.title = "Yaw rate by " + order, .panels = {std::move(panel)}},
                    fmt::format("Yaw rate over time after {} have been put at once.", order),
                    fmt::format("Linear answer to {} put at once and held.", order), scale.units);
}

// ---------------------------------------------------------------- page

std::vector<std::string> assumed_of(const LinearShip& ship, const std::string& file, double speed, const Scale& scale) {
  return {fmt::format("The ship is as {} says, given by {}.", file, form_words(ship)),
          fmt::format("Small motions about the straight course at {}, which is held; deep water and calm.",
                      scale.units.speed(speed)),
          "Indices are those of linear equations: up to 5 or 10 deg of rudder. In harder turns a ship is steadier and "
          "turns "
          "less than they say."};
}

}  // namespace

Page indices_page(const SteeringSides& sides, const std::string& file, double speed, bool si) {
  const auto& ship = sides.mean;
  const double L = ship.particulars.L;
  const Scale scale{UserUnits(si, L), L / speed};
  const auto& shown = sides.starboard ? *sides.starboard : ship;
  const std::string side = sides.starboard ? "To starboard: " : "";
  Page page{
      .kicker = "Steering indices",
      .title = ship.name,
      .headline = headline_of(sides, scale),
      .tone = tone_of(sides),
      .answers = {{"Is she stable on course?", stability_answer(sides, scale)},
                  {"How quickly does she answer the rudder?", side + quickness_answer(shown, scale)},
                  {"How strongly?", side + strength_answer(shown, speed, scale)}},
      .picture = picture_of_answer(sides, scale),
      .table = sides.port ? table_of_sides(*sides.port, *sides.starboard, speed, scale) : table_of(ship, speed, scale),
      .assumed = assumed_of(ship, file, speed, scale)};
  if (sides.port)
    page.sections = {section_of("port", *sides.port, speed, scale),
                     section_of("starboard", *sides.starboard, speed, scale)};
  page.footnotes = {made_by()};
  return page;
}

}  // namespace swayaw::app
