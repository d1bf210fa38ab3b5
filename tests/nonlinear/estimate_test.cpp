#include <catch.hpp>
#include <nlohmann/json.hpp>

#include "json.hpp"
#include "random_ships.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/estimates/clarke.hpp"
#include "swayaw/nonlinear/estimates/estimated_ship.hpp"
#include "swayaw/nonlinear/estimates/kijima.hpp"

/// Coefficients from main dimensions: laws over random hulls, then published numbers.
namespace swayaw {
namespace {

using nlohmann::json;

json reference(const std::string& ship) { return test::json_in(test::golden / "estimates.json").at(ship); }

HullDimensions<double> dimensions(const json& ship) {
  return {.L = ship.at("L_m"), .B = ship.at("B_m"), .d = ship.at("d_m"), .C_B = ship.at("C_B")};
}

HullDimensions<double> dimensions(const MmgShip<double>& ship) {
  const auto& p = ship.particulars;
  return {.L = p.L, .B = p.B, .d = p.d, .C_B = p.nabla / (p.L * p.B * p.d)};
}

/// A merchant ship within the range of the formulas.
HullDimensions<double> random_hull(test::RandomShips& random) {
  const double L = random.uniform(60, 350);
  const auto& range = merchant_ships;
  const double B = L / random.uniform(range.L_over_B.low, range.L_over_B.high);
  return {.L = L,
          .B = B,
          .d = B / random.uniform(range.B_over_d.low, range.B_over_d.high),
          .C_B = random.uniform(range.C_B.low, range.C_B.high)};
}

template <class Part>
void check_same(const Part& a, const Part& b, double relative) {
  for (const auto& p : Part::parameters()) {
    INFO(p.key);
    CHECK_THAT(a.*p.member, WithinRel(b.*p.member, relative));
  }
}

TEST_CASE("primed estimates do not change with the size of the ship", "[nonlinear][limit]") {
  test::RandomShips random(11);
  for (int i = 0; i < 100; ++i) {
    auto hull = random_hull(random);
    hull.trim = random.uniform(0.0, 0.2) * hull.d;
    const double scale = random.uniform(0.01, 1.0);
    const HullDimensions<double> model{
        .L = hull.L * scale, .B = hull.B * scale, .d = hull.d * scale, .C_B = hull.C_B, .trim = hull.trim * scale};
    check_same(zhou_added_mass(model), zhou_added_mass(hull), 1e-12);
    check_same(kijima_hull(model, zhou_added_mass(model), 0.01), kijima_hull(hull, zhou_added_mass(hull), 0.01), 1e-9);
    CHECK_THAT(clarke_derivatives(model).N_rdot, WithinRel(clarke_derivatives(hull).N_rdot, 1e-12));
    CHECK_THAT(dnv_rudder_area(model), WithinRel(dnv_rudder_area(hull) * scale * scale, 1e-12));
    CHECK(estimated_resistance(model, 1.0) > estimated_resistance(hull, 1.0));  // the larger Reynolds number rubs less
  }
}

TEST_CASE("every set of formulas damps sway and yaw and entrains water", "[nonlinear][limit]") {
  test::RandomShips random(12);
  for (int i = 0; i < 1000; ++i) {
    const auto hull = random_hull(random);
    const auto added = zhou_added_mass(hull);
    CHECK(added.m_x > 0.0);
    CHECK(added.m_x < 0.25 * added.m_y);
    CHECK(added.J_z > 0.0);
    for (const auto& h : {yoshimura_masumoto_hull(hull, added), kijima_hull(hull, added),
                          mmg_linear_hull(clarke_derivatives(hull), hull, added.m_x)}) {
      CHECK(h.Y_v < 0.0);
      CHECK(h.N_v < 0.0);
      CHECK(h.N_r < 0.0);
    }
    const auto clarke = clarke_derivatives(hull);
    CHECK(clarke.Y_vdot < 0.0);
    CHECK(clarke.N_rdot < 0.0);
  }
}

TEST_CASE("a deeper ship damps yaw more and a fuller one sway", "[nonlinear][limit]") {
  test::RandomShips random(13);
  for (int i = 0; i < 200; ++i) {
    const auto hull = random_hull(random);
    auto deeper = hull, fuller = hull;
    deeper.d *= 1.1;
    fuller.C_B *= 1.1;
    const auto h = yoshimura_masumoto_hull(hull, zhou_added_mass(hull));
    CHECK(yoshimura_masumoto_hull(deeper, zhou_added_mass(deeper)).N_r < h.N_r);
    CHECK(yoshimura_masumoto_hull(fuller, zhou_added_mass(fuller)).Y_v < h.Y_v);
    CHECK(clarke_derivatives(deeper).N_r < clarke_derivatives(hull).N_r);
    CHECK(clarke_derivatives(fuller).Y_v < clarke_derivatives(hull).Y_v);
  }
}

TEST_CASE("trim by the stern makes the bare hull hold her course better", "[nonlinear][limit]") {
  // Y_v' N_r' − N_v' (Y_r' − m' − m_x'), positive when the hull alone is stable on a straight course
  const auto stability = [](const HullDimensions<double>& hull, double m_x) {
    const auto k = kijima_derivatives(hull, m_x);
    return -k.Y_b * k.N_r + k.N_b * (k.Y_r - mass_prime(hull) - m_x);
  };
  test::RandomShips random(14);
  int within = 0;
  for (int i = 0; i < 400; ++i) {
    const auto even = random_hull(random);
    auto trimmed = even;
    trimmed.trim = random.uniform(0.01, 0.2) * even.d;
    if (!outside(trimmed, loaded_ships).empty()) continue;
    ++within;
    const double m_x = zhou_added_mass(even).m_x;
    CHECK(stability(trimmed, m_x) > stability(even, m_x));
    CHECK_THAT(kijima_derivatives(trimmed, m_x).N_b,
               WithinRel((1.0 - trimmed.trim / even.d) * kijima_derivatives(even, m_x).N_b, 1e-12));
  }
  CHECK(within > 150);
}

TEST_CASE("on an even keel Kijima and Yoshimura agree on Y_v, N_v and N_r", "[nonlinear][second-route]") {
  test::RandomShips random(15);
  for (int i = 0; i < 200; ++i) {
    const auto hull = random_hull(random);
    const auto added = zhou_added_mass(hull);
    const auto a = yoshimura_masumoto_hull(hull, added), b = kijima_hull(hull, added);
    CHECK_THAT(a.Y_v, WithinRel(b.Y_v, 1e-14));
    CHECK_THAT(a.N_v, WithinRel(b.N_v, 1e-14));
    CHECK_THAT(a.N_r, WithinRel(b.N_r, 1e-14));
    // Y_r' = m' + m_x' − 1.5 f with m' = 2 f
    CHECK_THAT(b.Y_r, WithinRel(a.Y_r, 1e-12));
  }
}

TEST_CASE("no other cube is nearer to the square than the one taken", "[nonlinear][second-route]") {
  const HullDimensions<double> hull{.L = 150, .B = 24, .d = 8.5, .C_B = 0.7};
  const auto added = zhou_added_mass(hull);
  const auto exact = kijima_derivatives(hull, added.m_x);
  const CubeRange range{.beta = 0.3, .r_prime = 0.6};
  const auto cubic = kijima_hull(hull, added, 0.0, range);
  const auto error = [](double square, double cube, double end) {  // ∫(s x² − c x³)² by midpoints
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double x = end * (i + 0.5) / 1000.0;
      const double gap = square * x * x - cube * x * x * x;
      sum += gap * gap;
    }
    return sum;
  };
  for (const double nudge : {0.99, 1.01}) {
    CHECK(error(exact.Y_bb, -cubic.Y_vvv * nudge, range.beta) > error(exact.Y_bb, -cubic.Y_vvv, range.beta));
    CHECK(error(exact.N_rr, cubic.N_rrr * nudge, range.r_prime) > error(exact.N_rr, cubic.N_rrr, range.r_prime));
  }
}

TEST_CASE("primes of SNAME and of the MMG standard are undone by each other", "[nonlinear][round-trip]") {
  test::RandomShips random(16);
  for (int i = 0; i < 100; ++i) {
    const auto hull = random_hull(random);
    const double x = random.uniform(-1, 1);
    CHECK_THAT(sname_prime(mmg_prime(x, hull), hull), WithinRel(x, 1e-15));
    // one force in newtons, whichever prime it comes from: ½ρL²U² Y' = ½ρLdU² Y''
    CHECK_THAT(hull.L * hull.L * x, WithinRel(hull.L * hull.d * mmg_prime(x, hull), 1e-14));
  }
}

TEST_CASE("derivatives of the estimates by a dimension agree with differences", "[nonlinear][second-route]") {
  using D = Dual<1>;
  const auto with_draught = [](const auto& d) {
    using S = std::decay_t<decltype(d)>;
    const HullDimensions<S> hull{.L = S(150.0), .B = S(24.0), .d = d, .C_B = S(0.7)};
    return kijima_hull(hull, zhou_added_mass(hull));
  };
  const auto exact = with_draught(D(8.5, 0));
  const auto above = with_draught(8.5 + 1e-5), below = with_draught(8.5 - 1e-5);
  CHECK_THAT(exact.Y_vvv.v[0], WithinRel((above.Y_vvv - below.Y_vvv) / 2e-5, 1e-7));
  CHECK_THAT(exact.N_r.v[0], WithinRel((above.N_r - below.N_r) / 2e-5, 1e-7));
}

// ---------------------------------------------------------------- published numbers

TEST_CASE("the formulas give Kulbiej's initial hull under its exchanged labels", "[nonlinear][published]") {
  const json paper = reference("nawigator_xxi");
  const auto hull = dimensions(paper);
  const double m = mass_prime(hull);
  const MmgAddedMass<double> added{.m_x = m * paper.at("m_x_over_m").get<double>(),
                                   .m_y = m * paper.at("m_y_over_m").get<double>(),
                                   .J_z = 0.0,
                                   .surge_coupling = {}};
  const auto h = yoshimura_masumoto_hull(hull, added, 0.0, DriftSigns::tabulated);
  const json& label = paper.at("printed_label_of");
  for (const auto& p : MmgHull<double>::parameters()) {
    const std::string key(p.key);
    if (key == "R_0") continue;
    INFO(key);
    const double printed = paper.at("printed").at(label.contains(key) ? label.at(key).get<std::string>() : key);
    CHECK_THAT(h.*p.member, WithinAbs(printed, key == "Y_v" ? 1e-4 : 0.5e-4));
  }
}

TEST_CASE("Clarke's added masses of the wPCC agree with the authors' but for a rounded coefficient",
          "[nonlinear][published]") {
  const json paper = reference("wpcc");
  const auto hull = dimensions(paper);
  const auto c = clarke_derivatives(hull);
  CHECK_THAT(c.Y_vdot, WithinRel(paper.at("Y_vdot").get<double>(), 1e-12));
  CHECK_THAT(c.Y_rdot, WithinRel(paper.at("Y_rdot").get<double>(), 1e-12));
  CHECK_THAT(c.N_rdot, WithinRel(paper.at("N_rdot").get<double>(), 1e-12));
  const double s = pi * hull.d * hull.d / (hull.L * hull.L);
  CHECK_THAT(c.N_vdot - 0.001 * s * hull.B / hull.d, WithinRel(paper.at("N_vdot_with_0.04").get<double>(), 1e-11));
}

TEST_CASE("Zhou's added masses of KVLCC2 are the published ones within 4 %", "[nonlinear][published]") {
  const auto ship = test::mmg(test::kvlcc2_l7());
  check_same(zhou_added_mass(dimensions(ship)), ship.added_mass, 0.04);
}

TEST_CASE("estimated hulls of KVLCC2 and KCS lie near the measured ones", "[nonlinear][published]") {
  const auto ship = test::mmg(test::kvlcc2_l7());
  const auto h = yoshimura_masumoto_hull(dimensions(ship), ship.added_mass, ship.particulars.x_G / ship.particulars.L);
  CHECK_THAT(h.Y_v, WithinRel(ship.hull.Y_v, 0.31));
  CHECK_THAT(h.Y_r, WithinRel(ship.hull.Y_r, 0.15));
  CHECK_THAT(h.N_v, WithinRel(ship.hull.N_v, 0.05));
  CHECK_THAT(h.N_r, WithinRel(ship.hull.N_r, 0.10));
  CHECK_THAT(h.Y_vrr, WithinRel(ship.hull.Y_vrr, 0.02));

  const json kcs = reference("kcs");
  const auto hull = dimensions(kcs);
  const auto added = zhou_added_mass(hull);
  const auto k = yoshimura_masumoto_hull(hull, added);
  CHECK_THAT(-k.Y_v, WithinRel(kcs.at("Y_b").get<double>(), 0.23));
  CHECK_THAT(k.Y_r - added.m_x, WithinRel(kcs.at("Y_r_minus_m_x").get<double>(), 0.15));
  CHECK_THAT(-k.N_v, WithinRel(kcs.at("N_b").get<double>(), 0.16));
  CHECK_THAT(k.N_r, WithinRel(kcs.at("N_r").get<double>(), 0.10));
  CHECK_THAT(-k.Y_vrr, WithinRel(kcs.at("Y_brr").get<double>(), 0.10));
  CHECK_THAT(k.N_vvr, WithinRel(kcs.at("N_bbr").get<double>(), 0.01));
}

TEST_CASE("measured hulls have the consistent signs of the drift angle, not the tabulated ones",
          "[nonlinear][published]") {
  const auto ship = test::mmg(test::kvlcc2_l7());
  const json kcs = reference("kcs");
  const auto compare = [](const HullDimensions<double>& hull, const MmgAddedMass<double>& added, double Y_vvv,
                          double N_vrr) {
    const auto a = yoshimura_masumoto_hull(hull, added),
               b = yoshimura_masumoto_hull(hull, added, 0.0, DriftSigns::tabulated);
    CHECK(std::abs(a.Y_vvv - Y_vvv) < 0.12 * std::abs(b.Y_vvv - Y_vvv));
    CHECK(std::abs(a.N_vrr - N_vrr) < 0.17 * std::abs(b.N_vrr - N_vrr));
  };
  compare(dimensions(ship), ship.added_mass, ship.hull.Y_vvv, ship.hull.N_vrr);
  const auto hull = dimensions(kcs);
  compare(hull, zhou_added_mass(hull), -kcs.at("Y_bbb").get<double>(), -kcs.at("N_brr").get<double>());
  // X_βr − m_y' = −1.91 f + 0.08 < 0: the entrained water loses part of what a turning ship would get from m_y v r
  const auto added = zhou_added_mass(hull);
  CHECK_THAT(-yoshimura_masumoto_hull(hull, added).X_vr - added.m_y,
             WithinRel(kcs.at("X_br_minus_m_y").get<double>(), 0.15));
}

TEST_CASE("interaction estimated for KVLCC2 lies near the published one", "[nonlinear][published]") {
  const auto ship = test::mmg(test::kvlcc2_l7());
  const auto i = yoshimura_masumoto_interaction(dimensions(ship), 0.35);
  CHECK_THAT(i.t_R, WithinRel(ship.rudder.t_R, 0.01));
  CHECK_THAT(i.epsilon, WithinRel(ship.rudder.epsilon, 0.03));
  CHECK_THAT(i.kappa, WithinRel(ship.rudder.kappa, 0.04));
  CHECK(i.gamma_R > ship.rudder.gamma_R_negative);
  CHECK(i.gamma_R < ship.rudder.gamma_R_positive);
  CHECK_THAT(dnv_rudder_area(dimensions(test::mmg(test::kvlcc2()))),
             WithinRel(test::mmg(test::kvlcc2()).rudder.A_R, 0.10));
}

// ---------------------------------------------------------------- ranges

TEST_CASE("a hull outside the range is told ratio by ratio", "[nonlinear][refusal]") {
  const HullDimensions<double> barge{.L = 100, .B = 30, .d = 4, .C_B = 0.95, .trim = 1.0};
  const auto sentences = outside(barge, merchant_ships);
  REQUIRE(sentences.size() == 4);
  CHECK(sentences[0] == "C_B = 0.95 lies outside 0.5 to 0.85");
  CHECK(outside({.L = 150, .B = 24, .d = 8.5, .C_B = 0.7}, merchant_ships).empty());
  CHECK_THROWS_AS(outside({.L = 0, .B = 24, .d = 8.5, .C_B = 0.7}, merchant_ships), std::domain_error);
}

}  // namespace
}  // namespace swayaw
