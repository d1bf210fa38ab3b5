#include "swayaw/mismatch/diagnose.hpp"

#include "checked_runs.hpp"
#include "commands.hpp"
#include "diagnose_report.hpp"
#include "effect_words.hpp"
#include "input.hpp"
#include "json.hpp"
#include "progress.hpp"
#include "recorded_inputs.hpp"
#include "run_selection.hpp"
#include "sentences.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/nonlinear/writable_ship.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- JSON

Json place_json(const MismatchPlace& p) {
  return {{"run", p.run}, {"quantity", p.quantity},   {"from_s", p.from},
          {"to_s", p.to}, {"share", number(p.share)}, {"where", p.where}};
}

Json parameters_json(const std::vector<ParameterEstimate>& estimates) {
  Json parameters = Json::object();
  for (const auto& p : estimates)
    parameters[p.key] = {{"value", number(p.value)}, {"standard_error", number(p.standard_error)}};
  return parameters;
}

Json effect_json(const FoundEffect& e) {
  Json parameters = parameters_json(e.parameters);
  if (const auto* channel = channel_of(e.effect))
    parameters["channel"] = {{"value", short_name(*channel)}, {"standard_error", nullptr}};
  if (!e.depends_on.empty()) parameters["depends_on"] = {{"value", e.depends_on}, {"standard_error", nullptr}};
  Json json{{"effect", id_of(e.effect)},           {"probability", number(e.probability)},
            {"onset_s", number(e.onset)},          {"end_s", number(e.end)},
            {"parameters", std::move(parameters)}, {"indistinguishable_from", e.indistinguishable_from}};
  if (e.scope != Scope::ship) json["scope"] = name_of(e.scope);
  return json;
}

Json surroundings_json(const std::vector<SurroundingsEstimate>& surroundings) {
  Json list = Json::array();
  for (const auto& s : surroundings) {
    Json entry{{"scope", s.scope}, {"runs", s.runs}};
    entry.update(parameters_json(s.parameters));
    if (!s.cannot_tell.empty()) entry["cannot_tell"] = s.cannot_tell;
    list.push_back(std::move(entry));
  }
  return list;
}

Json errors_json(const std::vector<QuantityError>& errors) {
  Json json = Json::object();
  for (const auto& e : errors) json[std::string(name_of(e.quantity))] = number(e.normalised());
  return json;
}

Json runs_json(const std::vector<RunErrors>& runs) {
  Json list = Json::array();
  for (const auto& r : runs)
    list.push_back({{"run", r.run},
                    {"before", errors_json(r.before)},
                    {"refitted", errors_json(r.refitted)},
                    {"after", errors_json(r.after)}});
  return list;
}

Json advice_json(const std::optional<Advice>& next) {
  if (!next) return nullptr;
  return {{"advice", next->advice}, {"separates", next->separates}};
}

Json detectable_json(const std::vector<DetectableSize>& sizes) {
  Json list = Json::array();
  for (const auto& size : sizes)
    list.push_back({{"effect", size.effect}, {"parameter", size.key}, {"value", number(size.value)}});
  return list;
}

Json shifts_json(const std::vector<BaselineShift>& shifts) {
  Json list = Json::array();
  for (const auto& s : shifts)
    list.push_back({{"key", s.key},
                    {"given", number(s.given)},
                    {"refitted", number(s.refitted)},
                    {"deviations", number(s.deviations)}});
  return list;
}

Json linear_json(const std::vector<LinearView>& views) {
  Json list = Json::array();
  const auto pair = [](double recorded, double model) {
    return Json{{"recorded", number(recorded)}, {"model", number(model)}};
  };
  for (const auto& v : views)
    list.push_back({{"run", v.run},
                    {"K", pair(v.recorded.K, v.model.K)},
                    {"T", pair(v.recorded.T, v.model.T)},
                    {"rudder_offset_rad", pair(v.recorded.delta_r, v.model.delta_r)},
                    {"loop_area", pair(v.recorded.loop_area, v.model.loop_area)}});
  return list;
}

Json instruments_json(const std::vector<InstrumentEstimate>& instruments) {
  Json list = Json::array();
  for (const auto& i : instruments)
    list.push_back({{"channel", i.channel},
                    {"error", i.error},
                    {"scope", "all"},
                    {"value", number(i.value)},
                    {"standard_error", number(i.standard_error)},
                    {"unit", i.unit}});
  return list;
}

