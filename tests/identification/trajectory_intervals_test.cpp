#include <catch.hpp>
#include <cmath>

#include "trajectory_recordings.hpp"

namespace swayaw {

TEMPLATE_TEST_CASE("of 100 seeded ships in noisy zigzags each number lies in its 95 % interval for 90 to 99 %",
                   "[identification][second-route]", MmgShip<double>, PiShip<double>, PuShip<double>,
                   AbkowitzShip<double>) {
  constexpr int ships = 100;
  // the forces of the PI model take three times as long
  const auto angles =
      std::is_same_v<TestType, PiShip<double>> ? std::vector{10.0, -20.0} : std::vector{10.0, -10.0, 20.0, -20.0};
  test::RandomModels random(20261202);
  const auto names = test::told_parameters<TestType>();
  std::vector<int> inside(names.size());
  unsigned seed = 0;
  for (int i = 0; i < ships; ++i) {
    auto [ship, runs] = test::steerable<TestType>(random, angles, 15.0, 0.1, 1e-8);
    for (auto& run : runs) test::add_noise(run, ship, ++seed);
    const auto fit = fit_trajectories(test::a_tenth_off(ship, names), runs,
                                      {.parameters = names, .channels = test::usual_channels, .step = 0.05});
    INFO("ship " << i);
    CHECK(fit.status == TrajectoryFitStatus::converged);
    const auto truth = test::values_of(ship, names);
    for (std::size_t k = 0; k < names.size(); ++k)
      inside[k] +=
          std::abs(fit.parameters[k].estimate.value - truth[k]) < 1.96 * fit.parameters[k].estimate.standard_error;
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    INFO(names[k]);
    CHECK(inside[k] >= 90);
    CHECK(inside[k] <= 99);
  }
}

}  // namespace swayaw
