#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/batch.hpp"

namespace swayaw {
namespace {

using State = LinearState<double>;

/// The exact map of a state over a fixed time, linear in state, rudder angle and rudder rate.
struct StepMap {
  State by_beta, by_omega, by_angle, by_rate;

  StepMap(const LinearResponse<double>& ship, double step)
      : by_beta(state_after(ship, {1.0, 0.0, 0.0}, {0.0, 0.0}, step)),
        by_omega(state_after(ship, {0.0, 1.0, 0.0}, {0.0, 0.0}, step)),
        by_angle(state_after(ship, {0.0, 0.0, 0.0}, {1.0, 0.0}, step)),
        by_rate(state_after(ship, {0.0, 0.0, 0.0}, {0.0, 1.0}, step)) {}

  /// What the rudder adds over the step.
  State forced(double angle, double rate) const {
    return {by_angle.beta * angle + by_rate.beta * rate, by_angle.omega * angle + by_rate.omega * rate, by_angle.psi * angle + by_rate.psi * rate};
  }

  State operator()(const State& x, const State& add) const {
    return {by_beta.beta * x.beta + by_omega.beta * x.omega + add.beta, by_beta.omega * x.beta + by_omega.omega * x.omega + add.omega,
            x.psi + by_beta.psi * x.beta + by_omega.psi * x.omega + add.psi};
  }
};

/// Steps taken at once, so that the processor works on as many chains.
constexpr std::size_t stride = 8;

}  // namespace

void sample_legs(const SwayYawCoefficients<double>& ship, std::span<const Leg<double>> legs, double step, std::span<State> states) {
  if (legs.empty()) throw std::domain_error("no legs to sample");
  require_positive(step, "step [ship lengths]");
  const LinearResponse<double> response(ship);
  const StepMap one(response, step), many(response, static_cast<double>(stride) * step);
  std::size_t next = 0;
  for (std::size_t i = 0; i < legs.size() && next < states.size(); ++i) {
    const auto& leg = legs[i];
    const double until = std::ceil((leg.from + leg.length) / step);
    const std::size_t first = next, end = i + 1 < legs.size() && until < static_cast<double>(states.size()) ? static_cast<std::size_t>(until) : states.size();
    if (first >= end) continue;
    const double start = static_cast<double>(first) * step - leg.from;
    const auto angle = [&](std::size_t k) { return leg.rudder.value + leg.rudder.rate * (start + static_cast<double>(k - first) * step); };
    states[first] = state_after(response, leg.start, leg.rudder, start);
    const std::size_t apart = std::min(first + stride, end);
    for (std::size_t k = first + 1; k < apart; ++k) states[k] = one(states[k - 1], one.forced(angle(k - 1), leg.rudder.rate));
    if (leg.rudder.rate == 0.0) {
      const State add = many.forced(leg.rudder.value, 0.0);
      for (std::size_t k = apart; k < end; ++k) states[k] = many(states[k - stride], add);
    } else {
      for (std::size_t k = apart; k < end; ++k) states[k] = many(states[k - stride], many.forced(angle(k - stride), leg.rudder.rate));
    }
    next = end;
  }
}

}  // namespace swayaw
