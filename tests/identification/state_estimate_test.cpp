#include "swayaw/identification/state_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

namespace swayaw {
namespace {

struct NoisyRun {
  Recording truth;
  Recording run;
  MeasurementNoise noise{};
};

/// A simulated zigzag of the KVLCC2 model with white noise on position, heading and yaw rate.
NoisyRun noisy_zigzag(const Ship& ship, unsigned seed, double step = 0.2) {
  NoisyRun result{.truth = zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.step = step}).run,
                  .run = {}};
  result.run.name = "noisy";
  result.run.time = result.truth.time;
  for (const Channel c : {Channel::delta, Channel::rev}) std::ranges::copy(result.truth[c], result.run.fill(c).begin());
  std::mt19937_64 engine(seed);
  for (const auto& [channel, deviation] :
       {std::pair{Channel::x, 0.02}, {Channel::y, 0.02}, {Channel::psi, radians(0.1)}, {Channel::r, radians(0.1)}}) {
    std::normal_distribution<double> noise(0.0, deviation);
    auto column = result.run.fill(channel);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = result.truth[channel][i] + noise(engine);
    result.noise[index_of(channel)] = deviation;
  }
  return result;
}

double rms(const StateEstimate& estimate, const Recording& truth, Channel channel, auto&& value) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.samples(); ++i)
    sum += std::pow(value(estimate.states[i].state) - truth[channel][i], 2);
  return std::sqrt(sum / static_cast<double>(truth.samples()));
}

TEST_CASE("a known ship in noise is found far closer than her measurements, and the smoother beats the filter",
          "[identification][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto [truth, run, noise] = noisy_zigzag(ship, 1);
  const ProcessNoise small{{1e-4, 1e-4, 1e-5}};
  const auto smooth = estimate_states(ship, run, {.noise = noise, .process_noise = small});
  const auto filtered = estimate_states(ship, run, {.noise = noise, .process_noise = small, .smooth = false});
  const auto heading = [](const ShipState<double>& s) { return s.psi; };
  const auto sway = [](const ShipState<double>& s) { return s.motion.v; };
  CHECK(rms(smooth, truth, Channel::psi, heading) < 0.3 * radians(0.1));
  CHECK(rms(smooth, truth, Channel::psi, heading) < rms(filtered, truth, Channel::psi, heading));
  CHECK(rms(smooth, truth, Channel::v, sway) < rms(filtered, truth, Channel::v, sway));
}

TEST_CASE("a force that the model lacks comes out over time", "[identification][second-route]") {
  Ship truth_ship = test::kvlcc2_l7();
  std::get<MmgShip<double>>(truth_ship.model).rudder.f_alpha *= 0.7;
  const Ship ship = test::kvlcc2_l7();
  const auto [truth, run, noise] = noisy_zigzag(truth_ship, 4);
  const auto estimate = estimate_states(ship, run, {.noise = noise});
  double error = 0.0, size = 0.0;
  const auto acceleration_of = [](const Ship& s, const ShipState<double>& state, const Controls<double>& c) {
    const auto& model = std::get<MmgShip<double>>(s.model);
    return acceleration(model, state.motion, forces(model, state.motion, c).total());
  };
  for (std::size_t i = 20; i + 20 < truth.samples(); ++i) {
    const ShipState<double> state{0, 0, 0, {truth[Channel::u][i], truth[Channel::v][i], truth[Channel::r][i]}};
    const Controls<double> c{truth[Channel::delta][i], truth[Channel::rev][i]};
    const double missing = acceleration_of(truth_ship, state, c).r - acceleration_of(ship, state, c).r;
    error += std::pow(estimate.states[i].unmodelled.r - missing, 2);
    size += missing * missing;
  }
  CHECK(std::sqrt(error / size) < 0.35);
}

TEST_CASE("missing samples, gaps and a wrapped heading do no harm", "[identification][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto [truth, run, noise] = noisy_zigzag(ship, 5);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    if (i % 3 == 0) run.fill(Channel::psi)[i] = missing;
    if (i > 100 && i < 140) run.fill(Channel::x)[i] = run.fill(Channel::y)[i] = missing;
    if (i > 200) run.fill(Channel::psi)[i] += 2.0 * pi;
  }
  const auto estimate = estimate_states(ship, run, {.noise = noise, .process_noise = ProcessNoise{{1e-4, 1e-4, 1e-5}}});
  CHECK(rms(estimate, truth, Channel::psi, [](const auto& s) { return s.psi; }) < radians(0.1));
  CHECK(rms(estimate, truth, Channel::x, [](const auto& s) { return s.x; }) < 0.03);
}

TEST_CASE("speed and course over ground tell the motion in place of position", "[identification][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto [truth, run, noise] = noisy_zigzag(ship, 6);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double u = truth[Channel::u][i], v = truth[Channel::v][i];
    run.fill(Channel::speed_over_ground)[i] = std::hypot(u, v);
    run.fill(Channel::course_over_ground)[i] = truth[Channel::psi][i] + std::atan2(v, u);
  }
  noise[index_of(Channel::speed_over_ground)] = 0.005;
  noise[index_of(Channel::course_over_ground)] = 0.005;
  const EstimationOptions options{.channels = {Channel::psi, Channel::speed_over_ground, Channel::course_over_ground},
                                  .noise = noise,
                                  .process_noise = ProcessNoise{{1e-4, 1e-4, 1e-5}}};
  const auto estimate = estimate_states(ship, run, options);
  CHECK(rms(estimate, truth, Channel::v, [](const auto& s) { return s.motion.v; }) < 0.005);
}

TEST_CASE("a run that tells neither position nor speed is refused", "[identification][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  auto [truth, run, noise] = noisy_zigzag(ship, 7);
  CHECK_THROWS_WITH(estimate_states(ship, run, {.channels = {Channel::psi, Channel::r}}),
                    "noisy: neither position nor speed is among the channels used");
}

}  // namespace
}  // namespace swayaw
