#include "swayaw/nonlinear/surroundings/wind.hpp"

#include <catch.hpp>
#include <set>
#include <tuple>

#include "random_windage.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/pack.hpp"

namespace swayaw {
namespace {

using test::RandomWinds;

void require_close(const PlanarForce<double>& a, const PlanarForce<double>& b, const PlanarForce<double>& scale,
                   double bound) {
  REQUIRE_THAT(a.X, WithinAbs(b.X, bound * scale.X));
  REQUIRE_THAT(a.Y, WithinAbs(b.Y, bound * scale.Y));
  REQUIRE_THAT(a.N, WithinAbs(b.N, bound * scale.N));
}

TEST_CASE("a symmetric ship in mirrored wind feels the mirrored load", "[nonlinear][symmetry]") {
  RandomWinds random(31);
  for (int i = 0; i < 300; ++i) {
    for (const auto& windage : random.of_all_forms()) {
      const auto wind = random.wind();
      const auto motion = random.motion();
      const double psi = random.heading();
      const auto port = wind_force(windage, Wind<double>{wind.speed, -wind.from}, mirrored(motion), -psi);
      const auto starboard = mirrored(wind_force(windage, wind, motion, psi));
      require_close(port, starboard, test::scale_of(windage, wind, motion), 1e-13);
    }
  }
}

TEST_CASE("only the direction of the wind from the bow counts", "[nonlinear][symmetry]") {
  RandomWinds random(32);
  for (int i = 0; i < 300; ++i) {
    for (const auto& windage : random.of_all_forms()) {
      const auto wind = random.wind();
      const auto motion = random.motion();
      const double psi = random.heading(), turn = random.uniform(-pi, pi);
      const auto here = wind_force(windage, wind, motion, psi);
      const auto turned = wind_force(windage, Wind<double>{wind.speed, wind.from + turn}, motion, psi + turn);
      require_close(turned, here, test::scale_of(windage, wind, motion), 1e-12);
    }
  }
}

TEST_CASE("the load of the wind grows with the square of all speeds", "[nonlinear][limit]") {
  RandomWinds random(33);
  for (int i = 0; i < 300; ++i) {
    for (const auto& windage : random.of_all_forms()) {
      const auto wind = random.wind();
      const auto [u, v, r] = random.motion();
      const double psi = random.heading(), k = random.uniform(0.1, 10.0);
      const auto one = wind_force(windage, wind, {u, v, r}, psi);
      const auto more = wind_force(windage, Wind<double>{k * wind.speed, wind.from}, {k * u, k * v, r}, psi);
      const auto scale = test::scale_of(windage, wind, {u, v, r});
      require_close({more.X / (k * k), more.Y / (k * k), more.N / (k * k)}, one, scale, 1e-12);
    }
  }
}

TEST_CASE("a ship that moves in still air feels head wind", "[nonlinear][limit]") {
  RandomWinds random(34);
  for (int i = 0; i < 200; ++i) {
    const auto windage = random.windage();
    const double u = random.uniform(0.1, 15.0), psi = random.heading();
    const PlanarMotion<double> ahead{u, 0.0, 0.0};
    const auto air = apparent_wind(Wind<double>{}, ahead, psi);
    REQUIRE(speed(air) == u);
    REQUIRE(angle_of_attack(air) == 0.0);
    REQUIRE(apparent_wind(Wind<double>{}, ShipState<double>{0.0, 0.0, psi, ahead}).u == air.u);
    const auto force = wind_force(windage, Wind<double>{}, ahead, psi);
    REQUIRE_THAT(force.X, WithinRel(-0.5 * windage.rho * windage.A_F * windage.C_Dl_bow * u * u, 1e-14));
    REQUIRE(force.Y == 0.0);
    REQUIRE(force.N == 0.0);
  }
}

TEST_CASE("a ship that drifts with the wind feels nothing", "[nonlinear][limit]") {
  RandomWinds random(35);
  const auto windage = random.windage();
  // wind from north carries a ship that heads east to starboard
  const auto force = wind_force(windage, Wind<double>{.speed = 8.0, .from = 0.0}, {0.0, 8.0, 0.0}, 0.5 * pi);
  const auto scale = test::scale_of(windage, {.speed = 8.0}, {});
  require_close(force, {0.0, 0.0, 0.0}, scale, 1e-30);
}

TEST_CASE("wind from ahead pushes astern, from starboard to port, and turns the bow away from the wind on the bow",
          "[nonlinear][symmetry]") {
  const auto windage = *windage_from({.frontal = 500.0, .lateral = 2000.0, .length = 180.0});
  const auto from = [&](double angle_deg) {
    return wind_force(windage, Wind<double>{.speed = 10.0, .from = radians(90.0 + angle_deg)}, {}, radians(90.0));
  };
  CHECK(from(0.0).X < 0.0);
  CHECK(from(180.0).X > 0.0);
  CHECK(from(90.0).Y < 0.0);
  CHECK(from(-90.0).Y > 0.0);
  CHECK(from(45.0).N < 0.0);   // starboard bow: bow to port
  CHECK(from(135.0).N > 0.0);  // starboard quarter: stern to port
  CHECK(from(-45.0).N > 0.0);
}

/// The formulas as [MSS] blendermann94.m writes them: gamma counts to port, 0 … pi.
PlanarForce<double> as_printed(const Windage<double>& w, double gamma, double V) {
  const double C_Dl_A_F = std::abs(gamma) <= pi / 2 ? w.C_Dl_bow : w.C_Dl_stern;
  const double C_Dl = C_Dl_A_F * w.A_F / w.A_L;
  const double den = 1.0 - 0.5 * w.delta * (1.0 - C_Dl / w.C_Dt) * std::pow(std::sin(2.0 * gamma), 2);
  const double C_X = -C_Dl_A_F * std::cos(gamma) / den;
  const double C_Y = w.C_Dt * std::sin(gamma) / den;
  const double C_N = (w.x_A / w.L_OA - 0.18 * (gamma - pi / 2)) * C_Y;
  const double q = 0.5 * w.rho * V * V;
  return {q * C_X * w.A_F, q * C_Y * w.A_L, q * C_N * w.A_L * w.L_OA};
}

TEST_CASE("load from areas is that of the printed formulas", "[nonlinear][second-route]") {
  RandomWinds random(36);
  for (int i = 0; i < 1000; ++i) {
    const auto windage = random.windage();
    const double gamma = random.uniform(0.0, pi), V = random.uniform(1.0, 25.0), psi = random.heading();
    const Wind<double> from_port{.speed = V, .from = psi - gamma};
    require_close(wind_force(windage, from_port, {}, psi), as_printed(windage, gamma, V),
                  test::scale_of(windage, from_port, {}), 1e-12);
  }
}

TEST_CASE("each type of ship has its tabled drag ahead, abeam and astern", "[nonlinear][published]") {
  for (const auto& ship : blendermann_ships) {
    const auto windage = *windage_from({.frontal = 160.7, .lateral = 434.8, .length = 55.0}, ship.type);
    CHECK(coefficients_at(windage, 0.0).X == -ship.C_Dl_bow);
    CHECK_THAT(coefficients_at(windage, 0.5 * pi).Y, WithinRel(-ship.C_Dt, 1e-14));
    CHECK_THAT(coefficients_at(windage, pi).X, WithinRel(ship.C_Dl_stern, 1e-14));
  }
}

// ---------------------------------------------------------------- the three scalars

template <class S>
std::array<S, 3> load(const Windage<S>& windage, const std::array<S, 5>& x) {
  const auto f = wind_force(windage, Wind<S>{x[0], x[1]}, PlanarMotion<S>{x[2], x[3], S(0.0)}, x[4]);
  return {f.X, f.Y, f.N};
}

TEST_CASE("dual numbers carry the derivatives of the wind load", "[nonlinear][second-route]") {
  using D = Dual<5>;
  RandomWinds random(37);
  for (int i = 0; i < 200; ++i) {
    for (const auto& windage : random.of_all_forms()) {
      const auto wind = random.wind();
      const auto motion = random.motion();
      const std::array<double, 5> x{wind.speed, wind.from, motion.u, motion.v, random.heading()};
      // kinks: C_X on the beam, the third derivative of a spline at its nodes, |alpha| ahead and astern
      if (speed(apparent_wind(wind, motion, x[4])) < 2.0) continue;
      if (std::abs(std::sin(2.0 * angle_of_attack(apparent_wind(wind, motion, x[4])))) < 0.05) continue;
      std::array<D, 5> seeded;
      for (int k = 0; k < 5; ++k) seeded[static_cast<std::size_t>(k)] = D(x[static_cast<std::size_t>(k)], k);
      const auto dual = load(cast_part<D>(windage), seeded);
      const auto value = load(windage, x);
      const auto scale = test::scale_of(windage, wind, motion);
      const double scales[] = {scale.X, scale.Y, scale.N};
      for (std::size_t k = 0; k < 5; ++k) {
        const double h = 1e-6;
        auto above = x, below = x;
        above[k] += h, below[k] -= h;
        const auto p = load(windage, above), m = load(windage, below);
        for (std::size_t j = 0; j < 3; ++j) {
          REQUIRE_THAT(dual[j].a, WithinAbs(value[j], 1e-13 * scales[j]));
          REQUIRE_THAT(dual[j].v[static_cast<int>(k)], WithinAbs((p[j] - m[j]) / (2.0 * h), 1e-7 * scales[j]));
        }
      }
    }
  }
}

TEST_CASE("dual numbers carry the derivatives by the numbers of the windage", "[nonlinear][second-route]") {
  using D = Dual<1>;
  RandomWinds random(38);
  for (int i = 0; i < 100; ++i) {
    const auto windage = random.windage();
    const ApparentWind<double> air{random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0)};
    const auto scale = test::scale_of(windage, {.speed = speed(air)}, {});
    for (std::size_t k = 0; k < Windage<double>::parameters().size(); ++k) {
      const auto member = Windage<double>::parameters()[k].member;
      auto seeded = cast_part<D>(windage);
      (seeded.*Windage<D>::parameters()[k].member).v[0] = 1.0;
      const auto dual = wind_force(seeded, ApparentWind<D>{D(air.u), D(air.v)});
      const double h = 1e-5 * std::max(std::abs(windage.*member), 0.1);
      auto above = windage, below = windage;
      above.*member += h, below.*member -= h;
      const auto p = wind_force(above, air), m = wind_force(below, air);
      require_close({dual.X.v[0] * h, dual.Y.v[0] * h, dual.N.v[0] * h},
                    {0.5 * (p.X - m.X), 0.5 * (p.Y - m.Y), 0.5 * (p.N - m.N)}, scale, 1e-12);
    }
  }
}

TEST_CASE("in still air the load and all its derivatives are zero", "[nonlinear][limit]") {
  using D = Dual<5>;
  RandomWinds random(39);
  for (const auto& windage : random.of_all_forms()) {
    const auto still = load(cast_part<D>(windage), {D(0.0, 0), D(1.0, 1), D(0.0, 2), D(0.0, 3), D(0.4, 4)});
    for (const auto& component : still) {
      CHECK(component.a == 0.0);
      CHECK(component.v.isZero(0.0));
    }
    const auto air = apparent_wind(Wind<D>{D(0.0, 0), D(1.0, 1)}, {D(0.0, 2), D(0.0, 3), D(0.0)}, D(0.4, 4));
    CHECK(speed(air).v.allFinite());
    CHECK(angle_of_attack(air).v.allFinite());
  }
}

TEST_CASE("a ship without areas feels no wind", "[nonlinear][limit]") {
  using D = Dual<5>;
  const auto force = load(Windage<D>{}, {D(12.0, 0), D(1.0, 1), D(3.0, 2), D(0.2, 3), D(0.4, 4)});
  for (const auto& component : force) {
    CHECK(component.a == 0.0);
    CHECK(component.v.isZero(0.0));
  }
  const Windage<double> nothing{.rho = 0.0, .C_Dt = 0.0, .C_Dl_bow = 0.0, .C_Dl_stern = 0.0, .delta = 0.0};
  for (const double component : load(nothing, {12.0, 1.0, 3.0, 0.2, 0.4})) CHECK(component == 0.0);
}

TEST_CASE("the slope of the load vanishes with the speed of the air", "[nonlinear][limit]") {
  using D = Dual<2>;
  RandomWinds random(40);
  for (const auto& windage : random.of_all_forms()) {
    for (const double V : {1e-3, 1e-20, 1e-90, 1e-120}) {
      const double from = random.uniform(-pi, pi);
      const auto force =
          wind_force(cast_part<D>(windage), ApparentWind<D>{D(-V * std::cos(from), 0), D(-V * std::sin(from), 1)});
      for (const auto& [component, area] : {std::pair(force.X, windage.A_F), std::pair(force.Y, windage.A_L)}) {
        CHECK(component.v.allFinite());
        CHECK(component.v.norm() <= 50.0 * windage.rho * area * V);
      }
    }
  }
}

TEST_CASE("every lane of a pack is one wind", "[nonlinear][second-route]") {
  constexpr std::size_t lanes = Pack::size;
  RandomWinds random(41);
  for (int i = 0; i < 200; ++i) {
    for (const auto& windage : random.of_all_forms()) {
      std::array<std::array<double, lanes>, 5> column;
      for (std::size_t k = 0; k < lanes; ++k) {
        const auto wind = random.wind();
        const auto motion = random.motion();
        const double values[] = {wind.speed, wind.from, motion.u, motion.v, random.heading()};
        for (std::size_t j = 0; j < 5; ++j)
          column[j][k] = k == 0 && i % 2 == 0 ? 0.0 : values[j];  // still air in one lane
      }
      std::array<Pack, 5> x;
      for (std::size_t j = 0; j < 5; ++j) x[j] = Pack::load_unaligned(column[j].data());
      const auto packed = load(cast_part<Pack>(windage), x);
      for (std::size_t k = 0; k < lanes; ++k) {
        const auto alone = load(windage, {column[0][k], column[1][k], column[2][k], column[3][k], column[4][k]});
        const auto scale = test::scale_of(windage, {.speed = column[0][k]}, {column[2][k], column[3][k], 0.0});
        require_close({packed[0].get(k), packed[1].get(k), packed[2].get(k)}, {alone[0], alone[1], alone[2]}, scale,
                      1e-12);
      }
    }
  }
}

TEST_CASE("every number of a windage has its key and keeps its range", "[nonlinear][limit]") {
  std::set<std::string_view> keys;
  for (const auto& ship : blendermann_ships) {
    const auto windage = *windage_from({.frontal = 1253.9, .lateral = 3657.1, .length = 320.0}, ship.type);
    for (const auto& parameter : Windage<double>::parameters()) {
      keys.insert(parameter.key);
      CHECK(parameter.range.contains(windage.*parameter.member));
    }
  }
  CHECK(keys.size() == 9);
}

TEST_CASE("numbers that a windage is not given are those of a ship file that does not give them",
          "[nonlinear][second-route]") {
  const Windage<double> windage;
  for (const auto& parameter : Windage<double>::parameters()) CHECK(windage.*parameter.member == parameter.fallback);
}

/// A ship that has a windage among her parts.
template <class S = double>
struct Boat {
  Windage<S> windage;

  static constexpr auto sections() { return std::tuple{Section<Boat, Windage<S>>{"windage", &Boat::windage}}; }
};

TEST_CASE("a ship with another scalar keeps the given coefficients of her windage", "[nonlinear][round-trip]") {
  RandomWinds random(42);
  for (const auto& windage : random.of_all_forms()) {
    const auto boat = cast<Dual<1>>(Boat<double>{windage});
    const ApparentWind<double> air{-7.0, 4.0};
    CHECK(boat.windage.given.index() == windage.given.index());
    CHECK_THAT(wind_force(boat.windage, ApparentWind<Dual<1>>{Dual<1>(air.u), Dual<1>(air.v)}).N.a,
               WithinRel(wind_force(windage, air).N, 1e-12));
  }
}

}  // namespace
}  // namespace swayaw
