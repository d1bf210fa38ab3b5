#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "on_board_case.hpp"
#include "score.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects.hpp"

namespace swayaw::concealed {
namespace {

using Names = std::vector<std::string>;

// ---------------------------------------------------------------- marks

/// How well an answer names what is there.
struct Mark {
  bool found;    ///< something was said to be missing
  bool first;    ///< the first name is right; nothing where nothing is
  bool third;    ///< the right name is among three
  bool covered;  ///< the right name is the first or one that the answer cannot tell from it
  bool all;      ///< every effect is named
};

Names truth_of(const Json& line) {
  Names names;
  for (const auto& e : line.at("effects")) names.push_back(e.at("effect"));
  return names;
}

bool is_unknown(const Names& truth) { return !truth.empty() && truth.front().starts_with("unknown"); }

bool any_of_in(const Names& truth, const Names& names, std::size_t most) {
  return std::any_of(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())),
                     [&](const auto& n) { return std::ranges::count(truth, n) > 0; });
}

/// @param unexplained  the answer says that something is there which it does not know
Mark mark(const Names& truth, const Names& effects, Names ranking, const Names& same, bool unexplained) {
  const bool found = unexplained || !effects.empty();
  if (truth.empty()) return {found, !found, !found, !found, !found};
  if (is_unknown(truth)) {
    const bool right = unexplained || (!effects.empty() && effects.front() == "unknown");
    return {found, right, right || std::ranges::count(ranking, "unknown") > 0, right, right};
  }
  ranking.insert(ranking.begin(), effects.begin(), effects.end());
  Names three;
  for (const auto& n : ranking)
    if (std::ranges::count(three, n) == 0) three.push_back(n);
  const bool first = any_of_in(truth, effects, 1), covered = first || (found && any_of_in(truth, same, same.size()));
  return {found, first, found && any_of_in(truth, three, 3), covered,
          std::ranges::all_of(truth, [&](const auto& n) { return std::ranges::count(effects, n) > 0; })};
}

Mark mark_of(const Json& line) {
  const auto& a = line.at("answer");
  Names effects, ranking, same;
  for (const auto& e : a.at("effects")) {
    if (effects.empty()) same = e.at("indistinguishable_from").get<Names>();
    effects.push_back(e.at("effect"));
  }
  for (const auto& c : a.at("candidates")) ranking.push_back(c.at("effect"));
  return mark(truth_of(line), effects, ranking, same, a.at("verdict") == "unexplained");
}

Mark mark_of_rival(const Json& line, const std::string& rival) {
  const auto names = line.at("rivals").at(rival).get<Names>();
  return mark(truth_of(line), names.empty() ? Names{} : Names{names.front()}, names, {}, false);
}

// ---------------------------------------------------------------- numbers

struct NumberErrors {
  std::vector<double> errors;  ///< relative; of directions in radians
  int inside = 0;              ///< of the 95 % intervals
};

bool is_direction(const std::string& key) { return key.ends_with("from_rad") || key.ends_with("to_rad"); }

void add_numbers(const Json& line, NumberErrors& all) {
  for (const auto& truth : line.at("effects"))
    for (const auto& found : line.at("answer").at("effects")) {
      const auto& parameters = truth.at("parameters");
      if (found.at("effect") != truth.at("effect") ||
          (parameters.contains("channel") && parameters["channel"] != found.value("channel", "")))
        continue;
      for (const auto& [key, value] : parameters.items()) {
        if (!value.is_number() || !found.at("parameters").contains(key) || found["parameters"][key][0].is_null())
          continue;
        const double t = value.get<double>(), v = found["parameters"][key][0].get<double>(),
                     s = found["parameters"][key][1].get<double>();
        const double off = is_direction(key) ? wrapped(v - t) : v - t;
        all.errors.push_back(is_direction(key) ? std::abs(off) : std::abs(off / t));
        all.inside += std::abs(off) <= 1.96 * s;
      }
    }
}

