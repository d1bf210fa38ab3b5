#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "checked_runs.hpp"
#include "commands.hpp"
#include "input.hpp"

namespace swayaw::app {

/// The recordings that the project ships need no check, and the check is not part of this program.
std::vector<Recording> checked_runs(const std::vector<std::filesystem::path>& files, const Reading&) {
  std::vector<Recording> runs;
  for (const auto& file : files) runs.push_back(load_run(file));
  return runs;
}

}  // namespace swayaw::app

/// The main job of the program by itself, for who wants to see it before building the rest:
///
///     swayaw_demo SHIP PAGE RUN…    is    swayaw compare SHIP RUN… --report PAGE
int main(int count, char** words) {
  if (count < 4) {
    fmt::print(stderr, "usage: {} SHIP PAGE RUN...\n", words[0]);
    return 2;
  }
  try {
    swayaw::app::compare({.ship = words[1], .runs = {words + 3, words + count}, .report = {.file = words[2]}});
    return 0;
  } catch (const std::exception& error) {
    swayaw::app::say_aside("{}\n", error.what());
    return 1;
  }
}
