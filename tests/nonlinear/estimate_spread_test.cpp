#include "swayaw/nonlinear/estimates/estimate_spread.hpp"

#include <catch.hpp>

#include "coaster.hpp"
#include "random_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/estimates/clarke.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// How far estimates are trusted: formulas beside each other, and measured ships beside both.
namespace swayaw {
namespace {

using test::coaster;

const CoefficientSpread& of(const std::vector<CoefficientSpread>& spread, std::string_view key) {
  const auto found = std::ranges::find(spread, key, &CoefficientSpread::key);
  REQUIRE(found != spread.end());
  return *found;
}
const CoefficientSpread& of(std::vector<CoefficientSpread>&&, std::string_view) = delete;  // it would be gone

std::vector<CoefficientSpread> spread_of(const HullDimensions<double>& hull, const EstimateOptions& options = {},
                                         const std::vector<Ship>& measured = measured_ships()) {
  return estimate_spread(hull, estimated_mmg_ship(hull, 7.0, options), options, measured);
}

TEST_CASE("formulas of one origin count once and others by their own numbers", "[nonlinear][second-route]") {
  const auto spread = spread_of(coaster, {}, {});
  const auto& Y_v = of(spread, "Y_v");
  REQUIRE(Y_v.formulas.size() == 3);  // Kijima's Y_v is that of Yoshimura and Masumoto
  CHECK(Y_v.distinct() == 2);
  const double m_x = zhou_added_mass(coaster).m_x;
  const double other = mmg_linear_hull(clarke_derivatives(coaster), coaster, m_x).Y_v;
  CHECK_THAT(Y_v.between_formulas, WithinRel(std::abs(other / Y_v.value - 1.0), 1e-12));
  const auto all = spread_of(coaster);
  const auto& X_vv = of(all, "X_vv");
  CHECK(X_vv.distinct() == 1);
  CHECK(X_vv.between_formulas == 0.0);
  CHECK(X_vv.relative() == std::min(X_vv.from_measured, least_trust));
}

TEST_CASE("the departure of the measured ships is that of estimates from their own dimensions",
          "[nonlinear][second-route]") {
  double sum = 0.0;
  for (const char* name : {"kvlcc2", "kcs"}) {
    const Ship ship = published_ship(name);
    const auto& model = test::mmg(ship);
    const auto& p = model.particulars;
    const HullDimensions<double> hull{.L = p.L, .B = p.B, .d = p.d, .C_B = p.nabla / (p.L * p.B * p.d)};
    const double error = model.hull.N_vvr - yoshimura_masumoto_hull(hull, zhou_added_mass(hull)).N_vvr;
    sum += error * error;
  }
  const auto spread = spread_of(coaster);
  const auto& N_vvr = of(spread, "N_vvr");
  CHECK_THAT(N_vvr.from_measured * std::abs(N_vvr.value), WithinRel(std::sqrt(sum / 2.0), 1e-12));
}

TEST_CASE("a coefficient that is given has the trust of a published one, and none has more", "[nonlinear][limit]") {
  const auto bare = spread_of(coaster), known = spread_of(coaster, {.wake_fraction = 0.3, .resistance = 0.01});
  CHECK(of(bare, "R_0").relative() > trust_in_published);
  CHECK(of(known, "R_0").relative() == trust_in_published);
  CHECK(of(known, "wake_fraction").given);
  for (const auto& s : bare) CHECK(s.relative() >= trust_in_published);
}

TEST_CASE("only formulas that take a trim tell a trimmed hull", "[nonlinear][limit]") {
  auto trimmed = coaster;
  trimmed.trim = 0.7;
  const auto spread = spread_of(trimmed, {.hull = HullFormula::kijima});
  REQUIRE(of(spread, "Y_v").formulas.size() == 1);
  CHECK(of(spread, "Y_v").formulas.front().formula == "Kijima");
  CHECK(of(spread, "Y_v").between_formulas == 0.0);
  CHECK(of(spread, "X_vv").formulas.front().formula == "Yoshimura and Masumoto");
}

/// How many coefficients of a ship lie within one and two deviations of their estimates.
struct Coverage {
  int one = 0, two = 0, all = 0;
};

/// Of the coefficients that formulas tell; trust comes from the formulas and from other ships than this one.
Coverage covered(std::string_view name, const std::vector<Ship>& others) {
  const Ship ship = published_ship(name);
  const auto& model = test::mmg(ship);
  const auto& p = model.particulars;
  const HullDimensions<double> hull{.L = p.L, .B = p.B, .d = p.d, .C_B = p.nabla / (p.L * p.B * p.d)};
  const EstimateOptions options{.rho = model.water.rho, .x_G = p.x_G, .k_zz_prime = p.k_zz / p.L};
  const auto spread = estimate_spread(hull, estimated_mmg_ship(hull, p.U_0, options), options, others);
  Coverage coverage;
  for (const auto& truth : parameters_of(ship)) {
    const auto s = std::ranges::find(spread, std::string(truth.key), &CoefficientSpread::key);
    if (s == spread.end() || s->formulas.empty()) continue;
    const double deviations = std::abs(truth.value / s->value - 1.0) / s->relative();
    coverage.one += deviations <= 1.0;
    coverage.two += deviations <= 2.0;
    ++coverage.all;
  }
  return coverage;
}

TEST_CASE("deviations cover published coefficients of ships that took no part in them", "[nonlinear][published]") {
  // A normal error is within one deviation in 68 % and within two in 95 % of the cases
  Coverage sum;
  for (const auto& c : {covered("kvlcc2", {published_ship("kcs")}), covered("kcs", {published_ship("kvlcc2")}),
                        covered("esso_osaka_3m", measured_ships())}) {
    CAPTURE(c.one, c.two, c.all);
    CHECK(c.all == 27);
    sum = {sum.one + c.one, sum.two + c.two, sum.all + c.all};
  }
  CAPTURE(sum.one, sum.two, sum.all);
  CHECK(sum.one >= 0.65 * sum.all);
  CHECK(sum.two >= 0.90 * sum.all);
}

// ---------------------------------------------------------------- two of each

TEST_CASE("two screws as one have the thrust and the race of both at their shaft speed", "[nonlinear][second-route]") {
  const EstimateOptions twin{.propeller_diameter = 3.0, .screws = 2, .rudders = 2};
  const auto one = estimated_mmg_ship(coaster, 7.0, twin).ship.propeller;
  CHECK_THAT(one.D, WithinRel(3.0 * std::sqrt(2.0), 1e-15));
  // each: k_0 = 2 k_0', k_1 = sqrt(2) k_1', k_2 = k_2'
  const double n = 3.1, u_P = 5.0, J = u_P / (n * 3.0), J_one = u_P / (n * one.D);
  const double K_T = 2.0 * one.k_0 + std::sqrt(2.0) * one.k_1 * J + one.k_2 * J * J;
  const double K_T_one = one.k_0 + one.k_1 * J_one + one.k_2 * J_one * J_one;
  CHECK_THAT(std::pow(one.D, 4) * K_T_one, WithinRel(2.0 * std::pow(3.0, 4) * K_T, 1e-12));  // thrust over ρn²
  CHECK_THAT(K_T_one / (J_one * J_one), WithinRel(K_T / (J * J), 1e-12));                    // loading, hence race
  CHECK_THAT(one.w_P0, WithinRel(0.55 * coaster.C_B - 0.20, 1e-12));
}

TEST_CASE("two rudders as one have their total area, the slope of each, and its share in the race",
          "[nonlinear][second-route]") {
  const double slope = fujii_slope(4.0 * 4.0 / 6.0);
  const auto in_one_race =
      estimated_mmg_ship(coaster, 7.0, {.rudder_area = 12.0, .rudder_height = 4.0, .rudders = 2}).ship;
  CHECK(in_one_race.rudder.A_R == 12.0);
  CHECK(in_one_race.rudder.H_R == 4.0);
  CHECK_THAT(in_one_race.rudder.f_alpha, WithinRel(slope, 1e-14));
  const auto each_its_own =
      estimated_mmg_ship(
          coaster, 7.0,
          {.rudder_area = 12.0, .rudder_height = 4.0, .propeller_diameter = 3.0, .screws = 2, .rudders = 2})
          .ship;
  CHECK(each_its_own.rudder.A_R == 12.0);
  CHECK_THAT(each_its_own.rudder.f_alpha, WithinRel(slope, 1e-14));
  CHECK_THAT(each_its_own.propeller.D / each_its_own.rudder.H_R, WithinRel(3.0 / 4.0, 1e-14));
}

TEST_CASE("one rudder between two screws, and three of anything, are refused", "[nonlinear][refusal]") {
  CHECK_THROWS_AS(estimated_mmg_ship(coaster, 7.0, {.screws = 2}), Refusal);
  CHECK_THROWS_AS(estimated_mmg_ship(coaster, 7.0, {.screws = 3, .rudders = 3}), Refusal);
}

// ---------------------------------------------------------------- any hull

TEST_CASE("a random ship with her confidence is written, read back the same, sails, and is alike to both sides",
          "[nonlinear][round-trip]") {
  test::RandomShips random(31);
  for (int i = 0; i < 50; ++i) {
    const double L = random.uniform(60, 350), B = L / random.uniform(4.5, 8.0);
    const HullDimensions<double> hull{
        .L = L, .B = B, .d = B / random.uniform(2.0, 4.5), .C_B = random.uniform(0.5, 0.85)};
    const int screws = random.uniform(0, 1) < 0.5 ? 1 : 2;
    const double U = random.uniform(0.12, 0.22) * std::sqrt(9.81 * L);
    const EstimateOptions options{.screws = screws, .rudders = screws};
    const auto guess = estimated_mmg_ship(hull, U, options);
    const Ship ship{.name = "random",
                    .model = guess.ship,
                    .confidence = confidence_of(estimate_spread(hull, guess, options)),
                    .surroundings = {}};
    const Ship again = parse_ship(ship_text(ship), "random.toml");
    const auto before = parameters_of(ship), after = parameters_of(again);
    REQUIRE(before.size() == after.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      INFO(before[k].name);
      CHECK(after[k].value == before[k].value);
      CHECK(after[k].deviation == before[k].deviation);
    }
    const auto& model = test::mmg(again);
    const PlanarMotion<double> turning{0.8 * U, -0.1 * U, 0.3 * U / L};
    const double rev = self_propulsion_rev(model, U);
    const auto starboard = forces(model, turning, Controls<double>{-0.3, rev}).total();
    const auto port = forces(model, mirrored(turning), Controls<double>{0.3, rev}).total();
    CHECK(port.X == starboard.X);
    CHECK(port.Y == -starboard.Y);
    CHECK(port.N == -starboard.N);
    if (i % 5 != 0) continue;
    const auto run = zigzag(again, {.rudder = radians(20), .heading = radians(20)}, {.sampled = false});
    REQUIRE(run.reversals.size() >= 4);
    for (int k = 0; k < 4; ++k) CHECK(run.reversals[static_cast<std::size_t>(k)].overshoot.value_or(pi) < radians(60));
  }
}

}  // namespace
}  // namespace swayaw
