#include "trial_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

/// Up to so many runs all their numbers are in the first table, and each has its sentence.
constexpr std::size_t few_runs = 3, runs_in_headline = 2;

// ---------------------------------------------------------------- words

/// "zigzag 10/10", "turning circle with 35 deg to port"
std::string words_for(const TrialResult& t) {
  if (t.zigzag) return fmt::format("{} to {}", t.manoeuvre.name, name_of(t.zigzag->first));
  if (!t.turn) return t.manoeuvre.name;
  return fmt::format("turning circle with {:.0f} deg to {}", degrees(t.manoeuvre.rudder), name_of(t.turn->side));
}

/// "second overshoot" of a criterion.
std::string words_for(const JudgedCriterion& c) {
  if (c.name.starts_with("first_overshoot")) return "first overshoot";
  if (c.name.starts_with("second_overshoot")) return "second overshoot";
  return in_words(c.name);
}

/// "first overshoot, starboard" of a row "overshoot 1, starboard".
std::string words_for(const TrialRow& row) {
  constexpr std::string_view overshoot = "overshoot ";
  if (!row.name.starts_with(overshoot) || row.name.size() <= overshoot.size()) return row.name;
  const auto comma = row.name.find(',');
  const auto place = row.name.substr(overshoot.size(), comma - overshoot.size());
  if (place.find_first_not_of("0123456789") != std::string::npos) return row.name;
  return ordinal(std::stoul(place)) + " overshoot" + row.name.substr(comma);
}

// ---------------------------------------------------------------- numbers

/// A number of a row, which is in degrees where it is an angle; ways in ship lengths, as the criteria have them.
std::string shown(const TrialRow& row, double value, double error, const UserUnits& units) {
  if (row.unit == "m" && row.in_lengths && !units.si()) {
    const double L = (row.corrected ? row.corrected : row.recorded)->value / *row.in_lengths;
    return with_error(value / L, error / L) + " L";
  }
  if (row.unit == "deg") return units.angle(radians(value), radians(error));
  if (row.unit == "deg/s") return units.yaw_rate(radians(value), radians(error));
  return units.in_unit(row.unit, value, error);
}

double power_of_ten(double value) { return std::floor(std::log10(std::abs(value))); }

/// Not below the fifth digit of the value: recordings made without noise tell more than anybody reads.
double error_of(const Told& told) {
  if (!std::isfinite(told.standard_error)) return 0.0;
  return told.value == 0.0 ? told.standard_error
                           : std::max(told.standard_error, std::pow(10.0, power_of_ten(told.value) - 4.0));
}

/// Three digits, or as many as the error allows.
double rounded(const Told& told) {
  if (told.value == 0.0) return 0.0;
  const double of_error = told.standard_error > 0.0 ? power_of_ten(told.standard_error) : -8.0;
  const double digit = std::pow(10.0, std::max(power_of_ten(told.value) - 2.0, of_error));
  return digit * std::round(told.value / digit);
}

std::string recorded_cell(const TrialRow& row, const UserUnits& units) {
  const auto& told = row.corrected ? row.corrected : row.recorded;
  return told ? shown(row, told->value, error_of(*told), units) : "-";
}

std::string simulated_cell(const TrialRow& row, const UserUnits& units) {
  return row.simulated ? shown(row, *row.simulated, 0.0, units) : "";
}

std::string in_unit_of(const JudgedCriterion& c, double value, const UserUnits& units) {
  return c.unit == "deg" ? units.angle(radians(value)) : fmt::format("{} {}", with_error(value), c.unit);
}

/// "10 deg", "4.5 L"
std::string limit_of(const JudgedCriterion& c, const UserUnits& units) {
  return c.unit == "deg" && units.si() ? units.angle(radians(c.limit)) : fmt::format("{:.3g} {}", c.limit, c.unit);
}

/// "first overshoot 5.61 deg (limit 10 deg)"
std::string sentence_part(const JudgedCriterion& c, const UserUnits& units) {
  const auto value = c.value ? in_unit_of(c, rounded(*c.value), units) : "not reached";
  return fmt::format("{} {} (limit {})", words_for(c), value, limit_of(c, units));
}

// ---------------------------------------------------------------- criteria of all runs

struct Judged {
  const JudgedRun* run;
  const JudgedCriterion* criterion;

