#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swayaw::inline core::detail {

/// Words of a name in plain small letters: "RudderAngle_1" -> rudder angle 1, "Kurs ü. Grund" -> kurs ue grund.
/// `signs` keeps + and - that stand alone as words.
std::vector<std::string> words_of(std::string_view name, bool signs = false);

}  // namespace swayaw::core::detail
