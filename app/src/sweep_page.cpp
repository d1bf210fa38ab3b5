#include "sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "page_writing.hpp"
#include "plot.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::app {
namespace {

/// Panels and curves of the picture that can still be read.
constexpr std::size_t most_panels = 3, most_curves = 4;

constexpr std::size_t q05 = 1, median = 3, q95 = 5;  // of summary_quantiles
static_assert(summary_quantiles[q05] == 0.05 && summary_quantiles[median] == 0.5 && summary_quantiles[q95] == 0.95);

std::string value_text(double value, const SweepColumn& column) {
  return column.unit == "-" ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, column.unit);
}

std::string range_text(const ColumnSummary& s, const SweepColumn& column) {
  return fmt::format("{:.4g} to {}", s.quantile[q05], value_text(s.quantile[q95], column));
}

/// Parameters of an item in words.
std::string parameters_text(const SweepWork& work, std::size_t item) {
  if (of_recordings(work.plan().task)) return work.name_of(item);
  const auto values = work.parameters_of(item);
  std::string words;
  for (std::size_t d = 0; d < values.size(); ++d)
    words += fmt::format("{}{} = {}", d ? ", " : "", work.columns()[d].name, value_text(values[d], work.columns()[d]));
  return words.empty() ? "the ship as she is" : words;
}

Curve histogram_curve(const ColumnSummary& s, std::string name, const char* colour) {
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .stroke = {.colour = colour}};
  const double width = (s.high - s.low) / static_cast<double>(s.histogram.size());
  for (std::size_t b = 0; b < s.histogram.size(); ++b)
    for (const std::size_t side : {0u, 1u}) {
      curve.x.push_back(s.low + width * static_cast<double>(b + side));
      curve.y.push_back(100.0 * static_cast<double>(s.histogram[b]) / static_cast<double>(s.count));
    }
  return curve;
}

PagePicture picture(const SweepWork& work, const SweepSummary& summary, const UserUnits& units) {
  constexpr std::array<const char*, most_curves> colours{ink::yaw, ink::drift, ink::line, ink::rudder};
  Plot plot{.title = "How often each result comes", .panels = {}};
  const auto& columns = work.columns();
  for (std::size_t c = work.varied(); c < columns.size() && plot.panels.size() < most_panels; ++c) {
    Panel panel{.x = {.quantity = spoken(columns[c]), .unit = columns[c].unit == "-" ? "" : columns[c].unit},
                .y = {.quantity = "Items in a bin", .unit = "%"},
                .curves = {}};
    for (const auto& s : summary.columns)
      if (s.column == c && s.count > 1 && s.high > s.low && panel.curves.size() < most_curves)
        panel.curves.push_back(histogram_curve(s, work.subjects()[s.subject], colours[panel.curves.size()]));
    if (!panel.curves.empty()) plot.panels.push_back(std::move(panel));
  }
  if (plot.panels.empty()) return {.words = "no result varies", .svg = {}, .caption = "No result varies."};
  return picture_of(std::move(plot), "Histograms of the results, one line for each ship",
                    "Share of the items in each of 40 equal bins between the least and the largest.", units);
}

PageTable results_table(const SweepWork& work, const SweepSummary& summary) {
  PageTable table{.caption = "Results",
                  .columns = {"Ship", "Result", "Median", "90 % of the items", "Least", "Largest", "Without"},
                  .rows = {}};
  for (const auto& s : summary.columns) {
    if (s.column < work.varied()) continue;
    const auto& column = work.columns()[s.column];
    std::vector<PageCell> row{work.subjects()[s.subject], spoken(column)};
    if (s.count == 0) row.insert(row.end(), {"-", "-", "-", "-"});
    else
      for (const auto& text : {value_text(s.quantile[median], column), range_text(s, column), value_text(s.low, column),
                               value_text(s.high, column)})
        row.emplace_back(text);
    row.emplace_back(fmt::format("{}", s.missing), s.missing > 0 ? Tone::look : Tone::neutral);
    table.rows.push_back(std::move(row));
  }
  return table;
}

PageTable sobol_table(const SweepWork& work, const SweepSummary& summary) {
  PageTable table{.caption = "Share of the variance of a result that a parameter makes, %",
                  .columns = {"Ship", "Result", "Parameter", "Alone", "95 %", "With all others", "95 %"},
                  .rows = {}};
  const auto percent = [](double x) { return fmt::format("{:.1f}", 100.0 * x); };
  const auto interval = [&](double low, double high) { return percent(low) + " to " + percent(high); };
  for (const auto& s : summary.sobol)
    table.rows.push_back({work.subjects()[s.subject], spoken(work.columns()[s.result]),
                          work.columns()[s.parameter].name, percent(s.first), interval(s.first_low, s.first_high),
                          percent(s.total), interval(s.total_low, s.total_high)});
  return table;
}

PageTable extremes_table(const SweepWork& work, const SweepSummary& summary) {
  PageTable table{.caption = "Largest and least", .columns = {"Result", "Item", "Value", "Parameters"}, .rows = {}};
  for (const auto& s : summary.columns) {
    if (s.column < work.varied()) continue;
    for (const auto* list : {&s.highest, &s.lowest})
      for (const auto& [item, value] : *list)
        table.rows.push_back({spoken(work.columns()[s.column]), fmt::format("{}", item),
                              value_text(value, work.columns()[s.column]), parameters_text(work, item)});
  }
  return table;
}

