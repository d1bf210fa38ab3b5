#include "swayaw/core/steering_gear.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core {

void require_rudder(double angle, const SteeringGear<double>& gear) {
  require_positive(angle, "rudder angle [rad]");
  if (angle <= gear.max_angle * (1.0 + 1e-12)) return;
  throw std::domain_error(fmt::format("rudder angle {:.6g} deg is beyond the ship's largest, {:.6g} deg",
                                      degrees(angle), degrees(gear.max_angle)));
}

}  // namespace swayaw::core
