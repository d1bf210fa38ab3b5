#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"
#include "swayaw/nonlinear/simulator.hpp"

/// Runs in a wind that is recorded, sailed by the simulator, which knows nothing of replays.
namespace swayaw::test {

/// Velocity of the air, to the north and the east [m/s].
struct AirMoves {
  double north, east;
};

/// A wind whose velocity wanders about its mean with that standard deviation and a memory of some ship lengths.
class WanderingWind {
 public:
  WanderingWind(AirMoves mean, double deviation, double memory, unsigned seed)
      : mean_(mean), deviation_(deviation), memory_(memory), engine_(seed) {}

  /// The wind a time later. Source of its law: x⁺ = a x + σ √(1 − a²) ε, a = exp(−h/τ).
  AirMoves after(double h) {
    const double a = std::exp(-h / memory_), b = deviation_ * std::sqrt(1.0 - a * a);
    about_ = {a * about_.north + b * normal_(engine_), a * about_.east + b * normal_(engine_)};
    return {mean_.north + about_.north, mean_.east + about_.east};
  }

 private:
  AirMoves mean_, about_{0.0, 0.0};
  double deviation_, memory_;
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

/// The rudder 10 deg to either side in turn for `lengths` ship lengths, in that wind; x, y, psi, u, v, r, the rudder,
/// the shaft and the wind as columns, `rate` samples in L/U.
inline Recording run_in_wind(const Ship& ship, WanderingWind wind, double lengths = 40.0, double rate = 50.0) {
  const double unit = time_unit_of(ship), h = unit / rate;
  Simulator simulator(ship);
  Recording run{.name = "gusty.csv", .facts = {}, .time = {}, .channels = {}, .extra = {}};
  const auto samples = static_cast<std::size_t>(lengths * rate);
  for (std::size_t k = 0; k < samples; ++k) run.time.push_back(static_cast<double>(k) * h);
  const std::array shown{Channel::x, Channel::y,     Channel::psi, Channel::u,          Channel::v,
                         Channel::r, Channel::delta, Channel::rev, Channel::wind_speed, Channel::wind_from};
  for (const auto channel : shown) run.fill(channel);
  for (std::size_t k = 0; k < samples; ++k) {
    const auto [north, east] = wind.after(h);
    simulator.set_wind({std::hypot(north, east), std::atan2(-east, -north)});
    if (k % static_cast<std::size_t>(5.0 * rate) == 0)
      simulator.order_rudder(radians(k / static_cast<std::size_t>(5.0 * rate) % 2 == 0 ? 10.0 : -10.0));
    const auto values = simulator.instruments();
    for (const auto channel : shown) run.channels[index_of(channel)][k] = values[index_of(channel)];
    simulator.step(h);
  }
  return run;
}

inline Recording without_wind(Recording run) {
  for (const auto channel : {Channel::wind_speed, Channel::wind_from}) run.channels[index_of(channel)].clear();
  return run;
}

}  // namespace swayaw::test
