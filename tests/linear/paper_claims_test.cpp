#include <Eigen/Dense>
#include <catch.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/euler_zigzag.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/loop.hpp"
#include "swayaw/linear/rudder_history.hpp"
#include "swayaw/linear/ship_parts.hpp"
#include "tanker.hpp"

/// What [Artyszuk2016] says in words, one test for each claim. The name begins with the verdict.
/// docs/papers/artyszuk2016.md tells the same in prose.
namespace swayaw {
namespace {

using nlohmann::json;
using test::printed_indices;
using test::printed_table_1;
using test::RandomLinearShips;
using test::reference;
using Coefficients = SwayYawCoefficients<double>;
using Indices = SteeringIndices<double>;
using Parts = LinearParts<double>;

// ---------------------------------------------------------------- the ship and its motions

Parts unrounded_table_1() {
  return test::parts_of(reference().at("unrounded_table1_that_prints_all_digits").at("table1"));
}

Coefficients reference_ship() { return coefficients_from(printed_indices()); }

/// First-order drift and yaw side by side, eqs (41) and (42).
Coefficients first_order_both(const Indices& i) {
  const auto drift = first_order_drift(i), yaw = first_order_yaw(i);
  return {-1.0 / drift.T, 0.0, drift.K / drift.T, 0.0, -1.0 / yaw.T, yaw.K / yaw.T};
}

/// First to starboard, so that drift and yaw rate begin positive.
LinearZigzagOrder ten_ten(double rate_deg_s = 2.5) { return test::ten_ten(rate_deg_s, Side::starboard); }

double overshoot_deg(const Coefficients& m, std::size_t i, double rate_deg_s = 2.5) {
  return degrees(linear_zigzag(m, ten_ten(rate_deg_s)).reversals.at(i).overshoot);
}

/// Largest |f| along legs, of their ends and of many samples between.
template <class F>
double largest(const LinearResponse<double>& ship, const std::vector<Leg<double>>& legs, double end, const F& f) {
  double most = 0.0;
  for (const auto& leg : legs)
    for (int i = 0; i <= 4000 && leg.from < end; ++i) {
      const double s = std::min(leg.length, end - leg.from) * i / 4000.0;
      const auto x = state_after(ship, leg.start, leg.rudder, s);
      most = std::max(most, std::abs(f(x, rates(ship.m, x, leg.rudder.value + leg.rudder.rate * s))));
    }
  return most;
}

struct Peaks {
  double drift;  ///< largest |d(beta)/ds'| before the first reversal
  double yaw;    ///< largest |d(omega')/ds'| before the first reversal
};

Peaks first_leg_peaks(const Coefficients& m, double rate_deg_s = 2.5) {
  const LinearResponse<double> ship(m);
  const auto z = linear_zigzag(m, ten_ten(rate_deg_s));
  const double end = z.reversals[0].execute;
  return {largest(ship, z.legs, end, [](const auto&, const auto& d) { return d.beta; }),
          largest(ship, z.legs, end, [](const auto&, const auto& d) { return d.omega; })};
}

LoopMeasures<double> loop_of(const Coefficients& m, double rate_deg_s = 2.5) {
  return drift_yaw_loop(m, limit_cycle(m, ten_ten(rate_deg_s)).zigzag).value();
}

std::string printed(double value, int digits) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

// ---------------------------------------------------------------- tables 1 to 3

/// Tables 2 and 3 and the numbers of section 6, 37 in all, as printed.
const std::vector<std::pair<const char*, const char*>> printed_numbers = {
    {"a1H", "-0.479"},       {"b1H", "-0.050"},       {"a2H", "4.843"},        {"b2H", "-2.182"},
    {"a1R", "-0.144"},       {"b1R", "-0.072"},       {"a2R", "-1.291"},       {"b2R", "-0.646"},
    {"b1C", "0.527"},        {"T1", "10.491"},        {"T3b", "0.154"},        {"Kb", "-3.464"},
    {"T2", "0.298"},         {"T3w", "0.983"},        {"Kw", "-4.896"},        {"a1", "-0.622"},
    {"b1", "0.405"},         {"c1", "-0.171"},        {"a2", "3.552"},         {"b2", "-2.827"},
    {"c2", "-1.539"},        {"a1, 2 T3b", "-0.046"}, {"b1, 2 T3b", "-0.037"}, {"c1, 2 T3b", "-0.342"},
    {"a2, 2 T3b", "4.366"},  {"b2, 2 T3b", "-3.403"}, {"c2, 2 T3b", "-1.539"}, {"a1, T3w/2", "-1.458"},
    {"b1, T3w/2", "0.996"},  {"c1, T3w/2", "-0.171"}, {"a2, T3w/2", "2.594"},  {"b2, T3w/2", "-1.992"},
    {"c2, T3w/2", "-0.770"}, {"2 T3b", "0.309"},      {"T3w/2", "0.492"},      {"beta0 [deg]", "34.6"},
    {"omega0", "0.854"}};

/// The same numbers from table 1.
template <class S>
std::vector<S> numbers_from(const LinearParts<S>& ship) {
  const auto split = coefficients(ship);
  const auto m = split.total();
  const auto i = steering_indices(m);
  const auto T = time_constants(transfer_functions(m)).value();
  auto twice = i, half = i;
  twice.T3b = 2.0 * i.T3b;
  half.T3w = 0.5 * i.T3w;
  const auto p = coefficients_from(twice), q = coefficients_from(half);
  const auto &h = split.hull, &r = split.rudder;
  return {h.a1,
          h.b1,
          h.a2,
          h.b2,
          r.a1,
          r.b1,
          r.a2,
          r.b2,
          split.centrifugal.b1,
          T.T1,
          i.T3b,
          i.Kb,
          T.T2,
          i.T3w,
          i.Kw,
          m.a1,
          m.b1,
          m.c1,
          m.a2,
          m.b2,
          m.c2,
          p.a1,
          p.b1,
          p.c1,
          p.a2,
          p.b2,
          p.c2,
          q.a1,
          q.b1,
          q.c1,
          q.a2,
          q.b2,
          q.c2,
          twice.T3b,
          half.T3w,
          -i.Kb * 10.0,
          -i.Kw * radians(10)};
}

TEST_CASE("true: tables 2 and 3 follow from table 1, all 37 numbers to the last digit from an unrounded one",
          "[linear][published]") {
  const auto numbers = numbers_from(unrounded_table_1());
  REQUIRE(printed_numbers.size() == 37);
  REQUIRE(numbers.size() == 37);
  double farthest = 0.0;
  for (std::size_t i = 0; i < 37; ++i) {
    INFO(printed_numbers[i].first);
    const std::string wanted = printed_numbers[i].second;
    const int digits = static_cast<int>(wanted.size() - wanted.find('.') - 1);
    CHECK(printed(numbers[i], digits) == wanted);
    farthest = std::max(farthest, std::abs(numbers[i] - std::stod(wanted)) * 2.0 * std::pow(10.0, digits));
  }
  CHECK_THAT(
      farthest,
      WithinAbs(
          reference().at("unrounded_table1_that_prints_all_digits").at("max_violation_in_half_units").get<double>(),
          1e-6));
}

TEST_CASE("true: that unrounded table 1 is the printed one within half a digit", "[linear][published]") {
  const std::pair<const char*, double> units[] = {
      {"LB", 1e-3},  {"cB", 1e-3},  {"rz", 1e-3}, {"k11", 1e-3}, {"k22", 1e-3}, {"r66", 1e-3},
      {"Yb", 1e-4},  {"Yw", 1e-4},  {"Nb", 1e-4}, {"Nw", 1e-4},  {"AR", 1e-4},  {"w", 1e-3},
      {"cTh", 1e-3}, {"cLa", 1e-4}, {"aH", 0.0},  {"cRy", 0.0},  {"xR", 0.0}};
  const auto &rounded = reference().at("table1_input"),
             &unrounded = reference().at("unrounded_table1_that_prints_all_digits").at("table1");
  for (const auto& [name, unit] : units) {
    INFO(name);
    CHECK_THAT(unrounded.at(name).get<double>(), WithinAbs(rounded.at(name).get<double>(), 0.5 * unit));
  }
}

TEST_CASE("half right: the printed table 1 gives tables 2 and 3 within its rounding, but few digits",
          "[linear][published]") {
  using D = Dual<14>;
  auto ship = printed_table_1();
  // half a unit of the last printed digit, of all but a_H, c_Ry and x'_Reff
  const double half[] = {5e-4, 5e-4, 5e-4, 5e-4, 5e-4, 5e-4, 5e-5, 5e-5, 5e-5, 5e-5, 5e-5, 5e-4, 5e-4, 5e-5};
  int next = 0;
  const auto input = [&](double value) {
    D x(value);
    x.v[next] = half[next];
    ++next;
    return x;
  };
  LinearParts<D> dual;
  const auto& h = ship.hull;
  const auto& r = ship.rudder;
  dual.hull = {input(h.L_over_B), input(h.c_B), input(h.k_11), input(h.k_22), input(h.r_z),
               input(h.r_66),     input(h.Y_b), input(h.Y_w),  input(h.N_b),  input(h.N_w)};
  dual.rudder = {input(r.area_ratio), input(r.w), input(r.c_Th), input(r.lift_slope), D(r.a_H), D(r.c_Ry), D(r.x_Reff)};
  const auto numbers = numbers_from(dual);
  int exact = 0;
  for (std::size_t i = 0; i < 37; ++i) {
    INFO(printed_numbers[i].first);
    const std::string wanted = printed_numbers[i].second;
    const int digits = static_cast<int>(wanted.size() - wanted.find('.') - 1);
    exact += printed(numbers[i].a, digits) == wanted;
    CHECK_THAT(numbers[i].a,
               WithinAbs(std::stod(wanted), numbers[i].v.cwiseAbs().sum() + 0.5 * std::pow(10.0, -digits)));
  }
  CHECK(exact == 6);
  CHECK_THAT(numbers[9].a, WithinAbs(9.936, 5e-4));  // T1, printed 10.491
}

TEST_CASE("wrong: r'_z and r'_66 are not J/(mL²) but its square root", "[linear][published]") {
  const auto ship = printed_table_1();
  const auto f = factors(ship);
  const double as_defined = f.h / (ship.hull.r_z + ship.hull.r_66) * ship.hull.N_b * (180.0 / pi);
  CHECK_THAT(as_defined, WithinAbs(1.12, 5e-3));
  CHECK_THAT(coefficients(ship).hull.a2, WithinRel(4.843, 0.03));  // with radii
}

TEST_CASE("wrong: the last form of (13) lacks a square of x'_Reff and gives +1.29 for -0.646", "[linear][published]") {
  const auto ship = printed_table_1();
  const auto split = coefficients(ship);
  const auto f = factors(ship);
  CHECK_THAT(f.sway / f.yaw * split.rudder.a1 * ship.rudder.x_Reff, WithinAbs(1.2855, 1e-4));
  CHECK_THAT(f.sway / f.yaw * split.rudder.a1 * ship.rudder.x_Reff * ship.rudder.x_Reff,
             WithinRel(split.rudder.b2, 1e-14));
  CHECK_THAT(split.rudder.b2, WithinAbs(-0.646, 5e-3));
}

TEST_CASE("half right: the rudder's share is 'up to 30 %' of a1, b1 and b2 (23, 18, 23 %), but 36 % of a2",
          "[linear][published]") {
  const auto split = coefficients(unrounded_table_1());
  const auto m = split.total();
  CHECK_THAT(100.0 * split.rudder.a1 / m.a1, WithinAbs(23.0, 0.5));
  CHECK_THAT(-100.0 * split.rudder.b1 / m.b1, WithinAbs(18.0, 0.5));
  CHECK_THAT(100.0 * split.rudder.b2 / m.b2, WithinAbs(23.0, 0.5));
  CHECK_THAT(-100.0 * split.rudder.a2 / m.a2, WithinAbs(36.0, 0.5));
}

TEST_CASE("true: only in the yaw moment by drift does the rudder act against the hull", "[linear][published]") {
  const auto s = coefficients(unrounded_table_1());
  CHECK(s.rudder.a2 * s.hull.a2 < 0.0);
  CHECK(s.rudder.a1 * s.hull.a1 > 0.0);
  CHECK(s.rudder.b1 * s.hull.b1 > 0.0);
  CHECK(s.rudder.b2 * s.hull.b2 > 0.0);
}

// ---------------------------------------------------------------- time constants

TEST_CASE("half right: T1 > T2 for a stable ship, if the poles are real", "[linear][published]") {
  RandomLinearShips random(91);
  int real = 0, pairs = 0;
  for (int k = 0; k < 5000; ++k) {
    const auto m = random.ship();
    if (!is_stable(m)) continue;
    const auto T = time_constants(transfer_functions(m));
    T ? ++real : ++pairs;
    if (T) REQUIRE(T->T1 >= T->T2);
  }
  CHECK(real > 1000);
  CHECK(pairs > 300);
}

TEST_CASE(
    "true: with the usual signs of hull and rudder a1 < 0 and b2 < 0, so that stability hangs on the determinant alone",
    "[linear][published]") {
  RandomLinearShips random(93);
  int unstable = 0;
  for (int k = 0; k < 2000; ++k) {
    auto ship = random.parts();
    ship.hull.N_b *= random.uniform(1.0, 3.0);
    const auto m = coefficients(ship).total();
    REQUIRE(m.a1 < 0.0);
    REQUIRE(m.b2 < 0.0);
    REQUIRE(is_stable(m) == (determinant(m) > 0.0));
    unstable += !is_stable(m);
  }
  CHECK(unstable > 100);
}

TEST_CASE("true: a1 and b2 rest on the time constants alone", "[linear][published]") {
  auto i = printed_indices();
  const auto m = coefficients_from(i);
  i.Kb *= 3.0;
  i.Kw *= 0.2;
  CHECK(coefficients_from(i).a1 == m.a1);
  CHECK(coefficients_from(i).b2 == m.b2);
  CHECK(coefficients_from(i).a2 != m.a2);
}

TEST_CASE("true: T3b and T3w can turn the sign of a coefficient: b1 is 0.41, with T3b doubled -0.04",
          "[linear][published]") {
  CHECK_THAT(coefficients_from(printed_indices()).b1, WithinAbs(0.41, 5e-3));
  CHECK_THAT(coefficients_from(printed_indices(0.309)).b1, WithinAbs(-0.04, 5e-3));
}

TEST_CASE("not in the paper: T3b and T3w do not depend on c_Ry, nor on a_H, rudder area, wake or propeller loading",
          "[linear][published]") {
  auto ship = printed_table_1();
  const auto closed = reference().at("T3_closed_form_table1");
  const std::pair<double, double> c_Ry_and_T1[] = {{0.5, -7.09}, {1.0, 9.94}, {2.0, 1.95}, {5.0, 0.81}};
  for (const auto& [c_Ry, T1] : c_Ry_and_T1) {
    ship.rudder.c_Ry = c_Ry;
    const auto m = coefficients(ship).total();
    CHECK_THAT(steering_indices(m).T3b, WithinRel(closed.at("T3b").get<double>(), 1e-12));
    CHECK_THAT(steering_indices(m).T3w, WithinRel(closed.at("T3w").get<double>(), 1e-12));
    CHECK_THAT(time_constants(transfer_functions(m))->T1, WithinAbs(T1, 5e-3));
  }
  ship.rudder.a_H = 0.2;
  ship.rudder.area_ratio = 0.03;
  ship.rudder.w = 0.1;
  ship.rudder.c_Th = 1.0;
  CHECK_THAT(steering_indices(coefficients(ship).total()).T3b, WithinRel(closed.at("T3b").get<double>(), 1e-12));
  ship.rudder.x_Reff = -0.4;
  CHECK(std::abs(steering_indices(coefficients(ship).total()).T3b - closed.at("T3b").get<double>()) > 1e-3);
}

TEST_CASE("not in the paper: 1/T3b = −b2H + (b1H + b1C) c2/c1 and 1/T3w = −a1H + a2H c1/c2", "[linear][published]") {
  RandomLinearShips random(92);
  for (int k = 0; k < 500; ++k) {
    const auto split = coefficients(random.parts());
    const auto m = split.total();
    const auto& h = split.hull;
    REQUIRE_THAT(1.0 / steering_indices(m).T3b, WithinRel(-h.b2 + (h.b1 + split.centrifugal.b1) * m.c2 / m.c1, 1e-11));
    REQUIRE_THAT(1.0 / steering_indices(m).T3w, WithinRel(-h.a1 + h.a2 * m.c1 / m.c2, 1e-11));
  }
}

TEST_CASE(
    "half right: T3b and T3w change a1, b1, a2, b2 much, but by a factor of 2 in them; one per cent gives about one",
    "[linear][published]") {
  using D = Dual<2>;
  const auto i = printed_indices();
  D T3b(i.T3b), T3w(i.T3w);
  T3b.v[0] = i.T3b;
  T3w.v[1] = i.T3w;
  const auto m = coefficients_from(SteeringIndices<D>{D(i.T1T2), D(i.T1_plus_T2), T3b, T3w, D(i.Kb), D(i.Kw)});
  for (int k = 0; k < 2; ++k) {
    for (const D& x : {m.a1, m.b1}) CHECK_THAT(std::abs(x.v[k] / x.a), WithinAbs(0.97, 0.23));   // 0.75 to 1.19
    for (const D& x : {m.a2, m.b2}) CHECK_THAT(std::abs(x.v[k] / x.a), WithinAbs(0.195, 0.05));  // 0.15 to 0.24
  }
}

TEST_CASE("true: as T3b nears T3w the coefficients grow as 1/|T3b − T3w|", "[linear][published]") {
  const auto near = coefficients_from(printed_indices(0.983 + 1e-4)),
             nearer = coefficients_from(printed_indices(0.983 + 1e-6));
  CHECK_THAT(nearer.a1 / near.a1, WithinRel(100.0, 1e-2));
  CHECK_THAT(nearer.b2 / near.b2, WithinRel(100.0, 1e-2));
  CHECK(std::abs(near.a1) > 1e4);
}

TEST_CASE("wrong: with T3b close to T3w only the loop becomes a line, each motion stays of second order",
          "[linear][published]") {
  const auto near = coefficients_from(printed_indices(0.983 * (1.0 + 1e-4)));
  CHECK(loop_of(near).distance_from_line < 1e-4);
  CHECK(loop_of(reference_ship()).distance_from_line > 0.01);
  // the overshoot is that of the second-order ship, not 12.5 deg of the first order
  CHECK_THAT(overshoot_deg(near, 0), WithinAbs(overshoot_deg(reference_ship(), 0), 1e-5));
  CHECK_THAT(first_leg_peaks(near).yaw / first_leg_peaks(first_order_both(printed_indices())).yaw,
             WithinAbs(2.25, 0.1));
}

// ---------------------------------------------------------------- steady turn and first order

TEST_CASE("true: beta_0 = 34.6 deg and omega'_0 = 0.854, with the signs dropped", "[linear][published]") {
  const auto i = printed_indices();
  CHECK_THAT(std::abs(i.Kb) * 10.0, WithinAbs(34.64, 1e-9));
  CHECK_THAT(std::abs(i.Kw) * radians(10), WithinAbs(0.85451, 5e-6));
  CHECK_THAT(std::abs(steering_indices(coefficients(unrounded_table_1()).total()).Kw) * radians(10),
             WithinAbs(0.85447, 5e-6));
  // a rudder to port, positive, turns to port, negative
  const auto settled = response_to(LinearResponse<double>(reference_ship()), rudder_step(radians(10)), {400.0})[0];
  CHECK_THAT(degrees(settled.beta), WithinRel(-34.64, 1e-6));
  CHECK_THAT(settled.omega, WithinRel(-0.85451, 1e-5));
}

TEST_CASE("true: the zigzag stays far below the steady turn: 10 of 34.6 deg, 0.29 of 0.85", "[linear][published]") {
  const auto loop = loop_of(reference_ship());
  CHECK_THAT(degrees(loop.beta_max), WithinAbs(10.03, 5e-3));
  CHECK_THAT(loop.omega_max, WithinAbs(0.2891, 5e-5));
}

TEST_CASE("true: T_b is close to T_w, 8.5 % above", "[linear][published]") {
  const auto i = printed_indices();
  CHECK_THAT(first_order_drift(i).T, WithinRel(reference().at("first_order").at("T_b").get<double>(), 1e-12));
  CHECK_THAT(first_order_yaw(i).T, WithinRel(reference().at("first_order").at("T_w").get<double>(), 1e-12));
  CHECK_THAT(first_order_drift(i).T / first_order_yaw(i).T, WithinAbs(1.08454, 5e-6));
}

/// Eq. (43), both divided by their steady values.
double eq43(double beta) {
  const auto i = printed_indices();
  return 1.0 - std::pow(1.0 - beta, first_order_drift(i).T / first_order_yaw(i).T);
}

/// Largest deviation of the first-order ramp-and-hold response from (43), in parts of omega'_0.
double deviation_from_43(double rate_deg_s) {
  const auto i = printed_indices();
  const LinearResponse<double> ship(first_order_both(i));
  const double delta = -radians(10), beta0 = i.Kb * delta, omega0 = i.Kw * delta;
  const auto all = legs(ship, rudder_ramp_and_hold(delta, radians(rate_deg_s) * 13.39), 100.0);
  double most = 0.0;
  for (double s = 0.0; s < 100.0; s += 0.01) {
    const auto x = state_at(ship, all, s);
    most = std::max(most, std::abs(x.omega / omega0 - eq43(x.beta / beta0)));
  }
  return most;
}

TEST_CASE(
    "true: (43) holds whatever the rudder rate, to 3e-6 of omega'_0 at 2.5 deg/s and 7e-5 at 0.5 deg/s, exactly for a "
    "step",
    "[linear][published]") {
  for (const auto& [beta, omega] : reference().at("first_order").at("eq43").items())
    CHECK_THAT(eq43(std::stod(beta)), WithinAbs(omega.get<double>(), 1e-12));
  CHECK_THAT(deviation_from_43(2.5), WithinAbs(3e-6, 0.5e-6));
  CHECK_THAT(deviation_from_43(0.5), WithinAbs(7e-5, 0.5e-5));
  CHECK(deviation_from_43(1e7) < 1e-12);
}

TEST_CASE("true: the curve (43) is practically a straight line, 3 % of omega'_0 off", "[linear][published]") {
  double most = 0.0;
  for (double beta = 0.0; beta <= 1.0; beta += 0.001) most = std::max(most, std::abs(eq43(beta) - beta));
  CHECK_THAT(most, WithinAbs(0.03, 0.002));
  CHECK_THAT(eq43(1e-6) / 1e-6, WithinRel(1.08454, 1e-5));
}

TEST_CASE("true: first order gives quite different overshoots, 12.5 against 6.8 deg", "[linear][published]") {
  const auto first = linear_zigzag(first_order_ship(-4.896, 9.806), ten_ten()).reversals;
  const auto& wanted = reference().at("figure_numbers_printed_TK").at("first_order rate 2.5");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK_THAT(degrees(first[i].overshoot), WithinRel(wanted.at("overshoot_deg")[i].get<double>(), 1e-9));
    CHECK_THAT(first[i].execute, WithinRel(wanted.at("execute_s")[i].get<double>(), 1e-9));
  }
  CHECK_THAT(degrees(first[0].overshoot), WithinAbs(12.5, 0.05));
  CHECK_THAT(overshoot_deg(reference_ship(), 0), WithinAbs(6.8, 0.05));
}

TEST_CASE(
    "wrong: very low T3b and T3w do not make the ship first-order, the overshoot is 27 % apart; T3w = T2 does, exactly",
    "[linear][published]") {
  const auto apart = [](const Indices& i) {
    return overshoot_deg(first_order_ship(i.Kw, first_order_yaw(i).T), 0) / overshoot_deg(coefficients_from(i), 0) -
           1.0;
  };
  CHECK_THAT(apart(printed_indices(0.0005, 0.001)), WithinAbs(-0.27, 5e-3));
  CHECK_THAT(apart(printed_indices(0.154, 0.298)), WithinAbs(0.0, 1e-12));  // a zero upon the pole of T2
}

TEST_CASE("true: the yaw acceleration peaks, 0.197 against 0.087 of the first order", "[linear][published]") {
  CHECK_THAT(first_leg_peaks(reference_ship()).yaw,
             WithinRel(reference().at("figure_numbers_printed_TK").at("REF").at("max_domega_ds_firstleg").get<double>(),
                       1e-6));
  CHECK_THAT(first_leg_peaks(first_order_both(printed_indices())).yaw, WithinAbs(0.0858, 5e-4));
}

TEST_CASE("half right: a slower rudder brings second order nearer to first: 83 % apart at 2.5 deg/s, still 37 % at 0.5",
          "[linear][published]") {
  const auto gap = [](double rate) {
    return overshoot_deg(first_order_ship(-4.896, 9.806), 0, rate) / overshoot_deg(reference_ship(), 0, rate) - 1.0;
  };
  CHECK_THAT(gap(2.5), WithinAbs(0.833, 5e-3));
  CHECK_THAT(gap(0.5), WithinAbs(0.366, 5e-3));
  CHECK_THAT(overshoot_deg(reference_ship(), 0, 0.5), WithinAbs(24.37, 5e-3));
  CHECK_THAT(overshoot_deg(first_order_ship(-4.896, 9.806), 0, 0.5), WithinAbs(33.29, 6e-3));
}

TEST_CASE("true: at 0.5 deg/s the yaw acceleration still jumps and the loop stays open", "[linear][published]") {
  const auto& wanted = reference().at("figure_numbers_printed_TK").at("REF rate0.5");
  const auto peaks = first_leg_peaks(reference_ship(), 0.5),
             first = first_leg_peaks(first_order_both(printed_indices()), 0.5);
  CHECK_THAT(peaks.yaw, WithinRel(wanted.at("max_domega_ds_firstleg").get<double>(), 1e-6));
  CHECK_THAT(peaks.drift, WithinRel(radians(wanted.at("max_dbeta_ds_deg_firstleg").get<double>()), 1e-6));
  CHECK(peaks.yaw > 1.25 * first.yaw);
  CHECK_THAT(loop_of(reference_ship(), 0.5).area, WithinAbs(0.0704, 5e-5));
}

// ---------------------------------------------------------------- T3b and T3w in the zigzag

TEST_CASE("true: T3b does not affect the yaw at all", "[linear][published]") {
  const LinearResponse<double> ship(reference_ship()), other(coefficients_from(printed_indices(0.309)));
  const auto a = linear_zigzag(ship.m, ten_ten()), b = linear_zigzag(other.m, ten_ten());
  double drift_apart = 0.0;
  for (double s = 0.0; s < 30.0; s += 0.1) {
    const auto x = state_at(ship, a.legs, s), y = state_at(other, b.legs, s);
    CHECK_THAT(y.omega, WithinAbs(x.omega, 1e-12));
    CHECK_THAT(y.psi, WithinAbs(x.psi, 1e-12));
    drift_apart = std::max(drift_apart, std::abs(x.beta - y.beta));
  }
  CHECK(degrees(drift_apart) > 0.5);
}

TEST_CASE("true: T3w leaves the drift alone until the first counter-rudder, and 1.6 deg at s' = 6 thereafter",
          "[linear][published]") {
  const LinearResponse<double> ship(reference_ship()), other(coefficients_from(printed_indices(0.154, 0.492)));
  const auto a = linear_zigzag(ship.m, ten_ten()), b = linear_zigzag(other.m, ten_ten());
  for (double s = 0.0; s < a.reversals[0].execute; s += 0.05)
    CHECK_THAT(state_at(other, b.legs, s).beta, WithinAbs(state_at(ship, a.legs, s).beta, 1e-13));
  CHECK_THAT(std::abs(degrees(state_at(other, b.legs, 6.0).beta - state_at(ship, a.legs, 6.0).beta)),
             WithinAbs(1.6, 0.1));
}

TEST_CASE("true: T3w governs the peak of the yaw acceleration, T3b that of the drift", "[linear][published]") {
  const std::tuple<const char*, double, double> cases[] = {{"REF", 0.154, 0.983},       {"T3b=0.309", 0.309, 0.983},
                                                           {"T3w=0.492", 0.154, 0.492}, {"T3w=1.966", 0.154, 1.966},
                                                           {"T3w=3", 0.154, 3.0},       {"T3w=5", 0.154, 5.0}};
  for (const auto& [name, T3b, T3w] : cases) {
    INFO(name);
    const auto& wanted = reference().at("figure_numbers_printed_TK").at(name);
    const auto found = first_leg_peaks(coefficients_from(printed_indices(T3b, T3w)));
    CHECK_THAT(found.yaw, WithinRel(wanted.at("max_domega_ds_firstleg").get<double>(), 1e-6));
    CHECK_THAT(degrees(found.drift), WithinRel(wanted.at("max_dbeta_ds_deg_firstleg").get<double>(), 1e-6));
  }
}

TEST_CASE("true: T3b changes the loop along the drift axis only", "[linear][published]") {
  const auto ref = loop_of(reference_ship()), twice = loop_of(coefficients_from(printed_indices(0.309)));
  CHECK_THAT(twice.omega_max, WithinRel(ref.omega_max, 1e-9));
  CHECK_THAT(twice.beta_max / ref.beta_max, WithinAbs(1.023, 1e-3));
  CHECK_THAT(twice.beta_at_omega_zero / ref.beta_at_omega_zero, WithinAbs(0.813, 1e-3));
}

TEST_CASE("true: T3w acts on the loop much more than T3b: halved it takes 45 % of the area, T3b doubled 19 %",
          "[linear][published]") {
  const double ref = loop_of(reference_ship()).area;
  CHECK_THAT(loop_of(coefficients_from(printed_indices(0.309))).area / ref, WithinAbs(1.0 - 0.187, 1e-3));
  CHECK_THAT(loop_of(coefficients_from(printed_indices(0.154, 0.492))).area / ref, WithinAbs(1.0 - 0.455, 1e-3));
}

TEST_CASE(
    "half right: a larger T3w contracts the loop in beta, but its largest omega' falls too and is back only at T3w = "
    "2.85",
    "[linear][published]") {
  const auto ref = loop_of(reference_ship()), twice = loop_of(coefficients_from(printed_indices(0.154, 1.966)));
  CHECK_THAT(degrees(twice.beta_max), WithinAbs(5.78, 5e-3));                            // from 10.03
  CHECK_THAT(twice.omega_at_beta_zero / ref.omega_at_beta_zero, WithinAbs(2.18, 5e-3));  // the loop opens
  CHECK_THAT(twice.omega_max / ref.omega_max - 1.0, WithinAbs(-0.109, 5e-4));            // but does not grow
  CHECK(loop_of(coefficients_from(printed_indices(0.154, 2.84))).omega_max < ref.omega_max);
  CHECK(loop_of(coefficients_from(printed_indices(0.154, 2.86))).omega_max > ref.omega_max);
  CHECK_THAT(loop_of(coefficients_from(printed_indices(0.154, 3.0))).omega_max / ref.omega_max, WithinAbs(1.028, 1e-3));
  CHECK(loop_of(coefficients_from(printed_indices(0.154, 5.0))).omega_max > 1.4 * ref.omega_max);
}

// ---------------------------------------------------------------- the method

TEST_CASE("wrong: Euler's method with ds' = 0.05 is not 'still powerful': overshoots 12, 10 and 15 % too large",
          "[linear][published]") {
  const Coefficients ships[] = {reference_ship(), RandomLinearShips::tanker()};
  for (const auto& ship : ships) {
    const auto exact = linear_zigzag(ship, ten_ten()).reversals, euler = euler_zigzag(ship, ten_ten()).reversals;
    const double percent[] = {12, 10, 15};
    for (std::size_t i = 0; i < 3; ++i)
      CHECK_THAT(100.0 * (euler[i].overshoot / exact[i].overshoot - 1.0), WithinAbs(percent[i], 0.6));
  }
  // 17 times finer it is within 0.2 deg
  const auto fine = euler_zigzag(reference_ship(), ten_ten(), 0.003).reversals;
  for (std::size_t i = 0; i < 3; ++i)
    CHECK_THAT(degrees(fine[i].overshoot), WithinAbs(overshoot_deg(reference_ship(), i), 0.2));
}

// ---------------------------------------------------------------- section 7

TEST_CASE("wrong: not any of 7 parameters can be fixed, only 5; a_H and x'_Reff follow from c1 and c2",
          "[linear][published]") {
  using D = Dual<7>;
  const auto ship = printed_table_1();
  const auto& h = ship.hull;
  const auto& r = ship.rudder;
  LinearParts<D> dual{
      .hull = {D(h.L_over_B), D(h.c_B), D(h.k_11), D(h.k_22), D(h.r_z), D(h.r_66), D(h.Y_b, 0), D(h.Y_w, 1),
               D(h.N_b, 2), D(h.N_w, 3)},
      .rudder = {D(r.area_ratio), D(r.w), D(r.c_Th), D(r.lift_slope), D(r.a_H, 5), D(r.c_Ry, 4), D(r.x_Reff, 6)}};
  const auto m = coefficients(dual).total();
  Eigen::Matrix<double, 6, 7> jacobian;
  const D rows[] = {m.a1, m.b1, m.c1, m.a2, m.b2, m.c2};
  for (int i = 0; i < 6; ++i) jacobian.row(i) = rows[i].v.transpose();
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(jacobian);
  REQUIRE(lu.rank() == 6);
  // the one direction in which the seven move without moving the coefficients
  const Eigen::VectorXd free = lu.kernel().col(0).normalized();
  for (int i = 0; i < 5; ++i) CHECK(std::abs(free[i]) > 1e-6);
  for (int i = 5; i < 7; ++i) CHECK(std::abs(free[i]) < 1e-12);
}

TEST_CASE("true: with one of the five fixed the others follow from the printed coefficients", "[linear][published]") {
  for (const auto& [name, known] : test::known_parts) {
    INFO(name);
    const auto& wanted = reference().at("section7").at("from_printed_abc").at(name);
    const auto found = parts_from(RandomLinearShips::tanker(), printed_table_1(), known);
    CHECK_THAT(found.rudder.a_H, WithinRel(wanted.at("aH").get<double>(), 1e-12));
    CHECK_THAT(found.rudder.x_Reff, WithinRel(wanted.at("xR").get<double>(), 1e-12));
    CHECK_THAT(found.rudder.c_Ry, WithinRel(wanted.at("cRy").get<double>(), 1e-11));
    CHECK_THAT(found.hull.Y_b, WithinRel(wanted.at("Yb").get<double>(), 1e-11));
    CHECK_THAT(found.hull.Y_w, WithinRel(wanted.at("Yw").get<double>(), 1e-11));
    CHECK_THAT(found.hull.N_b, WithinRel(wanted.at("Nb").get<double>(), 1e-11));
    CHECK_THAT(found.hull.N_w, WithinRel(wanted.at("Nw").get<double>(), 1e-11));
  }
}

TEST_CASE("half right: Y'_b and N'_b are best known, but fixing them multiplies their error; c_Ry would not",
          "[linear][published]") {
  const auto base = printed_table_1();
  const auto m = coefficients(base).total();
  const auto percent = [](double after, double before) { return 100.0 * (after / before - 1.0); };
  auto ship = base;
  ship.hull.Y_b *= 1.01;
  auto found = parts_from(m, ship, KnownPart::Y_b);
  CHECK_THAT(percent(found.rudder.c_Ry, base.rudder.c_Ry), WithinAbs(-3.3, 0.06));
  CHECK_THAT(percent(found.hull.Y_w, base.hull.Y_w), WithinAbs(4.7, 0.06));
  ship = base;
  ship.hull.N_b *= 1.01;
  found = parts_from(m, ship, KnownPart::N_b);
  CHECK_THAT(percent(found.rudder.c_Ry, base.rudder.c_Ry), WithinAbs(3.7, 0.06));
  CHECK_THAT(percent(found.hull.Y_w, base.hull.Y_w), WithinAbs(-5.3, 0.06));
  ship = base;
  ship.rudder.c_Ry *= 1.01;
  found = parts_from(m, ship, KnownPart::c_Ry);
  for (const auto& [after, before] : {std::pair{found.hull.Y_b, base.hull.Y_b},
                                      {found.hull.Y_w, base.hull.Y_w},
                                      {found.hull.N_b, base.hull.N_b},
                                      {found.hull.N_w, base.hull.N_w}})
    CHECK(std::abs(percent(after, before)) < 1.45);
}

TEST_CASE("not in the paper: one per cent of b1 is eight per cent of Y'_w", "[linear][published]") {
  const auto base = printed_table_1();
  auto m = coefficients(base).total();
  m.b1 *= 1.01;
  CHECK_THAT(std::abs(parts_from(m, base, KnownPart::c_Ry).hull.Y_w / base.hull.Y_w - 1.0), WithinAbs(0.081, 1e-3));
}

}  // namespace
}  // namespace swayaw