  /// Value over limit; what was not reached is beyond any.
  double load() const {
    return criterion->value ? criterion->value->value / criterion->limit : std::numeric_limits<double>::infinity();
  }
};

std::vector<Judged> judged(const std::vector<JudgedRun>& runs) {
  std::vector<Judged> all;
  for (const auto& run : runs)
    for (const auto& c : run.trial.imo) all.push_back({&run, &c});
  return all;
}

std::vector<std::string> named(const std::vector<Judged>& all, std::optional<bool> pass) {
  std::vector<std::string> names;
  for (const auto& [run, c] : all)
    if (c->pass == pass) names.push_back(fmt::format("the {} of the {}", words_for(*c), words_for(run->trial)));
  return names;
}

/// The manoeuvres that MSC.137(76) asks for, each to both sides.
struct Standard {
  std::string_view name;
  TrialKind kind;
  double rudder;  ///< of a zigzag [rad]; of a circle any
  std::string_view criterion;
};

constexpr std::array standards{Standard{"zigzag 10/10", TrialKind::zigzag, radians(10.0), "first_overshoot_10_10"},
                               Standard{"zigzag 20/20", TrialKind::zigzag, radians(20.0), "first_overshoot_20_20"},
                               Standard{"turning circle with full rudder", TrialKind::turn, 0.0, "advance"}};

/// @param by_criteria  whether criteria were judged, which tell it
bool is_of(const TrialResult& t, const Standard& s, bool by_criteria) {
  if (by_criteria) return std::ranges::count(t.imo, s.criterion, &JudgedCriterion::name) > 0;
  const auto near = [&](double angle) { return std::abs(angle - s.rudder) < radians(0.5); };
  return t.manoeuvre.kind == s.kind &&
         (s.kind == TrialKind::turn || (near(t.manoeuvre.rudder) && near(t.manoeuvre.heading)));
}

Side side_of(const TrialResult& t) { return t.zigzag ? t.zigzag->first : t.turn->side; }

std::set<Side> sides_of(const Standard& s, const std::vector<JudgedRun>& runs) {
  const bool by_criteria = !judged(runs).empty();
  std::set<Side> sides;
  for (const auto& run : runs)
    if (is_of(run.trial, s, by_criteria)) sides.insert(side_of(run.trial));
  return sides;
}

/// "the zigzag 20/20", to neither side.
std::vector<std::string> not_sailed(const std::vector<JudgedRun>& runs) {
  std::vector<std::string> names;
  for (const auto& s : standards)
    if (sides_of(s, runs).empty()) names.push_back(fmt::format("the {}", s.name));
  return names;
}

/// "the zigzag 10/10 (port)"
std::vector<std::string> sailed_to_one_side(const std::vector<JudgedRun>& runs) {
  std::vector<std::string> names;
  for (const auto& s : standards)
    if (const auto sides = sides_of(s, runs); sides.size() == 1)
      names.push_back(fmt::format("the {} ({})", s.name, name_of(*sides.begin())));
  return names;
}

// ---------------------------------------------------------------- headline

std::string against_rudder(const std::vector<JudgedRun>& runs) {
  std::vector<std::string> names;
  for (const auto& run : runs)
    if (run.trial.against_rudder) names.push_back(run.trial.run);
  return names.empty() ? ""
                       : fmt::format("The ship turns against her rudder in {}: the sign of the rudder angle is wrong. ",
                                     listed(names, few_runs));
}

/// What a run is known for where no criterion is judged.
std::string first_numbers(const JudgedRun& run, const TrialQuestion& q, const UserUnits& units) {
  std::vector<std::string> parts;
  for (const auto& row : rows_of(run.trial, run.simulated, q.L))
    if (row.recorded && parts.size() < 2) parts.push_back(words_for(row) + " " + recorded_cell(row, units));
  return listed(parts);
}

std::string sentence_of(const JudgedRun& run, const TrialQuestion& q, const UserUnits& units) {
  std::vector<std::string> parts;
  for (const auto& c : run.trial.imo)
    if (c.name != "initial_turning" || run.trial.imo.size() == 1) parts.push_back(sentence_part(c, units));
  return fmt::format("{}: {}. ", capital(words_for(run.trial)),
                     parts.empty() ? first_numbers(run, q, units) : listed(parts));
}

