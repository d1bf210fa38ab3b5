#include "swayaw/linear/zigzag.hpp"

#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/indices.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using nlohmann::json;
using test::RandomLinearShips;
using test::reference;
using test::ten_ten;

SwayYawCoefficients<double> printed(double T3b = 0.154, double T3w = 0.983) {
  return coefficients_from(test::printed_indices(T3b, T3w));
}

void check_zigzag(const json& wanted, const LinearZigzag<double>& found) {
  const auto& execute = wanted.at("execute_s");
  REQUIRE(found.reversals.size() >= execute.size());
  for (std::size_t i = 0; i < execute.size(); ++i) {
    CHECK_THAT(found.reversals[i].execute, WithinRel(execute[i].get<double>(), 1e-9));
    if (wanted.contains("peak_s"))
      CHECK_THAT(found.reversals[i].peak, WithinRel(wanted.at("peak_s")[i].get<double>(), 1e-9));
    CHECK_THAT(degrees(found.reversals[i].overshoot), WithinRel(wanted.at("overshoot_deg")[i].get<double>(), 1e-9));
  }
}

TEST_CASE("exact zigzags agree with the reference to 1e-9", "[linear][published]") {
  const auto r = reference().at("zigzag_exact");
  const auto tanker = RandomLinearShips::tanker();
  check_zigzag(r.at("REF_printed_abc_rate2.5"), linear_zigzag(tanker, ten_ten(2.5)));
  check_zigzag(r.at("REF_printed_abc_rate0.5"), linear_zigzag(tanker, ten_ten(0.5)));
  check_zigzag(r.at("REF_printed_TK_rate2.5"), linear_zigzag(printed(), ten_ten(2.5)));
  check_zigzag(r.at("REF_printed_TK_rate0.5"), linear_zigzag(printed(), ten_ten(0.5)));
  check_zigzag(r.at("T3b_0.309_rate2.5"), linear_zigzag(printed(0.309), ten_ten(2.5)));
  check_zigzag(r.at("T3w_0.492_rate2.5"), linear_zigzag(printed(0.154, 0.492), ten_ten(2.5)));
  check_zigzag(r.at("T3w_0.492_rate0.5"), linear_zigzag(printed(0.154, 0.492), ten_ten(0.5)));
}

TEST_CASE("zigzags of the figures and of the first-order equation agree with the reference", "[linear][published]") {
  const auto r = reference().at("figure_numbers_printed_TK");
  for (const double T3w : {1.966, 3.0, 5.0}) {
    const auto name = T3w == 1.966 ? std::string("T3w=1.966") : T3w == 3.0 ? "T3w=3" : "T3w=5";
    check_zigzag(r.at(name), linear_zigzag(printed(0.154, T3w), ten_ten(2.5)));
  }
  check_zigzag(r.at("first_order rate 2.5"), linear_zigzag(first_order_ship(-4.896, 9.806), ten_ten(2.5)));
  check_zigzag(r.at("first_order rate 0.5"), linear_zigzag(first_order_ship(-4.896, 9.806), ten_ten(0.5)));
}

TEST_CASE("30-digit zigzags agree to 1e-10", "[linear][published]") {
  const auto r = reference().at("zigzag_exact_mp");
  for (const auto& [name, rate] :
       {std::pair{"REF_printed_abc_rate2.5", 2.5}, std::pair{"REF_printed_abc_rate0.5", 0.5}}) {
    const auto found = linear_zigzag(RandomLinearShips::tanker(), ten_ten(rate));
    for (std::size_t i = 0; i < r.at(name).at("execute_s").size(); ++i) {
      CHECK_THAT(found.reversals[i].execute,
                 WithinRel(std::stod(r.at(name).at("execute_s")[i].get<std::string>()), 1e-12));
      CHECK_THAT(degrees(found.reversals[i].overshoot),
                 WithinRel(std::stod(r.at(name).at("overshoot_deg")[i].get<std::string>()), 1e-12));
    }
  }
}

