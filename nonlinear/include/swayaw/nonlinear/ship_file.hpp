#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::inline nonlinear {

/// Reads a ship file (docs/formats.md).
///
/// Every key of the model must be there, none that is not of the model may be, and every number must
/// lie in its range.
///
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong", naming the key
Ship read_ship(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
Ship parse_ship(std::string_view text, const std::filesystem::path& name);

/// The text of a ship file that parse_ship reads back to the same ship. Hull derivatives stand under their own names,
/// and the drag that belongs to a type of ship as numbers.
///
/// @param remark  lines above it, without their "# "; may be empty
/// @throws std::domain_error  if a number is not finite or not in its range
/// @throws Refusal            if her wind coefficients are Fourier series, which no ship file holds
std::string ship_text(const Ship& ship, std::string_view remark = {});

/// Writes that text, whole or not at all.
/// @throws FileError  if the file cannot be written
void write_ship(const std::filesystem::path& file, const Ship& ship, std::string_view remark = {});

}  // namespace swayaw::nonlinear
