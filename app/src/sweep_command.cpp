#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "progress.hpp"
#include "swayaw/app/sweep/ranks.hpp"
#include "swayaw/app/sweep/reduce.hpp"
#include "swayaw/app/sweep/run.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/version.hpp"
#include "sweep_page.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

/// Notes that are told; the file has all.
constexpr std::size_t most_notes = 10;

// ---------------------------------------------------------------- JSON

Json item_json(const SweepWork& work, const ItemValue& found) {
  Json parameters = Json::object();
  const auto values = work.parameters_of(found.item);
  for (std::size_t d = 0; d < values.size(); ++d) parameters[work.columns()[d].name] = number(values[d]);
  Json json{{"item", found.item}, {"value", number(found.value)}, {"parameters", std::move(parameters)}};
  if (const auto name = work.name_of(found.item); !name.empty()) json["name"] = name;
  return json;
}

Json counts_json(const WordCounts& counts) {
  Json json = Json::object();
  for (const auto& [word, count] : counts) json[word] = count;
  return json;
}

Json column_json(const SweepWork& work, const ColumnSummary& s) {
  const auto& column = work.columns()[s.column];
  Json json{{"ship", work.subjects()[s.subject]},
            {"column", column.name},
            {"unit", column.unit},
            {"varied", column.varied},
            {"count", s.count},
            {"missing", s.missing}};
  if (s.count == 0) return json;
  json.update({{"mean", number(s.mean)},
               {"standard_deviation", number(s.standard_deviation)},
               {"min", number(s.low)},
               {"max", number(s.high)}});
  Json quantiles = Json::object();
  for (std::size_t q = 0; q < summary_quantiles.size(); ++q)
    quantiles[fmt::format("{:.2f}", summary_quantiles[q])] = number(s.quantile[q]);
  json["quantiles"] = std::move(quantiles);
  json["histogram"] = s.histogram;
  if (column.varied) return json;
  json["lowest"] = json["highest"] = Json::array();
  for (const auto& found : s.lowest) json["lowest"].push_back(item_json(work, found));
  for (const auto& found : s.highest) json["highest"].push_back(item_json(work, found));
  return json;
}

Json document_of(const SweepWork& work, const SweepStore& store, const Swept& swept) {
  Json json{{"schema", "swayaw.sweep/1"},
            {"version", version()},
            {"plan", work.plan().file.string()},
            {"task", task_words(work.plan())},
            {"results", store.file().string()},
            {"ships", work.subjects()},
            {"items", swept.count.all},
            {"resumed_at", swept.count.before},
            {"seconds", swept.seconds},
            {"columns", Json::array()},
            {"sobol", Json::array()},
            {"pairs_left_out", swept.summary.pairs_left_out},
            {"notes", {{"count", swept.note_count}, {"first", Json::array()}}}};
  for (const auto& s : swept.summary.columns) json["columns"].push_back(column_json(work, s));
  for (const auto& s : swept.summary.sobol)
    json["sobol"].push_back(
        {{"ship", work.subjects()[s.subject]},
         {"result", work.columns()[s.result].name},
         {"parameter", work.columns()[s.parameter].name},
         {"first", {{"value", number(s.first)}, {"low", number(s.first_low)}, {"high", number(s.first_high)}}},
         {"total", {{"value", number(s.total)}, {"low", number(s.total_low)}, {"high", number(s.total_high)}}}});
  if (work.plan().task == SweepTask::diagnose)
    json.update({{"verdicts", counts_json(swept.verdicts)}, {"first_effects", counts_json(swept.first_effects)}});
  for (const auto& [item, text] : swept.notes) json["notes"]["first"].push_back({{"item", item}, {"text", text}});
  return json;
}

// ---------------------------------------------------------------- text

