#include "swayaw/mismatch/compare.hpp"

#include <algorithm>
#include <map>

#include "checked_runs.hpp"
#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "recorded_inputs.hpp"
#include "sentences.hpp"
#include "swayaw/app/report.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "terminal.hpp"
#include "user_units.hpp"
#include "way_ahead.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- JSON

Json region_json(const RegionError& r) {
  return {{"variable", name_of(r.variable)},
          {"from", number(r.from)},
          {"to", number(r.to)},
          {"samples", r.samples},
          {"rms", number(r.rms)},
          {"bias", number(r.bias)},
          {"share", number(r.share)}};
}

Json worst_region_json(const std::optional<RegionError>& region) {
  if (!region) return nullptr;
  Json json = region_json(*region);
  json["words"] = words_for(*region);
  return json;
}

Json interval_json(const std::optional<WorstInterval>& worst) {
  if (!worst) return nullptr;
  return {{"from_s", worst->from}, {"to_s", worst->to}, {"share", number(worst->share)}, {"rms", number(worst->rms)}};
}

Json error_json(const QuantityError& e) {
  Json by_region = Json::array();
  for (const auto& region : e.regions) by_region.push_back(region_json(region));
  return {{"quantity", name_of(e.quantity)},
          {"unit", unit_of(e.quantity)},
          {"variation", number(e.variation)},
          {"noise", number(e.noise)},
          {"window_rms", number(e.window_rms)},
          {"normalised", number(e.normalised())},
          {"bias", number(e.bias)},
          {"open_loop_rms", number(e.open_loop_rms)},
          {"open_loop_normalised", number(e.open_loop_normalised())},
          {"worst", interval_json(e.worst)},
          {"region", worst_region_json(e.region)},
          {"by_region", std::move(by_region)}};
}

Json errors_json(const std::vector<QuantityError>& errors) {
  Json quantities = Json::array();
  for (const auto& e : errors) quantities.push_back(error_json(e));
  return quantities;
}

Json run_json(const Comparison& c) {
  const auto& manoeuvre = c.recorded.facts.manoeuvre;
  return {{"run", c.recorded.name},
          {"manoeuvre", manoeuvre.empty() ? Json(nullptr) : Json(manoeuvre)},
          {"duration_s", c.recorded.time.back() - c.recorded.time.front()},
          {"samples", c.recorded.samples()},
          {"windows", c.window_starts.size()},
          {"quantities", errors_json(c.errors)}};
}

Json document_of(const Ship& ship, const CompareArguments& a, const std::vector<Comparison>& comparisons) {
  Json runs = Json::array();
  for (const auto& c : comparisons) runs.push_back(run_json(c));
  return {{"schema", "swayaw.comparison/1"},
          {"version", version()},
          {"ship", ship.name},
          {"ship_file", a.ship.string()},
          {"length_m", length(ship)},
          {"verdict", verdict(comparisons)},
          {"window_ship_lengths", a.window_lengths},
          {"all_runs", {{"quantities", errors_json(pooled(comparisons))}}},
          {"runs", std::move(runs)}};
}

// ---------------------------------------------------------------- series for the page

Json channels_json(const Recording& run, const std::vector<std::size_t>& breaks) {
  Json series = Json::object();
  const auto add = [&](std::string_view name, std::span<const double> values) {
    auto list = parameters(values);
    for (const auto i : breaks) list[i] = nullptr;
    series[std::string(name)] = std::move(list);
  };
  for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta})
    if (run.has(channel)) add(column_name(channel), run[channel]);
  if (!run.has(Channel::u) && run.has(Channel::speed_through_water)) add("u_m_s", run[Channel::speed_through_water]);
  if (tells(run, Quantity::drift)) add("drift_rad", values_of(run, Quantity::drift));
  return series;
}

Json series_json(const Comparison& c) {
  return {{"time_s", parameters(c.recorded.time)},
          {"recorded", channels_json(c.recorded, {})},
          {"open_loop", channels_json(c.open_loop, {})},
          {"windows", channels_json(c.restarted, c.window_starts)}};
}

// ---------------------------------------------------------------- first screen

std::string units_of(Quantity quantity, double value, const UserUnits& units) {
  switch (quantity) {
    case Quantity::heading:
    case Quantity::drift: return units.angle(value);
    case Quantity::yaw_rate: return units.yaw_rate(value);
    case Quantity::speed: return units.speed(value);
    case Quantity::position: return units.length(value);
  }
  return {};
}