/// The result that is told first: the first of the first ship that any item has.
const ColumnSummary* first_result(const SweepWork& work, const SweepSummary& summary) {
  const auto found = std::ranges::find_if(
      summary.columns, [&](const ColumnSummary& s) { return s.column >= work.varied() && s.count > 0; });
  return found == summary.columns.end() ? nullptr : &*found;
}

std::string matters_text(const SweepWork& work, const SweepSummary& summary, const ColumnSummary& first) {
  if (summary.sobol.empty())
    return "A plan with design = \"sobol\" and pairs = 1000 says how much of the spread each parameter makes.";
  const SobolIndex* most = nullptr;
  for (const auto& s : summary.sobol)
    if (s.subject == first.subject && s.result == first.column && (!most || s.total > most->total)) most = &s;
  if (!most) return "The results do not vary.";
  return fmt::format("{} makes {:.0f} % ({:.0f} to {:.0f} %) of the variance of the {}.",
                     work.columns()[most->parameter].name, 100.0 * most->total, 100.0 * most->total_low,
                     100.0 * most->total_high, spoken(work.columns()[first.column]));
}

/// "nothing_missing 5, missing_physics 3"
std::string counts_text(const WordCounts& counts) {
  std::string words;
  for (const auto& [word, count] : counts)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", word == "-" ? "nothing" : word, count);
  return words;
}

PageTable notes_table(const SweepWork& work, const Swept& swept) {
  PageTable table{
      .caption = "The first items that have no result, or less", .columns = {"Item", "Name", "Why"}, .rows = {}};
  for (const auto& [item, text] : swept.notes)
    table.rows.push_back({fmt::format("{}", item), work.name_of(item), text});
  return table;
}

}  // namespace

std::string spoken(const SweepColumn& column) {
  std::string words = column.name;
  if (const auto unit = "_" + column.unit; column.unit == "deg" || column.unit == "s" || column.unit == "m")
    if (words.ends_with(unit)) words.resize(words.size() - unit.size());
  for (const std::string_view end : {"_m_s", "_deg_s"})
    if (words.ends_with(end)) words.resize(words.size() - end.size());
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string task_words(const SweepPlan& plan) {
  switch (plan.task) {
    case SweepTask::zigzag: return fmt::format("zigzag {:.6g}/{:.6g}", degrees(plan.rudder), degrees(plan.heading));
    case SweepTask::turn: return fmt::format("turn {:.6g}", degrees(plan.rudder));
    case SweepTask::indices: return "indices";
    case SweepTask::trial: return "trial";
    case SweepTask::identify: return "identify " + plan.model;
    case SweepTask::diagnose: return "diagnose";
  }
  return {};
}

Page sweep_page(const SweepWork& work, const Swept& swept, const std::filesystem::path& results,
                const UserUnits& units) {
  const auto& plan = work.plan();
  const auto& summary = swept.summary;
  const bool recordings = of_recordings(plan.task);
  Page page{.kicker = "Sweep", .title = plan.file.filename().string(), .headline = {}};
  const auto* first = first_result(work, summary);
  if (!swept.verdicts.empty()) {
    page.headline = fmt::format("{} diagnoses: {}.", swept.count.done, counts_text(swept.verdicts));
    page.answers.push_back({"What is named first?", counts_text(swept.first_effects) + "."});
  } else if (first) {
    page.headline = fmt::format("{}, {} items: in nine of ten the {} {} {}.", task_words(plan), swept.count.done,
                                spoken(work.columns()[first->column]),
                                recordings ? "is" : "of " + work.subjects()[first->subject] + " is",
                                range_text(*first, work.columns()[first->column]));
  } else {
    page.headline = fmt::format("None of {} items has a result.", swept.count.done);
    page.tone = Tone::bad;
  }
  if (first) {
    const auto& column = work.columns()[first->column];
    const auto& worst = first->highest.front();
    page.answers.push_back({fmt::format("Where is the {} largest?", spoken(column)),
                            fmt::format("{}, item {}: {}.", value_text(worst.value, column), worst.item,
                                        parameters_text(work, worst.item))});
    if (!recordings) page.answers.push_back({"What matters most?", matters_text(work, summary, *first)});
  }
  page.answers.push_back({"Is anything left out?",
                          swept.note_count == 0 ? "No item failed."
                                                : fmt::format("{} items have no result, or less; the first are told "
                                                              "below.",
                                                              swept.note_count)});
  page.answers.push_back(
      {"What next?", fmt::format("All items are in {}: docs/sweep.md shows how to read them.", results.string())});
  page.picture = picture(work, summary, units);
  page.table = results_table(work, summary);
  if (!summary.sobol.empty())
    page.sections.push_back({.title = "What matters", .tables = {sobol_table(work, summary)}});
  page.sections.push_back({.title = "The extremes", .tables = {extremes_table(work, summary)}});
  if (!swept.notes.empty())
    page.sections.push_back({.title = "Without a result", .tables = {notes_table(work, swept)}});
  page.sections.push_back({.title = "The plan", .words = {plan.text}});
  if (!recordings) {
    page.assumed.push_back("Parameters that vary are drawn independently of each other.");
    page.assumed.push_back("Every ship gets the same draws, so that ships can be compared item by item.");
  }
  page.footnotes.push_back(
      fmt::format("{} of {} items, {:.3g} s. {}", swept.count.done, swept.count.all, swept.seconds, made_by()));
  return page;
}

}  // namespace swayaw::app
