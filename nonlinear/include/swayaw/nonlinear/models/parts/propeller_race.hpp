#pragma once

#include <numbers>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/scalar.hpp"

/// The race of a propeller and what it does to the rudder in it.
/// Valid for way ahead and thrust that does not turn the flow, 2T > −πρ r_0² V_A².
/// Source: [Alexandersson2024] appendix B.2.2
namespace swayaw::inline nonlinear {

/// The race of a propeller where it meets the rudder.
template <class S>
struct PropellerRace {
  S V_A;     ///< axial speed outside the race [m/s]
  S V_corr;  ///< axial speed in the race, mixing included [m/s]
  S r;       ///< radius, mixing included, r_x + r_Delta [m]
};

/// Momentum theory, contraction and turbulent mixing.
///
///     V_inf = V_A sqrt(1 + C_Th) = sqrt(V_A² + 2T/(πρ r_0²)),   q = r_0/r_inf = sqrt(2 V_inf/(V_A + V_inf))
///     r_x/r_0 = (0.14 + k q²)/(0.14 + k q³),   k = (x/r_0)^1.5
///     V_xC = V_inf r_inf²/r_x² = ½ (V_A + V_inf) (r_0/r_x)²
///     r_Delta = 0.15 x (V_xC − V_A)/(V_xC + V_A)
///     V_corr = V_A + (V_xC − V_A) (r_x/(r_x + r_Delta))²
///
/// Source: [Alexandersson2024] eqs (B.12)–(B.19), (B.17) divided by (r_inf/r_0)³
template <class S>
PropellerRace<S> race_at(const S& x, const S& r_0, const S& rho, const S& V_A, const S& T) {
  const S V_inf = root_of_positive(V_A * V_A + (2.0 / pi) * T / (rho * r_0 * r_0));
  const S sum = V_A + V_inf;
  const S qq = 2.0 * V_inf / sum;
  const S k = x / r_0 * sqrt(x / r_0);
  const S contraction = (0.14 + k * qq) / (0.14 + k * qq * root_of_positive(qq));  // r_x/r_0
  const S V_xC = 0.5 * sum / (contraction * contraction);
  const S r_x = r_0 * contraction;
  const S r = r_x + 0.15 * x * (V_xC - V_A) / (V_xC + V_A);
  const S mixing = r_x / r;
  return {.V_A = V_A, .V_corr = V_A + (V_xC - V_A) * mixing * mixing, .r = r};
}

/// Lift that the race loses because it is not wide, lambda_R = (V_A/V_corr)^f,
/// f = 2 (2/(2 + d/c))⁸, d = ½ sqrt(π) r. Source: [Alexandersson2024] eqs (B.22)–(B.25)
template <class S>
S lift_diminution(const PropellerRace<S>& race, const S& chord) {
  const S width = 1.0 + (0.25 / std::numbers::inv_sqrtpi) * race.r / chord;  // (2 + d/c)/2
  const S w2 = width * width, w4 = w2 * w2;
  return exp(2.0 / (w4 * w4) * log(race.V_A / race.V_corr));
}

}  // namespace swayaw::nonlinear
