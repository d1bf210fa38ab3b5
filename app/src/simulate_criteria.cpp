#include "simulate_criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sentences.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::app {
namespace {

struct CriterionWords {
  std::string_view name, words;
  int zigzag;  ///< [deg], 0 for the turning circle
};

constexpr CriterionWords known[] = {
    {"advance", "advance", 0},
    {"tactical_diameter", "tactical diameter", 0},
    {"initial_turning", "initial turning", 10},
    {"first_overshoot_10_10", "first overshoot", 10},
    {"second_overshoot_10_10", "second overshoot", 10},
    {"first_overshoot_20_20", "first overshoot", 20},
};

const CriterionWords& known_words(const Criterion& c) {
  return *std::ranges::find(known, c.name, &CriterionWords::name);
}

/// Why the criteria do not count; empty where they do.
std::string why_not(const Sailed& s) {
  if (s.L < smallest_judged_ship)
    return fmt::format(
        "Only if she carries chemicals or gas: others from {:g} m on; and a scale model has other limits "
        "than her ship",
        smallest_judged_ship);
  return s.calm ? "" : "Not as she was sailed: they are for deep water and calm, without what the ship file adds";
}

/// The same in a headline.
std::string doubt_words(const Sailed& s) {
  if (s.L < smallest_judged_ship)
    return fmt::format(" The criteria are for ships of {:g} m and more.", smallest_judged_ship);
  return s.calm ? "" : " The criteria are for deep water and calm.";
}

bool count_for(const Sailed& s) { return why_not(s).empty(); }

bool is_angle(const Criterion& c) { return c.unit == "deg"; }

/// A value, limit or margin of the criterion: "952 m (2.98 L)", "12.8 deg".
std::string in_full(const Criterion& c, double value, const Sailed& s) {
  return is_angle(c) ? s.units.angle(radians(value)) : s.units.length(value * s.L);
}

/// The same in the unit of the limit only.
std::string in_short(const Criterion& c, double value, const Sailed& s) {
  return is_angle(c) || s.units.si() ? in_full(c, value, s) : with_error(value) + " L";
}

/// Share of the limit that is left; negative beyond it.
double left_of(const Criterion& c) {
  if (!c.value) return c.pass ? -HUGE_VAL : HUGE_VAL;
  return (c.limit - *c.value) / c.limit;
}

/// "first overshoot"
std::string words_of(const Criterion& c) { return std::string(known_words(c).words); }

/// "first overshoot 10/10"
std::string short_words(const Criterion& c) {
  return is_angle(c) ? fmt::format("{} {}/{}", words_of(c), zigzag_of(c), zigzag_of(c)) : words_of(c);
}

/// "first overshoot of the 10/10 zigzag first to starboard"
std::string long_words(const Criterion& c) {
  const auto zigzag = is_angle(c) ? fmt::format(" of the {}/{} zigzag first", zigzag_of(c), zigzag_of(c)) : "";
  return fmt::format("{}{} to {}", words_of(c), zigzag, name_of(c.side));
}

std::vector<Criterion> only(std::vector<Criterion> criteria, const std::optional<bool>& pass) {
  std::erase_if(criteria, [&](const Criterion& c) { return c.pass != pass; });
  return criteria;
}

/// "advance 953 m (2.98 L), limit 4.50 L"
std::string with_limit(const Criterion& c, const Sailed& s) {
  return fmt::format("{} {}, limit {}", words_of(c), c.value ? in_full(c, *c.value, s) : "not reached",
                     in_short(c, c.limit, s));
}

/// "tactical diameter to port 1070 m (6.65 L) where 5.00 L is allowed"
std::string against_limit(const Criterion& c, const Sailed& s) {
  if (!c.value) return long_words(c) + " was not reached";
  return fmt::format("{}, {} where {} is allowed", long_words(c), in_full(c, *c.value, s), in_short(c, c.limit, s));
}

/// As many of the failed as a headline holds, the worst first.
std::string worst_of(std::vector<Criterion> failed, const Sailed& s) {
  constexpr std::size_t most = 2;
  std::ranges::stable_sort(failed, {}, left_of);
  std::string words;
  for (std::size_t i = 0; i < std::min(failed.size(), most); ++i)
    words += (i > 0 ? "; " : "") + against_limit(failed[i], s);
  return words + (failed.size() > most ? fmt::format("; and {} more", failed.size() - most) : "");
}

/// "fails 1 of 12 steering criteria of MSC.137(76)"
std::string verdict_words(const std::vector<Criterion>& criteria) {
  const auto failed = only(criteria, false).size(), open = only(criteria, std::nullopt).size();
  if (failed > 0) return fmt::format("fails {} of {} steering criteria of MSC.137(76)", failed, criteria.size());
  if (open > 0) return fmt::format("cannot be judged by {} of {} criteria of MSC.137(76)", open, criteria.size());
  if (criteria.size() == 1) return "passes the one criterion of MSC.137(76) that is told here";
  return fmt::format("passes all {} steering criteria of MSC.137(76){}", criteria.size(),
                     has_sides(criteria) ? ", to both sides" : " that are told here");
}

Tone tone_of(const Criterion& c) { return !c.pass ? Tone::look : *c.pass ? Tone::good : Tone::bad; }

std::string_view verdict_word(const Criterion& c) { return !c.pass ? "not judged" : *c.pass ? "pass" : "fail"; }

std::vector<PageCell> row_of(const Criterion& c, bool sides, const Sailed& s) {
  std::vector<PageCell> row{short_words(c)};
  if (sides) row.emplace_back(std::string(name_of(c.side)));
  row.emplace_back(c.value ? sides ? in_short(c, *c.value, s) : in_full(c, *c.value, s) : "not reached", tone_of(c));
  row.emplace_back(in_short(c, c.limit, s));
  row.emplace_back(c.value ? percent_of(left_of(c)) : "-");
  row.emplace_back(std::string(verdict_word(c)), tone_of(c));
  return row;
}

std::string margin_words(const Criterion& c, const Sailed& s) {
  if (!c.value) return capital(long_words(c)) + " was not reached";
  const double left = c.limit - *c.value;
  return fmt::format("{}: {}, {}; {} ({}) {} the limit of {}", left < 0.0 ? "Worst" : "Tightest", long_words(c),
                     in_full(c, *c.value, s), in_short(c, std::abs(left), s), percent_of(std::abs(left_of(c))),
                     left < 0.0 ? "beyond" : "below", in_short(c, c.limit, s));
}

}  // namespace

