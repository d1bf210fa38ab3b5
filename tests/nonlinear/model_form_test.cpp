#include <catch.hpp>
#include <cmath>
#include <random>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// The form of forces that no model has, against symmetry and rest.
namespace swayaw {
namespace {

using Catch::Matchers::WithinAbs;

ModelForm<> random_form(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  ModelForm<> form;
  for (const auto& p : ModelForm<>::parameters()) form.*p.member = 1e-3 * normal(engine);
  return form;
}

PlanarForce<double> added(const ModelForm<>& form, const PlanarMotion<double>& motion, double delta) {
  const Ship bare = test::kvlcc2_l7();
  const ShipState<double> state{0.0, 0.0, 0.4, motion};
  const Controls<double> controls{.delta = delta, .rev = 10.0};
  const auto with = force_breakdown(with_effect(bare, form), state, controls).total,
             without = force_breakdown(bare, state, controls).total;
  return {with.X - without.X, with.Y - without.Y, with.N - without.N};
}

}  // namespace

TEST_CASE("another form turns the other way as its mirror image, but for what differs from side to side",
          "[nonlinear][symmetry]") {
  std::mt19937_64 engine(31);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 50; ++i) {
    auto form = random_form(engine);
    const PlanarMotion<double> motion{1.0 + 0.3 * uniform(engine), 0.3 * uniform(engine), 0.1 * uniform(engine)};
    const double delta = radians(35.0) * uniform(engine);
    const auto sided = form;
    form.Y_u = form.N_u = form.Y_Rg = form.Y_Rw = 0.0;
    const auto a = added(form, motion, delta), b = added(form, {motion.u, -motion.v, -motion.r}, -delta);
    CHECK_THAT(a.X - b.X, WithinAbs(0.0, 1e-9 * std::abs(a.X) + 1e-9));
    CHECK_THAT(a.Y + b.Y, WithinAbs(0.0, 1e-9 * std::abs(a.Y) + 1e-9));
    CHECK_THAT(a.N + b.N, WithinAbs(0.0, 1e-9 * std::abs(a.N) + 1e-9));
    const auto c = added(sided, motion, delta), d = added(sided, {motion.u, -motion.v, -motion.r}, -delta);
    CHECK(std::abs(c.Y + d.Y) > 0.0);
  }
}

TEST_CASE("what a rudder differs by from side to side is the same force in a motion and in its mirror image",
          "[nonlinear][symmetry]") {
  const Ship ship = test::kvlcc2_l7();
  const double U = service_speed(ship), L = length(ship), q = 0.5 * 1000.0 * L * L * U * U;
  const PlanarMotion<double> turning{0.8 * U, -0.15 * U, 0.5 * U / L}, other{0.8 * U, 0.15 * U, -0.5 * U / L};
  const double beta_R = 0.15 + 0.9 * 0.5, beta_P = 0.15 + 0.48 * 0.5, alpha = 0.8 * radians(20.0) - 0.45 * beta_R;
  const auto check = [&](const ModelForm<>& form, double Y) {
    const auto a = added(form, turning, radians(20.0)), b = added(form, other, radians(-20.0));
    CHECK_THAT(a.Y / q, WithinAbs(Y, 1e-9));
    CHECK_THAT(b.Y / q, WithinAbs(Y, 1e-9));
    CHECK_THAT(a.N, WithinAbs(-0.48 * L * a.Y, 1e-6 * std::abs(L * a.Y)));
    CHECK_THAT(a.X, WithinAbs(0.0, 1e-9 * q));
  };
  check({.Y_Rg = 1e-3}, 1e-3 * 0.8 * beta_R);
  check({.Y_Rw = 1e-3}, 1e-3 * -beta_P * alpha);
}

TEST_CASE("another form fades with the way of the ship", "[nonlinear][limit]") {
  std::mt19937_64 engine(32);
  const auto form = random_form(engine);
  const auto moving = added(form, {1.0, 0.0, 0.0}, radians(20.0)),
             hardly = added(form, {1e-6, 0.0, 0.0}, radians(20.0));
  CHECK(std::abs(hardly.X) < 1e-5 * std::abs(moving.X) + 1e-9);
  CHECK(std::abs(hardly.Y) < 1e-5 * std::abs(moving.Y) + 1e-9);
  CHECK(std::abs(hardly.N) < 1e-5 * std::abs(moving.N) + 1e-9);
}

TEST_CASE("terms of the rudder beyond an angle do nothing before it", "[nonlinear][limit]") {
  const ModelForm<> form{.Y_d15 = 1e-3, .N_a28 = 1e-3};
  const PlanarMotion<double> ahead{1.1, 0.0, 0.0};
  CHECK(added(form, ahead, radians(14.9)).Y == 0.0);
  CHECK(added(form, ahead, radians(-27.9)).N == 0.0);
  CHECK(added(form, ahead, radians(-20.0)).Y < 0.0);
  CHECK(added(form, ahead, radians(30.0)).N > 0.0);
}

TEST_CASE("lift is lost to stall where a rudder is put over against a turn, not in it", "[nonlinear][limit]") {
  const ModelForm<> form{.Y_a28 = 1e-3, .N_a28 = 1e-3};
  const Ship ship = test::kvlcc2_l7();
  const double U = service_speed(ship), L = length(ship);
  const PlanarMotion<double> turning{0.6 * U, -0.2 * U, 0.4 * U / L};  // to starboard
  const auto in_the_turn = added(form, turning, radians(35.0)), against_it = added(form, turning, radians(-20.0));
  CHECK(in_the_turn.N == 0.0);
  CHECK(against_it.N < 0.0);
  // 20 deg and those of the flow, less 28, beside 30 less 28 on a straight course
  const double over = 0.6 * radians(20.0) + 0.45 * (0.2 + 0.9 * 0.4) - 0.6 * radians(28.0);
  CHECK_THAT(against_it.Y / added(form, {U, 0.0, 0.0}, radians(30.0)).Y, WithinAbs(-over / radians(2.0), 1e-9));
}

}  // namespace swayaw
