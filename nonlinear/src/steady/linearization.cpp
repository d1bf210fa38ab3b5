#include "swayaw/nonlinear/linearization.hpp"

#include <fmt/format.h>

#include <cmath>

#include "small_matrices.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/validity.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

using D = Dual<4>;

AccelerationDerivatives derivatives_of(const PlanarAcceleration<D>& a) {
  AccelerationDerivatives result;
  const D* rows[] = {&a.u, &a.v, &a.r};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) result.d[i][k] = rows[i]->v[static_cast<int>(k)];
  return result;
}

/// The motion, turned a little to that side, so that kinks show which branch the turn is on.
PlanarMotion<double> turned(const PlanarMotion<double>& m, Side side, double L) {
  const double U = speed(m), turn = 1e-9 * yaw_sign(side);
  return {m.u, m.v - turn * U, m.r + turn * U / L};
}

/// The force of a part alone, with its derivatives; motion without.
template <class Model>
std::vector<PartDerivatives> parts_on(const ActingShip<Model>& acting, const OperatingPoint& point, Side side) {
  const auto& model = acting.model;
  const auto ship = cast<D>(model);
  const auto added = without_heading(cast<D>(acting.added));
  const auto& [m, c] = point;
  const PlanarMotion<D> motion{D(m.u, 0), D(m.v, 1), D(m.r, 2)}, held{D(m.u), D(m.v), D(m.r)};
  const auto controls = with_rudder(cast<D>(c), D(c.delta, 3));
  const auto turn = turned(m, side, model.particulars.L);
  const auto branch = branch_at(model, turn, driven(acting.added, turn, c));
  const auto split = forces(ship, motion, driven(added, motion, controls), branch);
  std::vector<PartDerivatives> result;
  auto total = split.total();
  const auto add = [&](std::string_view name, const PlanarForce<D>& force) {
    result.push_back({std::string(name), derivatives_of(acceleration(ship, held, force))});
  };
  for (const auto& part : split.parts()) add(part.name, part.force);
  for_each_added(ship, added, ShipState<D>{D(0.0), D(0.0), D(0.0), motion},
                 steady_hidden(ship, added, motion, controls), controls,
                 [&](std::string_view name, const PlanarForce<D>& force) {
                   add(name, force);
                   total = total + force;
                 });
  const PlanarForce<D> constant{D(total.X.a), D(total.Y.a), D(total.N.a)};
  result.push_back({"centrifugal", derivatives_of(acceleration(ship, motion, constant))});
  return result;
}

AccelerationDerivatives mean(const AccelerationDerivatives& a, const AccelerationDerivatives& b) {
  AccelerationDerivatives result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) result.d[i][k] = 0.5 * (a.d[i][k] + b.d[i][k]);
  return result;
}

template <class Model>
std::vector<PartDerivatives> parts_on_side(const ActingShip<Model>& model, const OperatingPoint& point,
                                           std::optional<Side> side) {
  if (side) return parts_on(model, point, *side);
  auto parts = parts_on(model, point, Side::port);
  const auto starboard = parts_on(model, point, Side::starboard);
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i].derivatives = mean(parts[i].derivatives, starboard[i].derivatives);
  return parts;
}

std::array<std::complex<double>, 3> poles_of(const AccelerationDerivatives& a) {
  Eigen::Matrix3d J;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) J(i, k) = a.d[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  return eigenvalues(J);
}

/// Virtual masses of sway and yaw: the inverse of what unit force and moment accelerate, less the ship's own.
template <class Model>
SnameDerivatives<double> masses_of(const Model& model) {
  const PlanarMotion<double> rest{0.0, 0.0, 0.0};
  const auto by_force = acceleration(model, rest, {0.0, 1.0, 0.0}),
             by_moment = acceleration(model, rest, {0.0, 0.0, 1.0});
  const double det = by_force.v * by_moment.r - by_force.r * by_moment.v;
  const double L = model.particulars.L, unit = 0.5 * model.water.rho * L * L * L;
  const auto own = rigid_body(model);
  SnameDerivatives<double> d{};
  d.m = own.m / unit;
  d.x_G = own.x_G / L;
  d.I_z = own.I_z / (unit * L * L);
  d.Y_vdot = d.m - by_moment.r / det / unit;
  d.Y_rdot = d.m * d.x_G + by_moment.v / det / (unit * L);
  d.N_vdot = d.m * d.x_G + by_force.r / det / (unit * L);
  d.N_rdot = d.I_z - by_force.v / det / (unit * L * L);
  return d;
}

