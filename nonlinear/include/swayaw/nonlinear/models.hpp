#pragma once

#include <variant>

#include "swayaw/nonlinear/abkowitz_forces.hpp"
#include "swayaw/nonlinear/mmg_forces.hpp"
#include "swayaw/nonlinear/prime_propulsion.hpp"

namespace swayaw {

/// Every model of the nonlinear floor; what is done with a ship is done with `std::visit`.
using ShipModel = std::variant<MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>>;

}  // namespace swayaw
