#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "progress.hpp"
#include "sentences.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/identification/index_tuning.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "terminal.hpp"
#include "tune_page.hpp"

namespace swayaw::app {
namespace {

struct Findings {
  MeasuredIndices measured;
  std::vector<Parameter> parameters;
  IndexSensitivity sensitivity;
  std::vector<double> relative;  ///< singular values of d (I/I_measured) / d ln number
  Tuning tuning;
};

/// Singular values of d (I/I_measured) / d ln number.
std::vector<double> singular_values(const IndexSensitivity& s, const MeasuredIndices& measured) {
  std::vector<double> unit, values;
  for (const auto& trial : measured.trials)
    for (const auto& i : trial.indices) unit.push_back(std::abs(i.value / s.indices[unit.size()]));
  for (const auto& c : determined_combinations(s.exact, unit)) values.push_back(c.singular_value);
  return values;
}

std::size_t determined(const Tuning& t) {
  return static_cast<std::size_t>(std::ranges::count(t.combinations, true, &IndexCombination::determined));
}

// ---------------------------------------------------------------- JSON

Json change_json(double before, double after) { return {{"before", number(before)}, {"after", number(after)}}; }

Json numbers_json(const Tuning& t) {
  Json list = Json::array();
  for (const auto& n : t.parameters)
    list.push_back({{"name", n.number.name},
                    {"before", number(n.number.value / n.number.si)},
                    {"after", number(n.value / n.number.si)},
                    {"relative_change", number(n.value / n.number.value - 1.0)},
                    {"prior", number(n.prior)},
                    {"standard_error", number(n.deviation)},
                    {"told", number(n.told)},
                    {"determined", n.determined()},
                    {"at_bound", n.at_bound}});
  return list;
}

Json indices_json(const Findings& f) {
  Json list = Json::array();
  for (const auto& i : f.tuning.indices) {
    const double si = i.measured.si;
    list.push_back({{"manoeuvre", name_of(f.measured.trials[i.trial].manoeuvre)},
                    {"index", i.measured.name},
                    {"measured", number(i.measured.value / si)},
                    {"sd", number(i.measured.deviation / si)},
                    {"before", number(i.before / si)},
                    {"after", number(i.after / si)}});
  }
  return list;
}

Json combinations_json(const Findings& f) {
  Json list = Json::array();
  for (const auto& c : f.tuning.combinations) {
    Json weights = Json::object();
    for (std::size_t j = 0; j < c.weights.size(); ++j) weights[f.parameters[j].name] = number(c.weights[j]);
    list.push_back({{"singular_value", number(c.singular_value)},
                    {"standard_error", number(c.standard_error)},
                    {"determined", c.determined},
                    {"weights", weights}});
  }
  return list;
}

Json table_json(const std::vector<std::vector<double>>& rows) {
  Json table = Json::array();
  for (const auto& row : rows) table.push_back(swayaw::app::parameters(row));
  return table;
}

Json sensitivity_json(const Findings& f) {
  Json names = Json::array();
  for (const auto& n : f.parameters) names.push_back(n.name);
  return {{"numbers", names},
          {"ten_per_cent", table_json(f.sensitivity.ten_per_cent)},
          {"exact", table_json(f.sensitivity.exact)}};
}

Json tune_json(const Findings& f, const TuneArguments& a) {
  const auto& t = f.tuning;
  return {{"schema", "swayaw.tuning/1"},
          {"ship", t.ship.name},
          {"out", a.out.string()},
          {"status", in_words(t.status)},
          {"error",
           {{"turns", change_json(t.before.turns, t.after.turns)},
            {"zigzags", change_json(t.before.zigzags, t.after.zigzags)}}},
          {"voyages", {{"turns", t.simulations.turns}, {"zigzags", t.simulations.zigzags}}},
          {"numbers", numbers_json(t)},
          {"indices", indices_json(f)},
          {"decay_per_length", swayaw::app::parameters(t.decay)},
          {"determined_combinations", determined(t)},
          {"combinations", combinations_json(f)},
          {"relative_singular_values", swayaw::app::parameters(f.relative)},
          {"sensitivity", sensitivity_json(f)}};
}

// ---------------------------------------------------------------- text

/// Largest sensitivity of a number to the indices of a manoeuvre.
double largest(const Findings& f, std::size_t j, std::size_t first, std::size_t last) {
  double size = 0.0;
  for (std::size_t k = first; k < last; ++k) size = std::max(size, std::abs(f.sensitivity.exact[k][j]));
  return size;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Names as headings of columns, in as many lines as they need.
void print_headings(const std::vector<MeasuredIndex>& indices) {
  constexpr int width = 10;
  std::vector<std::vector<std::string>> headings;
  for (const auto& i : indices) headings.push_back(lines_of(folded(in_words(i.name), width)));
  std::size_t most = 0;
  for (const auto& lines : headings) most = std::max(most, lines.size());
  for (std::size_t row = 0; row < most; ++row) {
    say("  {:<12}", "");
    for (const auto& lines : headings) say("{:>11}", row < lines.size() ? lines[row] : "");
    say("\n");
  }
}

/// The parameters, those that do most first.
void print_sensitivity(const Findings& f, const MeasuredTrial& trial, std::size_t first) {
  const std::size_t last = first + trial.indices.size();
  say("\n{}: change in per cent for one per cent more of a number\n", name_of(trial.manoeuvre));
  print_headings(trial.indices);
  std::vector<std::size_t> order(f.parameters.size());
  for (std::size_t j = 0; j < order.size(); ++j) order[j] = j;
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t j) { return largest(f, j, first, last); });
  for (const std::size_t j : order) {
    say("  {:<12}", f.parameters[j].name);
    for (std::size_t k = first; k < last; ++k) say("{:>11.3f}", f.sensitivity.exact[k][j]);
    say("\n");
  }
}

void print_indices(const Findings& f) {
  std::size_t trial = f.measured.trials.size();
  for (const auto& i : f.tuning.indices) {
    if (i.trial != trial)
      say("\n{}\n  {:<28}{:>12}{:>10}{:>12}{:>12}\n", name_of(f.measured.trials[i.trial].manoeuvre), "", "measured",
          "sd", "before", "after");
    trial = i.trial;
    const double si = i.measured.si;
    say("  {:<28}{:>12.5g}{:>10.3g}{:>12.5g}{:>12.5g}\n", i.measured.name, i.measured.value / si,
        i.measured.deviation / si, i.before / si, i.after / si);
  }
}

void print_numbers(const Tuning& t) {
  say("\n  {:<14}{:>12}{:>12}{:>10}{:>11}{:>10}{:>8}\n", "number", "before", "after", "change %", "prior sd %",
      "sd now %", "told %");
  for (const auto& n : t.parameters)
    say("  {:<14}{:>12.5g}{:>12.5g}{:>10.1f}{:>11.3g}{:>10.3g}{:>8.0f}{}{}\n", n.number.name,
        n.number.value / n.number.si, n.value / n.number.si, 100.0 * (n.value / n.number.value - 1.0), 100.0 * n.prior,
        100.0 * n.deviation, 100.0 * n.told, n.determined() ? "" : "*", n.at_bound ? "|" : "");
  say("  told: by the indices rather than the prior; * undetermined{}\n",
      std::ranges::any_of(t.parameters, &TunedParameter::at_bound) ? "; | at its bound" : "");
}

/// The parameters with the largest weights.
std::string combination_text(const Findings& f, const IndexCombination& c) {
  std::vector<std::size_t> order(c.weights.size());
  for (std::size_t j = 0; j < order.size(); ++j) order[j] = j;
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t j) { return std::abs(c.weights[j]); });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(4, order.size()); ++i)
    text += fmt::format(" {:+.2f} {}", c.weights[order[i]], f.parameters[order[i]].name);
  return text;
}