/// {"yaw_moment": {"form": 0.55, …, "size": 0.12, "standard_error": {"form": 0.06, …}}, …}
Json budget_json(const std::vector<ForceBudget>& budget) {
  Json json = Json::object();
  for (const auto& b : budget) {
    Json shares = Json::object(), errors = Json::object();
    for (std::size_t i = 0; i < follows_count; ++i) {
      const std::string name(name_of(static_cast<Follows>(i)));
      shares[name] = number(b.share[i]), errors[name] = number(b.standard_error[i]);
    }
    shares["size"] = number(b.size);
    shares["standard_error"] = std::move(errors);
    json[b.quantity] = std::move(shares);
  }
  return json;
}

Json discrepancy_json(const std::optional<Discrepancy>& d) {
  if (!d) return nullptr;
  return {{"given", number(d->given)}, {"refitted", number(d->refitted)}, {"after", number(d->after)}};
}

Json document_of(const Diagnosis& d) {
  Json location = Json::array(), effects = Json::array(), candidates = Json::array();
  for (const auto& p : d.location) location.push_back(place_json(p));
  for (const auto& e : d.effects) effects.push_back(effect_json(e));
  for (const auto& c : d.candidates)
    candidates.push_back({{"effect", c.effect},
                          {"probability", number(c.probability)},
                          {"log_evidence_gain", number(c.log_evidence_gain)},
                          {"holdout_log_likelihood_gain", number(c.holdout_log_likelihood_gain)},
                          {"holdout_gain", number(c.holdout_gain)},
                          {"trace", c.trace},
                          {"too_large", c.too_large},
                          {"as_form", c.as_form},
                          {"refuted", c.refuted}});
  return {{"schema", "swayaw.diagnosis/2"},
          {"version", version()},
          {"verdict", name_of(d.verdict)},
          {"words", d.words},
          {"location", std::move(location)},
          {"effects", std::move(effects)},
          {"candidates", std::move(candidates)},
          {"doubt", number(d.prior_inflation)},
          {"imperfection", {{"refitted", number(d.refitted_process_noise)}, {"after", number(d.process_noise)}}},
          {"symmetry", d.symmetry},
          {"traces", d.traces},
          {"as_form", d.as_form},
          {"too_large", d.too_large},
          {"baseline_shift", shifts_json(d.shifts)},
          {"budget", budget_json(d.budget)},
          {"instruments", instruments_json(d.instruments)},
          {"surroundings", surroundings_json(d.surroundings)},
          {"discrepancy", discrepancy_json(d.discrepancy)},
          {"linear", linear_json(d.linear)},
          {"linear_words", words_of(d.linear)},
          {"fit", {{"train", runs_json(d.train)}, {"holdout", runs_json(d.holdout)}}},
          {"next_manoeuvre", advice_json(d.next)},
          {"detectable", detectable_json(d.detectable)},
          {"assumed", d.assumed},
          {"set_aside", Json::array()},
          {"not_written", Json::array()},
          {"troubles", d.troubles}};
}

// ---------------------------------------------------------------- text

/// A row of each quantity of each run; "in waves" where the error is no more than they add to what was recorded.
void print_runs(std::string_view title, const std::vector<RunErrors>& runs) {
  if (runs.empty()) return;
  bool any_in_waves = false;
  const auto words = [&](const QuantityError& e) {
    any_in_waves = any_in_waves || e.is_in_waves();
    return e.is_in_waves() ? "in waves" : fmt::format("{:.1f} %", 100.0 * e.normalised_beyond_waves());
  };
  say("\n{}: error of replays over two ship lengths, of the variation\n", title);
  say("  {:<30}{:<12}{:>10}{:>10}{:>14}\n", "run", "quantity", "as given", "refitted", "with effects");
  for (const auto& run : runs)
    for (std::size_t i = 0; i < run.before.size() && i < run.refitted.size() && i < run.after.size(); ++i)
      say("  {:<30}{:<12}{:>10}{:>10}{:>14}\n", i == 0 ? run.run : "", in_words(name_of(run.before[i].quantity)),
          words(run.before[i]), words(run.refitted[i]), words(run.after[i]));
  if (any_in_waves) say("  in waves: no more than waves add to what was recorded\n");
}

