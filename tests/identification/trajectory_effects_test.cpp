#include <algorithm>
#include <catch.hpp>
#include <cmath>

#include "effect_runs.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// Fits of trajectories beside every effect, to simulations of the same ship, which step otherwise.
namespace swayaw {
namespace {

/// Largest relative error of the fitted parameters.
double error_of(const TrajectoryFit& fit, const std::vector<Parameter>& truth) {
  double error = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    error = std::max(error, std::abs(fit.parameters[i].estimate.value / truth[i].value - 1.0));
  return error;
}

}  // namespace

// Beside a known effect the linear damping is what it was without it; without the effect in the file it is not.
TEMPLATE_TEST_CASE("coefficients come back from trajectories beside every effect", "[identification][round-trip]",
                   MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>) {
  const auto bare = test::sailing_ship<TestType>();
  const TrajectoryFitOptions options{.parameters = {"Y_v", "N_r"}, .step = 0.01};
  const auto truth = parameters_of(bare, options.parameters);
  const std::array wrong{0.9 * truth[0].value, 1.1 * truth[1].value};
  test::RandomEffects effects(15);
  for (const auto id : effect_ids()) {
    // the first puts other values in the place of these
    const auto effect = id == HullLinearDerivatives<>::id ? std::nullopt : effects.of_kind(id, bare);
    if (!effect) continue;
    INFO(id);
    const auto ship = with_effect(bare, *effect);
    const auto run = test::zigzag_of(ship);
    const auto known = fit_trajectories(with_values(ship, truth, wrong), run, options);
    CHECK(known.status == TrajectoryFitStatus::converged);
    CHECK(error_of(known, truth) < 2e-3);
    // a thrust that is recorded tells what the wake did
    const bool told = id == WakeChange<>::id && !takes_shaft_speed(bare);
    if (!told)
      CHECK(fit_trajectories(with_values(bare, truth, wrong), run, options).log_likelihood < known.log_likelihood);
  }
}

}  // namespace swayaw
