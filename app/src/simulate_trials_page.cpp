#include "simulate_trials_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

namespace swayaw::app {
namespace {

/// Rudder and helm in words: "1.11 deg to port".
std::string helm_words(double delta, const UserUnits& units) {
  if (std::abs(delta) < 1e-9) return "amidships";
  return fmt::format("{} to {}", units.angle(std::abs(delta)), delta > 0.0 ? "port" : "starboard");
}

Tone tone_of(bool stable) { return stable ? Tone::good : Tone::look; }

/// Yaw rates below this share of U/L are none: what is left when a motion counts as steady.
constexpr double no_yaw_rate = 1e-5;

/// "turns at 0.164 deg/s to port", "goes straight ahead"
std::string turning_words(double r, const Sailed& s) {
  if (std::abs(r) < no_yaw_rate * s.speed / s.L) return "goes straight ahead";
  return fmt::format("turns at {} to {}", s.units.yaw_rate(std::abs(r)), r < 0.0 ? "port" : "starboard");
}

/// The same as a number, positive to starboard.
std::string yaw_rate_of(double r, const Sailed& s) {
  return s.units.yaw_rate(std::abs(r) < no_yaw_rate * s.speed / s.L ? 0.0 : r);
}

// ---------------------------------------------------------------- spirals

Panel spiral_panel(std::vector<Curve> curves) {
  return {.x = {.quantity = "Rudder, to port", .unit = "deg"},
          .y = {.quantity = "Yaw rate, to starboard", .unit = "deg/s"},
          .curves = std::move(curves)};
}

/// Steady turns of one kind; the others interrupt the line.
Curve steady_curve(const std::vector<SteadyTurn>& turns, bool stable) {
  Curve curve{.name = stable ? "steady turns" : "unstable ones", .x = {}, .y = {}, .stroke = {ink::line, 2.0, !stable}};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto is = [&](std::size_t k) { return k < turns.size() && turns[k].stable == stable; };
    const bool joins = is(i) || (!stable && (is(i - 1) || is(i + 1)));
    curve.x.push_back(degrees(turns[i].delta));
    curve.y.push_back(joins ? degrees(turns[i].motion.r) : missing);
  }
  return curve;
}

Curve way_curve(const std::vector<SpiralPoint>& way, std::string name, Stroke stroke) {
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .stroke = stroke};
  for (const auto& point : way) {
    curve.x.push_back(degrees(point.delta));
    curve.y.push_back(degrees(point.motion.r));
  }
  return curve;
}

PageTable ways_table(const Spiral& spiral, const Sailed& s) {
  PageTable table{
      .caption = "Yaw rate at each rudder angle", .columns = {"Rudder, to port", "Way out", "Way back"}, .rows = {}};
  const auto rate = [&](const SpiralPoint& p) {
    return PageCell(yaw_rate_of(p.motion.r, s) + (p.settled ? "" : ", not steady"),
                    p.settled ? Tone::neutral : Tone::look);
  };
  for (std::size_t i = 0; i < spiral.down.size(); ++i)
    table.rows.push_back(
        {s.units.ordered(spiral.down[i].delta), rate(spiral.down[i]), rate(spiral.up[spiral.up.size() - 1 - i])});
  return table;
}

std::string amidships_words(const Spiral& spiral, const Sailed& s) {
  const auto near = [](const SpiralPoint& p) { return std::abs(p.delta); };
  const auto out = std::ranges::min_element(spiral.down, {}, near),
             back = std::ranges::min_element(spiral.up, {}, near);
  const auto first = turning_words(out->motion.r, s), second = turning_words(back->motion.r, s);
  return first == second ? "She " + first : fmt::format("She {} on the way out and {} on the way back", first, second);
}

std::string loop_words(const InstabilityLoop& loop, const UserUnits& units) {
  return fmt::format("{} of rudder wide and {} high", units.angle(loop.width), units.yaw_rate(loop.height));
}

std::string measured_loop_words(const Spiral& s, const SpiralOrder& order, const UserUnits& units) {
  if (!s.loop) return "None: the way out and the way back agree at every rudder angle";
  return fmt::format("{} to {} wide with steps of {}, {} high", units.angle(s.loop->width),
                     units.angle(s.loop->width + 2.0 * order.step), units.ordered(order.step),
                     units.yaw_rate(s.loop->height));
}

