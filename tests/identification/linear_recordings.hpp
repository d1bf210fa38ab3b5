#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "../linear/random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/linear/response.hpp"

/// Recordings of linear ships with known truth: a zigzag of the ship herself, sampled, with noise.
namespace swayaw::test {

inline constexpr double ship_length = 100.0, ship_speed = 7.0;
inline constexpr double ship_time = ship_length / ship_speed;

template <class T>
std::array<T, 6> listed(const SwayYawCoefficients<T>& m) {
  return {m.a1, m.b1, m.c1, m.a2, m.b2, m.c2};
}

struct RecordedZigzag {
  double rudder = radians(10.0);
  double heading = radians(10.0);
  double rate = 0.6;      ///< of the rudder, radians per ship length
  double lengths = 25.0;  ///< duration in ship lengths
  double step = 0.07;     ///< between samples, ship lengths
  LinearState<double> start{};
  double rudder_offset = 0.0;  ///< acts besides the recorded angle [rad]
  double noise = 0.0;          ///< of psi and of drift [rad]; of omega' 0.3 times that
  double disturbance = 0.0;    ///< random forces: growth of beta with the root of time; of omega' three times that
  double correlation = 0.0;    ///< of the noise of heading and drift, in ship lengths; 0 for white noise
  double speed_loss = 0.0;     ///< share of the speed lost evenly over the run
  double irregular = 0.0;      ///< share of the step by which samples are early or late
  bool drift = true;
  unsigned seed = 1;
};

/// Noise of given standard deviation and correlation length.
class Noise {
 public:
  Noise(double size, double correlation) : size_(size), correlation_(correlation) {}

  template <class Engine>
  double operator()(double step, Engine& engine) {
    const double kept = correlation_ > 0.0 ? std::exp(-step / correlation_) : 0.0;
    now_ = kept * now_ + std::sqrt(1.0 - kept * kept) * size_ * std::normal_distribution<double>()(engine);
    return now_;
  }

 private:
  double size_, correlation_, now_ = 0.0;
};

/// The zigzag sampled. Orders are given at samples and between samples the rudder moves in straight lines, so that the
/// recording is exact.
inline Recording recorded(const SwayYawCoefficients<double>& ship, const RecordedZigzag& wish) {
  const LinearResponse<double> response(ship);
  std::mt19937_64 engine(wish.seed);
  std::normal_distribution<double> normal;
  Noise psi_noise(wish.noise, wish.correlation), beta_noise(wish.noise, wish.correlation);
  const double reach = wish.rate * wish.step, step_s = wish.step * ship_length / ship_speed;
  Recording run;
  run.name = "linear ship";
  const auto count = static_cast<std::size_t>(wish.lengths / wish.step);
  std::uniform_real_distribution<double> late(-0.5 * wish.irregular, 0.5 * wish.irregular);
  for (std::size_t i = 0; i < count; ++i) run.time.push_back((static_cast<double>(i) + late(engine)) * step_s);
  const auto speed = [&](std::size_t i) {
    return ship_speed * (1.0 - wish.speed_loss * static_cast<double>(i) / static_cast<double>(count));
  };
  const auto psi = run.fill(Channel::psi), r = run.fill(Channel::r), delta = run.fill(Channel::delta),
             u = run.fill(Channel::u);
  const auto v = wish.drift ? run.fill(Channel::v) : std::span<double>{};
  LinearState<double> x = wish.start;
  double order = -wish.rudder;  // to starboard
  delta[0] = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) {
      delta[i] = delta[i - 1] + std::clamp(order - delta[i - 1], -reach, reach);
      const double s = 0.5 * (speed(i) + speed(i - 1)) / ship_length * (run.time[i] - run.time[i - 1]),
                   root = std::sqrt(s) * wish.disturbance;
      x = state_after(response, x, {delta[i - 1] + wish.rudder_offset, (delta[i] - delta[i - 1]) / s}, s);
      x.beta += root * normal(engine);
      x.omega += 3.0 * root * normal(engine);
    }
    if (x.psi * order < 0.0 && std::abs(x.psi) > wish.heading) order = -order;
    const double beta = x.beta + beta_noise(wish.step, engine);
    psi[i] = x.psi + psi_noise(wish.step, engine);
    r[i] = (x.omega + 0.3 * wish.noise * normal(engine)) * speed(i) / ship_length;
    u[i] = wish.drift ? speed(i) * std::cos(beta) : speed(i);
    if (wish.drift) v[i] = -speed(i) * std::sin(beta);
  }
  return run;
}

struct ShipAndZigzag {
  SwayYawCoefficients<double> ship;
  Recording run;
};

/// Seeded ships around the tanker, stable and not, whose zigzag stays a zigzag.
inline std::vector<ShipAndZigzag> random_zigzags(std::size_t count) {
  RandomLinearShips random(61);
  std::vector<ShipAndZigzag> result;
  while (result.size() < count) {
    const SwayYawCoefficients<double> ship{random.uniform(-0.9, -0.4),  random.uniform(0.3, 0.6),
                                           random.uniform(-0.25, -0.1), random.uniform(2.0, 5.0),
                                           random.uniform(-3.5, -2.0),  random.uniform(-2.0, -1.0)};
    const auto run = recorded(ship, {.start = {0.01, -0.03, 0.02}, .rudder_offset = 0.005});
    const auto psi = run[Channel::psi];
    if (std::ranges::max(psi) < 1.5 && std::ranges::min(psi) > -1.5) result.push_back({ship, run});
  }
  return result;
}

/// A tanker that does not keep her course: T1 = −10.6, T2 = 0.31.
inline SwayYawCoefficients<double> unstable_ship() { return {-0.5, 0.4, -0.15, 4.0, -2.6, -1.4}; }

}  // namespace swayaw::test
