#include "swayaw/linear/linear_recording.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/rudder_history.hpp"
#include "swayaw/linear/track.hpp"

namespace swayaw::inline linear {
namespace {

constexpr double runaway = 100.0;  ///< omega' of a ship that turns about a point a hundredth of her length away

/// Times in ship lengths and the states then.
struct Samples {
  std::vector<double> s;
  std::vector<LinearState<double>> states;
};

Samples sampled(const LinearResponse<double>& ship, const std::vector<Leg<double>>& legs, double step) {
  const double end = legs.back().from + legs.back().length;
  Samples samples;
  for (std::size_t i = 0; static_cast<double>(i) * step <= end * (1.0 + 1e-12); ++i) {
    const double s = std::min(static_cast<double>(i) * step, end);
    const auto state = state_at(ship, legs, s);
    if (!(std::abs(state.omega) <= runaway)) break;
    samples.s.push_back(s);
    samples.states.push_back(state);
  }
  return samples;
}

/// The legs up to a time.
void cut(std::vector<Leg<double>>& legs, double end) {
  while (legs.size() > 1 && legs.back().from > end) legs.pop_back();
  legs.back().length = std::min(legs.back().length, end - legs.back().from);
}

}  // namespace

Recording recording_of(const SwayYawCoefficients<double>& coefficients, std::vector<Leg<double>> legs,
                       const PrimeScale& scale, double step) {
  require_positive(step, "step [s]");
  if (legs.empty()) throw std::domain_error("a motion without legs cannot be sampled");
  const LinearResponse<double> ship(coefficients);
  const double L = scale.L, U = scale.U, time_unit = L / U;
  const auto samples = sampled(ship, legs, step / time_unit);
  const auto& times = samples.s;
  const auto& states = samples.states;
  cut(legs, times.back());
  const auto points = track(ship, legs, times);
  Recording run;
  for (std::size_t i = 0; i < times.size(); ++i) run.time.push_back(static_cast<double>(i) * step);
  const auto fill = [&](Channel channel, auto&& value) {
    auto column = run.fill(channel);
    for (std::size_t i = 0; i < times.size(); ++i) column[i] = value(i);
  };
  fill(Channel::x, [&](std::size_t i) { return points[i].x * L; });
  fill(Channel::y, [&](std::size_t i) { return points[i].y * L; });
  fill(Channel::psi, [&](std::size_t i) { return states[i].psi; });
  fill(Channel::u, [&](std::size_t i) { return U * std::cos(states[i].beta); });
  fill(Channel::v, [&](std::size_t i) { return -U * std::sin(states[i].beta); });
  fill(Channel::r, [&](std::size_t i) { return states[i].omega * U / L; });
  fill(Channel::delta, [&](std::size_t i) { return rudder_at(legs, times[i]); });
  return run;
}

}  // namespace swayaw::linear
