#include "swayaw/linear/response.hpp"

#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <catch.hpp>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using test::RandomLinearShips;
using Response = LinearResponse<double>;

/// The same by very many classical Runge–Kutta steps in long double.
LinearState<double> slowly_after(const SwayYawCoefficients<double>& m, LinearState<double> start,
                                 RudderLine<double> rudder, double end) {
  using R = long double;
  const int steps = 40'000;
  const R h = R(end) / steps;
  R b = start.beta, w = start.omega, psi = start.psi;
  const auto f = [&](R beta, R omega, R s) {
    const R delta = R(rudder.value) + R(rudder.rate) * s;
    return std::pair{R(m.a1) * beta + R(m.b1) * omega + R(m.c1) * delta,
                     R(m.a2) * beta + R(m.b2) * omega + R(m.c2) * delta};
  };
  for (int i = 0; i < steps; ++i) {
    const R s = h * i;
    const auto [k1b, k1w] = f(b, w, s);
    const auto [k2b, k2w] = f(b + h / 2 * k1b, w + h / 2 * k1w, s + h / 2);
    const auto [k3b, k3w] = f(b + h / 2 * k2b, w + h / 2 * k2w, s + h / 2);
    const auto [k4b, k4w] = f(b + h * k3b, w + h * k3w, s + h);
    psi += h * w + h * h / 6 * (k1w + k2w + k3w);
    b += h / 6 * (k1b + 2 * k2b + 2 * k3b + k4b);
    w += h / 6 * (k1w + 2 * k2w + 2 * k3w + k4w);
  }
  return {static_cast<double>(b), static_cast<double>(w), static_cast<double>(psi)};
}

TEST_CASE("the exact response is that of many small steps", "[linear][second-route]") {
  RandomLinearShips random(31);
  for (int k = 0; k < 40; ++k) {
    const auto m = random.ship();
    const LinearState<double> start{random.uniform(-0.2, 0.2), random.uniform(-0.5, 0.5), random.uniform(-1, 1)};
    const RudderLine<double> rudder{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double s = random.uniform(0.05, 6.0);
    const auto exact = state_after(Response(m), start, rudder, s), slow = slowly_after(m, start, rudder, s);
    const double scale = 1.0 + std::abs(slow.beta) + std::abs(slow.omega) + std::abs(slow.psi);
    CHECK_THAT(exact.beta, WithinAbs(slow.beta, 1e-11 * scale));
    CHECK_THAT(exact.omega, WithinAbs(slow.omega, 1e-11 * scale));
    CHECK_THAT(exact.psi, WithinAbs(slow.psi, 1e-11 * scale));
  }
}

TEST_CASE("the exact response is that of odeint at 1e-13", "[linear][second-route]") {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 3>;
  RandomLinearShips random(36);
  for (int k = 0; k < 10'000; ++k) {
    const auto m = random.ship();
    const LinearState<double> start{random.uniform(-0.2, 0.2), random.uniform(-0.5, 0.5), 0.0};
    const RudderLine<double> rudder{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double end = random.uniform(0.1, 5.0);
    State x{start.beta, start.omega, start.psi};
    const auto system = [&](const State& y, State& rate, double s) {
      const auto d = rates(m, {y[0], y[1], y[2]}, rudder.value + rudder.rate * s);
      rate = {d.beta, d.omega, d.psi};
    };
    odeint::integrate_adaptive(odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_dopri5<State>()), system, x,
                               0.0, end, 1e-3);
    const auto exact = state_after(Response(m), start, rudder, end);
    const double scale = 1.0 + std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);
    REQUIRE_THAT(exact.beta, WithinAbs(x[0], 1e-10 * scale));
    REQUIRE_THAT(exact.omega, WithinAbs(x[1], 1e-10 * scale));
    REQUIRE_THAT(exact.psi, WithinAbs(x[2], 1e-10 * scale));
  }
}

