#include "tune_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "terminal.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

/// An index agrees within so many of its standard deviations.
constexpr double agreement = 2.0;

constexpr std::size_t most_names = 6;

// ---------------------------------------------------------------- indices

/// Endings of the keys and their units, the longest first.
constexpr std::array<std::array<std::string_view, 2>, 9> endings{{{"_rad_s", "rad/s"},
                                                                  {"_deg_s", "rad/s"},
                                                                  {"_m_s", "m/s"},
                                                                  {"_kn", "m/s"},
                                                                  {"_deg", "rad"},
                                                                  {"_rad", "rad"},
                                                                  {"_L", "m"},
                                                                  {"_m", "m"},
                                                                  {"_s", "s"}}};

/// "final yaw rate" in "rad/s" of "final_yaw_rate_rad_s"; "second overshoot" of "overshoot_deg 2".
struct IndexWords {
  std::string name, unit;
};

std::string name_of_key(const std::string& key) {
  if (key == "final_u") return "final speed ahead";
  if (key == "final_v") return "final sway";
  return in_words(key);
}

IndexWords words_for(const MeasuredIndex& index) {
  const auto blank = index.name.find(' ');
  std::string key = index.name.substr(0, blank), unit;
  for (const auto& [ending, si] : endings) {
    if (!key.ends_with(ending)) continue;
    key.resize(key.size() - ending.size());
    unit = si;
    break;
  }
  const auto place = blank == std::string::npos ? "" : ordinal(std::stoul(index.name.substr(blank))) + " ";
  return {place + name_of_key(std::move(key)), std::move(unit)};
}

/// Ways in ship lengths, as they are compared; metres in SI.
class IndexUnits {
 public:
  IndexUnits(const UserUnits& units, double L) : units_(units), L_(L) {}

  std::string operator()(const IndexWords& index, double value, double error = 0.0) const {
    if (!std::isfinite(value)) return "-";
    if (index.unit == "m" && !units_.si()) return with_error(value / L_, error / L_) + " L";
    return units_.in_unit(index.unit, value, error);
  }

 private:
  const UserUnits& units_;
  double L_;
};

double relative(double value, const TunedIndex& i) { return value / i.measured.value - 1.0; }

bool agrees(double value, const TunedIndex& i) {
  return std::abs(value - i.measured.value) <= agreement * i.measured.deviation;
}

std::size_t agreeing(const Tuning& t, double TunedIndex::*when) {
  return static_cast<std::size_t>(std::ranges::count_if(t.indices, [&](const auto& i) { return agrees(i.*when, i); }));
}

/// Root mean square of the relative errors. An index that does not exist is wrong altogether.
double mean_error(const Tuning& t, double TunedIndex::*when) {
  double sum = 0.0;
  for (const auto& i : t.indices) sum += std::isfinite(i.*when) ? std::pow(relative(i.*when, i), 2) : 1.0;
  return std::sqrt(sum / static_cast<double>(t.indices.size()));
}

/// How far an index is off now, in its standard deviations.
double distance(const TunedIndex& i) {
  return std::isfinite(i.after) ? std::abs(i.after - i.measured.value) / i.measured.deviation : HUGE_VAL;
}

std::string name_in(const MeasuredIndices& measured, const TunedIndex& i) {
  return fmt::format("{} ({})", words_for(i.measured).name, name_of(measured.trials[i.trial].manoeuvre));
}

// ---------------------------------------------------------------- parameters

double change_of(const TunedParameter& p) { return p.value / p.number.value - 1.0; }

bool beyond_prior(const TunedParameter& p) { return std::abs(change_of(p)) > p.prior; }

/// What speaks against a change.
std::string doubt_about(const TunedParameter& p) {
  if (p.at_bound) return "at its bound";
  if (beyond_prior(p)) return "beyond its prior";
  return p.determined() ? "" : "not told by the indices";
}

Tone tone_of(const TunedParameter& p) {
  if (p.at_bound || beyond_prior(p)) return Tone::bad;
  return p.determined() ? Tone::good : Tone::look;
}