std::string nearest_words(const std::vector<Judged>& all, const UserUnits& units) {
  const auto worst = *std::ranges::max_element(all, {}, &Judged::load);
  return fmt::format("Nearest to its limit: {} in {}. ", sentence_part(*worst.criterion, units), worst.run->trial.run);
}

std::string verdict_words(const std::vector<Judged>& all) {
  if (all.empty()) return "No criterion of MSC.137(76) is judged";
  const auto failed = named(all, false), open = named(all, std::nullopt);
  if (!failed.empty()) return "She fails MSC.137(76) by " + listed(failed, few_runs);
  if (open.size() == all.size()) return "No criterion of MSC.137(76) could be decided";
  return "No criterion is failed" + (open.empty() ? "" : "; not decided: " + listed(open, few_runs));
}

std::string headline_of(const std::vector<JudgedRun>& runs, const TrialQuestion& q, const UserUnits& units) {
  const auto all = judged(runs);
  auto words = against_rudder(runs);
  if (runs.size() <= runs_in_headline)
    for (const auto& run : runs) words += sentence_of(run, q, units);
  else if (!all.empty()) words += counted(runs.size(), "run") + ". " + nearest_words(all, units);
  else words += counted(runs.size(), "run") + ". ";
  words += verdict_words(all);
  if (const auto rest = not_sailed(runs); !rest.empty() && !all.empty())
    words += fmt::format("; {} {} not sailed", listed(rest), rest.size() == 1 ? "was" : "were");
  return words + ".";
}

Tone tone_of(const std::vector<JudgedRun>& runs) {
  const auto all = judged(runs);
  const auto any = [&](std::optional<bool> pass) {
    return std::ranges::any_of(all, [&](const Judged& j) { return j.criterion->pass == pass; });
  };
  if (any(false) || !against_rudder(runs).empty()) return Tone::bad;
  if (all.empty() || any(std::nullopt)) return all.empty() ? Tone::neutral : Tone::look;
  return not_sailed(runs).empty() && sailed_to_one_side(runs).empty() ? Tone::good : Tone::neutral;
}

// ---------------------------------------------------------------- answers

std::string pass_words(const std::vector<JudgedRun>& runs, const TrialQuestion& q) {
  const auto all = judged(runs);
  if (all.empty())
    return !q.L ? "Not judged: the length of the ship is not known (--length, or --ship)."
                : "Not judged: these runs tell no criterion, or no approach speed (--speed).";
  return fmt::format(
      "{} of {} judged {} passed.{}", named(all, true).size(),
      all.size() == 1 ? "1 criterion" : fmt::format("{} criteria", all.size()), all.size() == 1 ? "is" : "are",
      q.L && *q.L < shortest_ship_of_criteria
          ? " The criteria are made for ships of 100 m and more; she is shorter, or a scale model, whose "
            "limits are not those of her ship."
          : "");
}

std::string sure_words(const std::vector<JudgedRun>& runs) {
  const auto open = named(judged(runs), std::nullopt);
  return fmt::format(
      "± is one standard error of instrument noise, rounding and sampling. Wind, waves and the helmsman are not in it. "
      "{}",
      open.empty() ? "Every limit lies more than two standard errors from its value."
                   : "Within two standard errors of the limit, or not reached: " + listed(open, few_runs) + ".");
}

std::string rest_words(const std::vector<JudgedRun>& runs) {
  const auto rest = not_sailed(runs), half = sailed_to_one_side(runs);
  if (rest.empty() && half.empty()) return "Nothing: all steering manoeuvres of MSC.137(76) to both sides are here.";
  std::string words;
  if (!rest.empty()) words = capital(listed(rest)) + (half.empty() ? "." : ". ");
  if (!half.empty()) words += "To one side only: " + listed(half) + ".";
  return words;
}

// ---------------------------------------------------------------- table

/// Beginning of a row's name and of the criterion on the same number.
constexpr std::array<std::array<std::string_view, 2>, 5> criterion_of_row{{{"overshoot 1,", "first_overshoot"},
                                                                           {"overshoot 2,", "second_overshoot"},
                                                                           {"way to ", "initial_turning"},
                                                                           {"advance", "advance"},
                                                                           {"tactical diameter", "tactical_diameter"}}};

