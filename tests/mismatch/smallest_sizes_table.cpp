#include <fmt/format.h>

#include <cstdio>

#include "planted_sizes.hpp"

/// The table of docs/results/smallest_sizes.md: how often effects of the listed sizes are found.
int main() {
  using namespace swayaw;
  constexpr int seeds = 10;
  fmt::print("| effect | parameter | size | named first | or told as equal | instead |\n");
  fmt::print("| --- | --- | ---: | ---: | ---: | --- |\n");
  for (const auto& size : test::listed_sizes()) {
    const auto [first, among_equals, instead] = test::found_of(size, seeds);
    std::vector<std::string> others;
    for (const auto& [name, count] : instead) others.push_back(fmt::format("{} {}", name, count));
    fmt::print("| {} | {} | {:.3g} | {} of {} | {} of {} | {} |\n", size.effect, size.key, size.value, first, seeds,
               among_equals, seeds, fmt::join(others, ", "));
    std::fflush(stdout);
  }
}
