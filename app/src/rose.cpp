#include "rose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "effect_words.hpp"
#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- headings sailed

constexpr std::size_t sectors = 72;
constexpr double sector = 2.0 * pi / sectors;

/// Whether a heading within each sector was sailed.
using Headings = std::array<bool, sectors>;

/// @param runs  of these only; empty: of all
Headings headings_of(const Diagnosis& d, std::span<const std::string> runs) {
  Headings sailed{};
  for (const auto* pictures : {&d.train_pictures, &d.holdout_pictures})
    for (const auto& p : *pictures) {
      const bool wanted = runs.empty() || std::ranges::count(runs, p.run) > 0;
      if (!wanted || !p.recorded.has(Channel::psi)) continue;
      for (const double psi : p.recorded[Channel::psi])
        if (std::isfinite(psi))
          sailed[static_cast<std::size_t>(std::floor((wrapped(psi) + 2.0 * pi) / sector)) % sectors] = true;
    }
  return sailed;
}

/// "340 deg (NNW) to 020 deg (NNE)" of each range.
std::string words_of(const Headings& sailed, const UserUnits& units) {
  if (std::ranges::all_of(sailed, [](bool s) { return s; })) return "all";
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < sectors; ++i) {
    if (!sailed[i] || sailed[(i + sectors - 1) % sectors]) continue;
    std::size_t count = 1;
    while (sailed[(i + count) % sectors]) ++count;
    ranges.push_back(fmt::format("{} to {}", units.direction(sector * static_cast<double>(i)),
                                 units.direction(sector * static_cast<double>(i + count))));
  }
  constexpr std::size_t most = 3;
  return ranges.empty() ? "not recorded" : listed(ranges, most);
}

// ---------------------------------------------------------------- the rose

/// A direction over the earth.
struct Direction {
  std::string name;  ///< "wind from"
  double value, standard_error;
  bool from;
};

std::optional<Direction> direction_of(std::span<const ParameterEstimate> parameters) {
  for (const auto& p : parameters) {
    const bool from = p.key.ends_with("_from_rad"), to = p.key.ends_with("_to_rad");
    if ((from || to) && std::isfinite(p.value))
      return Direction{name_of_parameter(p.key, "rad"), p.value, p.standard_error, from};
  }
  return std::nullopt;
}

/// Each group or run where the effect differs; else all runs, without a name.
std::vector<SurroundingsEstimate> parts_of(const FoundEffect& e, const Diagnosis& d) {
  auto places = places_of(e, d);
  if (e.scope == Scope::ship) places.push_back({.scope = "", .runs = {}, .parameters = e.parameters});
  return places;
}

/// Half of the interval that holds the direction with 95 %; half a turn where nothing is told.
double half_interval(const Direction& d) {
  return std::isfinite(d.standard_error) ? std::min(1.96 * d.standard_error, pi) : pi;
}

void add(Curve& curve, double radius, double bearing) {
  curve.x.push_back(radius * std::sin(bearing)), curve.y.push_back(radius * std::cos(bearing));
}

Curve arc(std::string name, double radius, double from, double to, Stroke stroke) {
  constexpr int points = 90;
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .stroke = stroke};
  for (int i = 0; i <= points; ++i) add(curve, radius, from + (to - from) * i / points);
  return curve;
}

Curve wedge(const Direction& d) {
  const double half = half_interval(d);
  auto curve = arc("95 % of it", 1.0, d.value - half, d.value + half, {.colour = "#a6cee3", .filled = true});
  add(curve, 0.0, 0.0);
  return curve;
}

Curve band_of(const Headings& sailed) {
  Curve curve{.name = "headings sailed", .x = {}, .y = {}, .stroke = {.colour = ink::yaw, .width = 6.0}};
  constexpr double radius = 1.06;
  for (std::size_t i = 0; i < sectors; ++i) {
    if (!sailed[i]) continue;
    const double from = sector * static_cast<double>(i);
    for (const double part : {0.0, 0.5, 1.0}) add(curve, radius, from + part * sector);
    curve.x.push_back(missing), curve.y.push_back(missing);
  }
  return curve;
}