void require_ahead(const OperatingPoint& point, double L) {
  const auto& [m, c] = point;
  if (!(m.u > 0.0)) throw Refusal(fmt::format("a ship is linearized under way ahead, not at u = {:.6g} m/s", m.u));
  require_valid(m, c, L);
}

template <class Model>
void require_steady(const ActingShip<Model>& acting, const OperatingPoint& point) {
  const auto& model = acting.model;
  const auto& [m, c] = point;
  require_ahead(point, model.particulars.L);
  const double L = model.particulars.L, U = speed(m), unit = U * U / L;
  const auto a = acceleration(model, m, steady_force(model, acting.added, m, c));
  const double size = std::max({std::abs(a.u), std::abs(a.v), std::abs(a.r) * L}) / unit;
  if (!(size <= 1e-6))
    throw Refusal(
        fmt::format("u = {:.6g} m/s, v = {:.6g} m/s, r = {:.6g} rad/s, delta = {:.6g} rad is no steady motion: the "
                    "ship accelerates by {:.3g} U2/L",
                    m.u, m.v, m.r, c.delta, size));
}

template <class Model>
Linearization linearize_model(const ActingShip<Model>& acting, const OperatingPoint& point, std::optional<Side> side) {
  const auto& model = acting.model;
  require_ahead(point, model.particulars.L);
  Linearization result{.point = point,
                       .scale = {.L = model.particulars.L, .U = speed(point.motion)},
                       .whole = {},
                       .parts = parts_on_side(acting, point, side),
                       .masses = masses_of(model),
                       .poles = {}};
  for (const auto& part : result.parts) result.whole += part.derivatives;
  result.poles = poles_of(result.whole);
  return result;
}

OperatingPoint settled(const Ship& ship, const Controls<double>& controls, double speed) {
  const auto steady = steady_motion(ship, controls, {speed, 0.0, 0.0});
  if (!steady) throw Refusal("the ship has no steady motion ahead near the straight course with this propulsion");
  return {steady->motion, controls};
}

}  // namespace

AccelerationDerivatives& AccelerationDerivatives::operator+=(const AccelerationDerivatives& other) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) d[i][k] += other.d[i][k];
  return *this;
}

Linearization linearize(const Ship& ship, const OperatingPoint& point, std::optional<Side> side) {
  visit_acting(ship, [&](const auto& acting) { require_steady(acting, point); });
  return linearize_transient(ship, point, side);
}

Linearization linearize_transient(const Ship& ship, const OperatingPoint& point, std::optional<Side> side) {
  return visit_acting(ship, [&](const auto& acting) { return linearize_model(acting, point, side); });
}

bool has_kink(const Ship& ship, const OperatingPoint& point) {
  const auto port = linearize_transient(ship, point, Side::port).whole,
             starboard = linearize_transient(ship, point, Side::starboard).whole;
  const auto differ = [](double a, double b) { return std::abs(a - b) > 1e-9 * std::max(std::abs(a), std::abs(b)); };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (differ(port.d[i][k], starboard.d[i][k])) return true;
  return false;
}

SwayYawCoefficients<double> sway_yaw(const AccelerationDerivatives& a, const PrimeScale& scale) {
  const DimensionalSwayYaw<double> d{a.d[1][1], a.d[1][2], a.d[1][3], a.d[2][1], a.d[2][2], a.d[2][3]};
  return to_prime(d, scale);
}

SnameDerivatives<double> sname(const Linearization& linear) {
  return sname_derivatives(sway_yaw(linear.whole, linear.scale), linear.masses);
}

LinearShip linear_ship(const Ship& ship, const Linearization& linear) {
  return {.name = ship.name,
          .particulars = {.L = linear.scale.L, .U_0 = linear.scale.U},
          .steering_gear = steering_gear(ship),
          .form = sway_yaw(linear.whole, linear.scale),
          .confidence = {}};
}

OperatingPoint straight_course(const Ship& ship, double speed) {
  return settled(ship, self_propulsion(ship, speed), speed);
}

OperatingPoint straight_course(const Ship& ship, const Controls<double>& propulsion) {
  return settled(ship, propulsion, service_speed(ship));
}

}  // namespace swayaw::nonlinear
