#include "swayaw/nonlinear/models/parts/prime_propulsion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline nonlinear {
namespace {

/// At a thrust [N] or a shaft speed [1/s].
template <PrimeShip Ship, class S>
Controls<S> controls_at(const Ship& ship, const S& drive) {
  if (takes_shaft_speed(ship)) return {.delta = S(0.0), .rev = drive};
  const S half = 0.5 * drive;
  return {.delta = S(0.0), .thrust = {half, half}, .by_thrust = true};
}

/// Without drag of the rudders, T = −(X_H + push)/(1 − t), and a shaft speed near it.
template <PrimeShip Ship>
double first_guess(const Ship& ship, const PlanarMotion<double>& ahead, double push) {
  const auto& p = ship.propeller;
  const double T = -(hull_force(ship, ahead).X + push) / (1.0 - p.t_P);
  if (!takes_shaft_speed(ship)) return T;
  // k_0 (nD)² + k_1 V_A nD + k_2 V_A² = T/(ρD²), T of one propeller; the larger root
  const double V_A = ahead.u * (1.0 - p.w_f), half = 0.5 * p.k_1 * V_A;
  const double constant = p.k_2 * V_A * V_A - T / (p.twin() ? 2.0 : 1.0) / (ship.water.rho * p.D * p.D);
  return (-half + root_of_positive(half * half - p.k_0 * constant)) / (p.k_0 * p.D);
}

/// Newton's method with the exact derivative.
template <template <class> class Model>
Controls<double> balanced(const Model<double>& model, double speed, double push) {
  using D = Dual<1>;
  require_positive(speed, "speed [m/s]");
  const auto ship = cast<D>(model);
  const PlanarMotion<D> ahead{D(speed), D(0.0), D(0.0)};
  double drive = first_guess(model, {speed, 0.0, 0.0}, push);
  for (int i = 0; i < 30 && drive > 0.0; ++i) {
    const D X = forces(ship, ahead, controls_at(model, D(drive, 0))).total().X + push;
    const double change = X.a / X.v[0];
    drive -= change;
    if (std::abs(change) <= 1e-15 * std::abs(drive)) return controls_at(model, drive);
  }
  throw Refusal(fmt::format("no thrust carries the ship straight ahead at {} m/s", speed));
}

}  // namespace

Controls<double> self_propulsion(const PiShip<double>& ship, double speed, double push) {
  return balanced(ship, speed, push);
}
Controls<double> self_propulsion(const PuShip<double>& ship, double speed, double push) {
  return balanced(ship, speed, push);
}

}  // namespace swayaw::nonlinear
