#include "swayaw/core/steering_gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "swayaw/core/refusal.hpp"

namespace swayaw {

void require_rudder(double angle, const SteeringGear<double>& gear) {
  require_positive(angle, "rudder angle [rad]");
  if (angle <= gear.max_angle * (1.0 + 1e-12)) return;
  throw std::domain_error(fmt::format("rudder angle {:.6g} deg is beyond the ship's largest, {:.6g} deg", degrees(angle),
                                      degrees(gear.max_angle)));
}

RudderMotion RudderMotion::moving(double time, double angle, double rate) {
  RudderMotion motion;
  motion.start_ = time;
  motion.angle_ = angle;
  motion.rate_ = rate;
  return motion;
}

RudderMotion RudderMotion::ordered(const SteeringGear<double>& gear, double time, double angle, double order) {
  const double error = order - angle;
  const double band = gear.dead_band;
  if (std::abs(error) <= band) return moving(time, angle, 0.0);
  auto motion = moving(time, angle, std::copysign(gear.rate, error));
  motion.lag_ = gear.lag;
  // |e|/T reaches the rate when |e| = T rate; the rudder may come to rest before
  const double slow = std::clamp(gear.lag * gear.rate, band, std::max(band, std::abs(error)));
  motion.slowing_ = time + (std::abs(error) - slow) / gear.rate;
  motion.error_ = std::copysign(slow, error);
  motion.order_ = order;
  motion.final_ = order - std::copysign(band, error);
  // T ln(|e|/b) until |e| = b; without a dead band the rudder never quite arrives
  if (slow <= band) motion.rest_ = motion.slowing_;
  else if (band > 0.0) motion.rest_ = motion.slowing_ + gear.lag * std::log(slow / band);
  return motion;
}

double RudderMotion::at(double time) const {
  if (time >= rest_) return final_;
  if (time <= slowing_) return angle_ + rate_ * (time - start_);
  return order_ - error_ * std::exp(-(time - slowing_) / lag_);
}

double RudderMotion::next_kink(double time) const {
  if (time < slowing_) return slowing_;
  return time < rest_ ? rest_ : never;
}

}  // namespace swayaw