const JudgedCriterion* criterion_on(const TrialRow& row, const TrialResult& trial) {
  for (const auto& [begins, name] : criterion_of_row)
    for (const auto& c : trial.imo)
      if (row.name.starts_with(begins) && c.name.starts_with(name)) return &c;
  return nullptr;
}

/// Numbers that everybody asks for; those of the steering model are further down.
bool is_asked_for(const TrialRow& row, bool few) {
  const bool overshoot = row.name.starts_with("overshoot") && row.unit == "deg";
  const bool of_steady = row.name.starts_with("yaw rate at rudder") || row.name.starts_with("loop");
  if (overshoot || of_steady || row.unit == "m") return true;
  return few && (row.name == "K'" || row.name == "T'" || row.name.starts_with("final over") ||
                 row.name.starts_with("final drift") || row.name.starts_with("mean"));
}

PageCell verdict_cell(const JudgedCriterion* c) {
  if (c == nullptr) return "";
  return {std::string(verdict_of(*c)), c->pass ? (*c->pass ? Tone::good : Tone::bad) : Tone::look};
}

class FirstTable {
 public:
  FirstTable(bool simulated, const UserUnits& units) : simulated_(simulated), units_(units) {
    table_.columns = {"Number", "Recorded", "IMO limit", "Verdict"};
    if (simulated_) table_.columns.insert(table_.columns.begin() + 2, "Simulated");
  }

  void add_title(const std::string& words) { put({words, "", ""}, nullptr); }

  void add(const TrialRow& row, const JudgedCriterion* c) {
    put({capital(words_for(row)), recorded_cell(row, units_), simulated_cell(row, units_)}, c);
  }

  void add_not_told(const JudgedCriterion& c) { put({capital(words_for(c)), "-", ""}, &c); }

  PageTable take(std::string caption) {
    table_.caption = std::move(caption);
    return std::move(table_);
  }

 private:
  void put(std::vector<PageCell> cells, const JudgedCriterion* c) {
    if (!simulated_) cells.pop_back();
    cells.emplace_back(c != nullptr ? limit_of(*c, units_) : "");
    cells.push_back(verdict_cell(c));
    table_.rows.push_back(std::move(cells));
  }

  bool simulated_;
  const UserUnits& units_;
  PageTable table_{};
};

/// How much of a run the table holds.
enum class Detail { criteria, asked_for, all };

bool is_shown(const TrialRow& row, Detail detail) {
  return detail != Detail::criteria && is_asked_for(row, detail == Detail::all);
}

void add_run(FirstTable& table, const JudgedRun& run, const std::optional<double>& L, Detail detail) {
  std::set<const JudgedCriterion*> shown;
  for (const auto& row : rows_of(run.trial, run.simulated, L)) {
    const auto* criterion = criterion_on(row, run.trial);
    if (criterion == nullptr && !is_shown(row, detail)) continue;
    shown.insert(criterion);
    table.add(row, criterion);
  }
  for (const auto& c : run.trial.imo)
    if (!shown.contains(&c)) table.add_not_told(c);
}

Detail detail_of(const std::vector<JudgedRun>& runs) {
  if (runs.size() <= few_runs) return Detail::all;
  return judged(runs).empty() ? Detail::asked_for : Detail::criteria;
}

/// With the file where two runs are of the same manoeuvre.
std::string title_of(const JudgedRun& run, const std::vector<JudgedRun>& runs) {
  const auto words = words_for(run.trial);
  const auto alike = std::ranges::count_if(runs, [&](const JudgedRun& r) { return words_for(r.trial) == words; });
  return capital(words) + (alike > 1 ? ", " + run.trial.run : "");
}

PageTable table_of(const std::vector<JudgedRun>& runs, const TrialQuestion& q, const UserUnits& units) {
  const bool simulated = std::ranges::any_of(runs, [](const JudgedRun& r) { return !r.simulated.json.is_null(); });
  const auto detail = detail_of(runs);
  FirstTable table(simulated, units);
  for (const auto& run : runs) {
    if (detail == Detail::criteria && run.trial.imo.empty()) continue;
    if (runs.size() > 1) table.add_title(title_of(run, runs));
    add_run(table, run, q.L, detail);
  }
  return table.take(runs.size() == 1             ? capital(words_for(runs.front().trial))
                    : detail == Detail::criteria ? "Criteria of all runs; all numbers are further down"
                                                 : "Numbers of all runs");
}

