#include "diagnose_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "effect_words.hpp"
#include "page_writing.hpp"
#include "recorded_inputs.hpp"
#include "rose.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "trial_table.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- words

/// "wind speed 5.1 ± 0.4 kn, wind from 105 ± 6 deg (ESE)"
std::string parameter_words(const Effect& effect, const std::vector<ParameterEstimate>& parameters,
                            const UserUnits& units) {
  constexpr std::size_t most = 3;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(most, parameters.size()); ++i) {
    const auto& p = parameters[i];
    if (!std::isnan(p.value))
      words.push_back(name_of_parameter(p.key, unit_of(effect, p.key)) + " " + in_users_units(effect, p, units));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// "Steady wind: wind speed 5.1 ± 0.4 kn, wind from 105 ± 6 deg (ESE)"; of one that differs, in each group or run.
std::string effect_words(const FoundEffect& e, const Diagnosis& d, const UserUnits& units) {
  if (e.scope == Scope::ship)
    return fmt::format("{}: {}", capital(label_of(e.effect)), parameter_words(e.effect, e.parameters, units));
  constexpr std::size_t most = 3;
  const auto places = places_of(e, d);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i)
    words.push_back(fmt::format("{}, {}", places[i].scope, parameter_words(e.effect, places[i].parameters, units)));
  if (places.size() > most) words.push_back(fmt::format("and {} more below", places.size() - most));
  return fmt::format("{} that differs from {} to {}: {}", capital(label_of(e.effect)), name_of(e.scope),
                     name_of(e.scope), fmt::join(words, "; "));
}

std::string listed_effects(const Diagnosis& d, const UserUnits& units) {
  std::vector<std::string> words;
  for (const auto& e : d.effects) words.push_back(effect_words(e, d, units));
  return fmt::format("{}", fmt::join(words, "; "));
}

// ---------------------------------------------------------------- answers

std::string how_far(const Diagnosis& d) {
  if (!d.discrepancy) return "No run tells a yaw rate.";
  auto words = fmt::format("Yaw rate: {} of its variation as given, {} with coefficients moved within what is known",
                           percent_of(d.discrepancy->given), percent_of(d.discrepancy->refitted));
  if (!d.effects.empty()) words += fmt::format(", {} with what was found", percent_of(d.discrepancy->after));
  return words + ".";
}

/// ": 18 % less rudder force", where numbers of the rudder explain the runs, or are among those that are further off
/// than was said.
std::string rudder_words(const Diagnosis& d) {
  const auto& force = d.moved && d.moved->rudder_force ? d.moved->rudder_force : d.rudder_force;
  return force ? ": " + rudder_force_words(*force) : "";
}

std::string what_is_wrong(const Diagnosis& d, const UserUnits& units) {
  if (!d.effects.empty()) return listed_effects(d, units) + ".";
  if (d.verdict == DiagnosisVerdict::unexplained) return "Something real that has no name here; see where, below.";
  const auto& most = !d.shifts.empty() ? d.shifts : d.moved ? d.moved->most : d.shifts;
  if (most.empty()) return "Nothing that these runs show.";
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, most.size()); ++i)
    changes.push_back(fmt::format("{} {:.3g} → {:.3g}", most[i].key, most[i].given, most[i].refitted));
  return fmt::format("No physics, but numbers of the {} ({}){}.", in_words(most.front().part), fmt::join(changes, ", "),
                     rudder_words(d));
}

/// What a share of the missing yaw moment, or of the next force that is told, follows.
std::string_view whose(Follows follows) {
  switch (follows) {
    case Follows::form: return "the ship's own motion and rudder (her model)";
    case Follows::side: return "one side of her (her model)";
    case Follows::earth: return "the earth (wind, stream, waves)";
    case Follows::past: return "the past (memory, steering gear)";
    case Follows::instruments: return "instruments";
    case Follows::nothing: return "nothing known";
  }
  return {};
}

std::string whose_fault(const Diagnosis& d) {
  const auto moment = std::ranges::find(d.budget, "yaw_moment", &ForceBudget::quantity);
  if (moment == d.budget.end()) return "Cannot be told from these runs.";
  std::vector<std::pair<double, std::size_t>> shares;
  for (std::size_t i = 0; i < follows_count; ++i) shares.emplace_back(moment->share[i], i);
  std::ranges::sort(shares, std::greater{});
  std::vector<std::string> words;
  for (const auto& [share, i] : shares)
    if (share >= 0.1 || words.empty())
      words.push_back(fmt::format("{:.0f} ± {:.0f} % follows {}", 100.0 * share, 100.0 * moment->standard_error[i],
                                  whose(static_cast<Follows>(i))));
  return fmt::format("Of the missing yaw moment {}.", fmt::join(words, ", "));
}