/// First sample at which a condition holds, on a fine grid of the exact legs: no zero may have been missed.
TEST_CASE("no earlier switch or peak was missed", "[linear][second-route]") {
  RandomLinearShips random(41);
  int sailed = 0, unstable = 0, complex = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto m = random.ship();
    const LinearZigzagOrder order{.rudder = radians(random.uniform(3, 20)),
                                  .heading = radians(random.uniform(1, 20)),
                                  .rate = random.uniform(0.1, 5.0),
                                  .reversals = 4,
                                  .longest = 60.0};
    const auto z = linear_zigzag(m, order);
    if (z.reversals.empty()) continue;
    ++sailed;
    unstable += !is_stable(m);
    complex += has_complex_poles(m);
    const LinearResponse<double> ship(m);
    double turn = 1.0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < z.legs.size() && next < z.reversals.size(); ++i) {
      const auto& leg = z.legs[i];
      for (int j = 0; j < 20; ++j) {
        const double s = leg.length * j / 20.0;
        const auto x = state_after(ship, leg.start, leg.rudder, s);
        REQUIRE(turn * x.psi <= (leg.from + s <= z.reversals[next].execute ? order.heading + 1e-9 : 1e9));
      }
      const auto end = state_after(ship, leg.start, leg.rudder, leg.length);
      if (std::abs(leg.from + leg.length - z.reversals[next].execute) < 1e-12) {
        REQUIRE_THAT(turn * end.psi, WithinAbs(order.heading, 1e-11));
        turn = -turn;
        ++next;
      }
    }
  }
  CHECK(sailed > 1000);
  CHECK(unstable > 100);
  CHECK(complex > 100);
}

TEST_CASE("a mirrored zigzag is the mirrored zigzag", "[linear][symmetry]") {
  RandomLinearShips random(42);
  for (int k = 0; k < 10'000; ++k) {
    const auto m = random.ship();
    LinearZigzagOrder order{
        .rudder = radians(10), .heading = radians(10), .rate = 1.0, .reversals = 4, .longest = 100.0};
    const auto starboard = linear_zigzag(m, order);
    order.first = Side::port;
    const auto port = linear_zigzag(m, order);
    REQUIRE(port.reversals.size() == starboard.reversals.size());
    for (std::size_t i = 0; i < port.reversals.size(); ++i) {
      REQUIRE_THAT(port.reversals[i].execute, WithinRel(starboard.reversals[i].execute, 1e-12));
      REQUIRE_THAT(port.reversals[i].peak, WithinRel(starboard.reversals[i].peak, 1e-12));
      REQUIRE_THAT(port.reversals[i].overshoot,
                   WithinAbs(starboard.reversals[i].overshoot, 1e-12 * (1.0 + starboard.reversals[i].overshoot)));
    }
  }
}

TEST_CASE("time scales: a ship n times as quick makes the zigzag in 1/n of the lengths", "[linear][limit]") {
  RandomLinearShips random(43);
  for (int k = 0; k < 10'000; ++k) {
    const auto m = random.ship();
    const double n = random.uniform(0.3, 3.0);
    // s -> s/n: omega scales with n, beta stays
    const SwayYawCoefficients<double> quick{n * m.a1, m.b1, n * m.c1, n * n * m.a2, n * m.b2, n * n * m.c2};
    const LinearZigzagOrder order{
        .rudder = radians(10), .heading = radians(10), .rate = 1.0, .reversals = 4, .longest = 100.0};
    auto quick_order = order;
    quick_order.rate *= n;
    quick_order.longest /= n;
    const auto a = linear_zigzag(m, order), b = linear_zigzag(quick, quick_order);
    REQUIRE(a.reversals.size() == b.reversals.size());
    for (std::size_t i = 0; i < a.reversals.size(); ++i) {
      REQUIRE_THAT(b.reversals[i].execute * n, WithinRel(a.reversals[i].execute, 1e-9));
      REQUIRE_THAT(b.reversals[i].overshoot,
                   WithinAbs(a.reversals[i].overshoot, 1e-9 * (1.0 + a.reversals[i].overshoot)));
    }
  }
}

/// The printed ship with another T2.
SteeringIndices<double> with_T2(double T2, double T3w = 0.983) {
  return {10.491 * T2, 10.491 + T2, 0.154, T3w, -3.464, -4.896};
}

/// Yaw of the printed ship with T2 = 0, T1 d(omega')/ds' + omega' = Kw (delta + T3w d(delta)/ds'): a part that follows
/// the rudder at once, and a first-order ship with what is left of Kw.
struct YawWithoutT2 {
  static constexpr double at_once = -4.896 * 0.983 / 10.491;
  LinearResponse<double> rest{first_order_ship(-4.896 * (1.0 - 0.983 / 10.491), 10.491)};