/// The force that is missing by what it follows, in per cent of its mean square; a row of each.
void print_budget(const std::vector<ForceBudget>& budget) {
  if (budget.empty()) return;
  say("\nforce that the model as given lacks, by what it follows, % of its mean square\n  {:<20}", "");
  for (const auto& b : budget) say("{:>18}", in_words(b.quantity));
  for (std::size_t i = 0; i < follows_count; ++i) {
    say("\n  {:<20}", in_words(name_of(static_cast<Follows>(i))));
    for (const auto& b : budget)
      say("{:>11.0f} ± {:<4.0f}", std::round(100.0 * b.share[i]) + 0.0, 100.0 * b.standard_error[i]);
  }
  say("\n  {:<20}", "over force on hull");
  for (const auto& b : budget) say("{:>18.2g}", b.size);
  say("\n");
}

void print_parameters(const Effect& effect, const std::vector<ParameterEstimate>& parameters, const UserUnits& units) {
  for (const auto& p : parameters)
    if (!std::isnan(p.value))
      say("  {:<26}{}\n", name_of_parameter(p.key, unit_of(effect, p.key)), in_users_units(effect, p, units));
}

/// The wind or stream that a place has.
Effect effect_of(const SurroundingsEstimate& there) {
  const bool wind = !there.parameters.empty() && there.parameters.front().key.starts_with("wind");
  return make_effect(wind ? SteadyWind<>::id : SteadyCurrent<>::id);
}

void print_surroundings(const std::vector<SurroundingsEstimate>& surroundings, const UserUnits& units) {
  for (const auto& there : surroundings) {
    say("\nsurroundings of {}\n", there.scope == "all" ? "all runs" : there.scope);
    print_parameters(effect_of(there), there.parameters, units);
    if (!there.cannot_tell.empty()) say("  {}\n", there.cannot_tell);
  }
}

void print_effects(const std::vector<FoundEffect>& effects, const UserUnits& units) {
  for (const auto& e : effects) {
    say("\n{} ({}), probability {:.3f}\n", label_of(e.effect), id_of(e.effect), e.probability);
    if (e.scope == Scope::ship) print_parameters(e.effect, e.parameters, units);
    else say("  differs from {0} to {0}; see the surroundings of each\n", name_of(e.scope));
    if (!e.indistinguishable_from.empty())
      say("  as well explained by {}\n", fmt::join(e.indistinguishable_from, ", "));
  }
}

void print_places(const Diagnosis& d) {
  if (!d.location.empty()) say("\nwhere force is missing\n");
  for (const auto& p : d.location)
    say("  {}: {} from {:.5g} to {:.5g} s, {:.0f} % of it\n    {}\n", p.run, in_words(p.quantity), p.from, p.to,
        100.0 * p.share, p.where);
  if (!d.symmetry.empty()) say("  {}\n", d.symmetry);
}

/// The first of each effect: the smallest size that these runs would have shown.
void print_detectable(const std::vector<DetectableSize>& sizes, const UserUnits& units) {
  if (!sizes.empty()) say("\nsmallest effects that these runs would have shown\n");
  for (const auto& x : sizes) {
    const auto effect = make_effect(x.effect);
    say("  {:<32}{:<22}{}\n", label_of(x.effect), name_of_parameter(x.key, unit_of(effect, x.key)),
        in_users_units(effect, {x.key, x.value, 0.0}, units));
  }
}

void print_candidates(const std::vector<Candidate>& candidates) {
  say("\ncandidates{:>26}{:>13}\n", "gain", "probability");
  constexpr double least = 5e-4;  // probability, that rounds to more than nothing
  for (const auto& c : candidates) {
    if (!(c.log_evidence_gain > 0.0 || c.probability >= least)) continue;
    say("  {:<24}{:>10.1f}{:>13.3f}{}\n", c.effect, c.log_evidence_gain, c.probability,
        c.as_form     ? "  may be the form of her forces"
        : c.too_large ? "  larger than it can be"
        : c.trace     ? "  too small, or not told"
                      : "");
  }
}

