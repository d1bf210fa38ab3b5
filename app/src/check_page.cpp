#include "check_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

using Kind = InstrumentErrorKind;

/// How many of a list a sentence holds.
constexpr std::size_t most_in_sentence = 3, most_in_headline = 2;

/// Half of a 95 % interval over the standard error.
constexpr double half_width = 1.96;

/// An error, the largest of its kind where several runs tell it one by one.
struct Finding {
  InstrumentError error;
  std::vector<std::string> runs;  ///< that tell it; empty: all together

  bool mistake() const { return is_mistake(error.kind); }
  bool told() const { return mistake() || error.told; }
};

// ---------------------------------------------------------------- words

/// "yaw rate", as all commands name the instrument.
std::string channel_of(const InstrumentError& e) {
  const auto words = words_for(e);
  return words.substr(0, words.find(':'));
}

std::string channel_of(Channel channel) { return channel_of({channel, Kind::zero, 0.0, 0.0}); }

/// What words_for says after the channel.
std::string law_of(const InstrumentError& e) {
  const auto words = words_for(e);
  return words.substr(std::min(words.size(), words.find(':') + 2));
}

/// What is wrong, before its size.
std::string error_words(const InstrumentError& e) {
  const auto side = [&](const char* more, const char* less) { return std::string(e.value > 0.0 ? more : less); };
  switch (e.kind) {
    case Kind::sign: return "sign is wrong";
    case Kind::order: return "order, no angle";
    case Kind::unit: return law_of(e);
    case Kind::zero: return "zero off by";
    case Kind::scale: return side("too large by", "too small by");
    case Kind::delay: return side("late by", "early by");
    case Kind::jump: return side("clock jumps late by", "clock jumps early by");
    case Kind::clock: return "clock wanders by";
    case Kind::clock_rate: return side("clock slow by", "clock fast by");
    case Kind::smoothing: return "smoothed over";
    case Kind::lever_arm_x: return side("antenna forward by", "antenna aft by");
    case Kind::lever_arm_y: return side("antenna to starboard by", "antenna to port by");
    case Kind::axes: break;
  }
  return e.channel == Channel::psi ? side("below the track's by", "above the track's by")
                                   : side("axes to starboard by", "axes to port by");
}

/// Its size; a side is told in words.
std::string size_of(const InstrumentError& e, const UserUnits& units) {
  if (is_mistake(e.kind)) return "";
  const double value = e.kind == Kind::zero ? e.value : std::abs(e.value);
  const double error = std::isfinite(e.standard_error) ? e.standard_error : 0.0;
  const bool share = e.kind == Kind::scale || e.kind == Kind::clock_rate;
  return (share ? with_error(100.0 * value, 100.0 * error) + " %"
                : units.in_unit(std::string(unit_of(e)), value, error)) +
         (e.kind == Kind::clock ? " in a minute" : "");
}

/// Whether `check --out` takes it off.
bool is_repaired(const InstrumentError& e) {
  if (e.kind == Kind::axes) return e.channel != Channel::v && e.channel != Channel::v_ground;
  return e.kind != Kind::clock && e.kind != Kind::smoothing;
}

/// In three words; of mistakes remedy_for tells more.
std::string remedy_words(const InstrumentError& e) {
  switch (e.kind) {
    case Kind::sign: return "turn the sign";
    case Kind::unit: return "name its unit";
    case Kind::order: return "name it an order";
    case Kind::zero: return "take it off";
    case Kind::scale: return fmt::format("divide by {:.4g}", 1.0 + e.value);
    case Kind::delay:
    case Kind::jump:
    case Kind::clock_rate: return "set the clock right";
    case Kind::lever_arm_x:
    case Kind::lever_arm_y: return "move to midship";
    case Kind::axes: return is_repaired(e) ? "turn back" : "sensor, or wind";
    case Kind::clock: return "none: time by others";
    case Kind::smoothing: break;
  }
  return "none: changes are lost";
}