void add_onset(const Json& line, std::vector<double>& errors) {
  for (const auto& truth : line.at("effects"))
    for (const auto& found : line.at("answer").at("effects"))
      if (found.at("effect") == truth.at("effect") && truth.at("parameters").contains("onset_s") &&
          !found.at("onset_s").is_null())
        errors.push_back(std::abs(found["onset_s"].get<double>() - truth["parameters"]["onset_s"].get<double>()) /
                         line.at("time_unit_s").get<double>());
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

// ---------------------------------------------------------------- groups of cases

/// Whether all that is hidden is in what was recorded: the ship moves as her model does.
bool is_of_instrument(const Json& line) {
  const auto names = truth_of(line);
  return !names.empty() && std::ranges::all_of(names, [](const std::string& name) {
    const auto effect = effect_named(name);
    return effect && place_of(*effect) == EffectPlace::sensor;
  });
}

struct Group {
  int cases = 0, found = 0, first = 0, third = 0, covered = 0, all = 0;
  NumberErrors parameters;
  std::vector<double> ratios, onsets;

  void add(const Mark& m) {
    ++cases, found += m.found, first += m.first, third += m.third, covered += m.covered, all += m.all;
  }
  void add(const Json& line) {
    add(mark_of(line));
    add_numbers(line, parameters);
    add_onset(line, onsets);
    const auto& ratio = line.at("answer").at("holdout_ratio");
    const bool runs_away = line["answer"].value("runs_away", false);
    if ((runs_away || !ratio.is_null()) && !line["answer"]["effects"].empty() && !is_of_instrument(line))
      ratios.push_back(runs_away ? HUGE_VAL : ratio.get<double>());
  }
};

std::string share(int part, int whole) {
  return whole ? fmt::format("{}/{} ({:.0f} %)", part, whole, 100.0 * part / whole) : "–";
}
std::string per_cent(std::optional<double> x) { return x ? fmt::format("{:.0f} %", 100.0 * *x) : "–"; }
std::string plain(std::optional<double> x) { return x ? fmt::format("{:.2f}", *x) : "–"; }
std::string inside(const NumberErrors& n) { return share(n.inside, static_cast<int>(n.errors.size())); }

std::string row(const std::string& name, const Group& g) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, g.cases, share(g.found, g.cases),
                     share(g.first, g.cases), share(g.third, g.cases), share(g.covered, g.cases),
                     per_cent(median(g.parameters.errors)), inside(g.parameters), plain(median(g.ratios)));
}

std::string head(const std::string& name) {
  return fmt::format(
      "| {} | cases | detected | first | among three | class | median error of numbers | in 95 % interval | held-out "
      "ratio |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | "
      "---: | ---: |\n",
      name);
}

using Lines = std::vector<const Json*>;

Lines where(const std::vector<Json>& lines, auto&& wanted) {
  Lines kept;
  for (const auto& line : lines)
    if (line.contains("answer") && wanted(truth_of(line))) kept.push_back(&line);
  return kept;
}

bool is_single(const Names& t) { return t.size() == 1 && !is_unknown(t); }

/// Groups by a name of each case, the worst first.
std::string grouped(const std::string& title, const Lines& lines, auto&& name_of) {
  std::map<std::string, Group> groups;
  for (const auto* line : lines) groups[name_of(*line)].add(*line);
  std::vector<std::pair<std::string, Group>> sorted(groups.begin(), groups.end());
  std::ranges::stable_sort(sorted, {}, [](const auto& g) {
    return std::pair(static_cast<double>(g.second.first) / g.second.cases,
                     static_cast<double>(g.second.covered) / g.second.cases);
  });
  std::string text = head(title);
  for (const auto& [name, group] : sorted) text += row(name, group);
  return text;
}

bool is_on_board(const Json& line) { return line.contains("form"); }

