#include "help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

#include "swayaw/core/detail/printable.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

struct Example {
  std::string_view command, text;
};

/// As typed in the folder of the project; docs/commands.md has more.
constexpr std::array examples{
    Example{"check", "swayaw check run1.csv run2.csv --report page.html"},
    Example{"compare", "swayaw compare kvlcc2_l7 zz10.csv turn35.csv --report page.html"},
    Example{"diagnose",
            "swayaw diagnose ship.toml zz10.csv turn35.csv --holdout zz20.csv \\\n    --report page.html --save-model "
            "new.toml"},
    Example{"estimate",
            "swayaw estimate --length 230 --beam 32.2 --draught 10.8 --block 0.651 \\\n    --out ship.toml"},
    Example{"fleet", "swayaw fleet ship.toml athena/*.csv boreas/*.csv --report page.html \\\n    --save-models today"},
    Example{"forces", "swayaw forces wpcc_pi --state u=0.96,v=0.05,r=-0.03,delta=0.1"},
    Example{"identify",
            "swayaw identify zz10.csv zz20.csv --ship kvlcc2_l7 --model mmg \\\n    --holdout zz15.csv --out new.toml"},
    Example{"import", "swayaw import log.csv --out run.csv"},
    Example{"indices", "swayaw indices tanker97 --report page.html"},
    Example{"invert", "swayaw invert ships/tanker97_nomoto.toml --parts ships/tanker97.toml \\\n    --known Y_w"},
    Example{"linearize", "swayaw linearize kvlcc2 --rudder 10"},
    Example{"loop", "swayaw loop tanker97 --zigzag 10/10 --report page.html"},
    Example{"replay", "swayaw replay kvlcc2_l7 run.csv --out simulated.csv"},
    Example{"ship", "swayaw ship kvlcc2 --out my_ship.toml"},
    Example{"simulate",
            "swayaw simulate kvlcc2 --zigzag 20/20\n  swayaw simulate kvlcc2 --turn 35 --first port --out turn.csv\n  "
            "swayaw simulate kvlcc2 --imo --report page.html"},
    Example{"trial", "swayaw trial zz10.csv turn35.csv --length 320 --report page.html"},
    Example{"sweep", "swayaw sweep plan.toml --out results --report page.html"},
    Example{"tune",
            "swayaw tune nawigator_ym --indices examples/indices/nawigator.toml \\\n    --prior 1 --bound 1 --out "
            "tuned.toml"}};

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  for (const auto* group : command.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); }))
    for (const auto& name : options_of(*group)) names.push_back(name);
  return names;
}

/// Lines of no more than 80 columns.
class NarrowFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::istringstream wide(CLI::Formatter::make_help(app, std::move(name), mode));
    std::string narrow;
    for (std::string line; std::getline(wide, line);)
      narrow += (line.starts_with("  -") && line.find("   ") == std::string::npos ? folded(line, columns, option_indent)
                                                                                  : fitted(line, columns)) +
                "\n";
    return narrow;
  }

 private:
  static constexpr int columns = 80;
  static constexpr std::size_t option_indent = 6;
};

}  // namespace

void add_examples(CLI::App& app) {
  for (const auto& [command, text] : examples)
    app.get_subcommand(std::string(command))->footer(fmt::format("For example\n  {}", text));
}

void narrow_help(CLI::App& app) { app.formatter(std::make_shared<NarrowFormatter>()); }

std::string completion_script(const CLI::App& app) {
  std::vector<std::string> commands;
  std::string cases;
  for (const auto* command : app.get_subcommands([](const CLI::App* one) { return !one->get_name().empty(); })) {
    commands.push_back(command->get_name());
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), fmt::join(options_of(*command), " "));
  }
  return fmt::format(
      "_swayaw() {{\n  local word=${{COMP_WORDS[COMP_CWORD]}} words=\n  if [ \"$COMP_CWORD\" = 1 ]; then\n"
      "    COMPREPLY=($(compgen -W \"{} --help --version\" -- \"$word\")); return\n  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n"
      "  case $word in -*) COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;; *) COMPREPLY=() ;; esac\n}}\n"
      "complete -o default -F _swayaw swayaw\n",
      fmt::join(commands, " "), cases);
}

std::string with_caret(const FilePlace& place) {
  if (place.line == 0 || place.column == 0 || place.file.extension() == ".mat") return {};
  if (std::error_code ignored; !std::filesystem::is_regular_file(place.file, ignored)) return {};
  std::ifstream file(place.file);
  std::string line;
  for (std::size_t i = 0; i < place.line; ++i)
    if (!std::getline(file, line)) return {};
  constexpr std::size_t longest = 200;
  if (line.size() > longest || line.find('\t') != std::string::npos) return {};
  if (line.ends_with('\r')) line.pop_back();
  if (core::detail::printable(line) != line) return {};  // the mark would not stand below its place
  const auto number = std::to_string(place.line);
  return fmt::format("{} | {}\n{} | {}^\n", number, line, std::string(number.size(), ' '),
                     std::string(place.column - 1, ' '));
}

}  // namespace swayaw::app
