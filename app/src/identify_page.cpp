#include "identify_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

/// How many names a sentence holds, and how many runs.
constexpr std::size_t most_names = 8, most_runs = 4;

// ---------------------------------------------------------------- coefficients

struct Trust {
  std::string words;
  Tone tone;
};

/// What its standard error allows to say; errors of the model are not in it.
Trust trust_in(const Found& f) {
  if (f.undetermined || f.estimate.verdict() == Verdict::not_determined) return {"not determined", Tone::bad};
  if (f.estimate.verdict() == Verdict::weakly_determined) return {"weak", Tone::look};
  return {"determined", Tone::good};
}

std::vector<std::string> with_trust(const std::vector<Found>& found, Tone tone) {
  std::vector<std::string> names;
  for (const auto& f : found)
    if (trust_in(f).tone == tone) names.push_back(f.before.name);
  return names;
}

std::string trusted_words(const Answer& answer) {
  const auto good = with_trust(answer.found, Tone::good), weak = with_trust(answer.found, Tone::look);
  std::string words =
      good.empty() ? "None to better than 10 %." : listed(good, most_names) + ", each to 10 % or better.";
  if (!weak.empty()) words += fmt::format(" By its sign only: {}.", listed(weak, most_names));
  if (answer.lacks_something)
    words += " That counts scatter alone; what the model lacks bends them, and swayaw diagnose names it.";
  return words;
}

std::string open_words(const Answer& answer) {
  const auto open = with_trust(answer.found, Tone::bad);
  if (open.empty()) return "None: every one is determined.";
  const auto advice = answer.advice.empty() ? "" : " " + capital(answer.advice.back()) + ".";
  return listed(open, most_names) + "." + advice;
}

// ---------------------------------------------------------------- prediction

std::string held_out_words(const Predictions& predictions) {
  if (predictions.holdout.empty()) return "Not told: no run was held out (--holdout RUN).";
  const auto errors = together(predictions.holdout);
  if (!errors) return "Not told: the held-out runs could not be replayed.";
  if (!errors->lost.empty()) return fmt::format("No: she cannot sail {} any more.", listed(errors->lost, most_runs));
  return fmt::format("{}: over two ship lengths she is off by {} of the variation, {} before, in {}.",
                     errors->worse() ? "No, worse than before" : "Yes", percent_of(errors->after),
                     percent_of(errors->before), counted(predictions.holdout.size(), "held-out run"));
}

std::string headline_of(const Answer& answer, const Predictions& predictions) {
  const bool held_out = !predictions.holdout.empty();
  const auto errors = together(held_out ? predictions.holdout : predictions.train);
  const auto which = held_out ? "Runs that were not used" : "The runs used";
  std::string words;
  if (!errors) words = fmt::format("{} cannot be replayed. ", which);
  else if (!errors->lost.empty())
    words = fmt::format("With the coefficients found she cannot sail {}. ", listed(errors->lost, most_runs));
  else
    words =
        fmt::format("{} are predicted {} over two ship lengths: the error goes from {} to {} of the variation. ", which,
                    errors->worse() ? "worse" : "better", percent_of(errors->before), percent_of(errors->after));
  words += fmt::format(
      "{} of {} coefficients {}.", with_trust(answer.found, Tone::good).size(), answer.found.size(),
      answer.lacks_something ? "are determined, but the model lacks something, which bends them" : "can be trusted");
  return words + (held_out ? "" : " No run was held out.");
}

Tone tone_of(const Answer& answer, const Predictions& predictions) {
  const auto errors = together(predictions.holdout.empty() ? predictions.train : predictions.holdout);
  if (!errors || errors->worse()) return Tone::bad;
  const bool sure = !answer.lacks_something && with_trust(answer.found, Tone::good).size() == answer.found.size();
  return sure && !predictions.holdout.empty() ? Tone::good : Tone::look;
}

// ---------------------------------------------------------------- tables

/// In the unit of the ship file; digits as the error allows.
std::string in_file_unit(const Parameter& p, double value, double error = 0.0) {
  const auto number = with_error(value / p.si, error / p.si);
  return p.unit == "-" || p.unit.empty() ? number : fmt::format("{} {}", number, p.unit);
}

