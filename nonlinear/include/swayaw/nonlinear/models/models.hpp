#pragma once

#include <variant>

#include "swayaw/nonlinear/models/abkowitz/abkowitz_forces.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/models/parts/prime_propulsion.hpp"

namespace swayaw::inline nonlinear {

/// Every model of the nonlinear floor; what is done with a ship is done with `std::visit`.
using ShipModel = std::variant<MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>>;

}  // namespace swayaw::nonlinear
