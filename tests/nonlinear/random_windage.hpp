#pragma once

#include "random_ships.hpp"
#include "swayaw/nonlinear/surroundings/wind.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

/// Seeded windages, winds and motions for laws that must hold for all of them.
namespace swayaw::test {

struct RandomWinds {
  explicit RandomWinds(unsigned seed) : random(seed) {}

  RandomShips random;

  double uniform(double low, double high) { return random.uniform(low, high); }

  Windage<double> windage() {
    const double L = uniform(50.0, 350.0);
    return {.rho = uniform(1.1, 1.4),
            .A_F = uniform(1.0, 3.0) * L,
            .A_L = uniform(4.0, 12.0) * L,
            .L_OA = L,
            .x_A = uniform(-0.1, 0.1) * L,
            .C_Dt = uniform(0.6, 1.0),
            .C_Dl_bow = uniform(0.3, 1.0),
            .C_Dl_stern = uniform(0.3, 1.0),
            .delta = uniform(0.0, 1.0)};
  }

  FourierSeries<double> series(bool even, bool odd) {
    FourierSeries<double> f{.a_0 = even ? uniform(-1.0, 1.0) : 0.0};
    for (int k = 0; k < 5; ++k) {
      if (even) f.a.push_back(uniform(-1.0, 1.0));
      if (odd) f.b.push_back(uniform(-1.0, 1.0));
    }
    return f;
  }

  /// Measured on one side, with the centre line.
  WindTable starboard_table() {
    WindTable table;
    for (double angle = 0.0; angle < 179.0; angle += uniform(5.0, 20.0)) {
      const bool ahead = angle == 0.0;
      table.push_back(
          {radians(angle), uniform(-1.0, 1.0), ahead ? 0.0 : uniform(-1.0, 0.0), ahead ? 0.0 : uniform(-0.2, 0.2)});
    }
    table.push_back({pi, uniform(0.0, 1.0), 0.0, 0.0});
    return table;
  }

  /// A symmetric ship whose coefficients come from areas, from a table and from a series.
  std::array<Windage<double>, 3> of_all_forms() {
    auto areas = windage(), table = areas, fourier = areas;
    table.given = wind_spline(both_sides(starboard_table()));
    fourier.given = WindSeries<double>{series(true, false), series(false, true), series(false, true)};
    return {areas, table, fourier};
  }

  Wind<double> wind() { return {.speed = uniform(0.0, 25.0), .from = uniform(-pi, 3.0 * pi)}; }
  PlanarMotion<double> motion() { return {uniform(-3.0, 10.0), uniform(-2.0, 2.0), uniform(-0.01, 0.01)}; }
  double heading() { return uniform(-4.0 * pi, 4.0 * pi); }
};

/// A force and a moment small against these are nothing.
inline PlanarForce<double> scale_of(const Windage<double>& w, const Wind<double>& wind,
                                    const PlanarMotion<double>& motion) {
  const double V = wind.speed + speed(motion), Y = 0.5 * w.rho * w.A_L * V * V;
  return {.X = 0.5 * w.rho * w.A_F * V * V, .Y = Y, .N = Y * w.L_OA};
}

}  // namespace swayaw::test
