#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"

#include <catch.hpp>
#include <cmath>

#include "model_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/estimates/nawigator.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

/// Exact derivatives of manoeuvre indices against differences of the precise manoeuvres.
namespace swayaw {
namespace {

constexpr ManoeuvreOptions precise{.tolerance = 1e-12, .sampled = false, .traced = true};

struct Turn {
  TurnOrder order;
  auto sail(const Ship& ship, const ManoeuvreOptions& options) const { return turning_circle(ship, order, options); }
  auto indices(const TurningCircle& circle) const { return indices_of(circle, order.side); }
};

struct ZigzagTrial {
  ZigzagOrder order;
  auto sail(const Ship& ship, const ManoeuvreOptions& options) const { return zigzag(ship, order, options); }
  auto indices(const Zigzag& result) const { return indices_of(result); }
};

/// Central differences, a step of 2e-5 of the number, or of 1 where it is 0.
template <class Trial>
auto difference(const Ship& ship, const Trial& trial, const ManoeuvreOptions& options, const Parameter& n) {
  const double step = 2e-5 * (n.value == 0.0 ? 1.0 : std::abs(n.value));
  const auto at = [&](double value) {
    return trial.indices(trial.sail(with_values(ship, std::span(&n, 1), std::array{value}), options));
  };
  auto slope = at(n.value + step);
  const auto before = at(n.value - step);
  for (const auto& p : slope.parameters()) slope.*p.member = (slope.*p.member - before.*p.member) / (2.0 * step);
  return slope;
}

/// Largest difference of the two derivatives, as a change of the index by 100 % of the number, over the index.
template <class Trial>
double disagreement(const Ship& ship, const Trial& trial, const ManoeuvreOptions& options,
                    std::span<const Parameter> numbers) {
  const auto result = trial.sail(ship, options);
  const auto indices = trial.indices(result);
  const auto slopes = index_slopes(ship, trial.order, options, result, numbers);
  double worst = 0.0;
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const auto should = difference(ship, trial, options, numbers[j]);
    constexpr auto list = decltype(indices)::parameters();
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto& is = slopes.*decltype(slopes)::parameters()[k].member;
      const double index = indices.*list[k].member;
      CHECK(is.empty() == std::isnan(index));
      if (is.empty()) continue;
      const double size = numbers[j].value == 0.0 ? 1.0 : std::abs(numbers[j].value);
      const double error = std::abs(is[j] - should.*list[k].member) * size / std::abs(index);
      INFO(numbers[j].name << " on " << list[k].key << ": " << is[j] << ", by differences " << should.*list[k].member);
      CHECK(error < 1e-5);
      worst = std::max(worst, error);
    }
  }
  return worst;
}

const std::array<Side, 2> sides{Side::port, Side::starboard};

TEST_CASE("derivatives of turn indices are those of differences for every hull number of MV Nawigator XXI",
          "[nonlinear][second-route]") {
  const Ship ship = nawigator_xxi(NawigatorHull::yoshimura_masumoto, SurgeReading::negative_X_vr);
  auto options = precise;
  options.rev = nawigator_rev;
  for (const Side side : sides)
    for (const double rudder : {15.0, 35.0})
      CHECK(disagreement(ship, Turn{{radians(rudder), side}}, options, coefficients_of(ship, "hull")) < 1e-5);
}

TEST_CASE("derivatives of zigzag indices are those of differences for every hull number of MV Nawigator XXI",
          "[nonlinear][second-route]") {
  const Ship ship = nawigator_xxi(NawigatorHull::yoshimura_masumoto, SurgeReading::negative_X_vr);
  auto options = precise;
  options.rev = nawigator_rev;
  for (const Side side : sides)
    CHECK(disagreement(ship, ZigzagTrial{{radians(20), radians(20), side}}, options, coefficients_of(ship, "hull")) <
          1e-5);
}

TEST_CASE("derivatives of indices hold for every number of an MMG ship, also where self-propulsion follows it",
          "[nonlinear][second-route]") {
  test::RandomShips random(20261122);
  for (int i = 0; i < 2; ++i) {
    auto model = test::symmetric(random.ship());
    model.steering_gear = {
        .rate = 0.08, .max_angle = 0.7, .lag = i == 0 ? 0.0 : 1.5, .dead_band = i == 0 ? 0.0 : 0.002};
    model.particulars.A_front = model.particulars.A_lateral = 0.0;
    const Ship ship = test::ship_of(model);
    auto numbers = parameters_of(ship);
    std::erase_if(numbers, [](const Parameter& n) { return n.value == 0.0 || n.key == "max_angle_deg"; });
    CHECK(disagreement(ship, Turn{{0.5, Side::port}}, precise, numbers) < 1e-5);
    CHECK(disagreement(ship, ZigzagTrial{{0.35, 0.35, Side::starboard}}, precise, numbers) < 1e-5);
  }
}

TEST_CASE("derivatives of indices hold for every published ship, way made included", "[nonlinear][second-route]") {
  for (const auto* name : {"wpcc_pi", "wpcc_pu", "mariner", "kvlcc2"}) {
    INFO(name);
    const Ship ship = published_ship(name);
    auto numbers = coefficients_of(ship, "hull");
    std::erase_if(numbers, [](const Parameter& n) { return n.value == 0.0; });
    const ManoeuvreOptions options{.tolerance = 1e-11, .traced = true};
    CHECK(disagreement(ship, Turn{{radians(20), Side::starboard}}, options, numbers) < 1e-5);
    CHECK(disagreement(ship, ZigzagTrial{{radians(10), radians(10), Side::port}}, options, numbers) < 1e-5);
  }
}

TEST_CASE("a symmetric ship has the same derivatives to both sides", "[nonlinear][symmetry]") {
  test::RandomShips random(77);
  const Ship ship = test::ship_of(test::symmetric(random.ship()));
  const auto numbers = coefficients_of(ship, "hull");
  const auto of = [&](Side side) {
    const TurnOrder order{0.5, side};
    return index_slopes(ship, order, precise, turning_circle(ship, order, precise), numbers);
  };
  const auto port = of(Side::port), starboard = of(Side::starboard);
  for (const auto& p : port.parameters())
    for (std::size_t j = 0; j < (port.*p.member).size(); ++j)
      CHECK_THAT((port.*p.member)[j], WithinRel((starboard.*p.member)[j], 1e-9));
}

TEST_CASE("in wind there are no derivatives of indices", "[nonlinear][refusal]") {
  Ship ship = published_ship("kvlcc2_l7");
  const TurnOrder order{0.5};
  const auto circle = turning_circle(ship, order, precise);
  ship.surroundings.windy = true;
  CHECK_THROWS_AS(index_slopes(ship, order, precise, circle, coefficients_of(ship, "hull")), Refusal);
}

}  // namespace
}  // namespace swayaw
