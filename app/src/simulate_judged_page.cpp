#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "input.hpp"
#include "page_writing.hpp"
#include "simulate_criteria.hpp"
#include "simulate_page.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::app {
namespace {

constexpr Stroke limit_stroke{.colour = ink::yaw, .width = 1.8, .dashed = true};

const char* const signs_words = "Heading counts to starboard, rudder to port.";

bool is_judged(const std::vector<Criterion>& criteria, std::string_view name) {
  return std::ranges::find(criteria, name, &Criterion::name) != criteria.end();
}

// ---------------------------------------------------------------- zigzag

/// What the overshoot after each reversal may come to, drawn until the next one.
Curve allowed_headings(const Zigzag& z, const ZigzagOrder& order, const std::vector<Criterion>& criteria) {
  Curve curve{.name = {}, .x = {}, .y = {}, .stroke = limit_stroke};
  std::size_t k = 0;
  double side = yaw_sign(order.first);
  for (const auto& c : criteria) {
    if (c.unit != "deg" || k >= z.reversals.size()) continue;
    const double end = k + 1 < z.reversals.size() ? z.reversals[k + 1].time : z.run.time.back();
    const double heading = side * (degrees(order.heading) + c.limit);
    for (const auto& [x, y] : {std::pair{z.reversals[k].time, heading}, {end, heading}, {end, missing}})
      curve.x.push_back(x), curve.y.push_back(y);
    side = -side, ++k;
  }
  return curve;
}

Panel heading_panel(const Recording& run) {
  return {.x = {.quantity = "Time", .unit = "s"},
          .y = {.quantity = "Heading, rudder", .unit = "deg"},
          .curves = {over_time(run, Channel::psi, "heading", {.colour = ink::heading, .width = 2.2}),
                     over_time(run, Channel::delta, "rudder, to port", {.colour = ink::rudder, .width = 1.4})}};
}

/// Points that are not drawn, each by itself, and keep the curves off the frame.
Curve room_around(const std::vector<Curve>& curves) {
  double largest = 0.0;
  for (const auto& curve : curves)
    for (const double y : curve.y) largest = std::fmax(largest, std::abs(y));
  const double room = 1.1 * largest;
  return {.name = {}, .x = {0.0, 0.0, 0.0}, .y = {room, missing, -room}, .stroke = {}};
}

std::string zigzag_name(const ZigzagOrder& order) {
  return fmt::format("{} first to {}", name_of(ZigzagAngles{order.rudder, order.heading}), name_of(order.first));
}

std::optional<PagePicture> zigzag_picture(const Zigzag& z, const ZigzagOrder& order,
                                          const std::vector<Criterion>& criteria, const UserUnits& units) {
  if (z.run.samples() == 0) return std::nullopt;
  auto panel = heading_panel(z.run);
  const auto allowed = allowed_headings(z, order, criteria);
  if (!allowed.x.empty()) panel.curves.push_back(allowed);
  panel.curves.push_back(room_around(panel.curves));
  return picture_of(
      {.title = zigzag_name(order), .panels = {std::move(panel)}},
      fmt::format("Heading and rudder over time of the {}.", zigzag_name(order)),
      std::string(allowed.x.empty() ? "" : "Dashed: the overshoot that MSC.137(76) allows. ") + signs_words, units);
}

/// "4.84 deg, 12.8 deg"
std::string overshoot_words(const Zigzag& z, const UserUnits& units) {
  std::string words;
  for (const auto& r : z.reversals)
    if (r.overshoot) words += (words.empty() ? "" : ", ") + units.angle(*r.overshoot);
  return words;
}

/// Overshoots that no criterion is about, period and way.
std::vector<Measure> other_measures(const Zigzag& z, const std::vector<Criterion>& criteria, const UserUnits& units) {
  std::vector<Measure> measures;
  for (auto k = static_cast<std::size_t>(std::ranges::count(criteria, "deg", &Criterion::unit)); k < z.reversals.size();
       ++k)
    measures.push_back({fmt::format("overshoot {}", k + 1),
                        z.reversals[k].overshoot ? units.angle(*z.reversals[k].overshoot) : "not reached"});
  if (!is_judged(criteria, "initial_turning"))
    measures.push_back({"way to the first reversal", length_of(z.initial_turning, units)});
  if (!z.reversals.empty()) measures.push_back({"time to the first reversal", units.time(z.reversals.front().time)});
  measures.push_back({"period of the last cycle", time_of(z.period, units)});
  return measures;
}

std::string zigzag_headline(const Zigzag& z, const std::vector<Criterion>& criteria, const Sailed& s) {
  if (z.reversals.empty()) return "The heading never reached the switch angle.";
  if (!criteria.empty()) return full_judgement(criteria, s);
  const auto overshoots = overshoot_words(z, s.units);
  if (overshoots.empty()) return "The heading had no peak before the run ended.";
  return fmt::format("Overshoots of {}.", overshoots);
}

// ---------------------------------------------------------------- turning circle

/// Advance and tactical diameter that are allowed, on the side of the turn.
Curve allowed_circle(const std::vector<Criterion>& criteria, Side side, double L) {
  Curve curve{.name = {}, .x = {}, .y = {}, .stroke = limit_stroke};
  const auto limit = [&](std::string_view name) {
    return std::ranges::find(criteria, name, &Criterion::name)->limit * L;
  };
  if (!is_judged(criteria, "advance")) return curve;
  const double north = limit("advance"), east = yaw_sign(side) * limit("tactical_diameter");
  return {.name = {}, .x = {0.0, east, east}, .y = {north, north, 0.0}, .stroke = limit_stroke};
}

std::string circle_name(const TurnOrder& order) {
  return fmt::format("turn {:.6g} to {}", degrees(order.rudder), name_of(order.side));
}

PagePicture circle_picture(const TurningCircle& c, const TurnOrder& order, const std::vector<Criterion>& criteria,
                           const Sailed& s) {
  auto allowed = allowed_circle(criteria, order.side, s.L);
  const std::string dashed = allowed.x.empty() ? "" : "Dashed: advance and tactical diameter that MSC.137(76) allows. ";
  return track_picture({{&c.run, circle_name(order), ink::drift}}, {std::move(allowed)}, s,
                       fmt::format("Track of the {}.", circle_name(order)),
                       dashed + "North is the approach course; the outline is the ship to scale.");
}

std::vector<Measure> other_measures(const TurningCircle& c, const std::vector<Criterion>& criteria,
                                    const UserUnits& units) {
  std::vector<Measure> measures;
  const auto add = [&](std::string_view id, const char* name, const std::optional<double>& metres) {
    if (!is_judged(criteria, id)) measures.push_back({name, length_of(metres, units)});
  };
  add("advance", "advance", c.advance);
  add("transfer", "transfer", c.transfer);
  add("tactical_diameter", "tactical diameter", c.tactical_diameter);
  add("initial_turning", "way to 10 deg of turn", c.initial_turning);
  measures.push_back({"time to 90 deg", time_of(c.time_90, units)});
  measures.push_back({"time to 180 deg", time_of(c.time_180, units)});
  if (!c.steady) return measures;
  measures.push_back({"final diameter", length_of(c.final_diameter, units)});
  measures.push_back({"final speed", units.speed(speed(*c.steady))});
  measures.push_back({"final drift angle", units.angle(drift_angle(*c.steady))});
  measures.push_back({"final yaw rate", units.yaw_rate(c.steady->r)});
  return measures;
}

std::string steady_words(const TurningCircle& c, const UserUnits& units) {
  if (c.way_lost) return fmt::format("None: she no longer moves ahead after {}", units.time(*c.way_lost));
  if (!c.steady) return "None was found";
  const double final_speed = speed(*c.steady);
  return fmt::format("{} across at {}, {} of the approach; drift angle {}", length_of(c.final_diameter, units),
                     units.speed(final_speed), percent_of(final_speed / c.approach_speed),
                     units.angle(drift_angle(*c.steady)));
}

std::string circle_headline(const TurningCircle& c, const std::vector<Criterion>& criteria, const Sailed& s) {
  if (!criteria.empty()) return full_judgement(criteria, s);
  return fmt::format("Advance {}, tactical diameter {}.", length_of(c.advance, s.units),
                     length_of(c.tactical_diameter, s.units));
}

// ---------------------------------------------------------------- all criteria

/// The picture of the manoeuvre that tells a criterion, sailed to that side.
PagePicture picture_for(const Ship& ship, int angle, Side side, ManoeuvreOptions options, const Sailed& s) {
  options.duration = std::nullopt;
  options.sampled = true;
  if (angle == 0) {
    const TurnOrder order{turning_rudder(ship), side};
    const auto circle = turning_circle(ship, order, options);
    return circle_picture(circle, order, criteria_of(circle, order, s.L, order.rudder), s);
  }
  const ZigzagOrder order{radians(angle), radians(angle), side};
  const auto z = zigzag(ship, order, options);
  return zigzag_picture(z, order, criteria_of(z, order, s.L), s.units).value();
}

/// The other manoeuvres, each to the side where she is nearer to the limit.
PageSection other_pictures(const Ship& ship, const ImoCriteria& result, const ManoeuvreOptions& options,
                           const Sailed& s) {
  PageSection section{.title = "The other manoeuvres", .words = {"Each to the side where the margin is smaller."}};
  for (const int angle : {0, 10, 20}) {
    auto its = result.criteria;
    std::erase_if(its, [&](const Criterion& c) { return zigzag_of(c) != angle; });
    if (angle != zigzag_of(tightest(result.criteria)))
      section.pictures.push_back(picture_for(ship, angle, tightest(its).side, options, s));
  }
  return section;
}

}  // namespace