/// Yaw-rate error over its variation of a run, or of the first quantity that it tells.
double leading_error(const Comparison& c) {
  const auto yaw = std::ranges::find(c.errors, Quantity::yaw_rate, &QuantityError::quantity);
  return (yaw == c.errors.end() ? c.errors.front() : *yaw).normalised();
}

/// What drives the simulation of a run, in words.
std::string drivers_of(const Ship& ship, const CompareArguments& a, const Recording& run) {
  return shaft_named(a.shaft) == Shaft::recorded ? drivers(ship, run)
                                                 : "the recorded rudder and her own self-propulsion";
}

/// Heading and track of the run in which the ship is furthest off, recorded and simulated.
/// @param by  what drove the simulation, in words
PagePicture picture_of_worst(const Ship& ship, const Comparison& c, const std::string& by, const UserUnits& units) {
  const Stroke recorded{.colour = ink::heading, .width = 2.4},
      simulated{.colour = ink::yaw, .width = 2.0, .dashed = true};
  Plot plot{.title = c.recorded.name, .panels = {}};
  plot.panels.push_back({.x = {.quantity = "Time", .unit = "s"},
                         .y = {.quantity = "Heading", .unit = "deg"},
                         .curves = {over_time(c.recorded, Channel::psi, "recorded", recorded),
                                    over_time(c.open_loop, Channel::psi, "simulated", simulated)}});
  if (c.recorded.has(Channel::x) && c.recorded.has(Channel::y)) {
    std::vector tracks{track_of(c.recorded, "recorded", recorded), track_of(c.open_loop, "simulated", simulated)};
    for (const auto& [run, colour] : {std::pair{&c.recorded, ink::heading}, std::pair{&c.open_loop, ink::yaw}})
      for (auto& hull : hulls_along(*run, length(ship), colour)) tracks.push_back(std::move(hull));
    plot.panels.push_back(track_panel(std::move(tracks), missing));
  }
  const auto& e = c.errors.front();
  return picture_of(
      plot,
      fmt::format("Recorded and simulated heading over time and track of {}. Simulated from start to end "
                  "the {} errs by {}.",
                  c.recorded.name, in_words(name_of(e.quantity)), units_of(e.quantity, e.open_loop_rms, units)),
      fmt::format("Simulated from the recorded start to the end with {}, never restarted.", by), units);
}

PageTable errors_table(const std::vector<Comparison>& comparisons, double window) {
  PageTable table{.caption = fmt::format("Error over {:g} ship lengths, of the variation in the run", window),
                  .columns = {"Run"},
                  .rows = {}};
  const auto all = pooled(comparisons);
  for (const auto& e : all) table.columns.push_back(in_words(name_of(e.quantity)));
  const auto add = [&](const std::string& name, const std::vector<QuantityError>& errors) {
    std::vector<PageCell> row{name};
    for (const auto& wanted : all) {
      const auto e = std::ranges::find(errors, wanted.quantity, &QuantityError::quantity);
      row.emplace_back(e == errors.end() ? std::string("-") : percent_of(e->normalised()));
    }
    table.rows.push_back(std::move(row));
  };
  for (const auto& c : comparisons) add(c.recorded.name, c.errors);
  if (comparisons.size() > 1) add("all runs", all);
  return table;
}

