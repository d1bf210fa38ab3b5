#include <catch.hpp>
#include <filesystem>
#include <vector>

#include "random_ships.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/mismatch/compare.hpp"

/// The free-running KVLCC2 models of HSVA and MARIN (SIMMAN 2008) against the published MMG coefficients.
namespace swayaw {
namespace {

std::vector<Comparison> compared(const std::filesystem::path& folder, Shaft shaft) {
  const Ship ship = test::kvlcc2_l7();
  std::vector<Comparison> comparisons;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".csv")
      comparisons.push_back(
          compare(ship, read_recording(entry.path()).recording, {.window_lengths = 2.0, .replay = {.shaft = shaft}}));
  return comparisons;
}

TEST_CASE("the KVLCC2 recordings can be compared, every quantity of every run", "[mismatch][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto comparisons = compared(*folder, Shaft::recorded);
  CHECK(comparisons.size() == 10);
  for (const auto& c : comparisons) {
    INFO(c.recorded.name);
    REQUIRE(c.errors.size() == all_quantities.size());
    for (const auto& e : c.errors) {
      CHECK(std::isfinite(e.window_rms));
      CHECK(std::isfinite(e.open_loop_rms));
      CHECK(e.window_rms > 0.5 * e.noise);
    }
  }
}

TEST_CASE("the published propeller does not carry the KVLCC2 models at their recorded shaft speed",
          "[mismatch][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  // the models had a propeller of 0.204 m, the published set one of 0.216 m and less thrust at 10.2 1/s
  const auto recorded = compared(*folder, Shaft::recorded), propelled = compared(*folder, Shaft::self_propulsion);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    INFO(recorded[i].recorded.name);
    for (std::size_t k = 0; k < recorded[i].errors.size(); ++k) {
      if (recorded[i].errors[k].quantity != Quantity::speed) continue;
      const double slow = recorded[i].errors[k].bias, carried = propelled[i].errors[k].bias;
      const bool large_rudder = recorded[i].recorded.facts.manoeuvre.starts_with("zigzag 30/");
      CHECK(slow < -0.01);
      // with 30 deg of rudder the models lost more speed than the published set, which now makes the simulation too
      // fast
      if (large_rudder) CHECK(carried > 0.01);
      else CHECK(std::abs(carried) < 0.01);
    }
  }
}

}  // namespace
}  // namespace swayaw