std::string factor(const Json& line, const std::string& name) {
  if (name == "noise") return fmt::format("noise x{:g}", line.at("noise").get<double>());
  if (name == "set") return "set " + line.at("set").get<std::string>();
  if (name == "reference") return line.value("reference", false) ? "with reference" : "without reference";
  if (name == "baseline") return line.at("baseline_error").get<double>() > 0.0 ? "baseline wrong" : "baseline right";
  if (name == "form") return "file in form " + line.at("form").get<std::string>();
  if (name == "sway") return "sway: " + line.at("instruments").at("drift").get<std::string>();
  if (name == "filter") return "filter: " + line.at("instruments").at("filter").get<std::string>();
  if (name == "clock")
    return line.at("instruments").at("clock") == 0.0 ? "positions in time" : "positions late or early";
  if (name == "sea") return line.value("sea", Json()).is_null() ? "calm water" : "in waves";
  if (name == "gyro") return line.at("instruments").at("gyro") ? "yaw rate of a gyro" : "yaw rate from headings";
  return line.contains("ship") ? line.at("ship") : line.at("family");
}

/// What cases differ in besides what is hidden.
std::vector<std::string> factors_of(const Json& line) {
  if (is_on_board(line)) return {"ship", "form", "reference", "sway", "gyro", "filter", "clock", "sea"};
  return {"noise", "set", "reference", "baseline", "ship"};
}

// ---------------------------------------------------------------- tables

std::string overview(const std::vector<Json>& lines) {
  const auto none = where(lines, [](const Names&t) { return t.empty(); }), some = where(lines, is_single),
             two = where(lines, [](const Names&t) { return t.size() > 1; });
  const auto strange = where(lines, is_unknown);
  Group alarms, singles, pairs, unknown;
  for (const auto* line : none) alarms.add(*line);
  for (const auto* line : some) singles.add(*line);
  for (const auto* line : two) pairs.add(*line);
  int misnamed = 0;
  for (const auto* line : strange) {
    unknown.add(*line);
    const auto& a = line->at("answer");
    misnamed += a.at("verdict") == "missing_physics" && !a["effects"].empty() &&
                a["effects"][0].at("probability").get<double>() > 0.8;
  }
  std::string text = "| what | found | wanted |\n| --- | ---: | ---: |\n";
  const auto line = [&](const char* what, const std::string& found, const char* wanted) {
    text += fmt::format("| {} | {} | {} |\n", what, found, wanted);
  };
  line("cases: nothing hidden, one effect, two, unknown",
       fmt::format("{}, {}, {}, {}", none.size(), some.size(), two.size(), strange.size()), "");
  line("false alarms", share(alarms.found, alarms.cases), "≤ 2 %");
  line("one effect: detected", share(singles.found, singles.cases), "");
  line("one effect: named first", share(singles.first, singles.cases), "");
  line("one effect: among three", share(singles.third, singles.cases), "");
  line("one effect: in the class of the first", share(singles.covered, singles.cases), "");
  line("named first, of those detected", share(singles.first, singles.found), "≥ 85 % with reference, 70 % without");
  line("both of two effects", share(pairs.all, pairs.cases), "≥ 75 %");
  line("one of two effects first", share(pairs.first, pairs.cases), "");
  line("unknown, not misnamed with more than 0.8", share(unknown.cases - misnamed, unknown.cases), "≥ 70 %");
  line("unknown, called unknown", share(unknown.first, unknown.cases), "");
  line("median error of numbers", per_cent(median(singles.parameters.errors)), "≤ 15 %");
  line("numbers in their 95 % interval", inside(singles.parameters), "90–99 %");
  line("median error of the onset of a gust [L/U]", plain(median(singles.onsets)), "≤ 1");
  line("median held-out ratio to the refitted baseline, effects of instruments left out", plain(median(singles.ratios)),
       "≤ 0.65");
  return text;
}

std::string alarms(const std::vector<Json>& lines) {
  std::map<std::string, std::pair<int, int>> groups;
  std::map<std::string, int> blamed;
  for (const auto* line : where(lines, [](const Names& t) { return t.empty(); })) {
    const auto& a = line->at("answer");
    const bool alarm = mark_of(*line).found;
    for (const auto& name : factors_of(*line))
      ++groups[factor(*line, name)].second, groups[factor(*line, name)].first += alarm;
    if (alarm)
      ++blamed[a.at("effects").empty() ? a.at("verdict").get<std::string>()
                                       : a["effects"][0].at("effect").get<std::string>()];
  }
  std::string text = "| cases with nothing hidden | false alarms |\n| --- | ---: |\n";
  for (const auto& [name, g] : groups) text += fmt::format("| {} | {} |\n", name, share(g.first, g.second));
  text += "\n| blamed | times |\n| --- | ---: |\n";
  for (const auto& [name, times] : blamed) text += fmt::format("| {} | {} |\n", name, times);
  return text;
}

