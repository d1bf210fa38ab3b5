#include "swayaw/nonlinear/linearization.hpp"

#include <cmath>

#include "catch.hpp"
#include "model_ships.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/response.hpp"
#include "swayaw/nonlinear/equilibria.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

namespace swayaw {
namespace {

using test::ship_of;

OperatingPoint straight(const Ship& ship) { return straight_course(ship, service_speed(ship)); }

// ---------------------------------------------------------------- second routes

TEST_CASE("the parts of a linearization add up, and equal extrapolated differences", "[nonlinear][second-route]") {
  test::RandomShips random(51);
  for (int i = 0; i < 100; ++i) {
    const auto model = random.ship();
    const Ship ship = ship_of(model);
    const auto propulsion = self_propulsion(model, model.particulars.U_0);
    for (const auto& turn : steady_turn_curve(ship, propulsion, 0.6, 0.2)) {
      const OperatingPoint point{turn.motion, with_rudder(propulsion, turn.delta)};
      if (has_kink(ship, point)) continue;
      const auto linear = linearize(ship, point);
      const auto branch = branch_at(model, point.motion, point.controls);
      const double L = model.particulars.L, U = linear.scale.U;
      const auto along = [&](std::size_t k, double h) {
        auto [m, c] = point;
        double* const moved[] = {&m.u, &m.v, &m.r, &c.delta};
        *moved[k] += h;
        const auto a = acceleration(model, m, forces(model, m, c, branch).total());
        return std::array{a.u, a.v, a.r};
      };
      const double steps[] = {1e-3 * U, 1e-3 * U, 1e-3 * U / L, 1e-3},
                   units[] = {U * U / L, U * U / L, U * U / (L * L)};
      for (std::size_t k = 0; k < 4; ++k) {
        const double h = steps[k];
        const auto p1 = along(k, h), m1 = along(k, -h), p2 = along(k, 2 * h), m2 = along(k, -2 * h);
        for (std::size_t j = 0; j < 3; ++j) {
          const double difference = (8.0 * (p1[j] - m1[j]) - (p2[j] - m2[j])) / 12e-3;
          REQUIRE_THAT(linear.whole.d[j][k] * h * 1e3, WithinAbs(difference, 1e-8 * units[j]));
        }
      }
    }
  }
}

/// Largest difference of a step response of the rudder and of the linear ship over five ship lengths, in U and U/L.
double error_of_linear_response(const Ship& ship, double delta) {
  const auto linear = linearize(ship, straight(ship));
  const auto equations = sway_yaw(linear.whole, linear.scale);
  REQUIRE(is_stable(equations));
  const LinearResponse<double> answer(equations);
  const auto [L, U] = linear.scale;
  const auto circle = turning_circle(ship, {.rudder = delta, .side = Side::port},
                                     {.duration = 5.0 * L / U, .step = 0.05 * L / U, .tolerance = 1e-12});
  double worst = 0.0;
  for (std::size_t i = 0; i < circle.run.samples(); ++i) {
    const auto small = state_after(answer, {0.0, 0.0, 0.0}, {delta, 0.0}, circle.run.time[i] * U / L);
    worst = std::max({worst, std::abs(circle.run[Channel::u][i] / U - 1.0),
                      std::abs(-circle.run[Channel::v][i] / U - small.beta),
                      std::abs(circle.run[Channel::r][i] * L / U - small.omega)});
  }
  return worst;
}

void check_second_order(ShipModel model) {
  std::visit([](auto& m) { m.steering_gear.rate = 1e3, m.steering_gear.lag = 0.0; }, model);
  const Ship ship = test::ship_of(model);
  double before = error_of_linear_response(ship, 0.02);
  for (const double delta : {0.01, 0.005, 0.0025}) {
    const double error = error_of_linear_response(ship, delta);
    INFO("delta " << delta);
    CHECK(std::log2(before / error) == Approx(2.0).margin(0.05));
    before = error;
  }
}

TEST_CASE("errors of the linear response to a small rudder fall with its square", "[nonlinear][second-route]") {
  // a stable tanker without kinks; a wake that changes with |beta| would change the speed at first order
  auto tanker = test::mmg(test::kvlcc2_l7());
  tanker.rudder.gamma_R_positive = tanker.rudder.gamma_R_negative = 0.9;
  tanker.propeller.C_1 = 0.0;
  tanker.hull.N_r *= 1.5;
  check_second_order(tanker);
  check_second_order(test::pi_ship("wpcc_pi"));
  check_second_order(test::wpcc_pu());
  check_second_order(test::symmetric(test::mariner()));
}

// ---------------------------------------------------------------- limits and symmetry

TEST_CASE("the derivatives of a mirrored ship are those of the other side", "[nonlinear][symmetry]") {
  test::RandomShips random(52);
  for (int i = 0; i < 50; ++i) {
    const auto model = random.ship();
    const Ship ship = ship_of(model), mirror = ship_of(test::mirrored(model));
    const auto port = sway_yaw(linearize(ship, straight(ship), Side::port).whole, {.L = 1.0, .U = 1.0});
    const auto starboard = sway_yaw(linearize(mirror, straight(mirror), Side::starboard).whole, {.L = 1.0, .U = 1.0});
    for (const auto& p : port.parameters()) CHECK(port.*p.member == Approx(starboard.*p.member).epsilon(1e-12));
  }
}

TEST_CASE("without a side the derivatives are the mean of both sides", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const auto point = straight(ship);
  CHECK(has_kink(ship, point));
  const auto both = linearize(ship, point), port = linearize(ship, point, Side::port),
             starboard = linearize(ship, point, Side::starboard);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(both.whole.d[i][k] == Approx(0.5 * (port.whole.d[i][k] + starboard.whole.d[i][k])).margin(1e-15));
}

TEST_CASE("without rudder and propeller the SNAME derivatives of the MMG hull are its own", "[nonlinear][published]") {
  auto model = test::mmg(test::kvlcc2_l7());
  model.rudder.A_R = 1e-30;
  const Ship ship = ship_of(model);
  const auto d = sname(linearize(ship, straight(ship)));
  const double over = model.particulars.d / model.particulars.L;  // ½ρLd over ½ρL²
  CHECK(d.Y_v == Approx(model.hull.Y_v * over));
  CHECK(d.Y_r == Approx((model.hull.Y_r - model.added_mass.m_x) * over));
  CHECK(d.N_v == Approx(model.hull.N_v * over));
  CHECK(d.N_r == Approx(model.hull.N_r * over));
  CHECK(d.Y_vdot == Approx(-model.added_mass.m_y * over));
  CHECK(d.N_rdot == Approx(-model.added_mass.J_z * over));
  CHECK(d.Y_rdot == Approx(0.0).margin(1e-15));
}

TEST_CASE("the poles of the straight course are those of surge and of the coupled equations",
          "[nonlinear][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto linear = linearize(ship, straight(ship));
  const auto h = transfer_functions(sway_yaw(linear.whole, linear.scale));
  const double t = linear.scale.L / linear.scale.U;
  for (const auto& pole : linear.poles) {
    const auto s = pole * t;
    const bool surge = std::abs(pole - linear.whole.d[0][0]) < 1e-12;
    if (!surge) CHECK(std::abs(s * s + h.e1 * s + h.e0) < 1e-10);
  }
}

// ---------------------------------------------------------------- refusals

TEST_CASE("a ship at rest, or one that accelerates, is not linearized", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  CHECK_THROWS_WITH(linearize(ship, {{0.0, 0.0, 0.0}, {0.0, 10.0}}),
                    "a ship is linearized under way ahead, not at u = 0 m/s");
  CHECK_THROWS_AS(linearize(ship, {{1.0, 0.2, 0.0}, {0.0, 10.0}}), Refusal);
}

}  // namespace
}  // namespace swayaw