// ---------------------------------------------------------------- reverse spiral

/// Yaw rates at which she is unstable with the rudder fixed.
std::vector<HeldYawRate> unstable_of(const ReverseSpiral& s) {
  auto points = s.points;
  std::erase_if(points, [](const HeldYawRate& p) { return !p.turn || p.turn->stable; });
  return points;
}

PageTable held_table(const ReverseSpiral& s, const UserUnits& units) {
  PageTable table{.caption = "Rudder that holds each yaw rate",
                  .columns = {"Yaw rate, to starboard", "Rudder, to port", "With the rudder fixed"},
                  .rows = {}};
  for (const auto& [r, turn] : s.points) {
    const bool stable = turn && turn->stable;
    table.rows.push_back({units.yaw_rate(r), turn ? units.angle(turn->delta) : "beyond the largest",
                          PageCell(!turn    ? "-"
                                   : stable ? "stable"
                                            : "unstable",
                                   stable ? Tone::neutral : Tone::look)});
  }
  return table;
}

std::vector<SteadyTurn> turns_of(const ReverseSpiral& s) {
  std::vector<SteadyTurn> turns;
  for (const auto& point : s.points)
    if (point.turn) turns.push_back(*point.turn);
  return turns;
}

/// The rudder that holds her straight.
std::string neutral_words(const ReverseSpiral& s, const UserUnits& units) {
  const auto straight = std::ranges::min_element(s.points, {}, [](const HeldYawRate& p) { return std::abs(p.r); });
  if (!straight->turn) return "No rudder angle holds her straight";
  return "Rudder " + helm_words(straight->turn->delta, units);
}

// ---------------------------------------------------------------- pull-out

/// Yaw rates whose difference is less than this share of U/L are the same, as in the spiral.
constexpr double same_yaw_rate = 1e-3;

/// Difference of what is left from both sides [rad/s].
double height_of(const PullOut& p) { return std::abs(p.sides.starboard.residual - p.sides.port.residual); }

/// Yaw rate from shortly before the order until the change is over.
Curve yaw_rate_after(const PullOutSide& side, double span, std::string name, const char* colour) {
  auto curve = over_time(side.run, Channel::r, std::move(name), {.colour = colour, .width = 2.0});
  for (double& t : curve.x) t -= side.execute;
  const auto before = std::ranges::lower_bound(curve.x, -0.1 * span) - curve.x.begin();
  curve.x.erase(curve.x.begin(), curve.x.begin() + before);
  curve.y.erase(curve.y.begin(), curve.y.begin() + before);
  return up_to(std::move(curve), span);
}

/// Until little of the change is left [s].
double span_of(const PullOutSide& side) {
  return std::max(8.0 * side.fall_time.value_or(0.0), 3.0 * side.decay_time.value_or(0.0));
}

/// "turns at 0.170 deg/s to starboard after turns to both sides"
std::string left_words(const PullOut& p, const Sailed& s) {
  const auto from_starboard = turning_words(p.sides.starboard.residual, s),
             from_port = turning_words(p.sides.port.residual, s);
  if (from_starboard == from_port) return from_port + " after turns to both sides";
  return fmt::format("{} after a turn to starboard and {} after one to port", from_starboard, from_port);
}

PagePicture pull_out_picture(const PullOut& p, const UserUnits& units) {
  const auto& [port, starboard] = p.sides;
  const double span = std::max(span_of(port), span_of(starboard));
  const Panel panel{.x = {.quantity = "Time from rudder amidships", .unit = "s"},
                    .y = {.quantity = "Yaw rate, to starboard", .unit = "deg/s"},
                    .curves = {yaw_rate_after(starboard, span, "from starboard", ink::line),
                               yaw_rate_after(port, span, "from port", "#a8201a")}};
  return picture_of({.title = "Pull-out", .panels = {panel}},
                    "Yaw rate after the rudder was put amidships, from both sides.",
                    "A course-stable ship comes to one yaw rate from both sides.", units);
}

