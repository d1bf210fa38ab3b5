#pragma once

#include "swayaw/core/dual.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/nonlinear/coefficients.hpp"

/// What a balance between carriage and model measures, for every model and scalar. Not installed.
namespace swayaw::inline identification::detail {

/// Force that gives a ship and the entrained water this acceleration. The acceleration is affine in the force, a = A F
/// + a_0, and surge is not coupled to sway and yaw. Forces are counted in units of the body's mass and inertia.
template <template <class> class Model, class S>
PlanarForce<S> force_that_gives(const Model<S>& ship, const RigidBody& body, const PlanarMotion<S>& motion,
                                const PlanarAcceleration<S>& wanted) {
  const auto at = [&](double X, double Y, double N) {
    return acceleration(ship, motion, PlanarForce<S>{S(X * body.m), S(Y * body.m), S(N * body.I_z)});
  };
  const auto a_0 = at(0, 0, 0), by_X = at(1, 0, 0), by_Y = at(0, 1, 0), by_N = at(0, 0, 1);
  const S du = wanted.u - a_0.u, dv = wanted.v - a_0.v, dr = wanted.r - a_0.r;
  const S A_vY = by_Y.v - a_0.v, A_rY = by_Y.r - a_0.r, A_vN = by_N.v - a_0.v, A_rN = by_N.r - a_0.r;
  const S over_det = 1.0 / (A_vY * A_rN - A_vN * A_rY);
  return {.X = body.m * du / (by_X.u - a_0.u),
          .Y = body.m * (A_rN * dv - A_vN * dr) * over_det,
          .N = body.I_z * (A_vY * dr - A_rY * dv) * over_det};
}

/// Force that accelerates the ship herself, without entrained water.
///
///     X = m (du/dt − v r − x_G r²),   Y = m (dv/dt + u r + x_G dr/dt),   N = I_z dr/dt + m x_G (dv/dt + u r)
inline PlanarForce<double> force_on_body(const RigidBody& b, const PlanarMotion<double>& m,
                                         const PlanarAcceleration<double>& a) {
  const double sway = a.v + m.u * m.r;
  return {.X = b.m * (a.u - m.v * m.r - b.x_G * m.r * m.r),
          .Y = b.m * (sway + b.x_G * a.r),
          .N = b.I_z * a.r + b.m * b.x_G * sway};
}

/// Σ weight (F − force that gives the acceleration), with the body's own share put back where it is not in the
/// measurement.
template <template <class> class Model, class S>
PlanarForce<S> captive_force(const Model<S>& ship, const RigidBody& body, const CaptivePoint& point) {
  PlanarForce<S> sum{S(0.0), S(0.0), S(0.0)};
  for (const auto& [m, a, c, weight] : point.moments) {
    const PlanarMotion<S> motion{S(m.u), S(m.v), S(m.r)};
    const auto force = forces(ship, motion, cast<S>(c)).total();
    const auto inertia = force_that_gives(ship, body, motion, PlanarAcceleration<S>{S(a.u), S(a.v), S(a.r)});
    const auto own = point.with_inertia ? PlanarForce<double>{} : force_on_body(body, m, a);
    sum = sum + PlanarForce<S>{weight * (force.X - inertia.X + own.X), weight * (force.Y - inertia.Y + own.Y),
                               weight * (force.N - inertia.N + own.N)};
  }
  return sum;
}

}  // namespace swayaw::identification::detail