/// "all runs together", "run.csv", "5 of 12 runs"
std::string where_of(const Finding& f, std::size_t runs) {
  if (f.runs.empty()) return "all runs together";
  return f.runs.size() == 1 ? f.runs.front() : fmt::format("{} of {} runs", f.runs.size(), runs);
}

/// What to do, in a few words.
std::string short_remedy(const InstrumentError& e) {
  if (!is_mistake(e.kind)) return remedy_words(e);
  const auto words = remedy_for(e);
  return words.substr(0, std::min(words.find(" ("), words.find(", or")));
}

std::string sentence_of(const Finding& f, std::size_t runs, const UserUnits& units) {
  const auto size = size_of(f.error, units);
  const auto where = runs == 1 ? "" : fmt::format(" ({})", where_of(f, runs));
  const auto most = f.runs.size() > 1 && !size.empty() ? "up to " : "";
  const auto what = f.error.kind == Kind::sign ? law_of(f.error) : error_words(f.error);
  return fmt::format("{}: {}{}{}{}{}: {}.", capital(channel_of(f.error)), what, size.empty() ? "" : " ", most, size,
                     where, short_remedy(f.error));
}

// ---------------------------------------------------------------- findings

bool same(const InstrumentError& a, const InstrumentError& b) { return a.channel == b.channel && a.kind == b.kind; }

/// What single runs tell, one line for each kind.
std::vector<Finding> of_single_runs(const std::vector<RunCheck>& checks) {
  std::vector<Finding> found;
  for (const auto& check : checks)
    for (const auto& e : check.errors) {
      if (!e.told && !is_mistake(e.kind)) continue;
      const auto known = std::ranges::find_if(found, [&](const Finding& f) { return same(f.error, e); });
      auto& finding = known == found.end() ? found.emplace_back(Finding{e, {}}) : *known;
      if (std::abs(e.value) > std::abs(finding.error.value)) finding.error = e;
      if (finding.runs.empty() || finding.runs.back() != check.run) finding.runs.push_back(check.run);
    }
  return found;
}

/// What several runs tell together replaces what they tell one by one; what they do not tell together does not.
void add_together(std::vector<Finding>& found, const std::vector<InstrumentError>& errors,
                  const std::vector<std::string>& where) {
  for (const auto& e : errors) {
    const auto known = std::ranges::find_if(found, [&](const Finding& f) { return same(f.error, e); });
    if (known == found.end()) found.push_back({e, where});
    else if (e.told && !known->mistake()) *known = {e, where};
  }
}

/// Mistakes, then what is told, that of all runs and the surest first, then the rest.
std::vector<Finding> findings_of(const std::vector<RunCheck>& checks, const std::optional<RunCheck>& log) {
  auto found = of_single_runs(checks);
  if (checks.size() == 1) add_together(found, checks.front().errors, {checks.front().run});
  else add_together(found, pooled(checks), {});
  if (log) {
    std::vector<InstrumentError> of_log;
    std::ranges::copy_if(log->errors, std::back_inserter(of_log), &InstrumentError::told);
    add_together(found, of_log, {"the whole log"});
  }
  std::ranges::stable_sort(found, std::greater{}, [&](const Finding& f) {
    const double surety = f.error.standard_error > 0.0 ? std::abs(f.error.value) / f.error.standard_error : 0.0;
    const auto runs = f.runs.empty() ? checks.size() : f.runs.size();
    return std::tuple(f.mistake(), f.told(), f.told() ? runs : 0, f.told() ? surety : 0.0);
  });
  return found;
}

std::vector<Finding> told_of(const std::vector<Finding>& findings) {
  std::vector<Finding> told;
  std::ranges::copy_if(findings, std::back_inserter(told), &Finding::told);
  return told;
}

// ---------------------------------------------------------------- headline and answers