std::vector<std::string> names_with(const Tuning& t, Tone tone) {
  std::vector<std::string> names;
  for (const auto& p : t.parameters)
    if (tone_of(p) == tone) names.push_back(p.number.name);
  return names;
}

/// The largest changes first.
std::vector<TunedParameter> by_change(const Tuning& t) {
  auto sorted = t.parameters;
  std::ranges::stable_sort(sorted, std::greater{}, [](const auto& p) { return std::abs(change_of(p)); });
  return sorted;
}

std::string change_words(const TunedParameter& p) { return fmt::format("{:+.0f} %", 100.0 * change_of(p)); }

// ---------------------------------------------------------------- headline and answers

std::string headline_of(const Tuning& t) {
  const auto held = names_with(t, Tone::bad).size();
  return fmt::format("On average the indices are off by {}, {} before tuning; {} of {} agree now, {} before.{}",
                     percent_of(mean_error(t, &TunedIndex::after)), percent_of(mean_error(t, &TunedIndex::before)),
                     agreeing(t, &TunedIndex::after), t.indices.size(), agreeing(t, &TunedIndex::before),
                     held == 0 ? ""
                               : fmt::format(" {} went to the bound or beyond {} prior.", counted(held, "coefficient"),
                                             held == 1 ? "its" : "their"));
}

Tone tone_of(const Tuning& t) {
  if (mean_error(t, &TunedIndex::after) >= mean_error(t, &TunedIndex::before)) return Tone::bad;
  const bool agree = agreeing(t, &TunedIndex::after) == t.indices.size();
  return agree && names_with(t, Tone::bad).empty() ? Tone::good : Tone::look;
}

std::string turns_words(const Tuning& t) {
  const auto agree = agreeing(t, &TunedIndex::after);
  return fmt::format("{}: {} of {} indices lie within two standard deviations of what was measured.",
                     agree == t.indices.size() ? "Yes"
                     : agree == 0              ? "No"
                                               : "In part",
                     agree, t.indices.size());
}

std::string believable_words(const Tuning& t) {
  std::vector<std::string> most;
  for (const auto& p : by_change(t)) most.push_back(fmt::format("{} {}", p.number.name, change_words(p)));
  const auto bad = names_with(t, Tone::bad), open = names_with(t, Tone::look);
  auto words =
      "Most: " + listed(std::vector(most.begin(), most.begin() + std::min<std::ptrdiff_t>(3, std::ssize(most)))) + ".";
  if (!bad.empty())
    words += fmt::format(" Not believable, at the bound or beyond the prior: {}.", listed(bad, most_names));
  if (!open.empty()) words += fmt::format(" Not told by the indices: {}.", listed(open, most_names));
  return words + (bad.empty() && open.empty() ? " All are told by the indices and within their priors." : "");
}

std::string misfit_words(const MeasuredIndices& measured, const Tuning& t, const IndexUnits& units) {
  const auto& worst = *std::ranges::max_element(t.indices, {}, distance);
  const auto name = words_for(worst.measured);
  if (agrees(worst.after, worst)) return "None: all agree within two standard deviations.";
  return fmt::format(
      "Worst the {}: {} instead of {}.{}", name_in(measured, worst), units(name, worst.after),
      units(name, worst.measured.value),
      t.indices.size() - agreeing(t, &TunedIndex::after) > 1
          ? fmt::format(" {} others do not agree either.", t.indices.size() - agreeing(t, &TunedIndex::after) - 1)
          : "");
}

// ---------------------------------------------------------------- tables

PageTable indices_table(const MeasuredIndices& measured, const Tuning& t, const IndexUnits& units) {
  PageTable table{.caption = "Indices", .columns = {"Index", "Measured ± sd", "Before", "After", "Error"}, .rows = {}};
  std::size_t trial = measured.trials.size();
  for (const auto& i : t.indices) {
    if (std::exchange(trial, i.trial) != i.trial)
      table.rows.push_back({capital(name_of(measured.trials[i.trial].manoeuvre)), "", "", "", ""});
    const auto name = words_for(i.measured);
    const bool exists = std::isfinite(i.after);
    table.rows.push_back({capital(name.name),
                          units(name, i.measured.value, i.measured.deviation),
                          units(name, i.before),
                          units(name, i.after),
                          {exists ? fmt::format("{:+.1f} %", 100.0 * relative(i.after, i)) : "not reached",
                           agrees(i.after, i) ? Tone::good : Tone::bad}});
  }
  return table;
}

