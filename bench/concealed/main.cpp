// Concealed cases of our own: makes them, and scores swayaw::diagnose on them. docs/concealed.md
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "concealed_case.hpp"
#include "score.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parallel.hpp"

namespace {

using namespace swayaw;
using namespace swayaw::concealed;

/// @param ship  kind or structure of the ships of the cases that are made; all of the plan where it is empty
void make(const std::filesystem::path& folder, const std::string& plan, std::size_t count, std::uint64_t seed,
          std::string_view ship, unsigned jobs) {
  auto plans = plan_named(plan, count, seed);
  if (!ship.empty()) std::erase_if(plans, [&](const CasePlan& p) { return p.ship_kind != ship; });
  if (plans.empty()) throw std::domain_error(fmt::format("no case of this plan has a ship of the kind \"{}\"", ship));
  in_parallel(plans.size(), jobs, [&](std::size_t i) { write_case(made(plans[i]), folder); });
  fmt::print("{} cases in {}\n", plans.size(), folder.string());
}

void tell(const Json& line) {
  std::vector<std::string> truth, found;
  for (const auto& e : line.at("effects"))
    truth.push_back(fmt::format("{}:{}", e.at("effect").get<std::string>(), e.at("level").get<std::string>()));
  if (line.contains("answer"))
    for (const auto& e : line["answer"].at("effects")) found.push_back(e.at("effect"));
  const auto conditions =
      line.contains("form")
          ? fmt::format("{} {}", line.at("family").get<std::string>(), line.at("form").get<std::string>())
          : fmt::format("noise {:g} set {}{}", line.at("noise").get<double>(), line.at("set").get<std::string>(),
                        line.at("baseline_error").get<double>() > 0.0 ? " wrong" : "");
  fmt::print("{} [{}] {}{} -> {} [{}]\n", line.at("case").get<std::string>(), fmt::join(truth, ", "), conditions,
             line.value("reference", false) ? " reference" : "",
             line.contains("answer") ? line["answer"].at("verdict").get<std::string>() : "rivals only",
             fmt::join(found, ", "));
  std::fflush(stdout);
}

/// How the true ships sail, and how near their ship files come.
std::string ships_table() {
  std::string text =
      "| ship | L [m] | overshoot 10/10, 20/20 [deg] | tactical diameter [L] | speed in the turn | residue of the ship "
      "file X, Y, N |\n| --- | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto kind : ship_kinds()) {
    const auto ship = true_ship(kind, 1);
    const auto c = character_of(ship);
    const auto residue = fair_ship(ship, 0.02).residue;
    text += fmt::format("| {} | {:.0f} | {:.1f}, {:.1f} | {:.2f} | {:.2f} | {:.1f}, {:.1f}, {:.1f} % |\n", kind, ship.L,
                        degrees(c.overshoot_10), degrees(c.overshoot_20), c.tactical_diameter, c.speed_in_turn,
                        100.0 * residue.X, 100.0 * residue.Y, 100.0 * residue.N);
  }
  return text;
}

/// The same of the ships of other structures, and how near files of each form come.
std::string structures_table() {
  std::string text =
      "| ship | L [m] | L/U [s] | overshoot 10/10, 20/20 [deg] | tactical diameter [L] | speed in the turn | residue "
      "X, Y, N of "
      "mmg | of pi | of abkowitz |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto kind : ship_structures()) {
    const auto ship = true_ship(kind, 1);
    const auto c = character_of(ship);
    text += fmt::format("| {} | {:.0f} | {:.0f} | {:.1f}, {:.1f} | {:.2f} | {:.2f} |", kind, ship.L, ship.time_unit(),
                        degrees(c.overshoot_10), degrees(c.overshoot_20), c.tactical_diameter, c.speed_in_turn);
    for (const auto form : {FileForm::mmg, FileForm::pi, FileForm::abkowitz}) {
      const auto residue = fair_ship(ship, form, 0.05).residue;
      text += fmt::format(" {:.1f}, {:.1f}, {:.1f} % |", 100.0 * residue.X, 100.0 * residue.Y, 100.0 * residue.N);
    }
    text += "\n";
  }
  return text;
}

void write_tables(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder) {
  std::vector<Json> lines;
  for (const auto& file : files)
    for (auto& line : read_lines(file)) lines.push_back(std::move(line));
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : tables_of(lines)) write_text(folder / (name + ".md"), text);
  const bool on_board = !lines.empty() && lines.front().contains("form");
  write_text(folder / "ships.md", on_board ? structures_table() : ships_table());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Concealed cases: make them, score the diagnosis on them");
  app.require_subcommand(1);
  std::filesystem::path folder;
  std::string plan = "all";
  std::size_t count = 0;
  std::uint64_t seed = 1;
  std::string ship;
  unsigned jobs = 1;
  auto* maker = app.add_subcommand("make", "writes cases");
  maker->add_option("folder", folder)->required();
  maker->add_option("--plan", plan, "clean, singles, pairs, unknown, all, on_board_clean or on_board")
      ->capture_default_str();
  maker->add_option("--count", count, "cases, 0 for as many as the plan has")->capture_default_str();
  maker->add_option("--seed", seed)->capture_default_str();
  maker->add_option("--ship", ship, "only the cases of the plan whose ship is of this kind or structure");
  maker->add_option("--jobs", jobs, "cases at a time")->capture_default_str();
  ScoreOptions options;
  auto* scorer = app.add_subcommand(
      "score", "diagnoses the cases that are not in the file of answers yet; may be stopped and begun again");
  scorer->add_option("folder", folder)->required();
  scorer->add_option("--lines", options.lines, "file of answers; FOLDER/score.jsonl unless given");
  scorer->add_option("--jobs", options.jobs, "cases at a time")->capture_default_str();
  scorer->add_flag("--rivals-only", options.rivals_only, "without the diagnosis itself");
  std::vector<std::filesystem::path> answers;
  auto* tables = app.add_subcommand(
      "tables", "tables of docs/concealed.md, or of docs/concealed_on_board.md for cases as on board");
  tables->add_option("folder", folder, "for the tables")->required();
  tables->add_option("lines", answers, "files of answers")->required();
  auto* ships = app.add_subcommand("ships", "how the true ships sail");
  CLI11_PARSE(app, argc, argv);
  try {
    if (*maker) make(folder, plan, count, seed, ship, jobs);
    if (*scorer) {
      if (options.lines.empty()) options.lines = folder / "score.jsonl";
      score(folder, options, tell);
    }
    if (*tables) write_tables(answers, folder);
    if (*ships) fmt::print("{}\n{}", ships_table(), structures_table());
  } catch (const std::exception& trouble) {
    fmt::print(stderr, "swayaw_concealed: {}\n", trouble.what());
    return 1;
  }
  return 0;
}
