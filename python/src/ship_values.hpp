#pragma once

#include <span>
#include <vector>

#include "swayaw/core/parameter.hpp"

namespace swayaw::python {

/// Values in SI from those in the units of the ship file.
/// @throws std::domain_error  "R_0 in [hull] cannot be -1", as a ship file is refused
std::vector<double> si_values(std::span<const Parameter> parameters, std::span<const double> given);

}  // namespace swayaw::python