// ---------------------------------------------------------------- picture

constexpr Stroke recorded_stroke{.colour = ink::heading, .width = 2.4},
    simulated_stroke{.colour = ink::yaw, .width = 2.0, .dashed = true},
    rudder_stroke{.colour = ink::rudder, .width = 1.4};

const Recording* simulated_run(const JudgedRun& run) {
  if (run.simulated.zigzag) return &run.simulated.zigzag->run;
  return run.simulated.turn ? &run.simulated.turn->run : nullptr;
}

/// The simulated track, which begins at the origin to the north, at place, time and heading of the recorded execute.
Recording as_recorded(Recording simulated, const JudgedRun& run) {
  const auto& r = run.recording;
  const double psi = run.trial.approach.heading.value, execute = run.trial.approach.execute.value;
  const Interpolant x0(r, Channel::x), y0(r, Channel::y);
  const double north = x0(execute), east = y0(execute), c = std::cos(psi), s = std::sin(psi);
  const auto x = simulated.fill(Channel::x), y = simulated.fill(Channel::y), heading = simulated.fill(Channel::psi);
  for (std::size_t i = 0; i < simulated.samples(); ++i) {
    const double ahead = x[i], starboard = y[i];
    x[i] = north + ahead * c - starboard * s;
    y[i] = east + ahead * s + starboard * c;
    heading[i] += psi;
  }
  return simulated;
}

Panel circle_of(const JudgedRun& run, const std::optional<double>& L) {
  std::vector tracks{track_of(run.recording, "recorded", recorded_stroke)};
  const auto add_hulls = [&](const Recording& track, const char* colour) {
    for (auto& hull : hulls_along(track, L.value_or(0.0), colour)) tracks.push_back(std::move(hull));
  };
  add_hulls(run.recording, ink::heading);
  if (const auto* simulated = simulated_run(run)) {
    const auto laid = as_recorded(*simulated, run);
    tracks.push_back(track_of(laid, "simulated", simulated_stroke));
    add_hulls(laid, ink::yaw);
  }
  return track_panel(std::move(tracks), missing);
}

/// Off the heading of the approach; the simulated run begins at the execute.
Curve moved(Curve curve, double time, double value) {
  for (double& x : curve.x) x += time;
  for (double& y : curve.y) y += value;
  return curve;
}

Panel headings_of(const JudgedRun& run) {
  const auto& r = run.recording;
  const auto& approach = run.trial.approach;
  const auto rudder = r.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  Panel panel{
      .x = {.quantity = "Time", .unit = "s"},
      .y = {.quantity = "Heading and rudder", .unit = "deg"},
      .curves = {moved(over_time(r, Channel::psi, "heading", recorded_stroke), 0.0, -degrees(approach.heading.value)),
                 over_time(r, rudder, "rudder, to port", rudder_stroke)}};
  if (const auto* simulated = simulated_run(run))
    panel.curves.push_back(moved(over_time(*simulated, Channel::psi, "heading, simulated", simulated_stroke),
                                 approach.execute.value, 0.0));
  return panel;
}

Panel spiral_of(const SpiralTrial& spiral) {
  Curve curve{.name = "recorded", .x = {}, .y = {}, .stroke = recorded_stroke};
  for (const auto& step : spiral.steps)
    curve.x.push_back(degrees(step.delta)), curve.y.push_back(degrees(step.yaw_rate.value));
  return {.x = {.quantity = "Rudder, to port", .unit = "deg"},
          .y = {.quantity = "Yaw rate, to starboard", .unit = "deg/s"},
          .curves = {std::move(curve)}};
}

/// The run nearest to a limit or beyond it, else the first.
const JudgedRun& decisive(const std::vector<JudgedRun>& runs) {
  const auto all = judged(runs);
  return all.empty() ? runs.front() : *std::ranges::max_element(all, {}, &Judged::load)->run;
}

/// At which speed her file has her simulated, if at one only; or what stands in its place.
std::string simulated_at(const TrialQuestion& q, std::string_view else_at) {
  if (!q.only_speed) return std::string(else_at);
  return at_only_speed(UserUnits(q.si, q.L.value_or(0.0)).speed(*q.only_speed));
}