PageTable coefficients_table(const Tuning& t) {
  PageTable table{.caption = "Coefficients that were changed, the most first",
                  .columns = {"Coefficient", "Before", "After", "Change", "Allowed by the prior", "Verdict"},
                  .rows = {}};
  for (const auto& p : by_change(t)) {
    const auto doubt = doubt_about(p);
    table.rows.push_back({p.number.name,
                          with_error(p.number.value / p.number.si),
                          with_error(p.value / p.number.si),
                          change_words(p),
                          std::isfinite(p.prior) ? "± " + percent_of(p.prior) : "anything",
                          {doubt.empty() ? "told" : doubt, tone_of(p)}});
  }
  return table;
}

// ---------------------------------------------------------------- picture

constexpr Stroke measured_stroke{.colour = ink::heading, .width = 1.6},
    before_stroke{.colour = ink::drift, .width = 1.8}, after_stroke{.colour = ink::yaw, .width = 2.2};

ManoeuvreOptions options_of(const MeasuredIndices& m) { return {.speed = m.speed, .rev = m.rev, .thrust = m.thrust}; }

/// What was measured of a manoeuvre under a key; nothing if it was not.
std::vector<double> measured_of(const MeasuredTrial& trial, std::string_view name) {
  std::vector<double> values;
  for (const auto& i : trial.indices)
    if (words_for(i).name.starts_with(name)) values.push_back(i.value);
  return values;
}

Curve level(double value, double from, double to, const char* name) {
  return {.name = name, .x = {from, to}, .y = {value, value}, .stroke = measured_stroke};
}

Curve upright(double value, double from, double to, const char* name) {
  return {.name = name, .x = {value, value}, .y = {from, to}, .stroke = measured_stroke};
}

/// Tracks before and after, and where advance and tactical diameter were measured.
Panel circle_of(const Ship& before, const MeasuredIndices& m, const MeasuredTrial& trial, const TurnOrder& order,
                const Ship& after) {
  std::vector tracks{track_of(turning_circle(before, order, options_of(m)).run, "before", before_stroke),
                     track_of(turning_circle(after, order, options_of(m)).run, "after", after_stroke)};
  const double side = order.side == Side::port ? -1.0 : 1.0;
  const auto [low, high] = std::ranges::minmax(tracks.front().y);
  const auto [west, east] = std::ranges::minmax(tracks.front().x);
  const auto advance = measured_of(trial, "advance"), diameter = measured_of(trial, "tactical diameter");
  if (!advance.empty()) tracks.push_back(level(advance.front(), west, east, "measured"));
  if (!diameter.empty())
    tracks.push_back(upright(side * diameter.front(), low, high, advance.empty() ? "measured" : ""));
  return track_panel(std::move(tracks), missing);
}

/// Headings before and after, and the heading peaks that were measured.
Panel zigzag_of(const Ship& before, const MeasuredIndices& m, const MeasuredTrial& trial, const ZigzagOrder& order,
                const Ship& after) {
  const auto run = zigzag(before, order, options_of(m)).run;
  Panel panel{.x = {.quantity = "Time", .unit = "s"},
              .y = {.quantity = "Heading", .unit = "deg"},
              .curves = {over_time(run, Channel::psi, "before", before_stroke),
                         over_time(zigzag(after, order, options_of(m)).run, Channel::psi, "after", after_stroke)}};
  for (const auto& i : trial.indices) {
    if (!words_for(i).name.ends_with("overshoot")) continue;
    const double to_starboard = (i.place % 2 == 0) == (order.first == Side::starboard) ? 1.0 : -1.0;
    panel.curves.push_back(level(to_starboard * degrees(order.heading + i.value), run.time.front(), run.time.back(),
                                 panel.curves.size() == 2 ? "peaks measured" : ""));
  }
  return panel;
}