/// "heading 2.46 deg, yaw rate 0.211 deg/s, …"
std::string sizes_words(const std::vector<QuantityError>& errors, const UserUnits& units) {
  std::vector<std::string> words;
  for (const auto& e : errors)
    words.push_back(fmt::format("{} {}", in_words(name_of(e.quantity)), units_of(e.quantity, e.window_rms, units)));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Where the quantity that is furthest off is so.
std::string place_words(const Comparison& c, const UserUnits& units) {
  const auto worst = std::ranges::max_element(c.errors, {}, [](const QuantityError& e) {
    return e.quantity == Quantity::position || !(e.variation > 0.0) ? -1.0 : e.beyond_noise() / e.variation;
  });
  auto words = fmt::format("{} in {}", in_words(name_of(worst->quantity)), c.recorded.name);
  if (worst->worst)
    words += fmt::format(", {:.0f} % of its error from {:.4g} to {:.4g} s", 100.0 * worst->worst->share,
                         worst->worst->from, worst->worst->to);
  if (worst->region)
    words += fmt::format("; off by {} with {}", units_of(worst->quantity, worst->region->rms, units),
                         words_for(*worst->region));
  return words;
}

/// Names of runs in a sentence.
constexpr std::size_t most_runs_named = 4;

std::vector<std::string> assumed_of(const Ship& ship, const CompareArguments& a,
                                    const std::vector<Comparison>& comparisons) {
  std::vector<std::string> lines{fmt::format("Ship file {}.", a.ship.string())};
  std::map<std::string, std::vector<std::string>> runs_by_drivers;
  for (const auto& c : comparisons) runs_by_drivers[drivers_of(ship, a, c.recorded)].push_back(c.recorded.name);
  for (const auto& [by, runs] : runs_by_drivers)
    lines.push_back(fmt::format("Simulated with {}: {}.", by, listed(runs, most_runs_named)));
  const auto any = [&](Channel channel) {
    return std::ranges::any_of(comparisons, [&](const Comparison& c) { return c.recorded.has(channel); });
  };
  lines.push_back(a.reading.ignored.wind     ? "The measured wind was left out, as asked."
                  : any(Channel::wind_speed) ? "The measured wind acts in the simulation."
                                             : "No wind was measured; none acts but that of the ship file.");
  lines.push_back(a.reading.no_check ? "Instruments were not checked, as asked."
                                     : "Instruments were checked first (swayaw check).");
  return lines;
}

Page first_screen(const Ship& ship, const CompareArguments& a, const std::vector<Comparison>& comparisons) {
  const UserUnits units(a.report.si, length(ship));
  const auto& worst = *std::ranges::max_element(comparisons, {}, leading_error);
  return {.kicker = "Simulation beside recordings",
          .title = ship.name,
          .headline = verdict(comparisons),
          .answers = {{"How far off is the model?", fmt::format("Over {:g} ship lengths: {}", a.window_lengths,
                                                                sizes_words(pooled(comparisons), units))},
                      {"Where is it worst?", place_words(worst, units)},
                      {"Why, and what next?",
                       "swayaw diagnose, with the same ship and runs, says what the model leaves out"}},
          .picture = picture_of_worst(ship, worst, drivers_of(ship, a, worst.recorded), units),
          .table = errors_table(comparisons, a.window_lengths),
          .assumed = assumed_of(ship, a, comparisons)};
}

void write_report(const Json& document, const Ship& ship, const CompareArguments& a,
                  const std::vector<Comparison>& comparisons) {
  Json data = only(document, {"version", "length_m", "window_ship_lengths", "all_runs", "runs"});
  for (std::size_t i = 0; i < comparisons.size(); ++i) data["runs"][i]["series"] = series_json(comparisons[i]);
  write_page(a.report.file, comparison_page(first_screen(ship, a, comparisons), for_page(data)));
}

// ---------------------------------------------------------------- text

/// An error in the unit that people read.
std::string shown(Quantity quantity, double value) {
  switch (quantity) {
    case Quantity::heading:
    case Quantity::drift: return fmt::format("{:.2f} deg", degrees(value));
    case Quantity::yaw_rate: return fmt::format("{:.3f} deg/s", degrees(value));
    case Quantity::speed: return fmt::format("{:.3f} m/s", value);
    case Quantity::position: return fmt::format("{:.2f} m", value);
  }
  return {};
}

std::string interval_words(const QuantityError& e) {
  if (!e.worst) return "-";
  return fmt::format("{:.5g}-{:.5g} s ({:.0f} %)", e.worst->from, e.worst->to, 100.0 * e.worst->share);
}

std::string region_text(const QuantityError& e) {
  return e.region ? fmt::format("{}: {}", words_for(*e.region), shown(e.quantity, e.region->rms)) : "-";
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

/// One row for each quantity.
std::vector<std::vector<std::string>> rows_of(const std::vector<QuantityError>& errors) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& e : errors)
    rows.push_back({std::string(name_of(e.quantity)), shown(e.quantity, e.window_rms), percent(e.normalised()),
                    shown(e.quantity, e.bias), shown(e.quantity, e.open_loop_rms), interval_words(e), region_text(e)});
  return rows;
}

const std::vector<std::string> headings{"quantity",  "window error",   "of variation", "bias",
                                        "whole run", "worst interval", "worst region"};

/// Sizes as a table, and below it where each quantity is worst.
void print_table(const std::vector<QuantityError>& errors) {
  const auto print_row = [](const std::vector<std::string>& cell) {
    say("  {:<10}{:>16}{:>14}{:>16}{:>16}\n", cell[0], cell[1], cell[2], cell[3], cell[4]);
  };
  print_row(headings);
  const auto rows = rows_of(errors);
  for (const auto& row : rows) print_row(row);
  for (const auto& row : rows)
    if (row[5] != "-" || row[6] != "-")
      say("  {} worst: {}{}{}\n", row[0], row[5] == "-" ? "" : row[5], row[5] != "-" && row[6] != "-" ? "; " : "",
          row[6] == "-" ? "" : row[6]);
}