PageTable pull_out_table(const PullOut& p, const Sailed& s) {
  const auto& units = s.units;
  const auto maybe = [&](const std::optional<double>& t) { return t ? units.time(*t) : std::string("-"); };
  PageTable table{.caption = {}, .columns = {"", "From starboard", "From port"}, .rows = {}};
  const auto add = [&](const char* name, auto&& value) {
    table.rows.push_back({name, value(p.sides.starboard), value(p.sides.port)});
  };
  add("yaw rate in the turn", [&](const PullOutSide& side) { return yaw_rate_of(side.turning, s); });
  add("yaw rate left", [&](const PullOutSide& side) { return yaw_rate_of(side.residual, s); });
  add("time until 37 % of the change is left", [&](const PullOutSide& side) { return maybe(side.fall_time); });
  add("time constant of the last of it", [&](const PullOutSide& side) { return maybe(side.decay_time); });
  add("slower time constant of linear theory", [&](const PullOutSide& side) { return maybe(side.T1); });
  add("steady at the end", [](const PullOutSide& side) { return std::string(side.settled ? "yes" : "not yet"); });
  return table;
}

// ---------------------------------------------------------------- Williamson turn

/// The track that she came along, from the first order back.
Curve original_track(const WilliamsonTurn& w) {
  const auto ahead = w.run[Channel::x];
  const double furthest = ahead.empty() ? 0.0 : *std::ranges::max_element(ahead);
  return {.name = "the original track",
          .x = {0.0, 0.0},
          .y = {-0.15 * furthest, furthest},
          .stroke = {ink::faint, 2.0, true}};
}

std::vector<PageCell> place_row(const char* name, const std::optional<TrackPlace>& p, const UserUnits& units) {
  if (!p) return {name, "not reached", "-", "-"};
  return {name, units.time(p->time), units.length(p->along), units.length(p->offset)};
}

std::string beside_words(const TrackPlace& p, Side first, const UserUnits& units) {
  const bool other = p.offset < 0.0;
  return fmt::format("{} beside the original track, to {}", units.length(std::abs(p.offset)),
                     name_of(other == (first == Side::port) ? Side::starboard : Side::port));
}

// ---------------------------------------------------------------- straight run in wind

/// Helm and drift for wind from all sides, in degrees; gaps where no helm holds her.
struct AllWinds {
  std::vector<double> from, helm, drift;
};

AllWinds all_winds(const Ship& ship, const Windage<double>& windage, double wind_speed, const WindRunOrder& order) {
  std::vector<double> relative;
  for (int k = 0; k <= 36; ++k) relative.push_back(radians(-180.0 + 10.0 * k));
  AllWinds all;
  for (const auto& [from, run] : steady_runs_in_wind(ship, windage, wind_speed, relative, order)) {
    all.from.push_back(degrees(from));
    all.helm.push_back(run ? degrees(run->delta) : missing);
    all.drift.push_back(run ? degrees(drift_angle(run->motion)) : missing);
  }
  return all;
}

std::optional<PagePicture> wind_picture(const Ship& ship, const WindRunOrder& order, const Sailed& s) {
  const auto around = surroundings_at(ship, 0.0);
  if (!around.windy) return std::nullopt;
  const auto all = all_winds(ship, around.windage, around.wind.speed, order);
  const double largest = degrees(steering_gear(ship).max_angle);
  Panel panel{.x = {.quantity = "Wind from, to starboard of the course", .unit = "deg", .tick = 45.0},
              .y = {.quantity = "Helm, drift", .unit = "deg"},
              .curves = {{"helm, to port", all.from, all.helm, {ink::rudder, 2.0}},
                         {"drift angle", all.from, all.drift, {ink::drift, 2.0}}}};
  const bool near = std::ranges::any_of(all.helm, [&](double helm) { return std::abs(helm) > 0.5 * largest; });
  for (const double limit : {largest, -largest})
    if (near) panel.curves.push_back({"", {-180.0, 180.0}, {limit, limit}, {ink::yaw, 1.4, true}});
  return picture_of({.title = "Wind of that speed from all sides", .panels = {std::move(panel)}},
                    "Helm and drift that keep the course, over the direction of the wind.",
                    fmt::format("Wind of {} from every side. {}No line: no helm keeps the course.",
                                s.units.speed(around.wind.speed), near ? "Dashed: the largest rudder angle. " : ""),
                    s.units);
}

