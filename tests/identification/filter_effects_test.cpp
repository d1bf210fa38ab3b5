#include <algorithm>
#include <catch.hpp>
#include <cmath>

#include "effect_runs.hpp"
#include "swayaw/identification/force_fit.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// The filter with every effect, beside simulations of the same ship, which step otherwise.
namespace swayaw {
namespace {

/// Noise of good instruments, and hardly any process noise.
EstimationOptions strict(const Ship& ship) {
  const double L = length(ship), U = service_speed(ship);
  EstimationOptions options{.process_noise =
                                ProcessNoise{{1e-4 * U * U / L, 1e-4 * U * U / L, 1e-4 * U * U / (L * L)}}};
  for (const auto channel : measured_channels()) options.noise[index_of(channel)] = 1e-3 * unit_of(channel, L, U);
  return options;
}

/// Perfect instruments, and as much process noise as a wrong hull needs.
EstimationOptions curious(const Ship& ship) {
  const double L = length(ship), U = service_speed(ship);
  EstimationOptions options{.process_noise = ProcessNoise{{0.1 * U * U / L, 0.1 * U * U / L, 0.1 * U * U / (L * L)}}};
  for (const auto channel : measured_channels()) options.noise[index_of(channel)] = 1e-6 * unit_of(channel, L, U);
  return options;
}

/// Largest root-mean-square innovation of any channel, over its expected size.
double largest_innovation(const StateEstimate& estimate) {
  double largest = 0.0;
  for (const auto& innovation : estimate.innovations) largest = std::max(largest, innovation.rms);
  return largest;
}

// A simulated run has no noise at all, so the innovations of a filter that knows the ship are next to nothing; one that
// does not know the effect is surprised by it.
TEMPLATE_TEST_CASE("the filter knows every effect that simulations know", "[identification][second-route]",
                   MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>) {
  const auto bare = test::sailing_ship<TestType>();
  test::for_each_effect(bare, 11, [&](std::string_view id, const Ship& ship) {
    INFO(id);
    const auto run = test::zigzag_of(ship);
    const auto options = strict(bare);
    const auto known = estimate_states(ship, run, options), unknown = estimate_states(bare, run, options);
    CHECK(largest_innovation(known) < 0.25);
    // a thrust that is recorded tells what the wake did
    const bool told = id == WakeChange<>::id && !takes_shaft_speed(bare);
    if (!told) CHECK(known.noise.log_likelihood > unknown.noise.log_likelihood + 1.0);
  });
}

// Beside a known effect the linear damping is what it was without it; without the effect in the file it is not.
TEMPLATE_TEST_CASE("coefficients come back from forces beside every effect", "[identification][round-trip]",
                   MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>) {
  const auto bare = test::sailing_ship<TestType>();
  const std::array names{std::string("Y_v"), std::string("N_r")};
  const auto truth = parameters_of(bare, names);
  const auto error_with = [&](const Ship& ship, const Recording& run) {
    const auto fit = fit_forces(ship, std::span(&run, 1), {.parameters = {"Y_v", "N_r"}, .states = curious(bare)});
    double error = 0.0;
    for (const auto& n : truth)
      error = std::max(error, std::abs(parameters_of(fit.ship, std::array{n.name})[0].value / n.value - 1.0));
    return error;
  };
  test::RandomEffects effects(12);
  for (const auto id : effect_ids()) {
    // the first puts other values in the place of these
    const auto effect = id == HullLinearDerivatives<>::id ? std::nullopt : effects.of_kind(id, bare);
    if (!effect) continue;
    INFO(id);
    const auto ship = with_effect(bare, *effect);
    const auto run = test::zigzag_of(ship);
    const std::array wrong{0.9 * truth[0].value, 1.1 * truth[1].value};
    const double known = error_with(with_values(ship, truth, wrong), run),
                 unknown = error_with(with_values(bare, truth, wrong), run);
    CHECK(known < 0.02);
    if (unknown > 0.05) CHECK(known < 0.2 * unknown);
  }
}

}  // namespace
}  // namespace swayaw
