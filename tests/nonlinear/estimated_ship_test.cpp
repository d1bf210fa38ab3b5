#include "swayaw/nonlinear/estimates/estimated_ship.hpp"

#include <catch.hpp>

#include "coaster.hpp"
#include "random_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// Ships made of main dimensions: they are complete, hold their speed, and sail.
namespace swayaw {
namespace {

using test::coaster;

/// A merchant ship within the range of the formulas and her service speed, Froude number 0.12 to 0.22.
std::pair<HullDimensions<double>, double> random_merchant(test::RandomShips& random) {
  const double L = random.uniform(60, 350), B = L / random.uniform(4.5, 8.0);
  const HullDimensions<double> hull{
      .L = L, .B = B, .d = B / random.uniform(2.0, 4.5), .C_B = random.uniform(0.5, 0.85)};
  return {hull, random.uniform(0.12, 0.22) * std::sqrt(9.81 * L)};
}

Ship named(const MmgShip<double>& model) {
  return {.name = "estimated", .model = model, .confidence = {}, .surroundings = {}};
}

/// Ships of 200 that make a 20/20 zigzag with four overshoots below 60 deg.
int sailing(HullFormula formula) {
  test::RandomShips random(20);
  int count = 0;
  for (int i = 0; i < 200; ++i) {
    const auto [hull, speed] = random_merchant(random);
    const auto estimate = estimated_mmg_ship(hull, speed, {.hull = formula});
    const auto run = zigzag(named(estimate.ship), {.rudder = radians(20), .heading = radians(20)}, {.sampled = false});
    const auto good = [](const Reversal& r) { return r.overshoot && *r.overshoot < radians(60); };
    count += run.reversals.size() >= 4 && std::all_of(run.reversals.begin(), run.reversals.begin() + 4, good);
  }
  return count;
}

TEST_CASE("all of 200 random merchant ships sail a 20/20 zigzag on the hull of Yoshimura and Masumoto",
          "[nonlinear][limit]") {
  CHECK(sailing(HullFormula::yoshimura_masumoto) == 200);
}

TEST_CASE("all of 200 random merchant ships sail a 20/20 zigzag on the hull of Kijima", "[nonlinear][limit]") {
  CHECK(sailing(HullFormula::kijima) == 200);
}

TEST_CASE("an estimated ship is complete and every number a ship file must give lies in its range",
          "[nonlinear][limit]") {
  test::RandomShips random(21);
  for (int i = 0; i < 200; ++i) {
    const auto [hull, speed] = random_merchant(random);
    const auto estimate = estimated_mmg_ship(hull, speed);
    CHECK(estimate.warnings.empty());
    const auto check = [&](const auto& section) {
      const auto& part = estimate.ship.*section.part;
      for (const auto& p : part.parameters()) {
        INFO(section.table << "." << p.key);
        CHECK(std::isfinite(part.*p.member));
        if (p.required) CHECK(p.range.contains(part.*p.member / p.si));
      }
    };
    std::apply([&](const auto&... section) { (check(section), ...); }, MmgShip<double>::sections());
    CHECK(estimate.ship.hull.Y_v < 0.0);
    CHECK(estimate.ship.hull.N_r < 0.0);
  }
}

TEST_CASE("an estimated ship holds her service speed and is mirror-symmetric", "[nonlinear][symmetry]") {
  const auto ship = estimated_mmg_ship(coaster, 7.272).ship;
  const double rev = self_propulsion_rev(ship, 7.272);
  const auto straight = forces(ship, PlanarMotion<double>{7.272, 0.0, 0.0}, Controls<double>{0.0, rev}).total();
  CHECK_THAT(straight.X, WithinAbs(0.0, 1e-6 * 0.5 * 1025 * coaster.L * coaster.d * 7.272 * 7.272));
  CHECK(straight.Y == 0.0);
  CHECK(straight.N == 0.0);
  const PlanarMotion<double> turning{6.0, -1.0, 0.01};
  const auto starboard = forces(ship, turning, Controls<double>{-0.3, rev}).total();
  const auto port = forces(ship, mirrored(turning), Controls<double>{0.3, rev}).total();
  CHECK(port.X == starboard.X);
  CHECK(port.Y == -starboard.Y);
  CHECK(port.N == -starboard.N);
}

TEST_CASE("KVLCC2 from main dimensions turns up to a third wider than published, an eighth with her resistance known",
          "[nonlinear][published]") {
  const auto published = test::kvlcc2();
  const auto& ship = test::mmg(published);
  const auto& p = ship.particulars;
  const HullDimensions<double> hull{.L = p.L, .B = p.B, .d = p.d, .C_B = p.nabla / (p.L * p.B * p.d)};
  const TurnOrder hard_over{.rudder = radians(35)};
  const auto truth = turning_circle(published, hard_over);
  const auto compare = [&](const EstimateOptions& options, double share) {
    const auto guess = turning_circle(named(estimated_mmg_ship(hull, p.U_0, options).ship), hard_over);
    CHECK_THAT(guess.advance.value(), WithinRel(truth.advance.value(), share));
    CHECK_THAT(guess.tactical_diameter.value(), WithinRel(truth.tactical_diameter.value(), share));
  };
  compare({.x_G = p.x_G}, 0.30);
  compare({.x_G = p.x_G, .resistance = ship.hull.R_0}, 0.12);
}

TEST_CASE("what is given is taken and what is not is told", "[nonlinear][limit]") {
  const auto bare = estimated_mmg_ship(coaster, 7.272);
  const auto known = estimated_mmg_ship(coaster, 7.272,
                                        {.rudder_area = 12.2,
                                         .rudder_height = 5.0,
                                         .propeller_diameter = 4.0,
                                         .wake_fraction = 0.326,
                                         .thrust_deduction = 0.2,
                                         .resistance = 0.02});
  CHECK(known.ship.rudder.A_R == 12.2);
  CHECK(known.ship.rudder.H_R == 5.0);
  CHECK(known.ship.propeller.D == 4.0);
  CHECK(known.ship.propeller.w_P0 == 0.326);
  CHECK(known.ship.propeller.t_P == 0.2);
  CHECK(known.ship.hull.R_0 == 0.02);
  CHECK(bare.assumptions.size() == known.assumptions.size() + 6);
  CHECK_THAT(bare.ship.rudder.A_R, WithinRel(dnv_rudder_area(coaster), 1e-15));
}

TEST_CASE("a ship outside the range is made and told of", "[nonlinear][refusal]") {
  const auto barge = estimated_mmg_ship({.L = 100, .B = 30, .d = 6, .C_B = 0.7}, 5.0);
  REQUIRE(barge.warnings.size() == 2);
  CHECK(barge.warnings[0] == "L/B = 3.333 lies outside 4.5 to 8");
}

TEST_CASE("senseless questions to the estimate are refused in words", "[nonlinear][refusal]") {
  auto trimmed = coaster;
  trimmed.C_B = 0.8;
  trimmed.trim = 1.0;
  CHECK_THROWS_AS(estimated_mmg_ship(trimmed, 7.0), Refusal);
  CHECK(estimated_mmg_ship(trimmed, 7.0, {.hull = HullFormula::kijima}).warnings.empty());
  CHECK_THROWS_AS(estimated_mmg_ship(coaster, 0.0), std::domain_error);
  CHECK_THROWS_AS(estimated_mmg_ship({.L = 100, .B = -16, .d = 6, .C_B = 0.7}, 7.0), std::domain_error);
  CHECK_THROWS_AS(estimated_mmg_ship(coaster, 7.0, {.rudder_area = -3.0}), std::domain_error);
  CHECK_THROWS_AS(fujii_slope(0.0), std::domain_error);
}

}  // namespace
}  // namespace swayaw