std::string weather_words(const Ship& ship, const UserUnits& units) {
  const auto around = surroundings_at(ship, 0.0);
  std::string words = around.windy ? fmt::format("wind of {} from {}", units.speed(around.wind.speed),
                                                 units.direction(around.wind.from))
                                   : "no wind";
  if (around.current.speed != 0.0)
    words +=
        fmt::format(", current of {} to {}", units.speed(around.current.speed), units.direction(around.current.to));
  return words;
}

}  // namespace

Page spiral_page(const Spiral& spiral, const SpiralOrder& order, const Sailed& s) {
  const auto& exact = spiral.exact;
  const auto largest = s.units.ordered(order.largest);
  Page page{
      .kicker = fmt::format("Simulated spiral to {}, first to {}", largest, name_of(order.first)),
      .title = {},
      .headline =
          exact ? fmt::format("{} is course unstable: her loop is {}.", s.ship, loop_words(*exact, s.units))
                : fmt::format("{} is course stable: one steady turn at every rudder angle up to {}.", s.ship, largest),
      .tone = tone_of(!exact)};
  page.answers = {{"Is she stable on course?", exact ? "No: at small rudder angles she may turn either way" : "Yes"},
                  {"What loop would the trial show?", measured_loop_words(spiral, order, s.units)},
                  {"What does she do amidships?", amidships_words(spiral, s)}};
  std::vector curves{steady_curve(spiral.curve, true), way_curve(spiral.down, "way out", {ink::drift, 1.4}),
                     way_curve(spiral.up, "way back", {ink::yaw, 1.4, true})};
  if (exact) curves.insert(curves.begin() + 1, steady_curve(spiral.curve, false));
  page.picture = picture_of({.title = "Spiral", .panels = {spiral_panel(std::move(curves))}},
                            "Yaw rate over rudder angle on the way out and back, and all steady turns.",
                            "Rudder counts to port, yaw rate to starboard.", s.units);
  page.table = ways_table(spiral, s);
  page.assumed = {"At each angle the ship turns until nothing changes but place and heading."};
  return completed(std::move(page), s);
}

Page reverse_spiral_page(const ReverseSpiral& spiral, const ReverseSpiralOrder& order, const Sailed& s) {
  const auto unstable = unstable_of(spiral);
  const auto largest = s.units.ordered(order.largest);
  Page page{
      .kicker = "Reverse spiral to " + largest,
      .title = {},
      .headline =
          unstable.empty()
              ? fmt::format("{} is course stable: with the rudder fixed every turn up to {} lasts.", s.ship, largest)
              : fmt::format("{} is course unstable: with the rudder fixed she keeps no yaw rate between {} and {}.",
                            s.ship, yaw_rate_of(unstable.front().r, s), yaw_rate_of(unstable.back().r, s)),
      .tone = tone_of(unstable.empty())};
  page.answers = {{"Is she stable on course?", unstable.empty() ? "Yes" : "No"},
                  {"Which rudder holds her straight?", neutral_words(spiral, s.units)}};
  const auto turns = turns_of(spiral);
  std::vector curves{steady_curve(turns, true)};
  if (!unstable.empty()) curves.push_back(steady_curve(turns, false));
  page.picture =
      picture_of({.title = "Reverse spiral", .panels = {spiral_panel(std::move(curves))}},
                 "Rudder angle that holds each yaw rate.", "Rudder counts to port, yaw rate to starboard.", s.units);
  page.table = held_table(spiral, s.units);
  page.assumed = {"The rudder is that of the exact steady turn; no helmsman is simulated."};
  return completed(std::move(page), s);
}