/// The smallest of each of the most common effects that would have been found.
std::string what_would_show(const Diagnosis& d, const UserUnits& units) {
  std::vector<std::string> words;
  for (const auto& size : d.detectable) {
    if (words.size() == 4 || (size.effect != "steady_wind" && size.effect != "steady_current" &&
                              size.effect != "rudder_effectiveness" && size.effect != "rudder_offset"))
      continue;
    const auto unit = unit_of(make_effect(size.effect), size.key);
    words.push_back(fmt::format("{} {}", label_of(size.effect), units.in_unit(unit, size.value)));
  }
  return words.empty() ? "" : fmt::format("These runs would have shown: {}.", fmt::join(words, ", "));
}

std::string how_sure(const Diagnosis& d, std::size_t held_out, const UserUnits& units) {
  auto words = what_would_show(d, units);
  if (!words.empty()) words += " ";
  for (const auto& e : d.effects) {
    words += fmt::format("{}: probability {:.2f}", capital(label_of(e.effect)), e.probability);
    if (!e.indistinguishable_from.empty()) {
      std::vector<std::string_view> rivals;
      for (const auto& id : e.indistinguishable_from) rivals.push_back(label_of(id));
      words += fmt::format(", these runs do not tell it from {}", fmt::join(rivals, ", "));
    }
    words += ". ";
  }
  if (held_out == 0) return words + "No run was held out: give one with --holdout to prove it.";
  return words + fmt::format("{} held-out run{} took no part in any fit; see their errors in the table.", held_out,
                             held_out == 1 ? "" : "s");
}

std::string what_next(const Diagnosis& d) {
  if (d.next) {
    std::vector<std::string_view> apart;
    for (const auto& id : d.next->separates) apart.push_back(label_of(id));
    return fmt::format("{} ({}).", capital(d.next->advice), fmt::join(apart, ", "));
  }
  for (const auto& there : d.surroundings)
    if (!there.cannot_tell.empty()) return capital(there.cannot_tell) + ".";
  if (!d.effects.empty()) return "Nothing to find it: these runs tell it from all else that was tried.";
  return d.moved || !d.shifts.empty() ? "Nothing more to find this; put the numbers of the file right (--save-model)."
                                      : "Nothing: the model holds for these manoeuvres.";
}

// ---------------------------------------------------------------- headline

/// "The model leaves out a steady wind." or what else the verdict is, after how far off the model is as given.
std::string headline(const Diagnosis& d) {
  std::string words;
  if (d.discrepancy) words = fmt::format("As given, the yaw rate is off by {}. ", percent_of(d.discrepancy->given));
  const auto to = d.discrepancy ? fmt::format(" ({} left)", percent_of(d.discrepancy->after)) : "";
  if (d.verdict == DiagnosisVerdict::unexplained)
    return words + "Something real is missing that no known effect explains" + to + ".";
  if (!d.effects.empty()) {
    std::vector<std::string> names;
    for (const auto& e : d.effects) names.push_back(phrase_of(e.effect));
    return words + fmt::format("The model leaves out {}{}.", fmt::join(names, ", and "), to);
  }
  const auto left = d.discrepancy ? fmt::format(" ({} left)", percent_of(d.discrepancy->refitted)) : "";
  if (!d.shifts.empty())
    return words + fmt::format("Numbers of the {} are further off than was said{}; no physics is missing.",
                               in_words(d.shifts.front().part), left);
  if (d.moved)
    return words +
           fmt::format("Numbers of the {} explain it{}, moved within what is known of them{}; no physics is missing.",
                       in_words(d.moved->part), rudder_words(d), left);
  return words + fmt::format("Nothing is missing beyond coefficients within their confidence{}.", left);
}

Tone tone_of(const Diagnosis& d) {
  if (d.verdict == DiagnosisVerdict::nothing_missing && d.shifts.empty() && !d.moved) return Tone::good;
  return d.verdict == DiagnosisVerdict::unexplained ? Tone::bad : Tone::look;
}

// ---------------------------------------------------------------- table of the manoeuvre

const QuantityError* error_of(const std::vector<QuantityError>& errors, Quantity quantity) {
  const auto found = std::ranges::find(errors, quantity, &QuantityError::quantity);
  return found == errors.end() ? nullptr : &*found;
}

std::string share_of(const std::vector<QuantityError>& errors) {
  const auto* yaw = error_of(errors, Quantity::yaw_rate);
  if (!yaw) return "-";
  return yaw->is_in_waves() ? "in waves" : percent_of(yaw->normalised_beyond_waves());
}

