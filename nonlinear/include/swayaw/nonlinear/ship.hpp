#pragma once

#include <string>
#include <variant>

#include "swayaw/core/confidence.hpp"
#include "swayaw/nonlinear/mmg_ship.hpp"

namespace swayaw {

/// A ship: one of the models, its name, and the trust in its numbers.
struct Ship {
  std::string name;
  std::variant<MmgShip<double>> model;
  Confidence confidence;
};

/// Length between perpendiculars [m].
inline double length(const Ship& ship) {
  return std::visit([](const auto& model) { return model.particulars.L; }, ship.model);
}

/// Speed at which the ship approaches a manoeuvre unless told otherwise [m/s].
inline double service_speed(const Ship& ship) {
  return std::visit([](const auto& model) { return model.particulars.U_0; }, ship.model);
}

/// What the steering gear can do.
inline const SteeringGear<double>& steering_gear(const Ship& ship) {
  return std::visit([](const auto& model) -> const auto& { return model.steering_gear; }, ship.model);
}

}  // namespace swayaw
