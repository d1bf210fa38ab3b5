#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "checked_runs.hpp"
#include "commands.hpp"
#include "diagnose_report.hpp"
#include "effect_words.hpp"
#include "fleet_page.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "progress.hpp"
#include "recorded_inputs.hpp"
#include "run_selection.hpp"
#include "swayaw/core/run_remark.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/nonlinear/writable_ship.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- runs

/// The key `vessel` of a recording, else the folder that it is in.
std::string vessel_of(const Recording& run, const std::filesystem::path& file) {
  const auto said = remark_of(run, "vessel");
  return said.empty() ? std::filesystem::absolute(file).parent_path().filename().string() : said;
}

// ---------------------------------------------------------------- JSON

Json change_json(const VesselChange& c) {
  Json days = Json::array();
  for (const auto& day : c.days)
    days.push_back(
        {{"date", date_text(day.day)}, {"value", number(day.value)}, {"standard_error", number(day.standard_error)}});
  return {{"effect", id_of(c.effect)},
          {"parameter", c.key},
          {"shape", name_of(c.shape)},
          {"before", number(c.before)},
          {"after", number(c.after)},
          {"standard_error", number(c.standard_error)},
          {"since",
           {{"date", date_text(c.since.likeliest)}, {"from", date_text(c.since.from)}, {"to", date_text(c.since.to)}}},
          {"probability", number(c.probability)},
          {"log_evidence_gain", number(c.log_evidence_gain)},
          {"over_floor", number(c.floors)},
          {"days", std::move(days)}};
}

Json vessel_json(const VesselReport& v) {
  Json changes = Json::array(), differences = Json::array();
  for (const auto& c : v.changes) changes.push_back(change_json(c));
  for (const auto& x : v.differences)
    differences.push_back({{"effect", id_of(x.effect)},
                           {"parameter", x.key},
                           {"sisters", number(x.sisters)},
                           {"own", number(x.own)},
                           {"standard_error", number(x.standard_error)},
                           {"over_floor", number(x.floors)}});
  return {{"vessel", v.vessel},
          {"days", v.days},
          {"runs", v.runs},
          {"first_day", date_text(v.first_day)},
          {"last_day", date_text(v.last_day)},
          {"changes", std::move(changes)},
          {"differences", std::move(differences)},
          {"errors",
           {{"given", number(v.errors.given)}, {"sisters", number(v.errors.sisters)}, {"own", number(v.errors.own)}}}};
}

Json document_of(const FleetDiagnosis& d) {
  Json vessels = Json::array(), shared = Json::array();
  for (const auto& v : d.vessels) vessels.push_back(vessel_json(v));
  for (const auto& c : d.shared)
    shared.push_back({{"key", c.key},
                      {"given", number(c.given)},
                      {"found", number(c.found)},
                      {"standard_error", number(c.standard_error)},
                      {"deviations", number(c.deviations)}});
  return {{"schema", "swayaw.fleet/1"},
          {"version", version()},
          {"words", d.words},
          {"vessels", std::move(vessels)},
          {"shared", std::move(shared)},
          {"spread", number(d.spread)},
          {"day_to_day", number(d.day_to_day)},
          {"traces", d.trace},
          {"set_aside", Json::array()},
          {"troubles", d.troubles}};
}

// ---------------------------------------------------------------- text

