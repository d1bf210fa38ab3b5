#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "swayaw/nonlinear/ship.hpp"

/// The ships of the folder ships/, which are part of the library. The files are the only place of their numbers.
namespace swayaw::inline nonlinear {

/// A ship file, known by its name without the ending.
struct PublishedShip {
  std::string_view name;
  std::string_view text;  ///< TOML, of any model (docs/formats.md)
};

/// All of them, by name.
std::span<const PublishedShip> published_ships();

/// The ship file of that name, if there is one.
std::optional<std::string_view> published_text(std::string_view name);

/// The published ship of a nonlinear model with that name.
/// @throws Refusal    if there is none; it lists the names
/// @throws FileError  if it is linear
Ship published_ship(std::string_view name);

}  // namespace swayaw::nonlinear
