#include "swayaw/nonlinear/steady_motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "acting_propulsion.hpp"
#include "small_matrices.hpp"
#include "steady_balance.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

using Vector = Eigen::Vector3d;

/// Newton's method.
std::optional<SteadyMotion> newton(const SteadyEquations& equations, double delta, const PlanarMotion<double>& guess) {
  const double U = speed(guess);
  const Vector unit(U, U, U / equations.L());
  Vector motion(guess.u, guess.v, guess.r);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const SteadyBalance balance = equations.at({motion[0], motion[1], motion[2]}, delta);
    const Eigen::Matrix3d J = balance.jacobian.leftCols<3>();
    const Vector step = solve(J, Vector(-balance.acceleration));
    const double size = step.cwiseQuotient(unit).cwiseAbs().maxCoeff();
    if (!std::isfinite(size)) return std::nullopt;
    motion += step * std::min(1.0, 0.2 / size);
    if (motion[0] <= 0.0) return std::nullopt;
    if (size < 1e-13) return SteadyMotion{{motion[0], motion[1], motion[2]}, is_stable(J)};
  }
  return std::nullopt;
}

}  // namespace

double self_propulsion_rev(const MmgShip<double>& ship, double speed, double push) {
  require_positive(speed, "speed [m/s]");
  const auto& p = ship.propeller;
  const double resistance =
      0.5 * ship.water.rho * ship.particulars.L * ship.particulars.d * speed * speed * ship.hull.R_0 - push;
  const double u_P = (1.0 - p.w_P0) * speed;
  const double needed = resistance / ((1.0 - p.t_P) * ship.water.rho * p.D * p.D);  // k_0 (nD)² + k_1 u_P nD + k_2 u_P²
  const double half = 0.5 * p.k_1 * u_P;
  const double discriminant = half * half - p.k_0 * (p.k_2 * u_P * u_P - needed);
  if (!(discriminant >= 0.0))
    throw Refusal(fmt::format(
        "no shaft speed propels the ship at {} m/s: the thrust curve kt does not reach its resistance", speed));
  return (-half + std::sqrt(discriminant)) / (p.k_0 * p.D);
}

Controls<double> self_propulsion(const MmgShip<double>& ship, double speed, double push) {
  return {.delta = 0.0, .rev = self_propulsion_rev(ship, speed, push)};
}

/// The polynomial holds the propulsion of its own speed and knows no other.
Controls<double> self_propulsion(const AbkowitzShip<double>& ship, double speed, double) {
  require_positive(speed, "speed [m/s]");
  const double U_0 = ship.particulars.U_0;
  if (std::abs(speed - U_0) <= 1e-6 * U_0) return {.delta = 0.0};
  throw Refusal(
      fmt::format("an abkowitz ship is propelled at the speed of its polynomial, {:.6g} m/s, and at no other", U_0));
}

Controls<double> self_propulsion(const Ship& ship, double speed) {
  return visit_acting(ship, [&](const auto& acting) { return acting_propulsion(acting, speed); });
}

bool takes_shaft_speed(const MmgShip<double>&) { return true; }

bool takes_shaft_speed(const AbkowitzShip<double>&) { return false; }

bool takes_shaft_speed(const Ship& ship) {
  return std::visit([](const auto& model) { return takes_shaft_speed(model); }, ship.model);
}

void require_drive(const ShipModel& model, const std::optional<double>& rev, const std::optional<double>& thrust) {
  if ((rev || thrust) && std::holds_alternative<AbkowitzShip<double>>(model))
    throw Refusal(
        "the propulsion of an abkowitz ship is part of its polynomial: it takes neither shaft speed nor thrust");
  const bool by_rev = std::visit([](const auto& ship) { return takes_shaft_speed(ship); }, model);
  if (rev && !by_rev) throw Refusal("this ship file does not tell the thrust at a shaft speed; give a thrust");
}

