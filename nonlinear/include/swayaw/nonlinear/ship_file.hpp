#pragma once

#include <filesystem>
#include <string_view>

#include "swayaw/nonlinear/ship.hpp"

namespace swayaw {

/// Reads a ship file (docs/formats.md).
///
/// Every key of the model must be there, none that is not of the model may be, and every number must
/// lie in its range.
///
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong", naming the key
Ship read_ship(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
Ship parse_ship(std::string_view text, const std::filesystem::path& name);

}  // namespace swayaw
