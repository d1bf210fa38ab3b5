#include "swayaw/identification/nomoto_zigzag.hpp"

#include <catch.hpp>

#include "../linear/random_linear_ships.hpp"
#include "linear_recordings.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/zigzag.hpp"

namespace swayaw {
namespace {

using test::recorded;

using test::ship_time;

TEST_CASE("Nomoto's analysis returns K, T and rudder offset of a first-order ship", "[identification][round-trip]") {
  test::RandomLinearShips random(71);
  for (int k = 0; k < 50; ++k) {
    const double K = random.uniform(-3.0, -0.8), T = random.uniform(0.5, 4.0);
    const auto n = nomoto_zigzag_analysis(recorded(first_order_ship(K, T), {.lengths = 60.0, .rudder_offset = 0.01}));
    REQUIRE_THAT(n.K * ship_time, WithinRel(K, 1e-6));
    REQUIRE_THAT(n.T / ship_time, WithinRel(T, 1e-6));
    REQUIRE_THAT(n.delta_r, WithinAbs(0.01, 1e-8));
  }
}

TEST_CASE("Nomoto's analysis of a second-order ship finds K and T too small, K/T too large",
          "[identification][limit]") {
  test::RandomLinearShips random(72);
  for (int k = 0; k < 50; ++k) {
    // T3 > T1 T2/(T1 + T2 − T3), as of ships
    const double T1 = random.uniform(3.0, 12.0), T2 = random.uniform(0.2, 0.4), T3 = random.uniform(0.7, 1.2),
                 K = random.uniform(-4.0, -1.5);
    const auto ship = coefficients_from(SteeringIndices<double>{T1 * T2, T1 + T2, 0.15, T3, 0.7 * K, K});
    const auto n = nomoto_zigzag_analysis(recorded(ship, {.lengths = 60.0}));
    const double T = T1 + T2 - T3;
    INFO("T1 " << T1 << " T2 " << T2 << " T3 " << T3 << " K " << K << ": K " << n.K * ship_time << ", T "
               << n.T / ship_time);
    CHECK(std::abs(n.K * ship_time) < std::abs(K));
    CHECK(n.T / ship_time < T);
    CHECK(std::abs(n.K / n.T) * ship_time * ship_time > std::abs(K / T));
  }
}

TEST_CASE("a run without three heading peaks is refused", "[identification][refusal]") {
  CHECK_THROWS_WITH(nomoto_zigzag_analysis(recorded(first_order_ship(-1.5, 2.0), {.lengths = 4.0})),
                    ContainsSubstring("three heading peaks"));
}

}  // namespace
}  // namespace swayaw