std::string stem_of(const std::string& run) { return std::filesystem::path(run).stem().string(); }

void add_errors(PageTable& table, const std::vector<RunErrors>& runs, std::string_view held_out) {
  for (const auto& run : runs)
    table.rows.push_back({fmt::format("yaw-rate error, {}{}", stem_of(run.run), held_out), "-", share_of(run.before),
                          share_of(run.after), "-"});
}

/// The numbers of a manoeuvre by which ships are judged.
bool is_main_number(std::string_view name) {
  return name.starts_with("overshoot 1") || name.starts_with("overshoot 2") || name == "advance" ||
         name == "tactical diameter";
}

/// In the unit of the row: lengths in metres.
std::string limit_of(const TrialResult& trial, std::string_view row, double L) {
  for (const auto& c : trial.imo) {
    const auto name = in_words(c.name);
    const bool same = (row.starts_with("overshoot 1") && name.starts_with("first overshoot")) ||
                      (row.starts_with("overshoot 2") && name.starts_with("second overshoot")) || name == row;
    if (same) return c.unit == "L" ? with_error(c.limit * L) + " m" : fmt::format("{} {}", with_error(c.limit), c.unit);
  }
  return "-";
}

/// Her own zigzag or turn, with the rudder as the manoeuvre asks: recorded, as given, with what was found.
void add_manoeuvre(PageTable& table, const Ship& given, const Ship& after, const Recording& run) try {
  const double L = length(given);
  const auto trial = judge_trial(run, {.L = L, .max_rudder = turning_rudder(given)});
  if (!trial.zigzag && !trial.turn) return;
  const auto before = rows_of(trial, simulated_trial(given, trial), L),
             found = rows_of(trial, simulated_trial(after, trial), L);
  const auto cell = [](const std::optional<double>& x, const std::string& unit) {
    return x ? fmt::format("{} {}", with_error(*x), unit) : std::string("-");
  };
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto& row = before[i];
    if (!is_main_number(row.name) || !row.recorded) continue;
    table.rows.push_back({fmt::format("{}, {}", row.name, stem_of(run.name)),
                          fmt::format("{} {}", with_error(row.recorded->value), row.unit),
                          cell(row.simulated, row.unit), cell(found[i].simulated, row.unit),
                          limit_of(trial, row.name, L)});
  }
} catch (const std::exception&) {  // a run that is no standard manoeuvre has none of these numbers
}

PageTable table_of(const Ship& ship, const Diagnosis& d, const UserUnits& units) {
  const auto speed = only_speed(ship);
  PageTable table{
      .caption = "The manoeuvres: recorded, simulated as given, and with what was found" +
                 (speed ? "; simulated" + at_only_speed(units.speed(*speed)) : ""),
      .columns = {"", "Recorded", "As given", d.effects.empty() ? "Refitted" : "With what was found", "IMO limit"},
      .rows = {}};
  for (const auto* pictures : {&d.train_pictures, &d.holdout_pictures})
    for (const auto& p : *pictures) add_manoeuvre(table, ship, d.improved, p.recorded);
  add_errors(table, d.train, "");
  add_errors(table, d.holdout, ", held out");
  const auto has_limit = [](const std::vector<PageCell>& row) { return row.back().text != "-"; };
  if (std::ranges::none_of(table.rows, has_limit)) {
    table.columns.pop_back();
    for (auto& row : table.rows) row.pop_back();
  }
  return table;
}

// ---------------------------------------------------------------- picture

/// Fall of the yaw-rate error over two ship lengths; 0 where it is not told.
double gain_of(const RunErrors& run) {
  const auto *before = error_of(run.before, Quantity::yaw_rate), *after = error_of(run.after, Quantity::yaw_rate);
  return before && after ? before->normalised_beyond_waves() - after->normalised_beyond_waves() : 0.0;
}

/// The run that gains most; a held-out one if there is.
const RunPicture* picture_that_gains_most(const Diagnosis& d) {
  const auto& pictures = d.holdout_pictures.empty() ? d.train_pictures : d.holdout_pictures;
  const auto& errors = d.holdout_pictures.empty() ? d.train : d.holdout;
  const auto runs = std::min(pictures.size(), errors.size());
  if (runs == 0) return nullptr;
  std::size_t most = 0;
  for (std::size_t i = 1; i < runs; ++i)
    if (gain_of(errors[i]) > gain_of(errors[most])) most = i;
  return &pictures[most];
}