std::string headline_of(const std::vector<Finding>& told, std::size_t runs, const UserUnits& units) {
  if (told.empty()) return fmt::format("No error of an instrument is told in {}.", counted(runs, "run"));
  std::string words;
  const auto shown = std::min(told.size(), most_in_headline);
  for (std::size_t i = 0; i < shown; ++i) words += sentence_of(told[i], runs, units) + " ";
  return words + (told.size() > shown ? fmt::format("{} below.", counted(told.size() - shown, "more error"))
                                      : "Nothing else is told.");
}

std::string belief_words(const std::vector<Finding>& told) {
  const auto mistakes = std::ranges::count_if(told, &Finding::mistake);
  if (mistakes > 0)
    return fmt::format("No, not before {} mended: every result would carry it on.",
                       mistakes == 1 ? "this mistake is" : "these mistakes are");
  if (told.empty()) return "Yes, as far as kinematics can tell: signs, units, zeros, scales and clocks agree.";
  return fmt::format("Yes, signs and units are right; {} should be corrected first.",
                     told.size() == 1 ? "one error" : counted(told.size(), "error"));
}

std::string work_words(const std::vector<Finding>& told) {
  if (told.empty()) return "None; nothing to do.";
  std::string mistakes;
  std::vector<std::string> errors;
  for (const auto& f : told) {
    if (f.mistake()) mistakes += fmt::format("{}: {}. ", capital(channel_of(f.error)), remedy_for(f.error));
    else if (auto one = fmt::format("{} ({})", channel_of(f.error), remedy_words(f.error));
             std::ranges::count(errors, one) == 0)
      errors.push_back(std::move(one));
  }
  const bool repaired = std::ranges::any_of(told, [](const Finding& f) { return is_repaired(f.error); });
  return mistakes + (errors.empty() ? "" : capital(listed(errors, most_in_sentence)) + ". ") +
         (repaired ? "swayaw check RUN --out repaired.csv writes a run put right." : "");
}

/// Lines with the number of runs that say them.
void count(std::vector<std::pair<std::string, std::size_t>>& lines, const std::string& line) {
  const auto known = std::ranges::find(lines, line, &std::pair<std::string, std::size_t>::first);
  if (known == lines.end()) lines.emplace_back(line, 1);
  else ++known->second;
}

std::vector<std::string> unchecked(const std::vector<RunCheck>& checks) {
  std::vector<std::pair<std::string, std::size_t>> lines;
  for (const auto& check : checks) {
    for (const auto& line : check.cannot_tell) count(lines, line);
    for (const auto& d : check.derived)
      count(lines, fmt::format("{}: not measured, made of {}", channel_of(d.channel), d.made_of));
    if (!check.gaps.empty()) count(lines, "no heading for a part of the time");
  }
  std::vector<std::string> words;
  for (const auto& [line, runs] : lines)
    words.push_back(runs == checks.size() ? line : fmt::format("{} (in {} of {} runs)", line, runs, checks.size()));
  return words;
}

std::string unchecked_words(const std::vector<RunCheck>& checks) {
  const auto lines = unchecked(checks);
  if (lines.empty()) return "Nothing that kinematics can tell. Noise that comes with the motion itself never shows.";
  std::string words;
  for (const auto& line : lines) words += capital(line) + ". ";
  return words;
}

// ---------------------------------------------------------------- table, picture

PageTable table_of(const std::vector<Finding>& findings, std::size_t runs, const UserUnits& units) {
  const bool any = std::ranges::any_of(findings, &Finding::told);
  PageTable table{.caption = any ? "Told errors first" : "None is told: what was found beside none",
                  .columns = {"Channel: error", "Value ± std error", "Remedy"},
                  .rows = {}};
  if (any && runs > 1) table.caption += "; in how many runs, else in all together";
  for (const auto& f : findings) {
    const auto tone = f.mistake() ? Tone::bad : f.told() ? Tone::look : Tone::neutral;
    const auto where = runs == 1 || f.runs.empty() ? "" : fmt::format(" ({} of {})", f.runs.size(), runs);
    table.rows.push_back({{fmt::format("{}: {}{}", capital(channel_of(f.error)), error_words(f.error), where), tone},
                          {size_of(f.error, units), tone},
                          f.told() ? remedy_words(f.error) : "-"});
  }
  return table;
}

