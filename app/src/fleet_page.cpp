#include "fleet_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "effect_words.hpp"
#include "page_writing.hpp"
#include "plot.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::app {
namespace {

/// Changes that the picture shows.
constexpr std::size_t most_changes_drawn = 4;

std::string signed_size(const Effect& effect, const std::string& key, double value, double error,
                        const UserUnits& units) {
  const auto text = in_users_units(effect, {key, value, error}, units);
  return value > 0.0 ? "+" + text : text;
}

std::string label_of_change(const VesselReport& v, const VesselChange& c) {
  return fmt::format("{}: {}", v.vessel, label_of(id_of(c.effect)));
}

/// Levels day by day with bars of 95 %, and the change as it was fitted.
Panel panel_of(const VesselReport& v, const VesselChange& c) {
  const auto unit = unit_of(c.effect, c.key);
  const bool angle = unit == "rad" || unit == "rad/s";
  const auto shown = [&](double value) { return angle ? degrees(value) : value; };
  constexpr double bars = 1.96;
  const double zero = std::floor(v.first_day);
  Curve levels{.name = "each day, 95 %", .x = {}, .y = {}, .stroke = {.colour = ink::drift}};
  for (const auto& day : c.days) {
    for (const double side : {-1.0, 1.0})
      levels.x.push_back(day.day - zero), levels.y.push_back(shown(day.value + side * bars * day.standard_error));
    levels.x.push_back(std::nan("")), levels.y.push_back(std::nan(""));
  }
  Curve fitted{.name = "found", .x = {}, .y = {}, .stroke = {.colour = ink::yaw}};
  const auto add = [&](double day, double value) { fitted.x.push_back(day - zero), fitted.y.push_back(shown(value)); };
  add(v.first_day, c.before), add(c.since.likeliest, c.before);
  if (c.shape == ChangeShape::sudden) add(c.since.likeliest, c.after);
  add(v.last_day, c.after);
  return {.x = {.quantity = "Days since " + date_text(zero), .unit = ""},
          .y = {.quantity = label_of_change(v, c),
                .unit = unit == "rad"     ? "deg"
                        : unit == "rad/s" ? "deg/s"
                                          : unit},
          .curves = {std::move(levels), std::move(fitted)}};
}

PagePicture picture(const FleetDiagnosis& d, const UserUnits& units) {
  Plot plot{.title = "What has changed", .panels = {}};
  for (const auto& v : d.vessels)
    for (const auto& c : v.changes)
      if (plot.panels.size() < most_changes_drawn) plot.panels.push_back(panel_of(v, c));
  return picture_of(std::move(plot), "Each number that changed, day by day, with what was found",
                    "A bar for each day, all else as the vessel is; the line is the change as found.", units);
}

PageTable vessels_table(const FleetDiagnosis& d) {
  PageTable table{.caption = "Vessels, worst first: errors of replays over the variation of what was recorded",
                  .columns = {"Vessel", "Days", "Runs", "From", "To", "As given", "Of the class", "Her own"},
                  .rows = {}};
  for (const auto& v : d.vessels) {
    std::vector<PageCell> row{v.vessel, fmt::format("{}", v.days), fmt::format("{}", v.runs), date_text(v.first_day),
                              date_text(v.last_day)};
    for (const double e : {v.errors.given, v.errors.sisters, v.errors.own})
      row.emplace_back(std::isfinite(e) ? percent_of(e) : "-");
    table.rows.push_back(std::move(row));
  }
  return table;
}

PageTable shared_table(const FleetDiagnosis& d) {
  PageTable table{.caption = "Coefficients of the class",
                  .columns = {"Coefficient", "Ship file", "Found", "Deviations of its confidence"},
                  .rows = {}};
  for (const auto& c : d.shared) {
    const double much = 2.0;  // deviations
    table.rows.push_back(
        {c.key,
         fmt::format("{:.5g}", c.given),
         with_error(c.found, c.standard_error),
         {fmt::format("{:+.1f}", c.deviations), std::abs(c.deviations) > much ? Tone::look : Tone::neutral}});
  }
  return table;
}

}  // namespace