PagePicture picture_of_run(const JudgedRun& run, const TrialQuestion& q) {
  const auto& t = run.trial;
  const bool circle = t.turn && run.recording.has(Channel::x) && run.recording.has(Channel::y);
  Plot plot{.title = t.run, .panels = {}};
  if (t.spiral) plot.panels.push_back(spiral_of(*t.spiral));
  else plot.panels.push_back(circle ? circle_of(run, q.L) : headings_of(run));
  const auto beside = simulated_run(run) == nullptr ? std::string()
                                                    : fmt::format(" Dashed: {} in the same manoeuvre{}.", q.ship,
                                                                  simulated_at(q, " at the same approach speed"));
  return picture_of(
      plot,
      fmt::format("{} of {}.",
                  t.spiral ? "Yaw rate over rudder angle"
                  : circle ? "Track"
                           : "Heading and rudder over time",
                  words_for(t)),
      fmt::format("{}{}.{}", capital(words_for(t)), circle || t.spiral ? "" : ", heading off the approach", beside),
      {q.si, 0.0});
}

// ---------------------------------------------------------------- assumed

std::string speed_words(const std::vector<JudgedRun>& runs, const UserUnits& units) {
  std::vector<std::string> words;
  for (const auto& run : runs) {
    const auto& a = run.trial.approach;
    auto one = a.speed ? fmt::format("{} {}", units.speed(a.speed->value, error_of(*a.speed)), in_words(a.speed_source))
                       : "not recorded";
    if (std::ranges::count(words, one) == 0) words.push_back(std::move(one));
  }
  return "Approach speed: " + listed(words, few_runs) + ".";
}

/// Whether lengths of turning circles are those over ground, or without the drift by current and wind.
std::string drift_words(const std::vector<JudgedRun>& runs, const UserUnits& units) {
  std::vector<std::string> words;
  for (const auto& run : runs) {
    const auto& turn = run.trial.turn;
    if (!turn) continue;
    words.push_back(turn->corrected && turn->drift
                        ? fmt::format("{}: a drift of {} towards {} is taken off", run.trial.run,
                                      units.speed(turn->drift->speed.value, turn->drift->speed.standard_error),
                                      units.direction(turn->drift->direction.value))
                        : fmt::format("{}: as recorded, drift by current and wind not taken off", run.trial.run));
  }
  return words.empty() ? "" : "Lengths of turning circles. " + listed(words, few_runs) + ".";
}

std::vector<std::string> assumed_of(const std::vector<JudgedRun>& runs, const TrialQuestion& q,
                                    const UserUnits& units) {
  std::vector<std::string> lines{
      q.L ? fmt::format("Length {:.4g} m, {}.", *q.L, q.L_source) : "The length of the ship is not known.",
      speed_words(runs, units)};
  if (auto drift = drift_words(runs, units); !drift.empty()) lines.push_back(std::move(drift));
  for (const auto& why : q.not_judged) lines.push_back(fmt::format("Not judged: {}.", why));
  if (!q.ship.empty())
    lines.push_back(
        fmt::format("Simulated: {}{}, propulsion held, in calm deep water unless her "
                    "file says otherwise.",
                    q.ship, simulated_at(q, "")));
  lines.emplace_back(
      "Rudder angles of the pictures are positive to port. A criterion is decided where its limit lies "
      "more than two standard errors from the value.");
  return lines;
}

}  // namespace

Page first_screen(const std::vector<JudgedRun>& runs, const TrialQuestion& q) {
  const UserUnits units(q.si, q.L.value_or(0.0));
  Page page{.kicker = "Recorded manoeuvres judged",
            .title = !q.ship.empty()    ? q.ship
                     : runs.size() == 1 ? runs.front().trial.run
                                        : "Manoeuvring trials",
            .headline = headline_of(runs, q, units),
            .tone = tone_of(runs)};
  page.answers = {{"Does she pass?", pass_words(runs, q)},
                  {"How sure is it?", sure_words(runs)},
                  {"What was not sailed?", rest_words(runs)}};
  page.picture = picture_of_run(decisive(runs), q);
  page.table = table_of(runs, q, units);
  page.assumed = assumed_of(runs, q, units);
  return page;
}

}  // namespace swayaw::app
