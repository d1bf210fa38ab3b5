#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::inline nonlinear {

double length(const Ship& ship) {
  return std::visit([](const auto& model) { return model.particulars.L; }, ship.model);
}

double service_speed(const Ship& ship) {
  return std::visit([](const auto& model) { return model.particulars.U_0; }, ship.model);
}

double time_unit_of(const Ship& ship) { return length(ship) / service_speed(ship); }

const SteeringGear<double>& steering_gear(const Ship& ship) {
  return std::visit(
      [](const auto& model) -> const auto& { return model.steering_gear; }, ship.model);
}

}  // namespace swayaw::nonlinear
