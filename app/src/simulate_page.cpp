#include "simulate_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "page_writing.hpp"
#include "simulate_criteria.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- how she was sailed

/// "shaft 107 rpm held"
std::string propulsion_words(const Ship& ship, const Controls<double>& c, const UserUnits& units) {
  if (c.by_thrust) return units.in_unit("N", c.thrust.port + c.thrust.starboard) + " of thrust held";
  if (!takes_shaft_speed(ship)) return "propulsion held";
  return units.si() ? fmt::format("shaft {} 1/s held", with_error(c.rev))
                    : fmt::format("shaft {} rpm held", with_error(60.0 * c.rev));
}

/// "draught 21.0 m, displacement 312000 m3"
template <class Model>
std::string loading_of(const Model& model) {
  if constexpr (requires { model.particulars.d; })
    return fmt::format("draught {} m, {} m³ displaced", with_error(model.particulars.d),
                       with_error(model.particulars.nabla));
  else return "loading as in the tests that gave the ship file";
}

bool disturbs(const Effect& effect) {
  const auto place = place_of(effect);
  return place == EffectPlace::air || place == EffectPlace::water ||
         std::holds_alternative<WaveDrift<double>>(effect) || std::holds_alternative<ShallowWater<double>>(effect);
}

/// "a steady wind, shallow water"
std::string phrases_of(const std::vector<Effect>& effects) {
  std::string words;
  for (const auto& effect : effects) words += (words.empty() ? "" : ", ") + phrase_of(effect);
  return words;
}

std::vector<std::string> assumed_of(const Ship& ship, const SimulateArguments& a, bool calm) {
  std::vector<std::string> lines{fmt::format("The ship is as {} says.", a.ship.string())};
  if (calm) lines.emplace_back("Deep water; no wind, no waves, no current.");
  if (!ship.effects.empty()) lines.push_back("Of the ship file acts besides: " + phrases_of(ship.effects) + ".");
  lines.emplace_back("The propulsion is held as it is on the straight approach.");
  return lines;
}

// ---------------------------------------------------------------- tracks

std::vector<Curve> curves_of(const std::vector<DrawnTrack>& tracks, double L) {
  std::vector<Curve> curves;
  for (const auto& [run, name, colour] : tracks) {
    curves.push_back(track_of(*run, name, {.colour = colour, .width = 2.0}));
    for (auto& hull : hulls_along(*run, L, colour)) curves.push_back(std::move(hull));
  }
  return curves;
}

double span_of(const std::vector<Curve>& curves, const std::vector<double> Curve::*axis) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& curve : curves)
    for (const double value : curve.*axis)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return high - low;
}

/// Distance of the marks on both axes: 1, 2 or 5 times a power of ten, five of them or fewer.
double tick_of(const std::vector<Curve>& curves) {
  const double least = std::max(span_of(curves, &Curve::x), span_of(curves, &Curve::y)) / 5.0;
  if (!(least > 0.0)) return 0.0;
  const double ten = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * ten >= least) return times * ten;
  return 10.0 * ten;
}

}  // namespace

Sailed sailed(const Ship& ship, double speed, const Controls<double>& propulsion, const SimulateArguments& a) {
  const UserUnits units(a.report.si, length(ship));
  const auto around = surroundings_at(ship, 0.0);
  const bool calm = !around.windy && around.current.speed == 0.0 && std::ranges::none_of(ship.effects, disturbs);
  return {.ship = ship.name,
          .L = length(ship),
          .speed = speed,
          .units = units,
          .how = fmt::format("{}, {}; {}", units.speed(speed), propulsion_words(ship, propulsion, units),
                             std::visit([](const auto& model) { return loading_of(model); }, ship.model)),
          .assumed = assumed_of(ship, a, calm),
          .calm = calm};
}

Sailed sailed(const LinearShip& ship, double speed, const SimulateArguments& a) {
  const UserUnits units(a.report.si, ship.particulars.L);
  return {.ship = ship.name,
          .L = ship.particulars.L,
          .speed = speed,
          .units = units,
          .how = fmt::format("{}, held; loading as in the tests that gave the ship file", units.speed(speed)),
          .assumed = {fmt::format("The ship is as {} says: linear equations of drift and yaw.", a.ship.string()),
                      "Her speed is held, whereas a real ship slows down in a turn.",
                      "Deep water; no wind, no waves, no current."}};
}

Page completed(Page page, const Sailed& s) {
  page.title = s.ship;
  page.answers.push_back({"At what speed and loading?", s.how});
  page.assumed.insert(page.assumed.begin(), s.assumed.begin(), s.assumed.end());
  page.footnotes.push_back(made_by());
  return page;
}

std::string length_of(const std::optional<double>& metres, const UserUnits& units) {
  return metres ? units.length(*metres) : "not reached";
}

std::string time_of(const std::optional<double>& seconds, const UserUnits& units) {
  return seconds ? units.time(*seconds) : "not reached";
}

PageTable table_of(const std::vector<Criterion>& criteria, const std::vector<Measure>& others, const Sailed& s) {
  PageTable table{.caption = {}, .columns = {"", "Value"}, .rows = {}};
  if (!criteria.empty()) table = criteria_table(criteria, s);
  for (const auto& [name, value] : others) {
    std::vector<PageCell> row{name, value};
    row.resize(table.columns.size(), "-");
    if (has_sides(criteria)) std::swap(row[1], row[2]);
    table.rows.push_back(std::move(row));
  }
  return table;
}

PagePicture track_picture(const std::vector<DrawnTrack>& tracks, std::vector<Curve> others, const Sailed& s,
                          std::string words, std::string caption) {
  auto curves = curves_of(tracks, s.L);
  std::ranges::move(others, std::back_inserter(curves));
  auto panel = track_panel(std::move(curves), missing);
  panel.x.tick = panel.y.tick = tick_of(panel.curves);
  constexpr int height = 380;  // px
  auto picture = picture_of({.title = "Track of midship", .panels = {std::move(panel)}}, std::move(words),
                            std::move(caption), s.units, height);
  if (tracks.size() > 1) picture.numbers.reset();  // they share no abscissa
  return picture;
}

Curve up_to(Curve curve, double x) {
  const auto end = std::ranges::upper_bound(curve.x, x) - curve.x.begin();
  curve.x.resize(static_cast<std::size_t>(end));
  curve.y.resize(static_cast<std::size_t>(end));
  return curve;
}

}  // namespace swayaw::app
