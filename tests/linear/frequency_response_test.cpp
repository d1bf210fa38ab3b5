#include "swayaw/linear/frequency_response.hpp"

#include <Eigen/Dense>
#include <catch.hpp>

#include "random_linear_ships.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/rudder_history.hpp"

namespace swayaw {
namespace {

using test::RandomLinearShips;
using Complex = std::complex<double>;
using Coefficients = SwayYawCoefficients<double>;

/// (jν I − A)⁻¹ c, and the heading as yaw rate over jν.
std::array<Complex, 3> directly(const Coefficients& m, double nu) {
  Eigen::Matrix2cd B;
  B << Complex(-m.a1, nu), -m.b1, -m.a2, Complex(-m.b2, nu);
  const Eigen::Vector2cd x = B.fullPivLu().solve(Eigen::Vector2cd(m.c1, m.c2));
  return {x[0], x[1], x[1] / Complex(0.0, nu)};
}

std::array<RudderTransfer<double>, 3> motions(const Coefficients& m) {
  const auto h = transfer_functions(m);
  return {rudder_to_drift(h), rudder_to_yaw(h), rudder_to_heading(h)};
}

/// One ship of each kind that the formulas must not trip over.
std::vector<Coefficients> special_ships() {
  return {RandomLinearShips::tanker(),
          {-0.5, 0.4, -0.17, 2.5, -2.0, -1.4},            // neutral: a1 b2 = a2 b1
          {-0.6, 0.4, 0.4 * 1.5 / 2.8, 3.5, -2.8, -1.5},  // Kb = 0
          {-1.0, 0.5, -0.2, -2.0, -1.2, -1.0},            // complex poles
          {-0.5, 0.5, -0.17, 4.0, -2.0, -1.4}};           // unstable
}

TEST_CASE("the frequency response is (jν I − A)⁻¹ c for every kind of ship", "[linear][second-route]") {
  RandomLinearShips random(61);
  auto ships = special_ships();
  while (ships.size() < 3000) ships.push_back(random.ship());
  for (const auto& m : ships) {
    const double nu = std::pow(10.0, random.uniform(-2.0, 2.0));
    const auto wanted = directly(m, nu);
    const auto t = motions(m);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = as_complex(response_at(t[i], nu));
      REQUIRE(std::abs(found - wanted[i]) < 1e-11 * std::abs(wanted[i]));
      REQUIRE_THAT(gain(t[i], nu), WithinRel(std::abs(found), 1e-12));
      REQUIRE_THAT(wrapped(phase(t[i], nu) - std::arg(found)), WithinAbs(0.0, 1e-11));
    }
  }
}

/// cos(nu s) by `n` straight lines in a period. Its fundamental is sinc²(π/n) of the cosine it is sampled from.
RudderHistory sampled_cosine(double nu, int n) {
  RudderHistory history;
  const double sinc = std::sin(pi / n) / (pi / n);
  for (int i = 0; i <= n; ++i) {
    history.s.push_back(2.0 * pi * i / n / nu);
    history.delta.push_back(std::cos(2.0 * pi * i / n) / (sinc * sinc));
  }
  return history;
}

TEST_CASE("on the periodic motion the exact response to a sampled sinusoid stays on it", "[linear][second-route]") {
  RandomLinearShips random(62);
  auto ships = special_ships();
  while (ships.size() < 60) ships.push_back(random.ship());
  int compared = 0, unstable = 0;
  for (const auto& m : ships) {
    const double nu = std::pow(10.0, random.uniform(-0.3, 1.0));
    const auto t = motions(m);
    const auto at = [&](std::size_t i, double s) {
      return (as_complex(response_at(t[i], nu)) * std::polar(1.0, nu * s)).real();
    };
    const auto history = sampled_cosine(nu, 2000);
    const auto found = response_to(LinearResponse<double>(m), history, history.s, {at(0, 0), at(1, 0), at(2, 0)});
    // what the corners disturb grows by no more than this in one period of an unstable ship
    const double growth = is_stable(m) ? 1.0 : std::exp(poles(trace(m), determinant(m)).size * 2.0 * pi / nu);
    if (growth > 1e3) continue;
    ++compared;
    unstable += growth > 1.0;
    for (std::size_t i = 0; i < found.size(); i += 97) {
      const double s = history.s[i], allowed = 3e-6 * growth;
      CHECK_THAT(found[i].beta, WithinAbs(at(0, s), allowed * gain(t[0], nu)));
      CHECK_THAT(found[i].omega, WithinAbs(at(1, s), allowed * gain(t[1], nu)));
      CHECK_THAT(found[i].psi, WithinAbs(at(2, s), allowed * (gain(t[2], nu) + gain(t[1], nu))));
    }
  }
  CHECK(compared > 40);
  CHECK(unstable > 5);
}

TEST_CASE("a stable ship settles into the periodic motion", "[linear][second-route]") {
  const auto m = RandomLinearShips::tanker();
  const LinearResponse<double> ship(m);
  const double nu = 2.0;
  const auto history = sampled_cosine(nu, 1000);
  LinearState<double> state{0.0, 0.0, 0.0};
  const double period = 2.0 * pi / nu;
  for (int i = 0; i < 80; ++i) state = response_to(ship, history, {period}, state)[0];
  const auto t = motions(m);
  CHECK_THAT(state.beta, WithinRel(response_at(t[0], nu).re, 1e-5));
  CHECK_THAT(state.omega, WithinRel(response_at(t[1], nu).re, 1e-5));
}

TEST_CASE("a Bode diagram has no jumps, and its phase is that of the response", "[linear][limit]") {
  RandomLinearShips random(63);
  auto ships = special_ships();
  while (ships.size() < 500) ships.push_back(random.ship());
  const auto frequencies = logarithmic_frequencies(1e-3, 1e3, 4000);
  for (const auto& m : ships)
    for (const auto& t : motions(m)) {
      const auto diagram = bode(t, frequencies, {.L = 97.4, .U = 7.272});
      // no root of numerator or denominator is so near the axis that a step of 0.35 % turns the phase by more
      const double sharpest =
          std::max({1.0, std::abs(t.e0 / t.e1), std::abs(t.n1 / t.n0), std::abs(t.n0 / t.n1), 1.0 / std::abs(t.e1)});
      for (std::size_t i = 1; i < diagram.size(); ++i) {
        REQUIRE(std::abs(diagram[i].phase - diagram[i - 1].phase) < std::min(3.0, 0.02 * sharpest));
        REQUIRE(diagram[i].gain > 0.0);
      }
    }
}

TEST_CASE("phase runs from port to its end: drift and yaw of a stable ship from −π to −3π/2, heading from −3π/2 to −2π",
          "[linear][limit]") {
  RandomLinearShips random(64);
  int seen = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto m = random.ship();
    const auto t = motions(m);
    const auto& yaw = t[1];
    if (!is_stable(m) || yaw.n0 >= 0.0) continue;  // c2 < 0 for all of them
    ++seen;
    REQUIRE_THAT(phase(yaw, 1e-9), WithinAbs(-pi, 1e-5));
    REQUIRE_THAT(phase(yaw, 1e9), WithinAbs(-1.5 * pi, 1e-5));
    REQUIRE_THAT(phase(t[2], 1e-9), WithinAbs(-1.5 * pi, 1e-5));
    REQUIRE_THAT(phase(t[2], 1e9), WithinAbs(-2.0 * pi, 1e-5));
  }
  CHECK(seen > 300);
}