void print_run(const Comparison& c) {
  say("\n{}", c.recorded.name);
  if (!c.recorded.facts.manoeuvre.empty()) say(": {}", c.recorded.facts.manoeuvre);
  say(", {:.5g} s, {} windows\n", c.recorded.time.back() - c.recorded.time.front(), c.window_starts.size());
  print_table(c.errors);
}

// ---------------------------------------------------------------- Markdown

/// A text that ends no cell and is no element of HTML, which Markdown may hold.
std::string in_markdown(const std::string& text) {
  std::string safe;
  for (const char c : core::detail::printable(text))
    safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '|' ? "\\|" : std::string(1, c);
  return safe;
}

void print_markdown_row(std::vector<std::string> cells) {
  for (auto& cell : cells) cell = in_markdown(cell);
  fmt::print("| {} |\n", fmt::join(cells, " | "));
}

void print_markdown_head(std::vector<std::string> names, std::size_t left) {
  print_markdown_row(names);
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = i < left ? "---" : "---:";
  print_markdown_row(names);
}

/// One row for each quantity of each run, the runs together first.
void print_markdown_runs(const std::vector<Comparison>& comparisons) {
  auto names = headings;
  names.insert(names.begin(), "run");
  print_markdown_head(names, 2);
  const auto print_rows = [](const std::string& name, const std::vector<QuantityError>& errors) {
    for (auto row : rows_of(errors)) {
      row.insert(row.begin(), name);
      print_markdown_row(row);
    }
  };
  print_rows("all", pooled(comparisons));
  for (const auto& c : comparisons) print_rows(std::filesystem::path(c.recorded.name).stem().string(), c.errors);
}

/// One row for each region: root mean square (bias) of each quantity in all runs.
void print_markdown_regions(const std::vector<Comparison>& comparisons) {
  const auto all = pooled(comparisons);
  std::vector<std::string> names{"region", "samples"};
  for (const auto& e : all) names.push_back(fmt::format("{}, rms (bias)", name_of(e.quantity)));
  print_markdown_head(names, 1);
  for (const auto& region : all.front().regions) {
    std::vector<std::string> row{words_for(region), std::to_string(region.samples)};
    for (const auto& e : all) {
      const auto same = std::ranges::find_if(e.regions, [&](const auto& r) {
        return r.variable == region.variable && r.from == region.from && r.to == region.to;
      });
      row.push_back(same == e.regions.end()
                        ? "-"
                        : fmt::format("{} ({})", shown(e.quantity, same->rms), shown(e.quantity, same->bias)));
    }
    print_markdown_row(row);
  }
}

void print_markdown(const std::vector<Comparison>& comparisons) {
  print_markdown_runs(comparisons);
  fmt::print("\n");
  print_markdown_regions(comparisons);
  fmt::print("\n{}\n", in_markdown(verdict(comparisons)));
}

void print_text(const Ship& ship, const CompareArguments& a, const std::vector<Comparison>& comparisons) {
  say("{}\n", ship.name);
  say("The simulation takes up the recorded state every {:g} ship lengths; errors are simulated minus recorded.\n",
      a.window_lengths);
  for (const auto& c : comparisons) print_run(c);
  if (comparisons.size() > 1) {
    say("\nall runs\n");
    print_table(pooled(comparisons));
  }
  say("\n"), say("{}\n", verdict(comparisons));
}

}  // namespace

void compare(const CompareArguments& a) {
  const Ship ship = parse_ship(ship_text(a.ship), a.ship);
  const CompareOptions options{.window_lengths = a.window_lengths, .replay = {.shaft = shaft_named(a.shaft)}};
  auto runs = checked_runs(a.runs, a.reading);
  for (auto& run : runs) run = with_way_ahead(ship, std::move(run));
  tell_in_vain(ship, runs);
  if (options.replay.shaft == Shaft::recorded) tell_propulsion(ship, runs);
  std::vector<Comparison> comparisons;
  for (const auto& run : runs) comparisons.push_back(swayaw::compare(ship, run, options));
  const Json document = document_of(ship, a, comparisons);
  if (a.report.wanted()) write_report(document, ship, a, comparisons);
  if (a.json) print_document(document);
  else if (a.markdown) print_markdown(comparisons);
  else print_text(ship, a, comparisons);
}

}  // namespace swayaw::app