PageTable coefficients_of(const Answer& answer) {
  PageTable table{
      .caption = "Coefficients", .columns = {"", "Before", "Found ± std error", "Change", "Verdict"}, .rows = {}};
  for (const auto& f : answer.found) {
    const auto [words, tone] = trust_in(f);
    const double change = tone == Tone::bad ? missing : f.estimate.value / f.before.value - 1.0;
    const auto error = std::isfinite(f.estimate.standard_error) ? f.estimate.standard_error : 0.0;
    table.rows.push_back({f.before.name,
                          in_file_unit(f.before, f.before.value),
                          in_file_unit(f.before, f.estimate.value, error),
                          std::isfinite(change) ? fmt::format("{:+.0f} %", 100.0 * change) : "-",
                          {words, tone}});
  }
  return table;
}

std::string share_in(const std::optional<std::vector<ErrorShare>>& shares, Quantity quantity) {
  if (!shares) return "lost";
  const auto found = std::ranges::find(*shares, quantity, &ErrorShare::quantity);
  return found == shares->end() ? "-" : percent_of(found->share);
}

PageTable errors_table(const std::vector<Prediction>& predictions, std::string caption) {
  PageTable table{.caption = std::move(caption), .columns = {"Run"}, .rows = {}};
  constexpr std::array quantities{Quantity::heading, Quantity::yaw_rate, Quantity::speed, Quantity::drift};
  for (const auto q : quantities) table.columns.push_back(capital(in_words(name_of(q))));
  for (const auto& p : predictions) {
    std::vector<PageCell> row{p.run};
    for (const auto q : quantities)
      row.emplace_back(fmt::format("{} → {}", share_in(p.before, q), share_in(p.after, q)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string angles_of(const std::optional<std::vector<double>>& angles, const UserUnits& units) {
  if (!angles) return "cannot sail it";
  std::vector<std::string> words;
  for (const double angle : *angles) words.push_back(units.angle(angle));
  return words.empty() ? "-" : listed(words);
}

PageTable zigzags_table(const Answer& answer, const UserUnits& units) {
  PageTable table{.caption = "Overshoots of zigzags", .columns = {"Run", "Recorded", "Before", "Found"}, .rows = {}};
  for (const auto& z : answer.zigzags)
    table.rows.push_back({z.run, angles_of(z.recorded, units), angles_of(z.before, units), angles_of(z.after, units)});
  return table;
}

// ---------------------------------------------------------------- picture

double worst_share(const Prediction& p) {
  if (!p.after || p.after->empty()) return p.after ? 0.0 : HUGE_VAL;
  return std::ranges::max(*p.after, {}, &ErrorShare::share).share;
}

/// The replay of a ship, never restarted; nothing where she cannot sail it.
std::optional<Comparison> replay_of(const Ship& ship, const Recording& run) {
  try {
    return compare(ship, run);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// Simulated less recorded heading.
Curve heading_error(const Comparison& c, const Stroke& stroke) {
  Curve curve{.name = {}, .x = c.recorded.time, .y = {}, .stroke = stroke};
  for (const double error : errors_of(c.open_loop, c.recorded, Quantity::heading)) curve.y.push_back(degrees(error));
  return curve;
}

/// A run never restarted with the ship before and the one found.
struct Replays {
  const Recording& run;
  std::optional<Comparison> before, found;
};

/// Heading over time, and how far it is off.
Plot headings_of(const Replays& r) {
  const Axis time{.quantity = "Time", .unit = "s"};
  Panel heading{.x = time,
                .y = {.quantity = "Heading", .unit = "deg"},
                .curves = {over_time(r.run, Channel::psi, "recorded", {.colour = ink::heading, .width = 2.6})}};
  Panel error{.x = time, .y = {.quantity = "Its error", .unit = "deg"}, .curves = {}};
  const auto add = [&](const std::optional<Comparison>& replay, const char* name, const Stroke& stroke) {
    if (!replay) return;
    heading.curves.push_back(over_time(replay->open_loop, Channel::psi, name, stroke));
    error.curves.push_back(heading_error(*replay, stroke));
  };
  add(r.before, "before", {.colour = ink::drift, .width = 1.8, .dashed = true});
  add(r.found, "found", {.colour = ink::yaw, .width = 2.0, .dashed = true});
  Plot plot{.title = r.run.name, .panels = {std::move(heading)}};
  if (!error.curves.empty()) plot.panels.push_back(std::move(error));
  return plot;
}

/// "by 12.1 deg", of the heading over the whole run.
std::string off_by(const std::optional<Comparison>& replay, const UserUnits& units) {
  if (!replay) return "so far that she cannot sail it";
  const auto e = std::ranges::find(replay->errors, Quantity::heading, &QuantityError::quantity);
  return e == replay->errors.end() ? "by what is not told" : "by " + units.angle(e->open_loop_rms);
}

PagePicture picture_of_worst(const Question& q, const Answer& answer, const Predictions& predictions,
                             const UserUnits& units) {
  const bool held_out = !q.holdout.empty();
  const auto& list = held_out ? predictions.holdout : predictions.train;
  const auto worst = std::ranges::max_element(list, {}, worst_share) - list.begin();
  const auto& run = (held_out ? q.holdout : q.runs)[static_cast<std::size_t>(worst)];
  const Replays replays{run, replay_of(q.ship, run), replay_of(answer.ship, run)};
  return picture_of(
      headings_of(replays),
      fmt::format("Heading of {} over time: recorded, with the ship before and with the ship found.", run.name),
      fmt::format("The {} that is predicted worst. Simulated from start to end with the recorded rudder and never "
                  "restarted, the heading was off {} before and is off {} now.",
                  held_out ? "held-out run" : "run", off_by(replays.before, units), off_by(replays.found, units)),
      units);
}

// ---------------------------------------------------------------- assumed

std::string fitted_words(const Answer& answer, std::size_t runs) {
  return fmt::format("{} in {}: {}.", counted(answer.found.size(), "coefficient"), counted(runs, "run"), answer.reason);
}

std::vector<std::string> assumed_of(const Question& q, const IdentifyArguments& a) {
  std::vector<std::string> lines{
      fmt::format("Ship file {}, in the model {}. What was not looked for stays as it is there.", a.ship.string(),
                  a.model),
      a.prior ? "The ship's own values, with her confidence, count as measurements."
              : "Nothing is known of the coefficients beforehand.",
      a.reading.no_check ? "Instruments were not checked, as asked." : "Instruments were checked first (swayaw check).",
      "Standard errors hold if the model is right; what it lacks is not in them."};
  for (const auto* runs : {&q.runs, &q.holdout})
    if (const auto words = assumed_propulsion(q.ship, *runs); !words.empty()) lines.push_back(capital(words) + ".");
  for (const auto& [run, why] : q.aside) lines.push_back(fmt::format("Set aside: {}, {}.", run, why));
  return lines;
}

std::vector<PageSection> sections_of(const Answer& answer, const Predictions& predictions, const UserUnits& units) {
  PageSection errors{
      .title = "How runs are predicted",
      .words = {"Simulated over two ship lengths from the recorded state, again and again: error over the "
                "variation of the quantity, before → found."}};
  if (!predictions.holdout.empty()) errors.tables.push_back(errors_table(predictions.holdout, "Runs held out"));
  errors.tables.push_back(errors_table(predictions.train, "Runs used"));
  if (!answer.zigzags.empty()) errors.tables.push_back(zigzags_table(answer, units));
  PageSection course{.title = "Straight course, and what to record next",
                     .words = {capital(answer.stability.words) + "."}};
  for (const auto* lines : {&answer.advice, &answer.troubles})
    for (const auto& line : *lines) course.words.push_back(capital(line) + ".");
  return {std::move(errors), std::move(course)};
}

}  // namespace

Page identify_page(const Question& q, const Answer& answer, const Predictions& predictions,
                   const IdentifyArguments& a) {
  const UserUnits units(a.report.si, length(q.ship));
  Page page{.kicker = "Coefficients from recordings",
            .title = q.ship.name,
            .headline = headline_of(answer, predictions),
            .tone = tone_of(answer, predictions)};
  page.answers = {{"Which coefficients can I trust?", trusted_words(answer)},
                  {"Which not?", open_words(answer)},
                  {"Does she predict runs that were not used?", held_out_words(predictions)},
                  {"What was fitted?", fitted_words(answer, q.runs.size())}};
  page.picture = picture_of_worst(q, answer, predictions, units);
  page.table = coefficients_of(answer);
  page.assumed = assumed_of(q, a);
  page.sections = sections_of(answer, predictions, units);
  page.footnotes = {made_by()};
  return page;
}

}  // namespace swayaw::app