TEST_CASE("slow swinging gives the static gains Kb and Kw, quick swinging c/ν", "[linear][limit]") {
  RandomLinearShips random(65);
  for (int k = 0; k < 1000; ++k) {
    const auto m = random.ship();
    if (std::abs(determinant(m)) < 0.05) continue;
    const auto i = steering_indices(m);
    const auto t = motions(m);
    REQUIRE_THAT(response_at(t[0], 1e-7).re, WithinAbs(i.Kb, 1e-6 * (1.0 + std::abs(i.Kb))));
    REQUIRE_THAT(response_at(t[1], 1e-7).re, WithinAbs(i.Kw, 1e-6 * (1.0 + std::abs(i.Kw))));
    REQUIRE_THAT(gain(t[1], 1e6) * 1e6, WithinRel(std::abs(m.c2), 1e-5));
    REQUIRE_THAT(gain(t[2], 1e4) * 1e8, WithinRel(std::abs(m.c2), 1e-3));
  }
}

TEST_CASE("bandwidth is where the gain has fallen to 1/√2 for good, and there is one", "[linear][second-route]") {
  RandomLinearShips random(66);
  const auto frequencies = logarithmic_frequencies(1e-4, 1e4, 400);
  int found = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto m = random.ship();
    for (const auto& t : {motions(m)[0], motions(m)[1]}) {
      const auto nu = bandwidth(t);
      REQUIRE(nu.has_value());
      ++found;
      const double wanted = std::abs(t.n0 / t.e0) / std::sqrt(2.0);
      REQUIRE_THAT(gain(t, *nu), WithinRel(wanted, 1e-9));
      for (const double f : frequencies)
        if (std::abs(f / *nu - 1.0) > 1e-6) REQUIRE((gain(t, f) < wanted) == (f > *nu));
    }
  }
  CHECK(found == 4000);
  CHECK_FALSE(bandwidth(rudder_to_heading(transfer_functions(RandomLinearShips::tanker()))).has_value());
  CHECK_FALSE(bandwidth(rudder_to_yaw(SwayYawTransfer<double>{0.0, 1.0, -1.0, -1.0, -1.0, -1.0})).has_value());
}

