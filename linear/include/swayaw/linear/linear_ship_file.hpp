#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "swayaw/linear/linear_ship.hpp"

namespace swayaw::inline linear {

/// Reads the ship file of a linear ship (docs/formats.md), in one of its three forms: [hull] and [rudder], [linear], or
/// [nomoto].
///
/// Every key of the form must be there, none that is not of the form may be, and every number must lie in its range.
///
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong", naming the key
LinearShip read_linear_ship(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
LinearShip parse_linear_ship(std::string_view text, const std::filesystem::path& name);

/// The text of a ship file that parse_linear_ship reads back to the same ship, in the form that she has.
/// @throws std::domain_error  if a number is not finite or not in its range
std::string ship_text(const LinearShip& ship, std::string_view remark = {});

/// Writes that text, whole or not at all.
/// @throws FileError  if the file cannot be written
void write_linear_ship(const std::filesystem::path& file, const LinearShip& ship, std::string_view remark = {});

}  // namespace swayaw::linear
