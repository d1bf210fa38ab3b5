#pragma once

#include <string>
#include <variant>

#include "swayaw/core/confidence.hpp"
#include "swayaw/nonlinear/models.hpp"
#include "swayaw/nonlinear/surroundings.hpp"

namespace swayaw {

/// A ship: one of the models, its name, the trust in its numbers, and what surrounds her.
struct Ship {
  std::string name;
  ShipModel model;
  Confidence confidence;
  Surroundings<double> surroundings;
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