void print_fleet(const Ship& ship, const FleetDiagnosis& d, const UserUnits& units) {
  say("{}\n{}\n", ship.name, d.words);
  const auto lines = lines_of(d, units);
  if (!lines.empty()) say("\nworst first\n");
  for (const auto& line : lines)
    say("  {:<14} {:<22} {:<22} {}{}\n", line.vessel, line.what, line.size, line.since,
        line.interval.empty() ? "" : fmt::format(" ({}), probability {}", line.interval, line.probability));
  say("\nerrors of replays, of the variation\n  {:<14}{:>6}{:>6}{:>12}{:>14}{:>10}\n", "", "days", "runs", "as given",
      "of the class", "her own");
  for (const auto& v : d.vessels)
    say("  {:<14}{:>6}{:>6}{:>10.1f} %{:>12.1f} %{:>8.1f} %\n", v.vessel, v.days, v.runs, 100.0 * v.errors.given,
        100.0 * v.errors.sisters, 100.0 * v.errors.own);
  const double much = 2.0;  // deviations
  if (std::ranges::any_of(d.shared, [&](const SharedCoefficient& c) { return std::abs(c.deviations) > much; }))
    say("\ncoefficients of the class beyond two of their deviations\n");
  for (const auto& c : d.shared)
    if (std::abs(c.deviations) > much)
      say("  {:<24}{:>12.5g} -> {:<12.5g} {:+.1f} deviations\n", c.key, c.given, c.found, c.deviations);
  for (const auto& line : d.trace) say("{}\n", line);
  for (const auto& line : d.troubles) say("{}\n", line);
}

// ---------------------------------------------------------------- ship files

/// A file name of a vessel: letters, digits, dots, hyphens and underscores.
std::string file_name_of(std::string vessel) {
  std::ranges::replace_if(
      vessel, [](unsigned char c) { return !(std::isalnum(c) || c == '-' || c == '_' || c == '.'); }, '_');
  return vessel;
}

void save_models(const std::filesystem::path& folder, const Ship& ship, const FleetDiagnosis& d) {
  std::filesystem::create_directories(folder);
  std::vector<std::string> taken;
  const auto save = [&](std::string name, const Ship& found, const std::string& remark) {
    // names that differ in what no file name has, and a vessel that is named as the class
    while (std::ranges::count(taken, name) > 0) name += "_";
    taken.push_back(name);
    const auto kept = writable(found, ship);
    write_ship(folder / (name + ".toml"), kept.ship,
               fmt::format("Made by swayaw {} from {}.\n{}", version(), ship.name, remark));
  };
  save("class", d.sisters, "What all vessels have in common.");
  for (const auto& v : d.vessels)
    save(file_name_of(v.vessel), v.today, fmt::format("{} as she is on {}.", v.vessel, date_text(v.last_day)));
}

}  // namespace

void fleet(const FleetArguments& a) {
  require_folder(a.report.file);
  const Ship ship = load_nonlinear_ship(a.ship);
  auto recordings = checked_runs(a.runs, a.reading);
  tell_propulsion(ship, recordings);
  std::vector<FleetRun> runs;
  std::vector<SetAside> aside;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const auto vessel = vessel_of(recordings[i], a.runs[i]);
    for (auto& run : sailable(ship, {std::move(recordings[i])}, aside)) runs.push_back({vessel, std::move(run)});
  }
  Progress progress("fleet");
  const Interrupt interrupt;
  FleetOptions options;
  options.progress = [&](std::size_t done, std::size_t days) {
    progress.tell(fmt::format("{} of {} days", done, days));
    progress.tell_rest(progress.seconds() * static_cast<double>(days - done) / static_cast<double>(done),
                       progress.seconds() * static_cast<double>(days - done) / static_cast<double>(done));
    return !interrupt.asked();
  };
  auto diagnosis = diagnose_fleet(ship, runs, options);
  for (const auto& trouble : diagnosis.troubles) say_aside("swayaw: {}\n", trouble);
  std::vector<std::string> unsaved;
  if (!a.save_models.empty())
    attempt(unsaved, a.save_models.string(), [&] { save_models(a.save_models, ship, diagnosis); });
  const UserUnits units(a.report.si, length(ship));
  if (a.report.wanted())
    attempt(unsaved, a.report.file.string(),
            [&] { write_page(a.report.file, html(fleet_page(diagnosis, ship.name, units))); });
  if (a.json) {
    auto document = document_of(diagnosis);
    for (const auto& [run, why] : aside) document["set_aside"].push_back({{"run", run}, {"why", why}});
    print_document(document);
  } else {
    print_fleet(ship, diagnosis, units);
    for (const auto& [run, why] : aside) say("Set aside: {}.\n", run);
  }
  if (!unsaved.empty()) throw Refusal(fmt::format("not everything was written: {}", fmt::join(unsaved, "; ")));
}

}  // namespace swayaw::app