TEST_CASE("beyond the crossover the loop never has gain 1 again", "[linear][second-route]") {
  RandomLinearShips random(67);
  const auto above = logarithmic_frequencies(1.0 + 1e-6, 1e4, 200);
  for (int k = 0; k < 2000; ++k) {
    const auto h = transfer_functions(random.ship());
    const double helm = std::pow(10.0, random.uniform(-1.5, 1.5));
    const auto c = crossover(h, helm);
    REQUIRE(c.has_value());  // the heading's gain falls from infinity to 0
    const auto heading = rudder_to_heading(h);
    REQUIRE_THAT(helm * gain(heading, c->frequency), WithinRel(1.0, 1e-9));
    for (const double factor : above) REQUIRE(helm * gain(heading, c->frequency * factor) < 1.0);
  }
}

/// Real parts of the poles of heading control are negative, by Routh: p (p² + e1 p + e0) − k (n1 p + n0).
bool steered_stably(const SwayYawTransfer<double>& h, double k) {
  const double a = h.e1, b = h.e0 - k * h.nw1, c = -k * h.nw0;
  return a > 0.0 && c > 0.0 && a * b > c;
}

TEST_CASE("a ship that helm keeps on course has a phase margin above zero, and one that it does not has none",
          "[linear][second-route]") {
  RandomLinearShips random(68);
  int kept = 0, lost = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto m = random.ship();
    const auto h = transfer_functions(m);
    const double helm = random.uniform(0.1, 4.0);
    if (!is_stable(m) || h.nw0 >= 0.0) continue;  // gain falls from infinity through 1 once: margin decides
    const double x1 = h.e1 * h.e1 - 2.0 * h.e0;
    if (x1 < 0.0) continue;  // no resonance
    (steered_stably(h, helm) ? kept : lost)++;
    REQUIRE((crossover(h, helm)->phase_margin > 0.0) == steered_stably(h, helm));
  }
  CHECK(kept > 300);
}

TEST_CASE("duals give the derivative of gain and phase", "[linear][second-route]") {
  using D = Dual<1>;
  RandomLinearShips random(69);
  for (int k = 0; k < 300; ++k) {
    const auto m = random.ship();
    const double nu = random.uniform(0.2, 5.0), step = 1e-6;
    const SwayYawCoefficients<D> dual{D(m.a1), D(m.b1), D(m.c1), D(m.a2, 0), D(m.b2), D(m.c2)};
    const auto t = rudder_to_heading(transfer_functions(dual));
    const auto at = [&](double shift) {
      auto moved = m;
      moved.a2 += shift;
      return rudder_to_heading(transfer_functions(moved));
    };
    const D g = gain(t, D(nu)), p = phase(t, D(nu));
    REQUIRE_THAT(g.v[0], WithinAbs((gain(at(step), nu) - gain(at(-step), nu)) / (2 * step),
                                   1e-6 * (1.0 + std::abs(g.v[0]) + g.a)));
    const double wanted = wrapped(phase(at(step), nu) - phase(at(-step), nu)) / (2 * step);
    REQUIRE_THAT(p.v[0], WithinAbs(wanted, 1e-6 * (1.0 + std::abs(p.v[0]))));
  }
}

TEST_CASE("frequencies with dimension are those per ship length times U/L", "[linear][published]") {
  const auto diagram = bode(motions(RandomLinearShips::tanker())[1], {1.0}, {.L = 97.4, .U = 7.272});
  CHECK_THAT(diagram[0].frequency_rad_s, WithinRel(1.0 / 13.3938, 1e-5));
}

TEST_CASE("senseless frequencies and gains are refused", "[linear][refusal]") {
  const auto h = transfer_functions(RandomLinearShips::tanker());
  CHECK_THROWS_WITH(bode(rudder_to_yaw(h), {0.0}, {1.0, 1.0}),
                    "frequency [rad per ship length] must be positive, got 0");
  CHECK_THROWS_WITH(bode(rudder_to_yaw(h), {1.0}, {.L = 0.0, .U = 1.0}), ContainsSubstring("length L"));
  CHECK_THROWS_WITH(logarithmic_frequencies(1.0, 2.0, 1), ContainsSubstring("at least 2"));
  CHECK_THROWS_WITH(highest_frequency_with_gain(rudder_to_yaw(h), -1.0), "gain must be positive, got -1");
  CHECK_FALSE(highest_frequency_with_gain(rudder_to_yaw(h), 1e6).has_value());
}

}  // namespace
}  // namespace swayaw
