#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "variables.hpp"

namespace swayaw::fmu {

inline constexpr std::string_view model_identifier = "swayaw_ship";

/// modelDescription.xml of FMI 2.0 for co-simulation.
std::string model_description(std::string_view ship_name, std::string_view guid,
                              const std::vector<Variable>& variables);

}  // namespace swayaw::fmu
