#pragma once

#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "trajectory_recordings.hpp"

/// Manoeuvres of seeded ships of every model as a trial records them: a straight approach in any direction, noise,
/// rounding, a current.
namespace swayaw::test {

/// What the instruments add. Times in L/U: 0.02 to 0.08 are half a second to two of a ship with L/U = 25 s.
struct TrialInstruments {
  double step = 0.04;              ///< between samples [L/U]
  double approach = 2.0;           ///< recorded time before the execute [L/U]
  double heading = 0.05;           ///< noise [deg]
  double heading_digit = 0.01;     ///< rounding [deg]
  double place = 1e-3;             ///< noise [L]
  double speed = 5e-3;             ///< noise [U]
  double rudder = 0.1;             ///< noise [deg]
  double north = 0.0, east = 0.0;  ///< current [U]
  double turned = 0.0;             ///< heading of the approach [rad]
  double smoothing = 0.0;          ///< of heading and speeds, by a bell of this standard deviation [L/U]
};

/// Means over neighbours, weighted by a bell of that standard deviation [samples].
inline void smooth(std::span<double> values, double width) {
  const std::vector<double> raw(values.begin(), values.end());
  const auto half = static_cast<std::ptrdiff_t>(4.0 * width), last = static_cast<std::ptrdiff_t>(raw.size()) - 1;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    double sum = 0.0, weights = 0.0;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(i - half, 0); k <= std::min(i + half, last); ++k) {
      const double z = static_cast<double>(k - i) / width, weight = std::exp(-0.5 * z * z);
      sum += weight * raw[static_cast<std::size_t>(k)];
      weights += weight;
    }
    values[static_cast<std::size_t>(i)] = sum / weights;
  }
}

inline TrialInstruments random_instruments(RandomModels& random) {
  return {.step = random.uniform(0.02, 0.08),
          .approach = random.uniform(1.0, 4.0),
          .heading = random.uniform(0.02, 0.1),
          .heading_digit = random.uniform(0.0, 1.0) < 0.5 ? 0.1 : 0.01,
          .place = random.uniform(3e-4, 3e-3),
          .speed = random.uniform(2e-3, 1e-2),
          .rudder = random.uniform(0.02, 0.2),
          .north = 0.0,
          .east = 0.0,
          .turned = random.uniform(-pi, pi)};
}

/// The run with an approach before it, turned, drifting, noisy and rounded. Its execute is at the time 100.
inline Recording as_trial(const Recording& run, double L, double U, const TrialInstruments& wish, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const double dt = run.time[1] - run.time[0];
  const auto before = static_cast<std::size_t>(wish.approach * L / U / dt);
  Recording trial;
  trial.name = "trial.csv";
  for (std::size_t i = 0; i < before + run.samples(); ++i)
    trial.time.push_back(100.0 + (static_cast<double>(i) - static_cast<double>(before)) * dt);
  const auto x = trial.fill(Channel::x), y = trial.fill(Channel::y), psi = trial.fill(Channel::psi),
             u = trial.fill(Channel::u), v = trial.fill(Channel::v), delta = trial.fill(Channel::delta);
  const double c = std::cos(wish.turned), s = std::sin(wish.turned), digit = radians(wish.heading_digit);
  for (std::size_t i = 0; i < trial.samples(); ++i) {
    const double t = trial.time[i] - 100.0;
    const bool straight = i < before;
    const std::size_t k = straight ? 0 : i - before;
    const double ahead = straight ? U * t : run[Channel::x][k], across = straight ? 0.0 : run[Channel::y][k];
    x[i] = ahead * c - across * s + wish.north * U * t + wish.place * L * normal(engine);
    y[i] = ahead * s + across * c + wish.east * U * t + wish.place * L * normal(engine);
    psi[i] = wish.turned + (straight ? 0.0 : run[Channel::psi][k]) + radians(wish.heading) * normal(engine);
    u[i] = (straight ? U : run[Channel::u][k]) + wish.speed * U * normal(engine);
    v[i] = (straight ? 0.0 : run[Channel::v][k]) + wish.speed * U * normal(engine);
    delta[i] = (straight ? 0.0 : run[Channel::delta][k]) + radians(wish.rudder) * normal(engine);
  }
  if (wish.smoothing > 0.0)
    for (const auto channel : {psi, u, v}) smooth(channel, wish.smoothing * L / U / dt);
  for (double& heading : psi) heading = std::round(heading / digit) * digit;
  return trial;
}

/// A seeded ship of the model with a steering gear that takes 35 deg over in a ship length and a half.
template <class Model>
std::optional<Ship> trial_ship(RandomModels& random) {
  auto model = tame<Model>(random);
  if (!damps_yaw(model)) return std::nullopt;
  model.steering_gear = {
      .rate = 0.4 * model.particulars.U_0 / model.particulars.L, .max_angle = 0.7, .lag = 0.0, .dead_band = 0.0};
  return ship_of(model);
}

}  // namespace swayaw::test
