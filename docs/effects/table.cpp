#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/nonlinear/effects.hpp"

/// The table of docs/effects.md, made from the files of the effects.
///   effect_table FOLDER        writes kinds.md there
///   effect_table --check FILE  fails where the table in FILE is another one
using namespace swayaw;

namespace {

/// " (0.4)", where the parameter of a file that does not give it has a value other than 0.
std::string fallback_of(double fallback) {
  if (std::isnan(fallback) || fallback == 0.0) return "";
  if (std::isinf(fallback)) return fallback > 0.0 ? " (none)" : " (always)";
  return fmt::format(" ({:.3g})", fallback);
}

/// "`tau_s`; optional `share` (0.3)"
std::string parameters_of(const Effect& effect) {
  std::string required = channel_of(effect) ? "`channel`" : "", optional;
  for_each_parameter(effect, [&](const auto& p, double) {
    auto& list = p.required ? required : optional;
    list += fmt::format("{}`{}`{}", list.empty() ? "" : " ", p.key, p.required ? "" : fallback_of(p.fallback));
  });
  if (required.empty()) return parameter_count(effect) > 1 ? "any of " + optional : optional;
  return optional.empty() ? required : required + "; optional " + optional;
}

std::string table() {
  std::string text =
      "| kind | acts on | one value for | parameters | what it does | confused with → separated by |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const auto id : effect_ids()) {
    const auto effect = make_effect(id);
    const auto& words = text_of(effect);
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", id, name_of(place_of(effect)), name_of(scope_of(effect)),
                        parameters_of(effect), words.law, words.confused_with);
  }
  return text;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count == 2) {
    write_text(std::filesystem::path(arguments[1]) / "kinds.md", table());
    return 0;
  }
  if (count != 3 || std::string(arguments[1]) != "--check")
    throw std::runtime_error("effect_table [--check FILE | FOLDER]");
  if (read_text(arguments[2]).find(table()) != std::string::npos) return 0;
  fmt::print(stderr, "the table in {} is not that of the effects: docs/effects/make_table.sh makes it\n", arguments[2]);
  return 1;
} catch (const std::exception& trouble) {
  fmt::print(stderr, "{}\n", trouble.what());
  return 1;
}