/// Wind in a run, that was found there or is in the ship file, for the arrow of the track.
double wind_of(const Diagnosis& d, const std::string& run) {
  for (const auto& there : d.surroundings)
    if (std::ranges::count(there.runs, run) > 0)
      for (const auto& p : there.parameters)
        if (p.key == "wind_from_rad" && !std::isnan(p.value)) return p.value;
  const auto around = surroundings_at(d.improved, 0.0);
  return around.windy ? around.wind.from : missing;
}

std::optional<PagePicture> picture_of_proof(const Ship& ship, const Diagnosis& d, const UserUnits& units) {
  const auto* p = picture_that_gains_most(d);
  if (!p || !p->given) return std::nullopt;
  const Stroke recorded{.colour = ink::heading, .width = 2.6},
      given{.colour = ink::drift, .width = 1.8, .dashed = true}, found{.colour = ink::yaw, .width = 2.2};
  const auto& after = d.effects.empty() ? p->refitted : p->after;
  const std::string name = d.effects.empty() ? "refitted" : "found";
  const bool yaw = p->recorded.has(Channel::r);
  const auto shown = yaw ? Channel::r : Channel::psi;
  Plot plot{.title = p->run, .panels = {}};
  plot.panels.push_back({.x = {.quantity = "Time", .unit = "s"},
                         .y = {.quantity = yaw ? "Yaw rate" : "Heading", .unit = yaw ? "deg/s" : "deg"},
                         .curves = {over_time(p->recorded, shown, "recorded", recorded),
                                    over_time(*p->given, shown, "as given", given)}});
  if (after) plot.panels.front().curves.push_back(over_time(*after, shown, name, found));
  if (p->recorded.has(Channel::x)) {
    std::vector tracks{track_of(p->recorded, "recorded", recorded), track_of(*p->given, "as given", given)};
    if (after) tracks.push_back(track_of(*after, name, found));
    for (auto& hull : hulls_along(p->recorded, length(ship), ink::heading)) tracks.push_back(std::move(hull));
    plot.panels.push_back(track_panel(std::move(tracks), wind_of(d, p->run)));
  }
  return picture_of(
      std::move(plot),
      fmt::format("{} over time and track of {}: recorded, simulated by the model as given, and {}.",
                  yaw ? "Yaw rate" : "Heading", p->run, name),
      fmt::format(
          "The run that gains most, simulated from the recorded start to the end with {}; the others are in the "
          "table and further down.",
          drivers(ship, p->recorded)),
      units);
}

// ---------------------------------------------------------------- what was assumed

std::vector<std::string> assumed_of(const Diagnosis& d, const DiagnoseArguments& a) {
  std::vector<std::string> lines{
      fmt::format("Ship file {}; her coefficients may be off as its [confidence] says{}.", a.ship.string(),
                  a.reference.empty() ? "" : fmt::format(", as {} reference run(s) leave it", a.reference.size()))};
  const auto measured_wind = [](const RunPicture& p) { return p.recorded.has(Channel::wind_speed); };
  lines.push_back(a.reading.ignored.wind                                 ? "The measured wind was left out, as asked."
                  : std::ranges::any_of(d.train_pictures, measured_wind) ? "The measured wind acts on the ship."
                                                                         : "No wind was measured in these runs.");
  for (const auto& words : d.assumed) lines.push_back(capital(words) + ".");
  lines.push_back(a.reading.no_check ? "Instruments were not checked, as asked."
                                     : "Instruments were checked first; ordinary errors of them are allowed for.");
  for (const auto& i : d.instruments)
    if (!i.is_effect)
      lines.push_back(fmt::format("Allowed for: {} of {}, {}{}{}.", i.error, i.channel,
                                  with_error(i.value, i.standard_error), i.unit.empty() ? "" : " ", i.unit));
  return lines;
}

}  // namespace

Page diagnosis_first_screen(const Ship& ship, const Diagnosis& d, const DiagnoseArguments& a) {
  const UserUnits units(a.report.si, length(ship));
  Page page{.kicker = "What the model leaves out",
            .title = ship.name,
            .headline = headline(d),
            .tone = tone_of(d),
            .answers = {{"How far off is my model?", how_far(d)},
                        {"What is wrong with it?", what_is_wrong(d, units)},
                        {"Whose fault is it?", whose_fault(d)},
                        {"How sure is it?", how_sure(d, d.holdout.size(), units)},
                        {"What should I sail next?", what_next(d)}},
            .picture = picture_of_proof(ship, d, units),
            .table = table_of(ship, d, units),
            .assumed = assumed_of(d, a),
            .sections = direction_sections(d, units)};
  page.sections.push_back({.title = "In one sentence", .words = {d.words}});
  std::erase_if(page.answers, [](const PageAnswer& answer) { return answer.answer.empty(); });
  return page;
}

}  // namespace swayaw::app