TEST_CASE("two short responses are one long response", "[linear][round-trip]") {
  RandomLinearShips random(32);
  for (int k = 0; k < 10'000; ++k) {
    const Response ship(random.ship());
    const LinearState<double> start{random.uniform(-0.2, 0.2), random.uniform(-0.5, 0.5), 0.0};
    const RudderLine<double> rudder{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double s = random.uniform(0.0, 4.0), t = random.uniform(0.0, 4.0);
    const auto half = state_after(ship, start, rudder, s);
    const auto twice = state_after(ship, half, {rudder.value + rudder.rate * s, rudder.rate}, t);
    const auto once = state_after(ship, start, rudder, s + t);
    const double scale = 1.0 + std::abs(once.beta) + std::abs(once.omega) + std::abs(once.psi);
    REQUIRE_THAT(twice.beta, WithinAbs(once.beta, 1e-12 * scale));
    REQUIRE_THAT(twice.omega, WithinAbs(once.omega, 1e-12 * scale));
    REQUIRE_THAT(twice.psi, WithinAbs(once.psi, 1e-12 * scale));
  }
}

TEST_CASE("the response satisfies its differential equation where cases meet", "[linear][limit]") {
  // near-equal poles, exactly equal, complex, one at zero, both at zero, one unstable
  const std::pair<double, double> trace_and_determinant[] = {
      {-2.0, 1.0},   {-2.0, 1.0 - 1e-9}, {-2.0, 1.0 + 1e-9}, {-2.0, 0.97}, {-2.0, 0.9}, {-2.0, 1.5},  {-2.0, 0.0},
      {-2.0, 1e-12}, {-2.0, -1e-9},      {0.0, 0.0},         {-3.0, -0.4}, {1.0, 0.1},  {-1e-3, 1e-9}};
  for (const auto& [tr, det] : trace_and_determinant) {
    for (const double s : {1e-3, 0.1, 0.249, 0.251, 0.6, 2.0, 9.0}) {
      INFO("trace " << tr << ", determinant " << det << ", s " << s);
      const auto b = response_basis(poles(tr, det), s);
      const double scale = 1.0 + std::abs(b.h_1) + std::abs(b.h0) + std::abs(b.h1) + std::abs(b.h2) + std::abs(b.h3);
      CHECK_THAT(b.h_1 - tr * b.h0 + det * b.h1, WithinAbs(1.0, 1e-13 * scale));
      CHECK_THAT(b.h0 - tr * b.h1 + det * b.h2, WithinAbs(s, 1e-13 * scale));
      CHECK_THAT(b.h1 - tr * b.h2 + det * b.h3, WithinAbs(0.5 * s * s, 1e-13 * scale));
    }
  }
}

TEST_CASE("basis functions are continuous where their formulas change", "[linear][limit]") {
  RandomLinearShips random(33);
  for (int k = 0; k < 2000; ++k) {
    const auto m = random.ship();
    const auto p = poles(trace(m), determinant(m));
    const double s = 0.5 / p.size;
    const auto below = response_basis(p, s * (1.0 - 1e-12)), above = response_basis(p, s * (1.0 + 1e-12));
    REQUIRE_THAT(above.h_1, WithinAbs(below.h_1, 1e-11));
    REQUIRE_THAT(above.h0, WithinRel(below.h0, 1e-11));
    REQUIRE_THAT(above.h1, WithinRel(below.h1, 1e-11));
    REQUIRE_THAT(above.h2, WithinRel(below.h2, 1e-10));
    REQUIRE_THAT(above.h3, WithinRel(below.h3, 1e-9));
  }
}

TEST_CASE("dual numbers give the derivative of the response by its coefficients", "[linear][second-route]") {
  using D = Dual<1>;
  RandomLinearShips random(34);
  for (int k = 0; k < 300; ++k) {
    const auto m = random.ship();
    const LinearState<double> start{0.02, 0.1, 0.3};
    const double s = random.uniform(0.1, 5.0), h = 1e-5;
    const auto at = [&](double shift) {
      auto moved = m;
      moved.a2 += shift;
      return state_after(Response(moved), start, {0.2, -0.1}, s);
    };
    const SwayYawCoefficients<D> dual{D(m.a1), D(m.b1), D(m.c1), D(m.a2, 0), D(m.b2), D(m.c2)};
    const auto x =
        state_after(LinearResponse<D>(dual), {D(start.beta), D(start.omega), D(start.psi)}, {D(0.2), D(-0.1)}, D(s));
    const auto plus = at(h), minus = at(-h);
    const double scale = 1.0 + std::abs(x.psi.a) + std::abs(x.psi.v[0]);
    REQUIRE_THAT(x.beta.v[0], WithinAbs((plus.beta - minus.beta) / (2 * h), 1e-7 * scale));
    REQUIRE_THAT(x.psi.v[0], WithinAbs((plus.psi - minus.psi) / (2 * h), 1e-7 * scale));
  }
}

TEST_CASE("a mirrored rudder gives the mirrored response", "[linear][symmetry]") {
  RandomLinearShips random(35);
  for (int k = 0; k < 10'000; ++k) {
    const Response ship(random.ship());
    const LinearState<double> start{random.uniform(-0.2, 0.2), random.uniform(-0.5, 0.5), random.uniform(-0.2, 0.2)};
    const RudderLine<double> rudder{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double s = random.uniform(0.0, 6.0);
    const auto a = state_after(ship, start, rudder, s);
    const auto b = state_after(ship, {-start.beta, -start.omega, -start.psi}, {-rudder.value, -rudder.rate}, s);
    REQUIRE(b.beta == -a.beta);
    REQUIRE(b.omega == -a.omega);
    REQUIRE(b.psi == -a.psi);
  }
}

TEST_CASE("the step response of the printed ship is that of the reference", "[linear][published]") {
  const Response ship(RandomLinearShips::tanker());
  for (const auto& [time, state] : test::reference().at("step_response_printed_abc").items()) {
    const auto x = state_after(ship, {0.0, 0.0, 0.0}, {radians(10), 0.0}, std::stod(time));
    CHECK_THAT(degrees(x.beta), WithinRel(state.at("beta_deg").get<double>(), 1e-9));
    CHECK_THAT(x.omega, WithinRel(state.at("omega").get<double>(), 1e-9));
  }
}

}  // namespace
}  // namespace swayaw