Page zigzag_page(const Zigzag& z, const ZigzagOrder& order, const Sailed& s) {
  const auto criteria = criteria_of(z, order, s.L);
  Page page{.kicker = "Simulated " + zigzag_name(order),
            .title = {},
            .headline = zigzag_headline(z, criteria, s),
            .tone = z.reversals.empty() ? Tone::look : tone_of(criteria, s),
            .answers = answers_of(criteria, s),
            .picture = zigzag_picture(z, order, criteria, s.units),
            .table = table_of(criteria, other_measures(z, criteria, s.units), s)};
  if (const auto overshoots = overshoot_words(z, s.units); !overshoots.empty())
    page.answers.push_back({"How far does she overshoot?", overshoots});
  return completed(std::move(page), s);
}

Page circle_page(const Ship& ship, const TurningCircle& c, const TurnOrder& order, const Sailed& s) {
  const auto criteria = criteria_of(c, order, s.L, turning_rudder(ship));
  Page page{.kicker = "Simulated " + circle_name(order),
            .title = {},
            .headline = circle_headline(c, criteria, s),
            .tone = tone_of(criteria, s),
            .answers = answers_of(criteria, s),
            .picture = circle_picture(c, order, criteria, s),
            .table = table_of(criteria, other_measures(c, criteria, s.units), s)};
  page.answers.push_back({"What is the steady turn?", steady_words(c, s.units)});
  return completed(std::move(page), s);
}

Page imo_page(const Ship& ship, const ImoCriteria& result, const ManoeuvreOptions& options, const Sailed& s) {
  const auto& worst = tightest(result.criteria);
  Page page{
      .kicker = "Steering criteria of IMO resolution MSC.137(76), simulated",
      .title = {},
      .headline = judgement(result.criteria, s),
      .tone = tone_of(result.criteria, s),
      .answers = answers_of(result.criteria, s),
      .picture = picture_for(ship, zigzag_of(worst), worst.side, options, s),
      .table = criteria_table(result.criteria, s),
      .assumed = {"Stopping is not simulated; its criterion, track reach, is not judged.",
                  "The approach speed is the test speed. MSC.137(76) asks for at least 90 % of that at 85 % of the "
                  "engine's largest output, full load and even keel; the ship file must stand for them."},
      .sections = {other_pictures(ship, result, options, s)}};
  return completed(std::move(page), s);
}

}  // namespace swayaw::app
