#pragma once

#include "swayaw/nonlinear/estimate.hpp"

/// Hull derivatives for a ship in any loading, with squares |beta| beta and |r'| r' where the MMG standard has cubes.
namespace swayaw::inline nonlinear {

/// Primes as in mmg_ship.hpp; the force on the drift angle beta = −v':
///
///     Y_H' = Y_b β + Y_r r' + Y_bb |β|β + Y_rr |r'|r' + Y_bbr β²r' + Y_brr β r'²
///     N_H' = N_b β + …, alike
template <class S = double>
struct KijimaDerivatives {
  S Y_b, Y_r, Y_bb, Y_rr, Y_bbr, Y_brr;
  S N_b, N_r, N_bb, N_rr, N_bbr, N_brr;
};

/// With f = C_B B/L, k = 2d/L, p = d (1 − C_B)/B, q = d C_B/B, and trim t = (d_aft − d_fore)/d:
///
///     Y_b = (½πk + 1.4 f)(1 + (25 f − 2.25) t)      Y_r = m' + m_x' − 1.5 f (1 + (571 p² − 81 p + 2.1) t)
///     N_b = k (1 − t)                               N_r = (−0.54 k + k²)(1 + (34 f − 3.4) t)
///     Y_bb = (2.5 p + 0.5)(1 − (35.7 f − 2.5) t)    Y_rr = (0.343 q − 0.07)(1 + (45 f − 8.1) t)
///     Y_bbr = (1.5 q − 0.65)(1 + (110 p − 9.7) t)   Y_brr = 5.95 p (1 + (40 p − 2) t)
///     N_bb = (−0.96 p + 0.066)(1 + (58 p − 5) t)    N_rr = (0.5 f − 0.09)(1 − (30 f − 2.6) t)
///     N_bbr = −(57.5 f² − 18.4 f + 1.6)(1 + (3 f − 1) t)
///     N_brr = −(0.5 q − 0.05)(1 + 100 (48 f² − 16 f + 1.3) t)
///
/// The trim factors of N_bb and N_rr stand in one public program only, which has f for q in N_brr; others have q.
/// See loaded_ships for the range. Source: [Kijima1990]
template <class S>
KijimaDerivatives<S> kijima_derivatives(const HullDimensions<S>& h, const S& m_x) {
  const S f = fullness(h), k = wing_aspect(h), t = h.trim / h.d;
  const S p = h.d * (1.0 - h.C_B) / h.B, q = h.d * h.C_B / h.B;
  return {
      .Y_b = (0.5 * pi * k + 1.4 * f) * (1.0 + (25.0 * f - 2.25) * t),
      .Y_r = mass_prime(h) + m_x - 1.5 * f * (1.0 + (571.0 * p * p - 81.0 * p + 2.1) * t),
      .Y_bb = (2.5 * p + 0.5) * (1.0 - (35.7 * f - 2.5) * t),
      .Y_rr = (0.343 * q - 0.07) * (1.0 + (45.0 * f - 8.1) * t),
      .Y_bbr = (1.5 * q - 0.65) * (1.0 + (110.0 * p - 9.7) * t),
      .Y_brr = 5.95 * p * (1.0 + (40.0 * p - 2.0) * t),
      .N_b = k * (1.0 - t),
      .N_r = (-0.54 * k + k * k) * (1.0 + (34.0 * f - 3.4) * t),
      .N_bb = (-0.96 * p + 0.066) * (1.0 + (58.0 * p - 5.0) * t),
      .N_rr = (0.5 * f - 0.09) * (1.0 - (30.0 * f - 2.6) * t),
      .N_bbr = -(57.5 * f * f - 18.4 * f + 1.6) * (1.0 + (3.0 * f - 1.0) * t),
      .N_brr = -(0.5 * q - 0.05) * (1.0 + 100.0 * (48.0 * f * f - 16.0 * f + 1.3) * t),
  };
}

/// How far the squares are replaced by cubes.
struct CubeRange {
  double beta = radians(20.0);  ///< drift angle [rad]
  double r_prime = 0.7;         ///< r L/U
};

/// The cubic hull of the MMG standard nearest to the quadratic one; what is linear or mixed is taken over.
///
/// The best c in x² ≈ c x³ over 0 … X, by least squares, is ∫x⁵ / ∫x⁶ = 7/(6X).
/// Surge derivatives, which this source does not give, are those of yoshimura_masumoto_hull; R_0 is left 0.
template <class S>
MmgHull<S> kijima_hull(const HullDimensions<S>& h, const MmgAddedMass<S>& added, const S& x_G_prime = S(0.0),
                       const CubeRange& range = {}) {
  const auto k = kijima_derivatives(h, added.m_x);
  const double of_beta = 7.0 / (6.0 * range.beta), of_r = 7.0 / (6.0 * range.r_prime);
  auto hull = yoshimura_masumoto_hull(h, added, x_G_prime);
  // odd powers of beta = −v' change their sign
  hull.Y_v = -k.Y_b;
  hull.Y_r = k.Y_r;
  hull.Y_vvv = -of_beta * k.Y_bb;
  hull.Y_vvr = k.Y_bbr;
  hull.Y_vrr = -k.Y_brr;
  hull.Y_rrr = of_r * k.Y_rr;
  hull.N_v = -k.N_b;
  hull.N_r = k.N_r;
  hull.N_vvv = -of_beta * k.N_bb;
  hull.N_vvr = k.N_bbr;
  hull.N_vrr = -k.N_brr;
  hull.N_rrr = of_r * k.N_rr;
  return hull;
}

/// Where kijima_derivatives is used without a warning; chosen like merchant_ships, with trim by the stern up to a fifth
/// of the draught. Trimmed ships are further bound to p ≤ 0.1, where trim by the stern makes every hull of the range
/// more stable on her course; beyond, the parabola in p overtakes that and makes deep, fine hulls less stable.
inline constexpr HullRange loaded_ships{.C_B = {0.50, 0.85},
                                        .L_over_B = {4.5, 8.0},
                                        .B_over_d = {2.0, 4.5},
                                        .trim_over_d = {0.0, 0.2},
                                        .fineness_trimmed = {0.0, 0.1}};

}  // namespace swayaw::nonlinear