  LinearState<double> after(const LinearState<double>& x, const RudderLine<double>& rudder, double s) const {
    const auto y = state_after(rest, {0.0, x.omega - at_once * rudder.value, x.psi}, rudder, s);
    return {0.0, y.omega + at_once * (rudder.value + rudder.rate * s),
            y.psi + at_once * (rudder.value + 0.5 * rudder.rate * s) * s};
  }

  /// The rudder goes from `angle` to `target` and rests there.
  LinearState<double> after(const LinearState<double>& x, double angle, double target, double rate, double s) const {
    const double ramp = std::abs(target - angle) / rate;
    const RudderLine<double> moving{angle, std::copysign(rate, target - angle)};
    return s < ramp ? after(x, moving, s) : after(after(x, moving, ramp), {target, 0.0}, s - ramp);
  }
};

/// Where f turns positive between 0 and 100, by halving.
template <class F>
double turning_place(const F& f) {
  double low = 0.0, high = 100.0;
  for (int i = 0; i < 80; ++i) (f(0.5 * (low + high)) > 0.0 ? high : low) = 0.5 * (low + high);
  return high;
}

/// Her 10/10 zigzag; at each reversal the rudder rests.
std::vector<LinearReversal<double>> zigzag_without_T2(const LinearZigzagOrder& order) {
  const YawWithoutT2 ship;
  std::vector<LinearReversal<double>> result;
  LinearState<double> x{0.0, 0.0, 0.0};
  double now = 0.0, angle = 0.0, turn = yaw_sign(order.first);
  for (;;) {
    const auto at = [&](double s) { return ship.after(x, angle, -turn * order.rudder, order.rate, s); };
    if (!result.empty()) {
      const double peak = turning_place([&](double s) { return turn * at(s).omega; });
      result.back().peak = now + peak;
      result.back().overshoot = -turn * at(peak).psi - order.heading;
      if (result.size() == order.reversals) return result;
    }
    const double execute = turning_place([&](double s) { return turn * at(s).psi - order.heading; });
    x = at(execute);
    now += execute;
    angle = -turn * order.rudder;
    turn = -turn;
    result.push_back({now, 0.0, 0.0, 0});
  }
}

TEST_CASE("as T2 vanishes the zigzag becomes that of the ship without it, in no more legs", "[linear][limit]") {
  for (const double rate : {2.5, 0.5}) {
    const auto usual = linear_zigzag(coefficients_from(with_T2(0.298)), ten_ten(rate));
    const auto limit = zigzag_without_T2(ten_ten(rate));
    for (const double T2 : {1e-5, 1e-7}) {
      INFO("T2 = " << T2);
      const auto found = linear_zigzag(coefficients_from(with_T2(T2)), ten_ten(rate));
      REQUIRE(found.reversals.size() == limit.size());
      CHECK(found.legs.size() == usual.legs.size());
      // what T2 does, and rounding: coefficients that grow as 1/T2 hold the indices to eps/T2
      const double allowed = 25.0 * T2 + 1e-15 / T2;
      for (std::size_t i = 0; i < limit.size(); ++i) {
        CHECK_THAT(found.reversals[i].execute, WithinAbs(limit[i].execute, allowed));
        CHECK_THAT(found.reversals[i].peak, WithinAbs(limit[i].peak, allowed));
        CHECK_THAT(found.reversals[i].overshoot, WithinAbs(limit[i].overshoot, allowed));
      }
    }
  }
}

TEST_CASE("without T2 and T3w the zigzag is the first-order one", "[linear][limit]") {
  const auto first = linear_zigzag(first_order_ship(-4.896, 10.491), ten_ten(2.5));
  const auto found = linear_zigzag(coefficients_from(with_T2(1e-7, 0.0)), ten_ten(2.5));
  CHECK(found.legs.size() == first.legs.size());
  for (std::size_t i = 0; i < first.reversals.size(); ++i) {
    CHECK_THAT(found.reversals[i].execute, WithinAbs(first.reversals[i].execute, 2.5e-6));
    CHECK_THAT(found.reversals[i].overshoot, WithinAbs(first.reversals[i].overshoot, 2.5e-6));
  }
}