void print_summary(const SweepWork& work, const SweepStore& store, const Swept& swept) {
  say("{}: {} items of {}, {}\n", work.plan().file.string(), swept.count.done, task_words(work.plan()),
      fmt::join(work.subjects(), ", "));
  for (std::size_t ship = 0; ship < work.subjects().size(); ++ship) {
    say("\n{}\n", work.subjects()[ship]);
    say("  {:<22}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "", "least", "5 %", "median", "95 %", "largest");
    for (const auto& s : swept.summary.columns) {
      if (s.subject != ship) continue;
      const auto& name = work.columns()[s.column].name;
      if (s.count == 0) say("  {:<22}{:>11}\n", name, "none");
      else
        say("  {:<22}{:>11.5g}{:>11.5g}{:>11.5g}{:>11.5g}{:>11.5g}\n", name, s.low, s.quantile[1], s.quantile[3],
            s.quantile[5], s.high);
    }
  }
  for (const auto& [title, counts] : std::array<std::pair<const char*, const WordCounts*>, 2>{
           {{"verdicts", &swept.verdicts}, {"first effects", &swept.first_effects}}})
    if (!counts->empty()) {
      say("\n{}\n", title);
      for (const auto& [word, count] : *counts) say("  {:<28}{:>6}\n", word, count);
    }
  if (!swept.summary.sobol.empty()) say("\nshare of the variance, %, with its 95 % interval\n");
  for (const auto& s : swept.summary.sobol)
    say("  {:<22}{:<22}alone {:.1f} ({:.1f} to {:.1f}), with all others {:.1f} ({:.1f} to {:.1f})\n",
        work.columns()[s.result].name, work.columns()[s.parameter].name, 100.0 * s.first, 100.0 * s.first_low,
        100.0 * s.first_high, 100.0 * s.total, 100.0 * s.total_low, 100.0 * s.total_high);
  if (swept.note_count > 0) say("\n{} items without a result or with less\n", swept.note_count);
  for (const auto& [item, text] : swept.notes) say("  item {:<6}{}  {}\n", item, work.name_of(item), text);
  say("\nall items are in {}\n", store.file().string());
}

// ---------------------------------------------------------------- CSV

/// A cell of a table, in quotes where a comma or a quote would end it.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// Every item in a line, shortest digits that read back to the same number; nothing where there is no result.
void write_table(const SweepWork& work, const SweepStore& store, const std::filesystem::path& file) {
  write_draft(file, [&](const std::filesystem::path& draft) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(draft.c_str(), "w"), std::fclose);
    if (!out) return false;
    std::string text = of_recordings(work.plan().task) ? "item,case" : "item,ship";
    for (const auto& column : work.columns()) text += "," + column.name;
    text += "\n";
    for (std::size_t ship = 0; ship < work.subjects().size(); ++ship) {
      std::vector<std::vector<double>> columns;
      for (std::size_t c = 0; c < work.columns().size(); ++c) columns.push_back(store.column(ship, c));
      for (std::size_t i = 0; i < work.points(); ++i) {
        const auto item = ship * work.points() + i;
        if (of_recordings(work.plan().task))
          fmt::format_to(std::back_inserter(text), "{},{}", item, cell(work.name_of(item)));
        else fmt::format_to(std::back_inserter(text), "{},{}", item, ship);
        for (const auto& column : columns) {
          text += ",";
          if (std::isfinite(column[i])) fmt::format_to(std::back_inserter(text), "{}", column[i]);
        }
        text += "\n";
        if (text.size() < (1u << 20)) continue;
        if (std::fwrite(text.data(), 1, text.size(), out.get()) != text.size()) return false;
        text.clear();
      }
    }
    return std::fwrite(text.data(), 1, text.size(), out.get()) == text.size() && std::fflush(out.get()) == 0;
  });
}

// ---------------------------------------------------------------- work

SweepCount run(const SweepWork& work, SweepStore& store, unsigned threads, Ranks* ranks) {
  Progress progress("sweep");
  const Interrupt interrupt;
  const auto go_on = [&](const SweepCount& now) {
    const double seconds = progress.seconds(), rate = static_cast<double>(now.done - now.before) / seconds;
    progress.tell(fmt::format("{} of {} items, {:.3g} a second, {:.0f} s to go", now.done, now.all, rate,
                              rate > 0.0 ? static_cast<double>(now.all - now.done) / rate : 0.0));
    return !interrupt.asked();
  };
  const auto count = ranks ? run_sweep_with_ranks(work, store, *ranks, go_on) : run_sweep(work, store, threads, go_on);
  if (count.done < count.all)
    throw Refusal(fmt::format("{}: ended at {} of {} items, which are kept; the same command goes on from there",
                              store.file().string(), count.done, count.all));
  return count;
}

}  // namespace

namespace {

/// @param ranks  of whom this is the first; nullptr: none
void sweep_and_tell(const SweepArguments& a, const SweepWork& work, SweepStore& store, Ranks* ranks) {
  const auto began = std::chrono::steady_clock::now();
  Swept swept{.summary = {}, .count = run(work, store, a.threads, ranks), .seconds = 0.0, .notes = {}, .note_count = 0};
  swept.summary = summary_of(store, work, a.threads);
  swept.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  swept.notes = store.notes(most_notes);
  swept.note_count = store.note_count();
  if (work.plan().task == SweepTask::diagnose) {
    swept.verdicts = store.counts("$.verdict");
    swept.first_effects = store.counts("$.effects[0].effect");
  }
  if (swept.count.before > 0)
    say_aside("swayaw: {}: {} items were there already\n", store.file().string(), swept.count.before);
  if (!a.csv.empty()) write_table(work, store, a.csv);
  if (a.report.wanted())
    write_page(a.report.file, html(sweep_page(work, swept, store.file(), UserUnits(a.report.si, 0.0))));
  if (a.json) print_document(document_of(work, store, swept));
  else print_summary(work, store, swept);
}

/// What every rank but the first does; trouble is told to the first, which tells the user.
void serve(const SweepArguments& a, Ranks& ranks) {
  const Interrupt left_to_the_first;
  try {
    serve_sweep(SweepWork(read_sweep_plan(a.plan)), ranks);
  } catch (const Refusal& e) {
    give_up(ranks, e.what());
  }
}

}  // namespace

void sweep(const SweepArguments& a) {
  const auto ranks = ranks_of_this_program();
  if (ranks && ranks->rank() > 0) return serve(a, *ranks);
  std::unique_ptr<SweepWork> work;
  std::unique_ptr<SweepStore> store;
  try {
    work = std::make_unique<SweepWork>(read_sweep_plan(a.plan));
    store = std::make_unique<SweepStore>(a.out, *work);
  } catch (const Refusal&) {
    if (ranks) dismiss(*ranks);
    throw;
  }
  sweep_and_tell(a, *work, *store, ranks.get());
}

}  // namespace swayaw::app