void print_diagnosis(const Ship& ship, const Diagnosis& d, const Json& document, const UserUnits& units) {
  say("{}\n", ship.name);
  say("{}\n", d.words);
  for (const auto& run : document["set_aside"]) say("Set aside: {}.\n", run["run"].get<std::string>());
  print_budget(d.budget);
  print_effects(d.effects, units);
  print_surroundings(d.surroundings, units);
  const auto allowed_for = [](const InstrumentEstimate& i) { return !i.is_effect; };
  if (std::ranges::any_of(d.instruments, allowed_for)) say("\ninstruments, allowed for\n");
  for (const auto& i : d.instruments)
    if (allowed_for(i)) say("  {:<10}{:<14}{} {}\n", i.channel, i.error, with_error(i.value, i.standard_error), i.unit);
  print_places(d);
  if (const auto words = words_of(d.linear); !words.empty()) say("\n{}\n", words);
  if (!d.shifts.empty()) say("\nnumbers of the model beyond two of their deviations\n");
  for (const auto& s : d.shifts)
    say("  {:<24}{:>12.5g} -> {:<12.5g} {:+.1f} deviations\n", s.key, s.given, s.refitted, s.deviations);
  if (d.next) {
    say("\nwhat to sail next\n");
    say("  {}\n", d.next->advice);
    say("  it separates {}\n", fmt::join(d.next->separates, ", "));
  }
  print_detectable(d.detectable, units);
  print_candidates(d.candidates);
  print_runs("runs used", d.train);
  print_runs("runs held out", d.holdout);
  for (const auto& line : document["not_written"]) say("{}\n", line.get<std::string>());
  for (const auto* lines : {&d.assumed, &d.troubles})
    for (const auto& line : *lines) say("{}\n", capital(line));
}

// ---------------------------------------------------------------- how long it takes

/// What the search says when it has fitted the baseline and begins its first round of effects.
constexpr std::string_view first_round = "trying every effect";

/// A round of effects takes so many times as long as the fit of the baseline, 20.3 s over 3.9 s with two zigzags of the
/// KVLCC2 model (SIMMAN 2008) on two cores.
constexpr double round_over_baseline = 5.2;

/// Three rounds at most, and as many with surge, sway and yaw apart.
constexpr double most_rounds = 6.0;

// ---------------------------------------------------------------- the ship file

void save_model(const std::filesystem::path& file, const Ship& ship, const WritableShip& improved, const Diagnosis& d) {
  auto remark = fmt::format("Made by swayaw {} from {}.\n{}", version(), ship.name, d.words);
  for (const auto& line : improved.changed) remark += "\n" + line + ".";
  write_ship(file, improved.ship, remark);
}

}  // namespace

void diagnose(const DiagnoseArguments& a) {
  require_folder(a.report.file);
  const Ship ship = load_nonlinear_ship(a.ship);
  Progress progress("diagnose");
  const Interrupt interrupt;
  DiagnosisOptions options;
  options.pictures = a.report.wanted();
  options.progress = [&](std::string_view what) {
    if (what == first_round)
      progress.tell_rest(round_over_baseline * progress.seconds(),
                         most_rounds * round_over_baseline * progress.seconds());
    progress.tell(what);
    return !interrupt.asked();
  };
  std::vector<SetAside> aside;
  const auto runs = sailable(ship, checked_runs(a.runs, a.reading), aside);
  require_some(runs, aside);
  const auto reference = sailable(ship, checked_runs(a.reference, a.reading), aside),
             holdout = sailable(ship, checked_runs(a.holdout, a.reading), aside);
  for (const auto& some : {runs, reference, holdout}) tell_in_vain(ship, some);
  auto diagnosis = swayaw::diagnose(ship, runs, reference, holdout, options);
  for (const auto& words : diagnosis.assumed) say_aside("swayaw: {}\n", words);
  for (const auto& trouble : diagnosis.troubles) say_aside("swayaw: {}\n", trouble);
  const auto kept = writable(diagnosis.improved, ship);
  std::vector<std::string> unsaved;
  if (!a.save_model.empty())
    attempt(unsaved, a.save_model.string(), [&] { save_model(a.save_model, ship, kept, diagnosis); });
  Json document = document_of(diagnosis);
  for (const auto& [run, why] : aside) document["set_aside"].push_back({{"run", run}, {"why", why}});
  document["not_written"] = kept.changed;
  if (a.report.wanted())
    attempt(unsaved, a.report.file.string(),
            [&] { write_diagnosis_report(document, ship, diagnosis, options.detection, a); });
  if (a.json) print_document(document);
  else print_diagnosis(ship, diagnosis, document, UserUnits(a.report.si, length(ship)));
  if (!unsaved.empty()) throw Refusal(fmt::format("not everything was written: {}", fmt::join(unsaved, "; ")));
}

}  // namespace swayaw::app
