#pragma once

#include <filesystem>
#include <string_view>

#include "swayaw/linear/linear_ship.hpp"

namespace swayaw {

/// Reads the ship file of a linear ship (docs/formats.md), in one of its three forms: [hull] and [rudder], [linear], or
/// [nomoto].
///
/// Every key of the form must be there, none that is not of the form may be, and every number must lie in its range.
///
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong", naming the key
LinearShip read_linear_ship(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
LinearShip parse_linear_ship(std::string_view text, const std::filesystem::path& name);

}  // namespace swayaw
