#pragma once

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "../nonlinear/model_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Recorded zigzags of seeded ships, and starts for fits to them.
namespace swayaw::test {

/// Parameters that zigzags to both sides tell apart, for each model.
template <class Model>
std::vector<std::string> told_parameters() {
  if constexpr (std::is_same_v<Model, MmgShip<double>>) return {"Y_v", "Y_r", "N_v", "N_r", "N_rrr", "R_0"};
  else if constexpr (std::is_same_v<Model, PiShip<double>>) return {"Y_v", "Y_r", "N_v", "N_r", "X_rr"};
  else if constexpr (std::is_same_v<Model, PuShip<double>>) return {"Y_v", "Y_r", "N_v", "N_r", "Y_delta", "N_delta"};
  else return {"Y_v", "Y_r", "N_v", "N_r", "Y_d", "N_d"};
}

/// Zigzags D/D of each of these angles [deg], to starboard first where positive, without noise, sampled every `step`
/// ship lengths. The rudder moves in straight lines between the samples, as a fit takes it to.
inline std::vector<Recording> zigzags(const Ship& ship, const std::vector<double>& angles, double lengths, double step,
                                      double tolerance = 1e-12) {
  const double unit = time_unit_of(ship);
  std::vector<Recording> runs;
  for (const double angle : angles) {
    const ZigzagOrder order{.rudder = radians(std::abs(angle)),
                            .heading = radians(std::abs(angle)),
                            .first = angle > 0.0 ? Side::starboard : Side::port};
    const auto run = zigzag(ship, order, {.duration = lengths * unit, .step = step * unit, .tolerance = tolerance}).run;
    runs.push_back(replay_from(ship, RecordedControls(ship, run), recorded_state(ship, run, 0.0), run.time,
                               {.tolerance = tolerance}));
    runs.back().name = "zigzag";
  }
  return runs;
}

/// A zigzag of a ship that can be steered: she turns both ways and back, and keeps way.
inline bool is_zigzag(const Recording& run) {
  const auto psi = run[Channel::psi], u = run[Channel::u];
  const double right = std::ranges::max(psi), left = -std::ranges::min(psi), most = std::max(right, left),
               least = std::min(right, left);
  return most < 1.2 && least > 0.5 * radians(10.0) && std::ranges::min(u) > 0.4 * u[0];
}

/// The ship part of the way to another one, number by number; terms that the other lacks only a twentieth of that way.
template <class Model>
Model nearer(Model ship, Model other, double way) {
  std::vector<double> goal;
  for_each_value(other, [&](double x) { goal.push_back(x); });
  std::size_t i = 0;
  for_each_value(ship, [&](double& x) {
    const double to = goal[i++];
    x = to == 0.0 ? 0.05 * x : to + way * (x - to);
  });
  return ship;
}

/// A seeded ship. Those of the polynomial models keep near the published one: large terms at random drive a ship out of
/// bounds.
template <class Model>
Model tame(RandomModels& random) {
  if constexpr (std::is_same_v<Model, PuShip<double>>) return nearer(random.ship<Model>(), wpcc_pu(), 1.0);
  else if constexpr (std::is_same_v<Model, AbkowitzShip<double>>) return nearer(random.ship<Model>(), mariner(), 0.4);
  else return random.ship<Model>();
}

/// A hull that damps yaw.
template <class Model>
bool damps_yaw(const Model& ship) {
  return ship.hull.N_r < 0.0;
}

/// A steerable seeded ship of the model and her zigzags.
template <class Model>
std::pair<Ship, std::vector<Recording>> steerable(RandomModels& random, const std::vector<double>& angles,
                                                  double lengths, double step, double tolerance = 1e-12) {
  while (true) {
    auto model = tame<Model>(random);
    if (!damps_yaw(model)) continue;
    model.steering_gear = {
        .rate = 0.4 * model.particulars.U_0 / model.particulars.L, .max_angle = 0.6, .lag = 0.0, .dead_band = 0.0};
    const Ship ship = ship_of(model);
    try {
      auto runs = zigzags(ship, angles, lengths, step, tolerance);
      if (std::ranges::all_of(runs, is_zigzag)) return {ship, std::move(runs)};
    } catch (const Refusal&) {}
  }
}

/// The ship with these parameters off by a tenth, up and down by turns.
inline Ship a_tenth_off(const Ship& ship, const std::vector<std::string>& names) {
  const auto parameters = parameters_of(ship, names);
  std::vector<double> values;
  for (const auto& n : parameters) values.push_back(n.value * (values.size() % 2 == 0 ? 1.1 : 0.9));
  return with_values(ship, parameters, values);
}

inline const std::vector<Channel> usual_channels{Channel::x, Channel::y, Channel::psi, Channel::r, Channel::u};

/// White noise: 0.001 L on place, 0.1 deg on heading, 0.01 U/L on yaw rate, 1 % on the log.
inline void add_noise(Recording& run, const Ship& ship, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const double L = length(ship), U = service_speed(ship);
  const auto shake = [&](Channel channel, double size) {
    for (double& x : run.fill(channel)) x += size * normal(engine);
  };
  shake(Channel::x, 1e-3 * L);
  shake(Channel::y, 1e-3 * L);
  shake(Channel::psi, radians(0.1));
  shake(Channel::r, 0.01 * U / L);
  shake(Channel::u, 0.01 * U);
}

inline std::vector<double> values_of(const Ship& ship, const std::vector<std::string>& names) {
  std::vector<double> values;
  for (const auto& n : parameters_of(ship, names)) values.push_back(n.value);
  return values;
}

}  // namespace swayaw::test
