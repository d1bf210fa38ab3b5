#include "swayaw/nonlinear/published_ships.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::inline nonlinear {

std::optional<std::string_view> published_text(std::string_view name) {
  const auto ships = published_ships();
  const auto found = std::ranges::find(ships, name, &PublishedShip::name);
  if (found == ships.end()) return std::nullopt;
  return found->text;
}

Ship published_ship(std::string_view name) {
  if (const auto text = published_text(name)) return parse_ship(*text, std::string(name) + ".toml");
  std::vector<std::string_view> names;
  for (const auto& ship : published_ships()) names.push_back(ship.name);
  throw Refusal(fmt::format("there is no published ship \"{}\"; there are {}", name, fmt::join(names, ", ")));
}

}  // namespace swayaw::nonlinear
