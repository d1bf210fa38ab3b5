#include <catch.hpp>
#include <cmath>
#include <vector>

#include "swayaw/app/sweep/points.hpp"

namespace swayaw::app {
namespace {

constexpr std::size_t many = 200000;

std::vector<double> draws(std::uint64_t seed, std::uint64_t dimension) {
  std::vector<double> u(many);
  for (std::size_t i = 0; i < many; ++i) u[i] = unit_draw(seed, i, dimension);
  return u;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b, std::size_t shift = 0) {
  double sum = 0.0;
  for (std::size_t i = 0; i + shift < a.size(); ++i) sum += (a[i + shift] - 0.5) * (b[i] - 0.5);
  return 12.0 * sum / static_cast<double>(a.size() - shift);
}

TEST_CASE("draws are uniform and do not know their neighbours", "[sweep]") {
  const double allowed = 4.0 / std::sqrt(static_cast<double>(many));  // 4 standard errors of a correlation
  for (const std::uint64_t seed : {0u, 1u, 2u, 77u}) {
    const auto u = draws(seed, 0), other_dimension = draws(seed, 1), other_seed = draws(seed + 1, 0);
    std::vector<int> bin(100);
    for (const double x : u) {
      REQUIRE((x > 0.0 && x < 1.0));
      ++bin[static_cast<std::size_t>(100.0 * x)];
    }
    double chi_squared = 0.0;
    const double expected = many / 100.0;
    for (const int n : bin) chi_squared += (n - expected) * (n - expected) / expected;
    CHECK(chi_squared < 99.0 + 4.0 * std::sqrt(2.0 * 99.0));
    CHECK(std::abs(correlation(u, u, 1)) < allowed);
    CHECK(std::abs(correlation(u, u, 2)) < allowed);
    CHECK(std::abs(correlation(u, other_dimension)) < allowed);
    CHECK(std::abs(correlation(u, other_seed)) < allowed);
    CHECK(std::abs(correlation(u, other_seed, 1)) < allowed);
  }
}

TEST_CASE("a normal law has its mean and deviation, and is cut where the range ends", "[sweep]") {
  const auto law = normal_law(-3.0, 0.5, any_number);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < many; ++i) {
    const double x = law.quantile(unit_draw(5, i, 0));
    sum += x, squares += x * x;
  }
  const double mean = sum / many;
  CHECK_THAT(mean, WithinAbs(-3.0, 4.0 * 0.5 / std::sqrt(many)));
  CHECK_THAT(std::sqrt(squares / many - mean * mean), WithinRel(0.5, 0.01));
  CHECK_THAT(law.quantile(0.5 + 0.34134474606854293), WithinAbs(-2.5, 1e-12));

  const auto cut = normal_law(0.1, 1.0, positive);
  double above = 0.0;
  for (std::size_t i = 0; i < many; ++i) {
    const double x = cut.quantile(unit_draw(6, i, 0));
    REQUIRE(x >= 0.0);
    above += x > 0.1;
  }
  // of what is above 0, which is Phi(0.1), a half of the whole lies above the centre
  CHECK_THAT(above / many, WithinAbs(0.5 / 0.5398278372770290, 4.0 * 0.5 / std::sqrt(many)));
}

TEST_CASE("a grid has every combination once", "[sweep]") {
  const std::vector<Law> laws{values_law({1.0, 2.0}), values_law({10.0, 20.0, 30.0}), values_law({5.0})};
  REQUIRE(point_count(SweepDesign::grid, 1, laws) == 6);
  std::vector<std::vector<double>> all;
  for (std::size_t p = 0; p < 6; ++p) {
    std::vector<double> values(3);
    values_of_point(SweepDesign::grid, 1, laws, p, values);
    all.push_back(values);
  }
  CHECK(all ==
        std::vector<std::vector<double>>{{1, 10, 5}, {1, 20, 5}, {1, 30, 5}, {2, 10, 5}, {2, 20, 5}, {2, 30, 5}});
}

TEST_CASE("points of a pair differ from A in the parameter of their place alone", "[sweep]") {
  const std::vector<Law> laws{uniform_law(0.0, 1.0), uniform_law(2.0, 3.0), normal_law(0.0, 1.0, any_number)};
  REQUIRE(point_count(SweepDesign::sobol, 4, laws) == 20);
  const auto point = [&](std::size_t p) {
    std::vector<double> values(3);
    values_of_point(SweepDesign::sobol, 8, laws, p, values);
    return values;
  };
  for (std::size_t pair = 0; pair < 4; ++pair) {
    const auto a = point(5 * pair), b = point(5 * pair + 1);
    for (std::size_t d = 0; d < 3; ++d) {
      auto expected = a;
      expected[d] = b[d];
      CHECK(a[d] != b[d]);
      CHECK(point(5 * pair + 2 + d) == expected);
    }
  }
}

}  // namespace
}  // namespace swayaw::app
