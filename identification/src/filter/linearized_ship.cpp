#include "linearized_ship.hpp"

#include "linearized_model.hpp"

namespace swayaw::inline identification::detail {

std::unique_ptr<LinearizedShip> linearized_ship(const Ship& ship) {
  return visit_acting(ship, [](const auto& acting) { return linearized_model(acting); });
}

}  // namespace swayaw::identification::detail