std::vector<FleetLine> lines_of(const FleetDiagnosis& d, const UserUnits& units) {
  std::vector<FleetLine> lines;
  for (const auto& v : d.vessels) {
    for (const auto& c : v.changes)
      lines.push_back(
          {.vessel = v.vessel,
           .what = std::string(label_of(id_of(c.effect))),
           .size = signed_size(c.effect, c.key, c.after - c.before, c.standard_error, units),
           .since = (c.shape == ChangeShape::sudden ? "since " : "growing since ") + date_text(c.since.likeliest),
           .interval = fmt::format("{} to {}", date_text(c.since.from), date_text(c.since.to)),
           .probability = fmt::format("{:.3f}", c.probability),
           .floors = c.floors});
    for (const auto& x : v.differences)
      lines.push_back({.vessel = v.vessel,
                       .what = std::string(label_of(id_of(x.effect))),
                       .size = signed_size(x.effect, x.key, x.own - x.sisters, x.standard_error, units),
                       .since = "from the first day",
                       .interval = "",
                       .probability = "",
                       .floors = x.floors});
  }
  std::ranges::stable_sort(lines, std::greater{}, &FleetLine::floors);
  return lines;
}

namespace {

/// The worst with their sizes; the words of the diagnosis where there is nothing.
std::string headline(const FleetDiagnosis& d, const std::vector<FleetLine>& lines) {
  constexpr std::size_t most = 3;
  if (lines.empty()) return d.words;
  std::string words;
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
    words +=
        fmt::format("{}{}: {} {} {}.", i > 0 ? " " : "", lines[i].vessel, lines[i].what, lines[i].size, lines[i].since);
  if (lines.size() > most) words += fmt::format(" {} more below.", lines.size() - most);
  return words;
}

PageTable lines_table(const std::vector<FleetLine>& lines) {
  PageTable table{
      .caption = "All that was found",
      .columns = {"Vessel", "What", "How much", "Since", "95 % of the dates", "Probability", "Over what matters"},
      .rows = {}};
  for (const auto& line : lines)
    table.rows.push_back({line.vessel, line.what, line.size, line.since, line.interval, line.probability,
                          fmt::format("{:.1f} times", line.floors)});
  return table;
}

}  // namespace

Page fleet_page(const FleetDiagnosis& d, const std::string& ship, const UserUnits& units) {
  const auto lines = lines_of(d, units);
  Page page{.kicker = "Fleet", .title = ship, .headline = headline(d, lines)};
  const bool changed = std::ranges::any_of(d.vessels, [](const VesselReport& v) { return !v.changes.empty(); });
  page.tone = changed ? Tone::look : Tone::good;
  PageTable table{.caption = "Worst first", .columns = {"Vessel", "What", "How much", "Since"}, .rows = {}};
  for (const auto& line : lines) table.rows.push_back({line.vessel, line.what, line.size, line.since});
  if (!table.rows.empty()) page.table = std::move(table);
  const auto moved =
      std::ranges::count_if(d.shared, [](const SharedCoefficient& c) { return std::abs(c.deviations) > 2.0; });
  page.answers.push_back({"What have the sisters in common?",
                          moved == 0 ? "No coefficient is off by more than two deviations of its confidence."
                                     : fmt::format("{} of {} coefficients are off by more than two deviations of their "
                                                   "confidence, told below.",
                                                   moved, d.shared.size())});
  if (d.vessels.size() > 1)
    page.answers.push_back({"How much do they differ?",
                            fmt::format("By {} of what the ship file's confidence allows; days of one vessel by {}.",
                                        percent_of(d.spread), percent_of(d.day_to_day))});
  page.answers.push_back({"Is anything left out?", d.troubles.empty()
                                                       ? "No day is left out."
                                                       : fmt::format("{}.", fmt::join(d.troubles, "; "))});
  if (!d.trace.empty())
    page.answers.push_back({"What is too small to matter?", fmt::format("{}.", fmt::join(d.trace, "; "))});
  page.answers.push_back({"What next?",
                          "--save-models DIR writes a ship file of the class and of every vessel as she is today; "
                          "swayaw diagnose says what is missing in the runs of one of them."});
  if (changed) page.picture = picture(d, units);
  if (!lines.empty()) page.sections.push_back({.title = "What was found", .tables = {lines_table(lines)}});
  page.sections.push_back({.title = "The vessels", .tables = {vessels_table(d)}});
  page.sections.push_back({.title = "The class", .tables = {shared_table(d)}});
  page.assumed.push_back(
      "Sisters have the coefficients of the class, each with a small spread of her own; both are found together.");
  page.assumed.push_back("Wind and stream differ from day to day; ordinary errors of instruments are allowed for.");
  page.footnotes.push_back(made_by());
  return page;
}

}  // namespace swayaw::app
