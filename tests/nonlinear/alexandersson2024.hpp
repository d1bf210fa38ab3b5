#pragma once

#include "files.hpp"
#include "json.hpp"

/// Numbers of [Alexandersson2024], and of an independent program.
namespace swayaw::test {

inline nlohmann::json alexandersson2024() { return json_in(golden / "alexandersson2024.json"); }

}  // namespace swayaw::test