std::string by_factor(const std::vector<Json>& lines) {
  const auto singles = where(lines, is_single);
  std::string text = head("one effect hidden");
  const auto level = [](const Json& line) { return line.at("effects")[0].at("level").get<std::string>(); };
  std::map<std::string, Group> levels;
  for (const auto* line : singles) levels[level(*line)].add(*line);
  for (const auto& [name, group] : levels) text += row(name, group);
  for (const auto& name : singles.empty() ? std::vector<std::string>{} : factors_of(*singles.front())) {
    std::map<std::string, Group> groups;
    for (const auto* line : singles) groups[factor(*line, name)].add(*line);
    for (const auto& [value, group] : groups) text += row(value, group);
  }
  return text;
}

std::string confusions(const std::vector<Json>& lines) {
  std::map<std::pair<std::string, std::string>, int> times;
  for (const auto& line : lines) {
    const auto truth = truth_of(line);
    if (!line.contains("answer") || mark_of(line).first) continue;
    const auto& a = line["answer"];
    ++times[{truth.empty() ? "none" : fmt::format("{}", fmt::join(truth, " + ")),
             a.at("effects").empty() ? a.at("verdict").get<std::string>()
                                     : a["effects"][0].at("effect").get<std::string>()}];
  }
  std::vector<std::pair<std::pair<std::string, std::string>, int>> sorted(times.begin(), times.end());
  std::ranges::stable_sort(sorted, std::greater{}, [](const auto& t) { return t.second; });
  std::string text = "| hidden | answered | times |\n| --- | --- | ---: |\n";
  for (const auto& [names, n] : sorted) text += fmt::format("| {} | {} | {} |\n", names.first, names.second, n);
  return text;
}

/// Probabilities that were said, in bins of the same width, beside how often they were right.
struct Reliability {
  struct Bin {
    int cases = 0, right = 0;
    double sum = 0.0;
  };
  std::vector<Bin> bins;
  double error = 0.0;  ///< expected calibration error: mean over the cases of |mean probability − share that is right|
};

/// The probability of the first effect where one is named, else that of nothing.
double probability_said(const Json& answer) {
  if (!answer.at("effects").empty()) return answer["effects"][0].at("probability").get<double>();
  double p = 1.0;
  for (const auto& c : answer.at("candidates"))
    p -= c.at("probability").is_null() ? 0.0 : c["probability"].get<double>();
  return p;
}

Reliability reliability(const std::vector<Json>& lines, std::size_t bins) {
  Reliability r{.bins = std::vector<Reliability::Bin>(bins)};
  int cases = 0;
  const double width = static_cast<double>(bins);
  for (const auto& line : lines) {
    if (!line.contains("answer") || line["answer"].at("verdict") == "failed") continue;
    const double p = probability_said(line["answer"]);
    auto& bin = r.bins[static_cast<std::size_t>(std::clamp(p * width, 0.0, width - 1.0))];
    ++bin.cases, ++cases, bin.sum += p, bin.right += mark_of(line).covered;
  }
  for (const auto& b : r.bins)
    if (b.cases > 0) r.error += std::abs(b.sum - b.right) / cases;
  return r;
}

std::string calibration(const std::vector<Json>& lines, std::size_t bins) {
  const auto r = reliability(lines, bins);
  std::string text = "| said | cases | mean probability | right |\n| --- | ---: | ---: | ---: |\n";
  const double width = 1.0 / static_cast<double>(bins);
  for (std::size_t i = 0; i < bins; ++i)
    if (const auto& b = r.bins[i]; b.cases > 0)
      text += fmt::format("| {:.1f} to {:.1f} | {} | {:.3f} | {} |\n", width * static_cast<double>(i),
                          width * static_cast<double>(i + 1), b.cases, b.sum / b.cases, share(b.right, b.cases));
  return text + fmt::format("\nExpected calibration error {:.3f} (wanted: at most 0.10).\n", r.error);
}