TEST_CASE("a switch moves with the coefficients as duals say", "[linear][second-route]") {
  using D = Dual<6>;
  RandomLinearShips random(44);
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    const auto m = random.ship();
    const LinearZigzagOrder order{
        .rudder = radians(10), .heading = radians(8), .rate = 0.8, .reversals = 3, .longest = 60.0};
    const auto z = linear_zigzag(m, order);
    if (z.reversals.size() < 3) continue;
    const SwayYawCoefficients<D> dual{D(m.a1, 0), D(m.b1, 1), D(m.c1, 2), D(m.a2, 3), D(m.b2, 4), D(m.c2, 5)};
    const auto carried = carried_through(z, dual, order);
    REQUIRE(carried.reversals.size() == 3);
    using C = SwayYawCoefficients<double>;
    double C::*const members[] = {&C::a1, &C::b1, &C::c1, &C::a2, &C::b2, &C::c2};
    for (int i = 0; i < 6; ++i) {
      const double h = 1e-6;
      auto up = m, down = m;
      up.*members[i] += h;
      down.*members[i] -= h;
      const auto zu = linear_zigzag(up, order), zd = linear_zigzag(down, order);
      if (zu.reversals.size() < 3 || zd.reversals.size() < 3) continue;
      ++compared;
      for (std::size_t r = 0; r < 3; ++r) {
        const double execute = (zu.reversals[r].execute - zd.reversals[r].execute) / (2 * h);
        const double overshoot = (zu.reversals[r].overshoot - zd.reversals[r].overshoot) / (2 * h);
        REQUIRE_THAT(carried.reversals[r].execute.a, WithinRel(z.reversals[r].execute, 1e-11));
        REQUIRE_THAT(carried.reversals[r].overshoot.a, WithinAbs(z.reversals[r].overshoot, 1e-11));
        REQUIRE_THAT(carried.reversals[r].execute.v[i], WithinAbs(execute, 1e-4 * (1.0 + std::abs(execute))));
        REQUIRE_THAT(carried.reversals[r].overshoot.v[i], WithinAbs(overshoot, 1e-4 * (1.0 + std::abs(overshoot))));
      }
    }
  }
  CHECK(compared > 300);
}

TEST_CASE("T3b does not touch the yaw, and drift does not know T3w before the first reversal", "[linear][published]") {
  const auto reference_zigzag = linear_zigzag(printed(), ten_ten(2.5));
  const auto other_T3b = linear_zigzag(printed(0.309), ten_ten(2.5));
  for (std::size_t i = 0; i < reference_zigzag.reversals.size(); ++i) {
    CHECK_THAT(other_T3b.reversals[i].execute, WithinRel(reference_zigzag.reversals[i].execute, 1e-12));
    CHECK_THAT(other_T3b.reversals[i].overshoot, WithinRel(reference_zigzag.reversals[i].overshoot, 1e-11));
  }
  const LinearResponse<double> ship(printed()), other_T3w(printed(0.154, 0.492));
  for (double s = 0.1; s < 1.7; s += 0.1) {
    const RudderLine<double> rudder{0.0, 0.4};
    CHECK_THAT(state_after(other_T3w, {0, 0, 0}, rudder, s).beta,
               WithinAbs(state_after(ship, {0, 0, 0}, rudder, s).beta, 1e-14));
  }
}

TEST_CASE("senseless zigzags are refused", "[linear][refusal]") {
  const auto ship = RandomLinearShips::tanker();
  CHECK_THROWS_WITH(linear_zigzag(ship, {.rudder = 0.0, .heading = 0.1, .rate = 1.0}),
                    "rudder angle [rad] must be positive, got 0");
  CHECK_THROWS_WITH(linear_zigzag(ship, {.rudder = 0.1, .heading = 0.1, .rate = 0.0}),
                    ContainsSubstring("rudder rate"));
}

TEST_CASE("a ship whose motion changes without end in a moment is refused, and takes no memory", "[linear][refusal]") {
  auto ship = RandomLinearShips::tanker();
  for (double* c : {&ship.a1, &ship.b1, &ship.c1, &ship.a2, &ship.b2, &ship.c2}) *c *= 1e56;
  CHECK_THROWS_WITH(linear_zigzag(ship, {.rudder = radians(10.0), .heading = radians(10.0), .rate = radians(10.0)}),
                    ContainsSubstring("changes too fast to be sailed"));
}

}  // namespace
}  // namespace swayaw
