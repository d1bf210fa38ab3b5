#pragma once

#include "swayaw/core/angle.hpp"
#include "swayaw/core/scalar.hpp"

namespace swayaw {

/// What finite depth makes of the numbers of a ship: factors on those of deep water.
template <class S = double>
struct ShallowWaterFactors {
  S R_0, X_vr, Y_v, Y_r, N_v, N_r, N_vvr, N_vrr;
  S m_x, m_y, J_z;
  S one_minus_t;  ///< on 1 − t_P
  S one_minus_w;  ///< on 1 − w_P
  S gamma_R;
};

/// Main dimensions of a ship in shallow water.
template <class S = double>
struct ShallowHull {
  S L, B, d, C_B;
};

/// Factors at a depth over draught h/d. With x = d/h, F = h/d − 1, k = 2d/L, f = C_B B/L and
/// the effective aspect ratio of the hull over a bottom k e(q),   e(q) = 1/(½x + (½πx cot(½πx))^q):
///
///     Y_v: (½πk e(2.3) + 1.4 f)/(½πk + 1.4 f)    Y_r: e(0.7)    N_v: e(1.7)    N_r: (0.54 e − k e²)/(0.54 − k), e = e(0.7)
///     N_vvr, N_vrr: 1 + 6 x^2.5    X_vr: 1 + 1.3 x²    R_0: 1 + 0.388 x²
///     m_x: 1 + (3.77 + 1.14 B/d − 0.233 L/d − 3.43 C_B)/F^1.3, not below 1
///     m_y: 1 + (0.413 + 0.032 B/d + 0.0129 (B/d)²)/F^0.82
///     J_z: 1 + (0.413 + 0.0192 B/d + 0.00554 (B/d)²)/F^0.82
///     1 − t_P: 1/(1 − 0.2 x + 0.7295 x²)    1 − w_P: cos(1.4 C_B x)    gamma_R: 1 + 0.0161 x + 4.4222 x² − 4.9825 x³
///
/// Other numbers stay: the published factor of X_vv changes its sign at h/d = 2.9 and is left out. Valid for 1.2 ≤ h/d; every factor goes to 1 in deep water,
/// e(q) from a few per cent below.
/// Source: [Furukawa2016], [Tang2020], added masses [Li1990], all as public programs have them
template <class S>
ShallowWaterFactors<S> shallow_water_factors(const ShallowHull<S>& hull, const S& depth_over_draught) {
  const auto& [L, B, d, C_B] = hull;
  const S x = 1.0 / depth_over_draught, F = depth_over_draught - 1.0, k = 2.0 * d / L, f = C_B * B / L, b = B / d;
  const S half = 0.5 * pi * x, cotangent = half * cos(half) / sin(half);
  const auto to_the = [](const S& base, double power) { return S(exp(power * log(base))); };
  const auto e = [&](double q) { return S(1.0 / (0.5 * x + to_the(cotangent, q))); };
  const S e_r = e(0.7), grown = 1.0 + 6.0 * to_the(x, 2.5), wake = 1.0 / to_the(F, 0.82);
  return {
      .R_0 = 1.0 + 0.388 * x * x,
      .X_vr = 1.0 + 1.3 * x * x,
      .Y_v = (0.5 * pi * k * e(2.3) + 1.4 * f) / (0.5 * pi * k + 1.4 * f),
      .Y_r = e_r,
      .N_v = e(1.7),
      .N_r = e_r * (0.54 - k * e_r) / (0.54 - k),
      .N_vvr = grown,
      .N_vrr = grown,
      .m_x = 1.0 + positive_part(S(3.77 + 1.14 * b - 0.233 * L / d - 3.43 * C_B)) / to_the(F, 1.3),
      .m_y = 1.0 + (0.413 + 0.032 * b + 0.0129 * b * b) * wake,
      .J_z = 1.0 + (0.413 + 0.0192 * b + 0.00554 * b * b) * wake,
      .one_minus_t = 1.0 / (1.0 - 0.2 * x + 0.7295 * x * x),
      .one_minus_w = cos(1.4 * C_B * x),
      .gamma_R = 1.0 + x * (0.0161 + x * (4.4222 - 4.9825 * x)),
  };
}

}  // namespace swayaw