Controls<double> propulsion(const ShipModel& model, double speed, const std::optional<double>& rev,
                            const std::optional<double>& thrust) {
  require_drive(model, rev, thrust);
  if (thrust) return {.delta = 0.0, .thrust = {0.5 * *thrust, 0.5 * *thrust}, .by_thrust = true};
  if (rev) return {.delta = 0.0, .rev = require_positive(*rev, "shaft speed [1/s]")};
  return std::visit([&](const auto& ship) { return self_propulsion(ship, speed); }, model);
}

Controls<double> propulsion(const Ship& ship, double speed, const std::optional<double>& rev,
                            const std::optional<double>& thrust) {
  return visit_acting(ship, [&](const auto& acting) { return acting_propulsion(acting, speed, rev, thrust); });
}

template <class Model>
Controls<double> detail::acting_propulsion(const ActingShip<Model>& acting, double speed,
                                           const std::optional<double>& rev, const std::optional<double>& thrust) {
  const auto alone = propulsion(ShipModel(acting.model), speed, rev, thrust);
  if (rev || thrust) return alone;
  auto lasting = without_heading(acting.added);
  for_each_acting(acting.added, [&](auto i, const auto& e) {
    if (!never_steady(e).empty()) lasting.acting &= ~(std::uint32_t{1} << i.value);
  });
  const ShipState<double> ahead{0.0, 0.0, 0.0, {speed, 0.0, 0.0}};
  const double push = added_force(acting.model, lasting, ahead, Hidden<double>{}, alone).X;
  return push == 0.0 ? alone : self_propulsion(acting.model, speed, push);
}

template <class Model>
Controls<double> detail::settled_propulsion(const ActingShip<Model>& acting, double speed, double psi) {
  const auto calm = self_propulsion(acting.model, speed);
  const ShipState<double> ahead{0.0, 0.0, psi, {speed, 0.0, 0.0}};
  double push = added_force(acting.model, acting.added, ahead, Hidden<double>{}, calm).X;
  if (acting.surroundings.windy) push += wind_load(acting.surroundings, ahead).X;
  auto carrying = calm;
  try {
    if (push != 0.0) carrying = self_propulsion(acting.model, speed, push);
  } catch (const Refusal&) {  // no thrust is as small
    carrying = acting_propulsion(acting, speed);
  }
  // an engine that slows at that speed is set to what it slows from
  const double kept = driven(acting.added, ahead.motion, Controls<double>{.delta = 0.0, .rev = 1.0}).rev;
  if (kept > 0.0) carrying.rev /= kept;
  return carrying;
}

template Controls<double> detail::acting_propulsion(const ActingShip<MmgShip<double>>&, double,
                                                    const std::optional<double>&, const std::optional<double>&);
template Controls<double> detail::acting_propulsion(const ActingShip<PiShip<double>>&, double,
                                                    const std::optional<double>&, const std::optional<double>&);
template Controls<double> detail::acting_propulsion(const ActingShip<PuShip<double>>&, double,
                                                    const std::optional<double>&, const std::optional<double>&);
template Controls<double> detail::acting_propulsion(const ActingShip<AbkowitzShip<double>>&, double,
                                                    const std::optional<double>&, const std::optional<double>&);
template Controls<double> detail::settled_propulsion(const ActingShip<MmgShip<double>>&, double, double);
template Controls<double> detail::settled_propulsion(const ActingShip<PiShip<double>>&, double, double);
template Controls<double> detail::settled_propulsion(const ActingShip<PuShip<double>>&, double, double);
template Controls<double> detail::settled_propulsion(const ActingShip<AbkowitzShip<double>>&, double, double);

std::optional<SteadyMotion> steady_motion(const Ship& ship, const Controls<double>& controls,
                                          const PlanarMotion<double>& guess) {
  return newton(SteadyEquations(ship, controls), controls.delta, guess);
}

}  // namespace swayaw::nonlinear