Page pull_out_page(const PullOut& p, const PullOutOrder& order, const Sailed& s) {
  const bool stable = height_of(p) < same_yaw_rate * p.approach_speed / s.L;
  const auto& [port, starboard] = p.sides;
  const auto left = left_words(p, s);
  Page page{.kicker = fmt::format("Simulated pull-out from turns with {} of rudder", s.units.ordered(order.rudder)),
            .title = {},
            .headline = fmt::format("{} is course {}. With the rudder amidships she {}.", s.ship,
                                    stable ? "stable" : "unstable", left),
            .tone = tone_of(stable)};
  page.answers = {
      {"What is left of the turn?", "She " + left},
      {"How soon is it gone?", fmt::format("37 % of the change is left after {} from starboard, {} from port",
                                           time_of(starboard.fall_time, s.units), time_of(port.fall_time, s.units))}};
  page.picture = pull_out_picture(p, s.units);
  page.table = pull_out_table(p, s);
  return completed(std::move(page), s);
}

Page williamson_page(const WilliamsonTurn& w, const WilliamsonOrder& order, const Sailed& s) {
  const auto& back = w.reciprocal;
  Page page{.kicker = fmt::format("Simulated Williamson turn with {} of rudder, first to {}",
                                  s.units.ordered(order.rudder), name_of(order.first)),
            .title = {},
            .headline = back ? fmt::format("{} is on the opposite course after {}, {}.", s.ship,
                                           s.units.time(back->time), beside_words(*back, order.first, s.units))
                             : fmt::format("{} does not come to the opposite course: her heading changed by {}.",
                                           s.ship, s.units.angle(w.heading)),
            .tone = back ? Tone::neutral : Tone::look};
  page.answers = {{"How far does she miss the original track?", back ? beside_words(*back, order.first, s.units) : "-"},
                  {"How long does it take?", back ? s.units.time(back->time) : "not reached"},
                  {"How far does she sail?", length_of(w.way, s.units)}};
  page.picture = track_picture({{&w.run, "track", ink::drift}}, {original_track(w)}, s,
                               "Track of the Williamson turn beside the track that she came along.",
                               "North is the approach course; the outline is the ship to scale.");
  page.table = PageTable{.caption = {},
                         .columns = {"", "After", "Ahead", "Beside the track"},
                         .rows = {place_row("rudder to the other side", w.shifted, s.units),
                                  place_row("rudder amidships", w.amidships, s.units),
                                  place_row("opposite course", w.reciprocal, s.units)}};
  page.assumed = {"The rudder is shifted at " + s.units.ordered(order.heading) + " of turn and put amidships " +
                      s.units.ordered(order.before) + " before the opposite course; nobody steers after that.",
                  "Ahead and beside count from the first rudder order, beside to the side turned to first."};
  return completed(std::move(page), s);
}

Page straight_page(const Ship& ship, const WindRun& run, const WindRunOrder& order, const Sailed& s) {
  const auto course = s.units.direction(order.direction), helm = helm_words(run.delta, s.units),
             weather = weather_words(ship, s.units);
  const double largest = steering_gear(ship).max_angle;
  Page page{.kicker = "Straight run in wind and current",
            .title = {},
            .headline = run.holds
                            ? fmt::format("{} holds course {} with rudder {}; {}.", s.ship, course, helm, weather)
                            : fmt::format("{} cannot hold course {}: it would take rudder {}, and she has {}; {}.",
                                          s.ship, course, helm, s.units.ordered(largest), weather),
            .tone = run.holds ? Tone::good : Tone::bad};
  page.answers = {{"Can she hold the course?", fmt::format("{}: it takes rudder {}, and she has {}",
                                                           run.holds ? "Yes" : "No", helm, s.units.ordered(largest))},
                  {"How fast is she over ground?", s.units.speed(run.speed_over_ground)},
                  {"In what weather?", capital(weather)}};
  page.picture = wind_picture(ship, order, s);
  page.table = PageTable{.caption = {},
                         .columns = {"", "Value"},
                         .rows = {{"heading", s.units.direction(run.psi)},
                                  {"drift angle", s.units.angle(drift_angle(run.motion))},
                                  {"rudder", helm},
                                  {"speed through the water", s.units.speed(speed(run.motion))},
                                  {"speed over ground", s.units.speed(run.speed_over_ground)},
                                  {"wind force ahead", s.units.in_unit("N", run.wind_force.X)},
                                  {"wind force to starboard", s.units.in_unit("N", run.wind_force.Y)}}};
  page.assumed = {"Steady wind and current; whether the run is stable without a helmsman is not said."};
  return completed(std::move(page), s);
}

}  // namespace swayaw::app
