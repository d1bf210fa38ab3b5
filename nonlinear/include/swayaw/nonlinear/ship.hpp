#pragma once

#include <string>
#include <variant>
#include <vector>

#include "swayaw/core/confidence.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/models/models.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

namespace swayaw::inline nonlinear {

/// A ship: one of the models, its name, the trust in its numbers, what surrounds her, and what the model leaves out.
///
/// acting_ship.hpp tells what the effects make of her. Wind and current of the surroundings blow and run beside those
/// of the effects; ships from files have them as effects.
struct Ship {
  std::string name;
  ShipModel model;
  Confidence confidence;
  Surroundings<double> surroundings;
  std::vector<Effect> effects{};  ///< none that `exclude_each_other`
};

/// Length between perpendiculars [m].
double length(const Ship& ship);

/// Speed at which the ship approaches a manoeuvre unless told otherwise [m/s].
double service_speed(const Ship& ship);

/// Time in which she sails her length at that speed, L/U [s].
double time_unit_of(const Ship& ship);

/// What the steering gear can do.
const SteeringGear<double>& steering_gear(const Ship& ship);

}  // namespace swayaw::nonlinear
