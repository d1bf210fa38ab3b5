#pragma once

#include <algorithm>
#include <vector>

#include "prime_ships.hpp"

/// Zigzags at constant thrust by a plain Runge–Kutta method, as the published ones were made.
namespace swayaw::test {

struct PrimeSample {
  double time, delta;
  ShipState<double> state;
};

using PrimeState = std::array<double, 6>;

template <PrimeShip Ship>
PrimeState rates(const Ship& ship, const PrimeState& s, double delta, double thrust) {
  const PlanarMotion<double> m{s[3], s[4], s[5]};
  const auto a =
      acceleration_at(ship, m, Controls<double>{.delta = delta, .thrust = {thrust / 2, thrust / 2}, .by_thrust = true});
  return {m.u * std::cos(s[2]) - m.v * std::sin(s[2]), m.u * std::sin(s[2]) + m.v * std::cos(s[2]), m.r, a.u, a.v, a.r};
}

/// Samples every `step` from a straight course; `order` tells the rudder order [rad] from a sample, thrust [N] from the
/// time.
template <PrimeShip Ship, class Order, class Thrust>
std::vector<PrimeSample> sail(const Ship& ship, double u_0, double duration, double step, Thrust&& thrust,
                              Order&& order) {
  PrimeState s{0, 0, 0, u_0, 0, 0};
  double delta = 0.0;
  std::vector<PrimeSample> run;
  for (int i = 0; i * step < duration + 0.5 * step; ++i) {
    const double t = i * step;
    run.push_back({t, delta, {s[0], s[1], s[2], {s[3], s[4], s[5]}}});
    const double target = order(run.back()), reach = ship.steering_gear.rate * step;
    const auto rudder = [&](double part) { return delta + std::clamp(target - delta, -part * reach, part * reach); };
    const auto moved = [&](double h, const PrimeState& k) {
      PrimeState result = s;
      for (std::size_t j = 0; j < 6; ++j) result[j] += h * k[j];
      return result;
    };
    const double half = t + 0.5 * step;
    const auto k1 = rates(ship, s, rudder(0), thrust(t)),
               k2 = rates(ship, moved(step / 2, k1), rudder(0.5), thrust(half)),
               k3 = rates(ship, moved(step / 2, k2), rudder(0.5), thrust(half)),
               k4 = rates(ship, moved(step, k3), rudder(1), thrust(t + step));
    for (std::size_t j = 0; j < 6; ++j) s[j] += step / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    delta = rudder(1);
  }
  return run;
}

/// Orders of a zigzag, first to port.
class ZigzagOrders {
 public:
  explicit ZigzagOrders(double angle) : angle_(angle) {}

  double operator()(const PrimeSample& s) {
    // a positive rudder turns to port, psi < 0
    if (-side_ * s.state.psi > angle_) side_ = -side_;
    return side_ * angle_;
  }

 private:
  double angle_;
  double side_ = 1.0;
};

}  // namespace swayaw::test