void print_combinations(const Findings& f) {
  const auto& t = f.tuning;
  say("\nthe indices determine {} of {} combinations of relative changes to better than a half:\n", determined(t),
      t.combinations.size());
  for (const auto& c : t.combinations) {
    if (!c.determined) break;
    say("  to {:>5.1f} %  {}\n", 100.0 * c.standard_error, combination_text(f, c));
  }
}

void print_text(const Findings& f, const TuneArguments& a) {
  const auto& t = f.tuning;
  say("{}: {} numbers, {} indices\n", t.ship.name, f.parameters.size(), t.indices.size());
  std::size_t first = 0;
  for (const auto& trial : f.measured.trials) {
    print_sensitivity(f, trial, first);
    first += trial.indices.size();
  }
  print_indices(f);
  print_numbers(t);
  print_combinations(f);
  say("\nsum of squared relative errors: turns {:.4f} before, {:.4f} after; zigzags {:.4f} before, {:.4f} after\n",
      t.before.turns, t.after.turns, t.before.zigzags, t.after.zigzags);
  say("{} after {} turning circles and {} zigzags; written to {}\n", in_words(t.status), t.simulations.turns,
      t.simulations.zigzags, a.out.string());
}

// ---------------------------------------------------------------- work

std::string remark(const Tuning& t, const TuneArguments& a) {
  return fmt::format(
      "Made by swayaw {} tune from {} and the indices of {}.\n{} numbers changed; {} after {} turning circles and {} "
      "zigzags.\n"
      "Sum of squared relative errors: turns {:.6g} before, {:.6g} after; zigzags {:.6g} before, {:.6g} after.",
      version(), a.ship.filename().string(), a.indices.filename().string(), t.parameters.size(), in_words(t.status),
      t.simulations.turns, t.simulations.zigzags, t.before.turns, t.after.turns, t.before.zigzags, t.after.zigzags);
}