/// From the rim to the middle where it comes from there, else from the middle to the rim.
Curve arrow(const Direction& d) {
  Curve curve{.name = d.name, .x = {}, .y = {}, .stroke = {.colour = ink::heading, .width = 2.6}};
  constexpr double barb = 0.1;
  const double tip = d.from ? 0.0 : 1.0, back = d.from ? 0.16 : 0.84;
  add(curve, 1.0 - tip, d.value), add(curve, tip, d.value);
  for (const double side : {barb, -barb}) {
    curve.x.push_back(back * std::sin(d.value) + side * std::cos(d.value));
    curve.y.push_back(back * std::cos(d.value) - side * std::sin(d.value));
    add(curve, tip, d.value);
  }
  return curve;
}

Plot plot_of(const std::string& title, const Direction& d, const Headings& sailed) {
  Panel panel{.x = {}, .y = {}, .curves = {wedge(d)}, .same_scale = true, .labels = {}, .bare_to = 1.35};
  panel.curves.push_back(arc("", 1.0, 0.0, 2.0 * pi, {.colour = ink::faint, .width = 1.2}));
  panel.curves.push_back(band_of(sailed));
  panel.curves.push_back(arrow(d));
  constexpr double out = 1.2;
  panel.labels = {{"N", 0.0, out}, {"E", out, 0.0}, {"S", 0.0, -out}, {"W", -out, 0.0}};
  return {.title = title, .panels = {std::move(panel)}};
}

PageTable numbers_of(const std::string& title, const Effect& effect, const SurroundingsEstimate& part,
                     const Direction& d, const Headings& sailed, const UserUnits& units) {
  PageTable table{.caption = title, .columns = {"", "Value"}, .rows = {}};
  for (const auto& p : part.parameters)
    if (std::isfinite(p.value))
      table.rows.push_back({name_of_parameter(p.key, unit_of(effect, p.key)), in_users_units(effect, p, units)});
  const double half = half_interval(d);
  table.rows.push_back(
      {d.name + ", 95 %",
       half < pi ? fmt::format("{} to {}", units.direction(d.value - half), units.direction(d.value + half)) : "any"});
  table.rows.push_back({"headings sailed", words_of(sailed, units)});
  return table;
}

std::optional<PageSection> section_of(const FoundEffect& e, const SurroundingsEstimate& part,
                                      const Diagnosis& diagnosis, const UserUnits& units) {
  const auto d = direction_of(part.parameters);
  if (!d) return std::nullopt;
  const auto sailed = headings_of(diagnosis, part.runs);
  const auto title =
      fmt::format("Direction of the {}{}{}", label_of(e.effect), part.scope.empty() ? "" : ", ", part.scope);
  const auto told = fmt::format("{} {}", capital(d->name), units.direction(d->value, d->standard_error));
  constexpr int height = 300;  // px
  auto picture = picture_of(plot_of("", *d, sailed),
                            fmt::format("A rose, north up. {}; headings sailed: {}.", told, words_of(sailed, units)),
                            "North is up. The arrow goes with it; shaded: where it is with 95 %.", units, height);
  picture.numbers = numbers_of(title, e.effect, part, *d, sailed, units);
  return PageSection{.title = title, .words = {told + "."}, .pictures = {std::move(picture)}};
}

}  // namespace

std::vector<PageSection> direction_sections(const Diagnosis& diagnosis, const UserUnits& units) {
  std::vector<PageSection> sections;
  for (const auto& e : diagnosis.effects)
    for (const auto& part : parts_of(e, diagnosis))
      if (auto section = section_of(e, part, diagnosis, units)) sections.push_back(std::move(*section));
  return sections;
}

}  // namespace swayaw::app
