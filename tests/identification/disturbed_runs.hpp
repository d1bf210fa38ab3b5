#pragma once

#include <algorithm>
#include <random>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// Runs of ships that random accelerations disturb, simulated in short steps by code of their own, and what noisy
/// sensors see of them.
namespace swayaw::test {

/// Random accelerations as an process noise describes them.
struct Disturbance {
  ProcessNoise process_noise{{0.0, 0.0, 0.0}};
  bool coloured = true;
  double tau = std::numeric_limits<double>::infinity();  ///< [s]
};

/// What the sensors of a run are like.
using Sensors = std::vector<std::pair<Channel, double>>;

inline const Sensors good_sensors{
    {Channel::x, 0.02}, {Channel::y, 0.02}, {Channel::psi, radians(0.1)}, {Channel::r, radians(0.1)}};

struct DisturbedRun {
  Recording truth;  ///< x, y, psi, u, v, r and controls
  std::vector<PlanarAcceleration<double>> unmodelled;
  Recording run;  ///< controls, and what the sensors saw
  MeasurementNoise noise{};
};

/// Rudder that goes to and fro: `swing` seconds to a side, a fifth of them on the way.
inline double swinging_rudder(double t, double angle, double swing) {
  const double phase = std::fmod(t, 2.0 * swing), ramp = 0.2 * swing;
  const double up = std::min(phase / ramp, 1.0), down = std::clamp((phase - swing) / ramp, 0.0, 1.0);
  return angle * (2.0 * (up - down) - 1.0);
}

struct DisturbedOptions {
  std::size_t samples = 200;
  double step = 0.5;
  double rudder = radians(15);
  double swing = 15.0;  ///< [s]
};

class Disturber {
 public:
  Disturber(const Ship& ship, const Disturbance& by, unsigned seed) : ship_(ship), by_(by), engine_(seed) {}

  DisturbedRun run(const Sensors& sensors, const DisturbedOptions& options) {
    DisturbedRun result;
    simulate(result, options);
    result.run = result.truth;
    result.run.name = "noisy";
    for (const Channel c : measured_channels()) result.run.channels[index_of(c)].clear();
    for (const auto& [channel, deviation] : sensors) {
      auto column = result.run.fill(channel);
      for (std::size_t i = 0; i < column.size(); ++i)
        column[i] = result.truth[channel][i] + deviation * normal_(engine_);
      result.noise[index_of(channel)] = deviation;
    }
    return result;
  }

 private:
  using Accelerations = std::array<double, 3>;

  void simulate(DisturbedRun& result, const DisturbedOptions& options) {
    auto& truth = result.truth;
    for (std::size_t k = 0; k < options.samples; ++k) truth.time.push_back(options.step * static_cast<double>(k));
    const double U = service_speed(ship_);
    auto controls = self_propulsion(ship_, U);
    StateVector<double> s{0.0, 0.0, 0.3, U, 0.0, 0.0};
    for (std::size_t i = 0; i < 3; ++i) a_[i] = std::isfinite(by_.tau) ? size(i) * normal_(engine_) : 0.0;
    for (std::size_t k = 0; k < options.samples; ++k) {
      controls.delta = swinging_rudder(truth.time[k], options.rudder, options.swing);
      record(result, k, s, controls);
      const double next = swinging_rudder(truth.time[k] + options.step, options.rudder, options.swing);
      s = carried_on(s, controls, next, options.step);
    }
  }

  void record(DisturbedRun& result, std::size_t k, const StateVector<double>& s, const Controls<double>& c) const {
    const Channel channels[] = {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r};
    for (std::size_t i = 0; i < 6; ++i) result.truth.fill(channels[i])[k] = s[i];
    const auto ground = over_ground(ship_.surroundings.current, state_of(s));
    result.truth.fill(Channel::speed_over_ground)[k] = speed(ground);
    result.truth.fill(Channel::course_over_ground)[k] = s[2] - drift_angle(ground);
    result.truth.fill(Channel::delta)[k] = c.delta;
    if (c.by_thrust) result.truth.fill(Channel::thrust)[k] = c.thrust.port + c.thrust.starboard;
    else result.truth.fill(Channel::rev)[k] = c.rev;
    result.unmodelled.push_back({a_[0], a_[1], a_[2]});
  }

  /// Over the time between two samples, in 20 steps of Runge and Kutta.
  StateVector<double> carried_on(StateVector<double> s, const Controls<double>& from, double delta, double duration) {
    constexpr int steps = 20;
    const double h = duration / steps;
    for (int i = 0; i < steps; ++i) {
      const auto rudder = [&](double share) {
        return with_rudder(from, from.delta + (i + share) / steps * (delta - from.delta));
      };
      const auto a = mean_acceleration(h);
      const auto rate = [&](const StateVector<double>& at, const Controls<double>& c) { return rates(at, c, a); };
      const auto moved = [&](const StateVector<double>& k, double by) {
        StateVector<double> there = s;
        for (std::size_t j = 0; j < 6; ++j) there[j] += by * k[j];
        return there;
      };
      const auto k1 = rate(s, rudder(0.0)), k2 = rate(moved(k1, 0.5 * h), rudder(0.5)),
                 k3 = rate(moved(k2, 0.5 * h), rudder(0.5)), k4 = rate(moved(k3, h), rudder(1.0));
      for (std::size_t j = 0; j < 6; ++j) s[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
    }
    return s;
  }

  StateVector<double> rates(const StateVector<double>& s, const Controls<double>& c, const Accelerations& a) const {
    const auto state = state_of(s);
    const auto of_model = [&](const auto& model) {
      return rates_of(model, ship_.surroundings, state, c, branch_at(model, state.motion, c));
    };
    auto rate = std::visit(of_model, ship_.model);
    for (std::size_t i = 0; i < 3; ++i) rate[3 + i] += a[i];
    return rate;
  }

  double size(std::size_t i) const {
    return std::array{by_.process_noise.size.u, by_.process_noise.size.v, by_.process_noise.size.r}[i];
  }

  /// The random accelerations over h seconds; keeps their end.
  Accelerations mean_acceleration(double h) {
    Accelerations mean;
    for (std::size_t i = 0; i < 3; ++i) {
      const double shock = size(i) * normal_(engine_), before = a_[i];
      if (!by_.coloured) {
        mean[i] = shock / std::sqrt(h);
        continue;
      }
      const double fading = h / by_.tau;
      a_[i] = std::isfinite(by_.tau) ? before * std::exp(-fading) + shock * std::sqrt(-std::expm1(-2.0 * fading))
                                     : before + shock * std::sqrt(h);
      mean[i] = 0.5 * (before + a_[i]);
    }
    return mean;
  }

  const Ship& ship_;
  Disturbance by_;
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  Accelerations a_{};
};

inline DisturbedRun disturbed_run(const Ship& ship, const Disturbance& by, unsigned seed,
                                  const DisturbedOptions& options = {}, const Sensors& sensors = good_sensors) {
  return Disturber(ship, by, seed).run(sensors, options);
}

/// Gauss–Markov accelerations with a memory of one ship length, 2 % of U²/L and U²/L².
inline Disturbance ordinary(const Ship& ship, double share = 0.02) {
  const double L = length(ship), U = service_speed(ship), a = share * U * U / L;
  return {.process_noise = {{a, a, a / L}}, .tau = L / U};
}

}  // namespace swayaw::test