std::string rivals(const std::vector<Json>& lines) {
  std::string text =
      "| answer | false alarms | detected | first | among three | class | both of two | unknown called unknown |\n| "
      "--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const std::string who : {"diagnose", "nothing", "random", "ols_bic", "sparse", "pooled"}) {
    Group none, single, two, unknown;
    for (const auto& line : lines) {
      if (who == "diagnose" ? !line.contains("answer") : !line.at("rivals").contains(who)) continue;
      const auto truth = truth_of(line);
      (truth.empty()       ? none
       : is_unknown(truth) ? unknown
       : truth.size() > 1  ? two
                           : single)
          .add(who == "diagnose" ? mark_of(line) : mark_of_rival(line, who));
    }
    if (none.cases + single.cases + two.cases + unknown.cases == 0) continue;
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", who, share(none.found, none.cases),
                        share(single.found, single.cases), share(single.first, single.cases),
                        share(single.third, single.cases), share(single.covered, single.cases),
                        share(two.all, two.cases), share(unknown.first, unknown.cases));
  }
  return text;
}

// ---------------------------------------------------------------- on board

constexpr std::size_t bins_on_board = 10;

bool is_misnamed(const Json& line) {
  const auto& a = line.at("answer");
  return a.at("verdict") == "missing_physics" && !a["effects"].empty() && a["effects"][0].at("effect") != "unknown" &&
         a["effects"][0].at("probability").get<double>() > 0.8;
}

Group group_of(const Lines& lines) {
  Group group;
  for (const auto* line : lines) group.add(*line);
  return group;
}

/// Whether each of what is hidden, told to the file beside the rest, improves replays of the runs held out by 10 %.
bool truth_helps(const Json* line) {
  return std::ranges::all_of(line->at("effects"),
                             [](const Json& e) { return e.value("replay_gain", 0.0) >= noticeable; });
}

std::string overview_on_board(const std::vector<Json>& lines) {
  const auto none = where(lines, [](const Names&t) { return t.empty(); }), one = where(lines, is_single),
             two = where(lines, [](const Names&t) { return t.size() > 1; }), strange = where(lines, is_unknown);
  Lines strong, moderate;
  for (const auto* line : one) (line->at("effects")[0].at("level") == "strong" ? strong : moderate).push_back(line);
  Group known;
  std::vector<double> work;
  int failed = 0, away = 0;
  for (const auto& line : lines) {
    if (!line.contains("answer")) continue;
    if (line.contains("seconds")) work.push_back(line["seconds"].get<double>());
    failed += line["answer"].at("verdict") == "failed";
    away += line["answer"].value("runs_away", false);
    if (!truth_of(line).empty() && !is_unknown(truth_of(line))) known.add(line);
  }
  const auto helped = [](Lines some) {
    std::erase_if(some, std::not_fn(truth_helps));
    return group_of(some);
  };
  const auto s = group_of(strong), m = group_of(moderate), pairs = group_of(two), alarms = group_of(none),
             unknown = group_of(strange), s_helped = helped(strong), m_helped = helped(moderate),
             pairs_helped = helped(two);
  const int misnamed = static_cast<int>(std::ranges::count_if(strange, [](const Json* l) { return is_misnamed(*l); }));
  std::string text = "| what | found |\n| --- | ---: |\n";
  const auto add = [&](const char* what, const std::string& found) {
    text += fmt::format("| {} | {} |\n", what, found);
  };
  add("cases: nothing hidden, one strong effect, one moderate, two, unknown",
      fmt::format("{}, {}, {}, {}, {}", none.size(), strong.size(), moderate.size(), two.size(), strange.size()));
  add("false alarms with nothing hidden", share(alarms.found, alarms.cases));
  add("strong: named first", share(s.first, s.cases));
  add("moderate: named first", share(m.first, m.cases));
  add("strong or moderate: something detected", share(s.found + m.found, s.cases + m.cases));
  add("strong or moderate: among three", share(s.third + m.third, s.cases + m.cases));
  add("two effects: one of them first", share(pairs.first, pairs.cases));
  add("two effects: both", share(pairs.all, pairs.cases));
  add("the same where the truth improves replays by the file by 10 %: strong", share(s_helped.first, s_helped.cases));
  add("… moderate", share(m_helped.first, m_helped.cases));
  add("… two effects, each beside the other: both", share(pairs_helped.all, pairs_helped.cases));
  add("unknown: called unknown or unexplained", share(unknown.first, unknown.cases));
  add("unknown: misnamed with more than 0.8", share(misnamed, unknown.cases));
  add("without an answer", share(failed, static_cast<int>(work.size())));
  add("without a ship that can sail the runs held out", share(away, static_cast<int>(work.size())));
  add("median error of numbers", per_cent(median(known.parameters.errors)));
  add("numbers in their 95 % interval", inside(known.parameters));
  add("median held-out ratio to the refitted baseline, effects of instruments left out", plain(median(known.ratios)));
  add("expected calibration error, ten bins", fmt::format("{:.3f}", reliability(lines, bins_on_board).error));
  if (!work.empty())
    add("work of one core for a case: median, most [s]",
        fmt::format("{:.1f}, {:.1f}", *median(work), *std::ranges::max_element(work)));
  return text;
}