int zigzag_of(const Criterion& c) { return known_words(c).zigzag; }

bool has_sides(const std::vector<Criterion>& criteria) {
  return std::ranges::any_of(criteria, [&](const Criterion& c) { return c.side != criteria.front().side; });
}

const Criterion& tightest(const std::vector<Criterion>& criteria) {
  return *std::ranges::min_element(criteria, {}, left_of);
}

PageTable criteria_table(const std::vector<Criterion>& criteria, const Sailed& s) {
  const bool sides = has_sides(criteria);
  PageTable table{.caption = "Steering criteria of MSC.137(76)", .columns = {"Criterion"}, .rows = {}};
  if (sides) table.columns.emplace_back("First to");
  for (const char* name : {"Value", "Limit", "Margin", "Verdict"}) table.columns.emplace_back(name);
  for (const auto& c : criteria) table.rows.push_back(row_of(c, sides, s));
  return table;
}

std::string judgement(const std::vector<Criterion>& criteria, const Sailed& s) {
  auto words = fmt::format("{} {}", s.ship, verdict_words(criteria));
  if (const auto failed = only(criteria, false); !failed.empty()) words += ": " + worst_of(failed, s);
  return words + "." + doubt_words(s);
}

std::string full_judgement(const std::vector<Criterion>& criteria, const Sailed& s) {
  auto ordered = criteria;
  std::ranges::stable_sort(ordered, {}, [](const Criterion& c) { return c.pass.value_or(false); });
  std::string words;
  for (const auto& c : ordered) words += (words.empty() ? "" : "; ") + with_limit(c, s);
  return fmt::format("{} {}: {}.{}", s.ship, verdict_words(criteria), words, doubt_words(s));
}

Tone tone_of(const std::vector<Criterion>& criteria, const Sailed& s) {
  if (criteria.empty()) return Tone::neutral;
  if (!count_for(s)) return Tone::look;
  if (!only(criteria, false).empty()) return Tone::bad;
  return only(criteria, std::nullopt).empty() ? Tone::good : Tone::look;
}

std::vector<PageAnswer> answers_of(const std::vector<Criterion>& criteria, const Sailed& s) {
  if (criteria.empty()) return {{"Does she pass?", "MSC.137(76) has no limit for this manoeuvre"}};
  const auto failed = only(criteria, false).size(), passed = only(criteria, true).size(), all = criteria.size();
  std::vector<PageAnswer> answers{{"Does she pass?", fmt::format("{}: she meets {} of {} criteria",
                                                                 failed > 0      ? "No"
                                                                 : passed == all ? "Yes"
                                                                                 : "It cannot be told",
                                                                 passed, all)},
                                  {"By how much?", margin_words(tightest(criteria), s)}};
  if (!count_for(s)) answers.push_back({"Do the criteria count for her?", why_not(s)});
  return answers;
}

}  // namespace swayaw::app
