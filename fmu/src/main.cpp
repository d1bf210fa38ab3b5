// swayaw_fmu: a unit of FMI 2.0 for co-simulation from a ship file.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "contents.hpp"
#include "model_description.hpp"
#include "stored_zip.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "variables.hpp"

namespace {

using namespace swayaw;
using namespace swayaw::fmu;

/// Text of a ship file, or where no such file is there, of the published ship of that name.
std::string text_of(const std::filesystem::path& ship) {
  const auto published = std::filesystem::exists(ship) ? std::nullopt : published_text(ship.string());
  return published ? std::string(*published) : read_text(ship, FileUse::description);
}

std::size_t count_of(const std::vector<Variable>& variables, Causality causality) {
  return static_cast<std::size_t>(std::ranges::count(variables, causality, &Variable::causality));
}

void make(const std::string& ship, const std::filesystem::path& out) {
  const auto variables = variables_of(ship);
  const auto text = text_of(ship);
  const auto name = parse_ship(text, ship).name;
  const auto description = model_description(name, guid_of(text, variables), variables);
  std::vector<ZipEntry> entries{{"modelDescription.xml", description},
                                {fmt::format("resources/{}", default_ship_file), text}};
  for (const auto& [file, bytes] : contents()) entries.push_back({std::string(file), bytes});
  write_text(out, stored_zip(entries));
  fmt::print("{}: {}, {} inputs, {} outputs, {} parameters\n", out.string(), name,
             count_of(variables, Causality::input), count_of(variables, Causality::output),
             count_of(variables, Causality::parameter));
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app(
      "A ship as a unit of FMI 2.0 for co-simulation (FMU), to be run by Simulink, Modelica tools, FMPy and others.");
  app.set_version_flag("--version", SWAYAW_VERSION);
  std::string ship;
  std::filesystem::path out;
  app.add_option("SHIP", ship, "ship file, or the name of a published ship")->required();
  app.add_option("--out", out, "the unit; SHIP with the ending .fmu in this folder unless given");
  CLI11_PARSE(app, count, arguments);
  if (out.empty()) out = std::filesystem::path(ship).stem().string() + ".fmu";
  try {
    make(ship, out);
  } catch (const std::exception& e) {
    fmt::print(stderr, "swayaw_fmu: {}\n", e.what());
    return 1;
  }
}