/// Every case with its answer.
std::string cases_on_board(const std::vector<Json>& lines) {
  std::string text =
      "| case | ship | file | hidden (detectability) | answered (probability) |\n| --- | --- | --- | --- | --- |\n";
  for (const auto& line : lines) {
    if (!line.contains("answer")) continue;
    std::vector<std::string> hidden, found;
    for (const auto& e : line.at("effects"))
      hidden.push_back(fmt::format("{} ({:.2f})", e.at("effect").get<std::string>(), e.value("detectability", 0.0)));
    for (const auto& e : line["answer"].at("effects"))
      found.push_back(fmt::format("{} ({:.2f})", e.at("effect").get<std::string>(), e.at("probability").get<double>()));
    text += fmt::format(
        "| {}{} | {} | {} | {} | {} |\n", hidden.empty() ? "clean " : "", line.at("case").get<std::string>(),
        line.at("family").get<std::string>(), line.at("form").get<std::string>(),
        hidden.empty() ? "–" : fmt::format("{}", fmt::join(hidden, ", ")),
        found.empty() ? line["answer"].at("verdict").get<std::string>() : fmt::format("{}", fmt::join(found, ", ")));
  }
  return text;
}

/// Answers without what the ship has and her file cannot, hidden or not: to name it is right, and no answer to the
/// question.
std::vector<Json> without_native(std::vector<Json> lines) {
  const auto is_native = [](const Json& name) { return name == "roll_coupling"; };
  const auto is_native_entry = [&](const Json& entry) { return is_native(entry.at("effect")); };
  for (auto& line : lines) {
    if (line.value("family", "") != "rolling") continue;
    if (line.contains("answer"))
      for (const char* list : {"effects", "candidates"}) {
        auto& entries = line["answer"].at(list).get_ref<Json::array_t&>();
        std::erase_if(entries, is_native_entry);
      }
    for (auto& names : line.at("rivals")) std::erase_if(names.get_ref<Json::array_t&>(), is_native);
  }
  return lines;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> tables_of(const std::vector<Json>& answers) {
  const auto lines = without_native(answers);
  const auto first_effect = [](const Json& line) { return line.at("effects")[0].at("effect").get<std::string>(); };
  const bool on_board = !lines.empty() && std::ranges::all_of(lines, is_on_board);
  std::vector<std::pair<std::string, std::string>> tables{
      {"overview", on_board ? overview_on_board(lines) : overview(lines)},
      {"effects", grouped("hidden", where(lines, is_single), first_effect)},
      {"unknown", grouped("hidden", where(lines, is_unknown), first_effect)},
      {"factors", by_factor(lines)},
      {"alarms", alarms(lines)},
      {"confusions", confusions(lines)},
      {"calibration", calibration(lines, on_board ? bins_on_board : 5)},
      {"rivals", rivals(lines)}};
  if (on_board) tables.emplace_back("cases", cases_on_board(lines));
  return tables;
}

}  // namespace swayaw::concealed