/// A value of a run with its 95 % interval, as a level line with a mark.
Curve interval(const InstrumentError& e, double one, double place, const char* colour) {
  const double low = (e.value - half_width * e.standard_error) / one;
  const double high = (e.value + half_width * e.standard_error) / one;
  const double middle = e.value / one, mark = 0.15;
  return {.name = {},
          .x = {low, high, missing, middle, middle},
          .y = {place, place, missing, place - mark, place + mark},
          .stroke = {.colour = colour, .width = 2.4}};
}

/// SI value of what the axis is in, and its name.
std::pair<double, std::string> axis_of(const InstrumentError& e, bool si) {
  const std::string unit(unit_of(e));
  if (unit.empty()) return {0.01, "%"};
  if (si) return {1.0, unit};
  return unit == "rad"     ? std::pair{radians(1.0), "deg"}
         : unit == "rad/s" ? std::pair{radians(1.0), "deg/s"}
                           : std::pair{1.0, unit.c_str()};
}

/// The surest error in each run that tells of it, and in all together.
std::optional<PagePicture> picture_of_worst(const std::vector<Finding>& findings, const std::vector<RunCheck>& checks,
                                            bool si) {
  const auto worst = std::ranges::find_if(
      findings, [](const Finding& f) { return !f.mistake() && f.told() && f.error.standard_error > 0.0; });
  if (worst == findings.end() || checks.size() < 2) return std::nullopt;
  const auto [one, unit] = axis_of(worst->error, si);
  const auto title = fmt::format("{}: {}", capital(channel_of(worst->error)), name_of(worst->error.kind));
  Plot plot{.title = title,
            .panels = {{.x = {.quantity = "Value", .unit = unit},
                        .y = {.quantity = "Run, from the first below", .unit = "", .tick = 1.0}}}};
  auto& curves = plot.panels.front().curves;
  for (std::size_t i = 0; i < checks.size(); ++i)
    for (const auto& e : checks[i].errors)
      if (same(e, worst->error) && e.standard_error > 0.0)
        curves.push_back(interval(e, one, static_cast<double>(i + 1), e.told ? ink::yaw : ink::drift));
  return picture_of(plot, fmt::format("{} in {}, with 95 % intervals.", title, counted(checks.size(), "run")),
                    "95 % intervals; orange where the run alone tells the error.", {si, 0.0});
}

std::vector<std::string> assumed_of(const std::vector<RunCheck>& checks) {
  std::vector<std::string> lines{
      "The laws of motion without forces: way made good is velocity turned by the heading, the heading is the sum of "
      "the yaw rate. No ship file is needed.",
      "An error is told beyond 3.7 standard errors if it is large enough to matter to an answer about a ship."};
  if (checks.size() > 1) lines.emplace_back("All runs together: the same instruments in all, mounted and set alike.");
  return lines;
}

}  // namespace

Page first_screen(const std::vector<RunCheck>& checks, const std::optional<RunCheck>& log, bool si) {
  const UserUnits units(si, 0.0);
  const auto findings = findings_of(checks, log);
  const auto told = told_of(findings);
  Page page{.kicker = "Instruments checked by kinematics",
            .title = checks.size() == 1 ? checks.front().run : counted(checks.size(), "recording"),
            .headline = headline_of(told, checks.size(), units),
            .tone = told.empty()             ? Tone::good
                    : told.front().mistake() ? Tone::bad
                                             : Tone::look};
  page.answers = {{"Can the recordings be believed?", belief_words(told)},
                  {"Which instruments are off, and what to do?", work_words(told)},
                  {"What could not be checked?", unchecked_words(checks)}};
  page.picture = picture_of_worst(findings, checks, si);
  page.table = table_of(findings, checks.size(), units);
  page.assumed = assumed_of(checks);
  return page;
}

}  // namespace swayaw::app
