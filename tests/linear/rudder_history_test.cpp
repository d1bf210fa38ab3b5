#include "swayaw/linear/rudder_history.hpp"

#include <catch.hpp>
#include <cmath>
#include <limits>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/track.hpp"

namespace swayaw {
namespace {

using test::RandomLinearShips;
using Response = LinearResponse<double>;

RudderHistory random_history(RandomLinearShips& random, int points) {
  RudderHistory history;
  double s = 0.0;
  for (int i = 0; i < points; ++i) {
    history.s.push_back(s);
    history.delta.push_back(random.uniform(-0.5, 0.5));
    if (random.uniform(0.0, 1.0) > 0.2) s += random.uniform(0.0, 1.0);  // else a step
  }
  return history;
}

/// Angle of a history by its definition.
double interpolated(const RudderHistory& h, double s) {
  for (std::size_t i = h.s.size(); i-- > 0;) {
    if (h.s[i] > s) continue;
    if (i + 1 == h.s.size()) return h.delta[i];
    return h.delta[i] + (h.delta[i + 1] - h.delta[i]) * (s - h.s[i]) / (h.s[i + 1] - h.s[i]);
  }
  return 0.0;
}

/// One state by very many Runge–Kutta steps between the corners.
std::array<double, 5> slowly(const SwayYawCoefficients<double>& m, const RudderHistory& history, double end) {
  std::vector<double> corners;
  for (const double s : history.s)
    if (s < end) corners.push_back(s);
  corners.push_back(end);
  std::array<double, 5> x{};  // beta, omega, psi, x, y
  for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
    const double from = corners[c], length = corners[c + 1] - from;
    if (length <= 0.0) continue;
    const int steps = 400;
    const double h = length / steps, d0 = interpolated(history, from), d1 = interpolated(history, from + 0.5 * length);
    const double rate = (d1 - d0) / (0.5 * length);
    const auto f = [&](const std::array<double, 5>& y, double s) {
      const double delta = d0 + rate * s;
      return std::array<double, 5>{m.a1 * y[0] + m.b1 * y[1] + m.c1 * delta, m.a2 * y[0] + m.b2 * y[1] + m.c2 * delta,
                                   y[1], std::cos(y[2] - y[0]), std::sin(y[2] - y[0])};
    };
    const auto moved = [](std::array<double, 5> a, const std::array<double, 5>& d, double by) {
      for (std::size_t i = 0; i < 5; ++i) a[i] += by * d[i];
      return a;
    };
    for (int i = 0; i < steps; ++i) {
      const double s = i * h;
      const auto k1 = f(x, s), k2 = f(moved(x, k1, h / 2), s + h / 2), k3 = f(moved(x, k2, h / 2), s + h / 2),
                 k4 = f(moved(x, k3, h), s + h);
      for (std::size_t j = 0; j < 5; ++j) x[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    }
  }
  return x;
}

TEST_CASE("response and track of a rudder history are those of many small steps", "[linear][second-route]") {
  RandomLinearShips random(71);
  for (int k = 0; k < 60; ++k) {
    const auto m = random.ship();
    const Response ship(m);
    const auto history = random_history(random, 8);
    const double end = random.uniform(0.1, 6.0);
    const auto slow = slowly(m, history, end);
    const auto x = response_to(ship, history, {end})[0];
    const auto way = track(ship, legs(ship, history, end), {end})[0];
    const double scale = 1.0 + std::abs(x.beta) + std::abs(x.omega) + std::abs(x.psi);
    CHECK_THAT(x.beta, WithinAbs(slow[0], 1e-8 * scale));
    CHECK_THAT(x.omega, WithinAbs(slow[1], 1e-8 * scale));
    CHECK_THAT(x.psi, WithinAbs(slow[2], 1e-8 * scale));
    CHECK_THAT(way.x, WithinAbs(slow[3], 1e-8 * scale * scale));
    CHECK_THAT(way.y, WithinAbs(slow[4], 1e-8 * scale * scale));
    CHECK(way.psi == x.psi);
  }
}

TEST_CASE("a corner in a straight line changes nothing", "[linear][round-trip]") {
  RandomLinearShips random(72);
  for (int k = 0; k < 1000; ++k) {
    const Response ship(random.ship());
    auto history = random_history(random, 5);
    const double s = random.uniform(0.0, 3.0);
    auto with_corner = history;
    const auto place = std::upper_bound(history.s.begin(), history.s.end(), s) - history.s.begin();
    with_corner.s.insert(with_corner.s.begin() + place, s);
    with_corner.delta.insert(with_corner.delta.begin() + place, interpolated(history, s));
    const auto a = response_to(ship, history, {4.0, 0.5}), b = response_to(ship, with_corner, {4.0, 0.5});
    for (std::size_t i = 0; i < 2; ++i) {
      const double scale = 1.0 + std::abs(a[i].beta) + std::abs(a[i].omega) + std::abs(a[i].psi);
      REQUIRE_THAT(b[i].beta, WithinAbs(a[i].beta, 1e-12 * scale));
      REQUIRE_THAT(b[i].psi, WithinAbs(a[i].psi, 1e-12 * scale));
    }
  }
}

TEST_CASE("two histories together give the sum of the two responses", "[linear][symmetry]") {
  RandomLinearShips random(73);
  for (int k = 0; k < 500; ++k) {
    const Response ship(random.ship());
    const auto a = rudder_ramp_and_hold(random.uniform(-0.5, 0.5), 0.4), b = rudder_step(random.uniform(-0.5, 0.5));
    RudderHistory sum = a;
    for (double& delta : sum.delta) delta += b.delta[0];
    const auto x = response_to(ship, a, {2.0})[0], y = response_to(ship, b, {2.0})[0],
               z = response_to(ship, sum, {2.0})[0];
    REQUIRE_THAT(z.beta, WithinAbs(x.beta + y.beta, 1e-12 * (1.0 + std::abs(z.beta))));
    REQUIRE_THAT(z.psi, WithinAbs(x.psi + y.psi, 1e-12 * (1.0 + std::abs(z.psi))));
  }
}

TEST_CASE("step, ramp, and ramp and hold are what their names say", "[linear][limit]") {
  const Response ship(RandomLinearShips::tanker());
  CHECK(rudder_at(legs(ship, rudder_step(0.2), 5.0), 0.0) == 0.2);
  CHECK_THAT(rudder_at(legs(ship, rudder_ramp(-0.1, 3.0), 5.0), 2.0), WithinRel(-0.2, 1e-15));
  CHECK_THAT(rudder_at(legs(ship, rudder_ramp(-0.1, 3.0), 5.0), 4.0), WithinRel(-0.3, 1e-15));
  const auto held = legs(ship, rudder_ramp_and_hold(-0.3, 0.1), 5.0);
  REQUIRE(held.size() == 2);
  CHECK_THAT(rudder_at(held, 1.5), WithinRel(-0.15, 1e-15));
  CHECK(rudder_at(held, 5.0) == -0.3);
  // an infinitely quick ramp is a step
  const auto quick = response_to(ship, rudder_ramp_and_hold(0.2, 1e9), {3.0})[0],
             step = response_to(ship, rudder_step(0.2), {3.0})[0];
  CHECK_THAT(quick.beta, WithinRel(step.beta, 1e-8));
  CHECK(response_to(ship, rudder_step(0.2), {}).empty());
}

TEST_CASE("the rudder of a zigzag gives the zigzag back", "[linear][round-trip]") {
  const Response ship(RandomLinearShips::tanker());
  for (const double rate : {0.1, 0.6, std::numeric_limits<double>::infinity()}) {
    const auto zigzag =
        linear_zigzag(ship.m, {.rudder = radians(10), .heading = radians(10), .rate = rate, .reversals = 5});
    std::vector<double> times;
    for (const auto& leg : zigzag.legs) times.push_back(leg.from);
    const auto states = response_to(ship, rudder_history(zigzag), times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      CHECK_THAT(states[i].beta, WithinAbs(zigzag.legs[i].start.beta, 1e-13));
      CHECK_THAT(states[i].omega, WithinAbs(zigzag.legs[i].start.omega, 1e-13));
      CHECK_THAT(states[i].psi, WithinAbs(zigzag.legs[i].start.psi, 1e-12));
    }
  }
}

TEST_CASE("duals carry through a history", "[linear][second-route]") {
  using D = Dual<1>;
  const auto m = RandomLinearShips::tanker();
  const auto history = rudder_ramp_and_hold(0.3, 0.2);
  const SwayYawCoefficients<D> dual{D(m.a1, 0), D(m.b1), D(m.c1), D(m.a2), D(m.b2), D(m.c2)};
  const auto x = response_to(LinearResponse<D>(dual), history, {4.0})[0];
  auto up = m, down = m;
  up.a1 += 1e-6;
  down.a1 -= 1e-6;
  const double slope =
      (response_to(Response(up), history, {4.0})[0].psi - response_to(Response(down), history, {4.0})[0].psi) / 2e-6;
  CHECK_THAT(x.psi.v[0], WithinRel(slope, 1e-7));
}

TEST_CASE("a steady turn sails a circle of radius 1/omega'", "[linear][limit]") {
  const Response ship(RandomLinearShips::tanker());
  const auto i = steering_indices(ship.m);
  const double delta = -0.2, omega = i.Kw * delta, beta = i.Kb * delta;
  const auto circle = legs(ship, rudder_step(delta), 40.0, {beta, omega, 0.0});
  for (const auto& [s, point] :
       {std::pair{7.0, track(ship, circle, {7.0})[0]}, std::pair{40.0, track(ship, circle, {40.0})[0]}}) {
    CHECK_THAT(point.x, WithinAbs((std::sin(omega * s - beta) + std::sin(beta)) / omega, 1e-12));
    CHECK_THAT(point.y, WithinAbs((std::cos(beta) - std::cos(omega * s - beta)) / omega, 1e-12));
  }
}

TEST_CASE("without rudder the ship sails straight on", "[linear][limit]") {
  const Response ship(RandomLinearShips::tanker());
  const auto ahead = track(ship, legs(ship, rudder_step(0.0), 12.0, {0.0, 0.0, radians(30)}), {12.0, 0.0});
  CHECK_THAT(ahead[0].x, WithinRel(12.0 * std::cos(radians(30)), 1e-14));
  CHECK_THAT(ahead[0].y, WithinRel(6.0, 1e-14));
  CHECK(ahead[1].x == 0.0);
}

TEST_CASE("the track does not depend on where it is cut, and a mirrored one is mirrored", "[linear][symmetry]") {
  RandomLinearShips random(74);
  for (int k = 0; k < 100; ++k) {
    const Response ship(random.ship());
    LinearZigzagOrder order{
        .rudder = radians(10), .heading = radians(10), .rate = 1.0, .reversals = 4, .longest = 30.0};
    const auto starboard = linear_zigzag(ship.m, order);
    if (starboard.reversals.size() < 4) continue;
    order.first = Side::port;
    const auto port = linear_zigzag(ship.m, order);
    const double end = starboard.legs.back().from + starboard.legs.back().length;
    const std::vector<double> times{0.3 * end, 0.99 * end};
    const auto a = track(ship, starboard.legs, times), b = track(ship, port.legs, times);
    const auto c = track(ship, legs(ship, rudder_history(starboard), end), times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      REQUIRE_THAT(b[i].x, WithinAbs(a[i].x, 1e-11));
      REQUIRE_THAT(b[i].y, WithinAbs(-a[i].y, 1e-11));
      REQUIRE_THAT(c[i].x, WithinAbs(a[i].x, 1e-10));
      REQUIRE_THAT(c[i].y, WithinAbs(a[i].y, 1e-10));
    }
  }
}

TEST_CASE("the track of the tanker's zigzag is that of very fine sums", "[linear][second-route]") {
  const Response ship(RandomLinearShips::tanker());
  const auto zigzag =
      linear_zigzag(ship.m, {.rudder = radians(10), .heading = radians(10), .rate = radians(2.5) * 13.39});
  double x = 0.0, y = 0.0;
  for (const auto& leg : zigzag.legs) {  // Boole's rule
    const int panels = 200;
    const double h = leg.length / (4 * panels);
    for (int i = 0; i <= 4 * panels; ++i) {
      const auto state = state_after(ship, leg.start, leg.rudder, i * h);
      const double weight = (i == 0 || i == 4 * panels ? 7.0
                             : i % 2 == 1              ? 32.0
                             : i % 4 == 2              ? 12.0
                                                       : 14.0) *
                            2.0 / 45.0 * h;
      x += weight * std::cos(state.psi - state.beta);
      y += weight * std::sin(state.psi - state.beta);
    }
  }
  const auto& last = zigzag.legs.back();
  const auto point = track(ship, zigzag.legs, {last.from + last.length})[0];
  CHECK_THAT(point.x, WithinAbs(x, 1e-12));
  CHECK_THAT(point.y, WithinAbs(y, 1e-12));
}

TEST_CASE("histories that are none are refused", "[linear][refusal]") {
  const Response ship(RandomLinearShips::tanker());
  CHECK_THROWS_WITH(response_to(ship, {}, {1.0}), ContainsSubstring("at least one point"));
  CHECK_THROWS_WITH(response_to(ship, {.s = {0.0, 1.0}, .delta = {0.0}}, {1.0}),
                    ContainsSubstring("one angle for each time"));
  CHECK_THROWS_WITH(response_to(ship, {.s = {0.0, -1.0}, .delta = {0.0, 0.1}}, {1.0}),
                    ContainsSubstring("must not descend"));
  CHECK_THROWS_WITH(response_to(ship, {.s = {0.0, NAN}, .delta = {0.0, 0.1}}, {1.0}), ContainsSubstring("finite"));
  CHECK_THROWS_WITH(response_to(ship, rudder_step(0.1), {-1.0}), ContainsSubstring("before"));
  CHECK_THROWS_WITH(response_to(ship, rudder_step(0.1), {2.0, -1.0}), ContainsSubstring("before the first leg"));
  CHECK_THROWS_WITH(track(ship, legs(ship, rudder_step(0.1), 2.0), {3.0}), ContainsSubstring("after the last leg"));
  CHECK_THROWS_WITH(track(ship, {}, {0.0}), ContainsSubstring("before the first leg"));
  CHECK_THROWS_WITH(rudder_ramp(0.1, 0.0), "duration [ship lengths] must be positive, got 0");
  CHECK_THROWS_WITH(rudder_ramp_and_hold(0.1, 0.0), ContainsSubstring("rudder rate"));
}

}  // namespace
}  // namespace swayaw