PagePicture picture_of_trial(const Ship& before, const MeasuredIndices& m, const MeasuredTrial& trial,
                             const Ship& after, const UserUnits& units) {
  const auto* turn = std::get_if<TurnOrder>(&trial.manoeuvre);
  const auto name = capital(name_of(trial.manoeuvre));
  auto panel = turn != nullptr ? circle_of(before, m, trial, *turn, after)
                               : zigzag_of(before, m, trial, std::get<ZigzagOrder>(trial.manoeuvre), after);
  return picture_of({.title = name, .panels = {std::move(panel)}},
                    fmt::format("{}: the ship before and after tuning, beside what was measured.", name),
                    turn != nullptr ? "Tracks before and after. Thin lines: advance and tactical diameter as measured."
                                    : "Headings before and after. Thin lines: heading peaks as measured.",
                    units);
}

/// One for each manoeuvre that both ships sail.
std::vector<PagePicture> pictures_of(const Ship& before, const MeasuredIndices& m, const Ship& after,
                                     const UserUnits& units) {
  std::vector<PagePicture> pictures;
  for (const auto& trial : m.trials) {
    try {
      pictures.push_back(picture_of_trial(before, m, trial, after, units));
    } catch (const std::exception& without) {
      say_aside("swayaw: {}: no picture: {}\n", name_of(trial.manoeuvre), without.what());
    }
  }
  return pictures;
}

// ---------------------------------------------------------------- assumed

std::vector<std::string> assumed_of(const MeasuredIndices& m, const TuneArguments& a, const Tuning& t,
                                    const UserUnits& units) {
  const auto shaft = m.rev      ? fmt::format("shaft speed {:.4g} 1/s", *m.rev)
                     : m.thrust ? fmt::format("thrust {:.4g} N", *m.thrust)
                                : std::string("the shaft speed of self-propulsion");
  return {fmt::format("Measured: {}. Approach at {}, {} held; calm, deep water.", a.indices.string(),
                      m.speed ? units.speed(*m.speed) : "the service speed", shaft),
          a.prior ? fmt::format("Every coefficient may differ by {} (one standard deviation).", percent_of(*a.prior))
                  : "Priors are the confidence of the ship file.",
          a.most_change ? fmt::format("None changes by more than {}.", percent_of(*a.most_change))
                        : "No bound but the ranges of the ship file.",
          fmt::format("Tuning {}: {} and {} were sailed. All but these coefficients stay as they are in {}.",
                      in_words(t.status), counted(static_cast<std::size_t>(t.simulations.turns), "turning circle"),
                      counted(static_cast<std::size_t>(t.simulations.zigzags), "zigzag"), a.ship.string())};
}

}  // namespace

Page tune_page(const Ship& before, const MeasuredIndices& m, const Tuning& t, const TuneArguments& a) {
  const double L = length(before);
  const UserUnits units(a.report.si, L);
  const IndexUnits index_units(units, L);
  Page page{.kicker = "Coefficients tuned to measured indices",
            .title = before.name,
            .headline = headline_of(t),
            .tone = tone_of(t)};
  page.answers = {{"Does she turn as measured now?", turns_words(t)},
                  {"What had to change, and is it believable?", believable_words(t)},
                  {"Which index does not fit?", misfit_words(m, t, index_units)}};
  auto pictures = pictures_of(before, m, t.ship, units);
  if (!pictures.empty()) {
    page.picture = std::move(pictures.front());
    pictures.erase(pictures.begin());
  }
  page.table = indices_table(m, t, index_units);
  page.assumed = assumed_of(m, a, t, units);
  page.sections = {{.title = "What had to change", .tables = {coefficients_table(t)}}};
  if (!pictures.empty()) page.sections.push_back({.title = "The other manoeuvres", .pictures = std::move(pictures)});
  page.footnotes = {made_by()};
  return page;
}

}  // namespace swayaw::app
