#pragma once

#include <string>
#include <string_view>

#include "swayaw/core/parts_reader.hpp"

namespace swayaw::inline core {

/// The text of a ship file, which PartsReader reads back to the same numbers.
///
/// Optional numbers and choices that have their fallback are left out.
///
/// @param remark  lines above the file, without their "# "; may be empty
/// @throws std::domain_error  if a number is not finite or not in its range
std::string ship_text(std::string_view model, const ShipFileHead& head, const FileKeys& keys,
                      const std::vector<FileEffect>& effects = {}, std::string_view remark = {});

}  // namespace swayaw::core
