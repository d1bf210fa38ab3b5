#pragma once

#include "swayaw/linear/response_basis.hpp"
#include "swayaw/linear/sway_yaw.hpp"

/// Exact solution of the sway–yaw equations for a rudder that moves in straight lines of time.
namespace swayaw::inline linear {

/// Drift, yaw rate and heading of a ship in linear motion, dimensionless time.
template <class S = double>
struct LinearState {
  S beta;   ///< drift angle [rad]
  S omega;  ///< omega' = rL/U
  S psi;    ///< heading [rad]
};

/// Rudder angle that changes linearly: value + rate s.
template <class S = double>
struct RudderLine {
  S value;  ///< at the start [rad]
  S rate;   ///< per ship length [rad]
};

/// A ship that answers to her rudder: coefficients with what follows from them.
template <class S = double>
struct LinearResponse {
  SwayYawCoefficients<S> m;
  SwayYawTransfer<S> h;
  Poles<S> p;

  explicit LinearResponse(const SwayYawCoefficients<S>& coefficients)
      : m(coefficients), h(transfer_functions(coefficients)), p(poles(S(-h.e1), h.e0)) {}
};

/// State after the time s, by Cayley–Hamilton:
///
///     omega(s) = h_{−1} omega0 + h_0 (a2 beta0 − a1 omega0) + delta0 (h_0 c2 + h_1 nw0) + rho (h_1 c2 + h_2 nw0)
///     beta(s)  = h_{−1} beta0 + h_0 (b1 omega0 − b2 beta0) + delta0 (h_0 c1 + h_1 nb0) + rho (h_1 c1 + h_2 nb0)
///     psi(s)   = psi0 + ∫ omega ds, one integral more of each h
///
/// @param b  the basis functions at the time s
template <class S>
LinearState<S> state_after(const LinearResponse<S>& ship, const LinearState<S>& start, const RudderLine<S>& rudder,
                           const ResponseBasis<S>& b) {
  const auto& m = ship.m;
  const auto& n = ship.h;
  const S yaw = m.a2 * start.beta - m.a1 * start.omega;
  const S drift = m.b1 * start.omega - m.b2 * start.beta;
  return {
      .beta = b.h_1 * start.beta + b.h0 * drift + rudder.value * (b.h0 * m.c1 + b.h1 * n.nb0) +
              rudder.rate * (b.h1 * m.c1 + b.h2 * n.nb0),
      .omega = b.h_1 * start.omega + b.h0 * yaw + rudder.value * (b.h0 * m.c2 + b.h1 * n.nw0) +
               rudder.rate * (b.h1 * m.c2 + b.h2 * n.nw0),
      .psi = start.psi + b.h0 * start.omega + b.h1 * yaw + rudder.value * (b.h1 * m.c2 + b.h2 * n.nw0) +
             rudder.rate * (b.h2 * m.c2 + b.h3 * n.nw0),
  };
}

/// The same for one time alone.
template <class S>
LinearState<S> state_after(const LinearResponse<S>& ship, const LinearState<S>& start, const RudderLine<S>& rudder,
                           const S& s) {
  return state_after(ship, start, rudder, response_basis(ship.p, s));
}

/// d(beta)/ds' and d(omega')/ds' at a state, and d(psi)/ds' = omega'.
template <class S>
LinearState<S> rates(const SwayYawCoefficients<S>& m, const LinearState<S>& x, const S& delta) {
  return {m.a1 * x.beta + m.b1 * x.omega + m.c1 * delta, m.a2 * x.beta + m.b2 * x.omega + m.c2 * delta, x.omega};
}

}  // namespace swayaw::linear
