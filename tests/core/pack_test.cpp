#include "swayaw/core/pack.hpp"

#include <catch.hpp>
#include <cmath>
#include <random>

namespace swayaw {
namespace {

TEST_CASE("elementary functions of packs are those of numbers", "[core][second-route]") {
  std::mt19937_64 engine(11);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int i = 0; i < 100'000; ++i) {
    const double angle = i % 3 == 0 ? uniform(-9e4, 9e4) : uniform(-2.0, 2.0);
    const auto [s, c] = sin_cos(Pack(angle));
    REQUIRE_THAT(s.get(0), WithinAbs(std::sin(angle), 3e-16));
    REQUIRE_THAT(c.get(0), WithinAbs(std::cos(angle), 3e-16));
    const double x = std::exp(uniform(-30.0, 6.0));
    REQUIRE_THAT(decay(Pack(x)).get(0), WithinRel(std::exp(-x), 5e-16));
    const double across = uniform(-1.0, 1.0) * std::exp(uniform(-20.0, 20.0)), ahead = uniform(-1.0, 1.0);
    REQUIRE_THAT(angle_of(Pack(across), Pack(ahead)).get(0), WithinAbs(std::atan2(across, ahead), 9e-16));
  }
}

TEST_CASE("the angle of a vector on an axis is exact, and that of none is nothing", "[core][limit]") {
  for (const double y : {-2.0, 0.0, 2.0})
    for (const double x : {-3.0, 3.0})
      CHECK(angle_of(Pack(y == 0.0 ? 0.0 : y * 1e-300), Pack(x)).get(0) == std::atan2(y == 0.0 ? 0.0 : y * 1e-300, x));
  CHECK(angle_of(Pack(1.0), Pack(0.0)).get(0) == std::atan2(1.0, 0.0));
  CHECK(angle_of(Pack(0.0), Pack(0.0)).get(0) == 0.0);
}

TEST_CASE("each lane of a pack is independent of the others", "[core][symmetry]") {
  alignas(64) double lane[Pack::size];
  for (std::size_t i = 0; i < Pack::size; ++i) lane[i] = 0.3 + 1e3 * static_cast<double>(i);
  const Pack mixed = Pack::load_aligned(lane);
  CHECK(sin_cos(mixed).sin.get(0) == sin_cos(Pack(0.3)).sin.get(0));
  CHECK(decay(mixed).get(0) == decay(Pack(0.3)).get(0));
  CHECK(angle_of(Pack(0.3), mixed).get(0) == angle_of(Pack(0.3), Pack(0.3)).get(0));
}

}  // namespace
}  // namespace swayaw