Tuning tuned(const Ship& ship, const MeasuredIndices& measured, TuningOptions options) {
  const Interrupt interrupt;
  Progress progress("tune");
  const int most_turns = options.most_turns;
  options.watch = [&](const TuningProgress& p) {
    if (const int turns = static_cast<int>(p.simulations.turns); turns > 0 && progress.seconds() > 1.0)
      progress.tell_rest(0.0, (most_turns - turns) * progress.seconds() / turns);
    progress.tell(fmt::format("{} turning circles, {} zigzags, squared errors {:.4f} and {:.4f}", p.simulations.turns,
                              p.simulations.zigzags, p.error.turns, p.error.zigzags));
    return !interrupt.asked();
  };
  return tune(ship, measured, options);
}

}  // namespace

void tune(const TuneArguments& a) {
  const Ship ship = load_nonlinear_ship(a.ship);
  const TuningOptions options{.parameters = a.parameters,
                              .prior = a.prior,
                              .most_change = a.most_change,
                              .most_turns = a.most_turns,
                              .watch = {}};
  auto measured = read_indices(a.indices, length(ship));
  auto parameters = tuned_parameters(ship, options);
  auto tuning = tuned(ship, measured, options);
  write_ship(a.out, tuning.ship, remark(tuning, a));
  if (tuning.status == TuningStatus::interrupted)
    say_aside("swayaw: interrupted; the best ship so far is written to {}\n", a.out.string());
  auto sensitivity = index_sensitivity(ship, measured, parameters);
  auto relative = singular_values(sensitivity, measured);
  const Findings f{std::move(measured), std::move(parameters), std::move(sensitivity), std::move(relative),
                   std::move(tuning)};
  if (a.json) print_document(tune_json(f, a));
  else print_text(f, a);
  if (a.report.wanted()) write_page(a.report.file, html(tune_page(ship, f.measured, f.tuning, a)));
}

}  // namespace swayaw::app
