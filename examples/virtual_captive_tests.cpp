// A ship as a towing tank: captive tests of her with measurement noise, and the derivatives that they give back.
//
//   virtual_captive_tests SHIP.toml
#include <fmt/format.h>

#include <random>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace {

using namespace swayaw;

/// A steady test; r' in ship lengths.
CaptivePoint steady(const char* test, const Ship& ship, double beta_deg, double r_prime, double delta_deg) {
  const double U = service_speed(ship), beta = radians(beta_deg);
  const auto controls = with_rudder(self_propulsion(ship, U), radians(delta_deg));
  CaptivePoint point{.run = "",
                     .tests = {test},
                     .moments = {{{U * std::cos(beta), -U * std::sin(beta), r_prime * U / length(ship)}, {}, controls}},
                     .measured = {}};
  point.measured = captive_force(ship, point);
  return point;
}

/// Rudder, drift, circles, circles with drift, and drift with rudder for validation.
std::vector<CaptivePoint> tests_of(const Ship& ship) {
  std::vector<CaptivePoint> points;
  for (const double delta : {-20.0, -10.0, 0.0, 10.0, 20.0})
    points.push_back(steady("static_rudder", ship, 0, 0, delta));
  for (const double beta : {-12.0, -9.0, -6.0, -3.0, 3.0, 6.0, 9.0, 12.0}) {
    points.push_back(steady("static_drift", ship, beta, 0, 0));
    points.push_back(steady("static_drift_rudder", ship, beta, 0, -beta));
  }
  for (const double r : {-0.6, -0.4, -0.2, 0.2, 0.4, 0.6}) {
    points.push_back(steady("circle", ship, 0, r, 0));
    for (const double beta : {-8.0, 4.0, 8.0, 12.0}) points.push_back(steady("circle_drift", ship, beta, r, 0));
  }
  return points;
}

/// Each force with an error of 1 %.
void measure(std::vector<CaptivePoint>& points) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> error(1.0, 0.01);
  for (auto& [run, tests, moments, f, with_inertia] : points)
    f = {f.X * error(engine), f.Y * error(engine), f.N * error(engine)};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: virtual_captive_tests SHIP.toml\n");
    return 2;
  }
  try {
    const auto ship = read_ship(arguments[1]);
    auto points = tests_of(ship);
    measure(points);
    const auto fit = fit_captive(ship, points, captive_plan(ship, points, HullTerms::cubic, radians(12)));
    for (const auto& step : fit.steps) {
      fmt::print("{} of {} tests: {}, condition {:.1f}\n", in_words(step.step.component), step.points,
                 in_words(step.fit.status), step.fit.condition_number);
      for (const auto& c : step.fit.coefficients) {
        const double truth = parameters_of(ship, std::array{c.name})[0].value;
        fmt::print("  {:<10} {:9.5f} ± {:.5f}   true {:9.5f}{}\n", c.name, c.estimate.value, c.estimate.standard_error,
                   truth, c.undetermined ? "   not determined" : "");
      }
    }
    const auto error = fit.validation.relative();
    fmt::print("drift with rudder, not used: errors of X, Y, N {:.1f}, {:.1f}, {:.1f} %\n", 100 * error.X,
               100 * error.Y, 100 * error.N);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
