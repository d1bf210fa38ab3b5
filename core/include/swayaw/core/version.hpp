#pragma once

#include <string_view>

namespace swayaw::inline core {

/// Version of the library, "major.minor.patch".
std::string_view version();

}  // namespace swayaw::core
