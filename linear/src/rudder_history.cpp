#include "swayaw/linear/rudder_history.hpp"

#include <cmath>
#include <stdexcept>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline linear {

RudderHistory rudder_step(double angle) { return {.s = {0.0}, .delta = {angle}}; }

RudderHistory rudder_ramp(double rate, double duration) {
  return {.s = {0.0, require_positive(duration, "duration [ship lengths]")}, .delta = {0.0, rate * duration}};
}

RudderHistory rudder_ramp_and_hold(double angle, double rate) {
  require_positive(rate, "rudder rate [rad per ship length]");
  return {.s = {0.0, std::abs(angle) / rate}, .delta = {0.0, angle}};
}

RudderHistory rudder_history(const LinearZigzag<double>& zigzag) {
  RudderHistory history;
  const auto add = [&](double s, double delta) {
    history.s.push_back(s);
    history.delta.push_back(delta);
  };
  for (const auto& leg : zigzag.legs) {
    add(leg.from, leg.rudder.value);
    add(leg.from + leg.length, leg.rudder.value + leg.rudder.rate * leg.length);
  }
  return history;
}

void require_history(const RudderHistory& history) {
  const auto &s = history.s, &delta = history.delta;
  if (s.empty()) throw std::domain_error("a rudder history needs at least one point");
  if (s.size() != delta.size()) throw std::domain_error("a rudder history needs one angle for each time");
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(s.begin(), s.end(), finite) || !std::all_of(delta.begin(), delta.end(), finite))
    throw std::domain_error("times and angles of a rudder history must be finite");
  if (!std::is_sorted(s.begin(), s.end())) throw std::domain_error("times of a rudder history must not descend");
}

}  // namespace swayaw::linear
