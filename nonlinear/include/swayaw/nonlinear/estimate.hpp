#pragma once

#include "swayaw/nonlinear/estimates/hull_dimensions.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

/// Numbers of the MMG standard model from main dimensions, in its primes and signs (mmg_ship.hpp).
///
/// Each coefficient was compared with public programs; docs/estimates.md tells which agree and what remains doubtful.
namespace swayaw::inline nonlinear {

/// Added masses, a fit of Motora's charts. With m' = 2 C_B B/L:
///
///     m_x'/m' = (0.398 + 11.97 C_B (1 + 3.73 d/B) − 2.89 C_B L/B (1 + 1.13 d/B)
///                + 0.175 C_B (L/B)² (1 + 0.541 d/B) − 1.107 (L/B)(d/B)) / 100
///     m_y'/m' = 0.882 − 0.54 C_B (1 − 1.6 d/B) − 0.156 (L/B)(1 − 0.673 C_B)
///                + 0.826 (d/B)(L/B)(1 − 0.678 d/B) − 0.638 C_B (d/B)(L/B)(1 − 0.669 d/B)
///     J_z'/m' = ((33 − 76.85 C_B (1 − 0.784 C_B) + 3.43 (L/B)(1 − 0.63 C_B)) / 100)²
///
/// Valid for merchant ships on even keel; see merchant_ships.
/// Source: [Zhou1983] after [Motora1959]
template <class S>
MmgAddedMass<S> zhou_added_mass(const HullDimensions<S>& h) {
  const S C_B = h.C_B, l = h.L / h.B, b = h.d / h.B, m = mass_prime(h);
  const S x = 0.398 + 11.97 * C_B * (1.0 + 3.73 * b) - 2.89 * C_B * l * (1.0 + 1.13 * b) +
              0.175 * C_B * l * l * (1.0 + 0.541 * b) - 1.107 * l * b;
  const S y = 0.882 - 0.54 * C_B * (1.0 - 1.6 * b) - 0.156 * l * (1.0 - 0.673 * C_B) +
              0.826 * b * l * (1.0 - 0.678 * b) - 0.638 * C_B * b * l * (1.0 - 0.669 * b);
  const S z = 33.0 - 76.85 * C_B * (1.0 - 0.784 * C_B) + 3.43 * l * (1.0 - 0.63 * C_B);
  return {.m_x = 0.01 * x * m, .m_y = y * m, .J_z = 1e-4 * z * z * m, .surge_coupling = {}};
}

/// How the formulas of Yoshimura and Masumoto, written for the drift angle beta, were carried to v' = −beta.
enum class DriftSigns {
  consistent,  ///< every odd power of beta changes its sign
  tabulated,   ///< as many programs and table 3 of [Kulbiej2021] have it: X_vr unchanged, the second terms of Y_vvv and
               ///< N_vrr unchanged
};

/// Hull derivatives. With f = C_B B/L, k = 2d/L, and beta for −v':
///
///     X_ββ = 1.15 f − 0.18        X_βr = m_y' − 1.91 f + 0.08         X_rr = −0.085 f + 0.008 − x_G' m_y'    X_ββββ =
///     −6.68 f + 1.1 Y_β = ½πk + 1.4 f           Y_r = m_x' + 0.5 f                  N_β = k N_r = −0.54 k + k² Y_βββ =
///     0.185 L/B + 0.48    Y_βrr = 0.26 (1 − C_B) L/B + 0.11   Y_ββr = −0.75                          Y_rrr = −0.051
///     N_βββ = −0.69 C_B + 0.66    N_βrr = 0.075 (1 − C_B) L/B − 0.098 N_ββr = 1.55 f − 0.76                  N_rrr =
///     0.25 f − 0.056
///
/// The paper itself was not at hand: the numbers are those of table 3 of [Kulbiej2021] and of public programs, the
/// signs of Y_βββ and N_βrr those that the measured derivatives of KVLCC2 and KCS confirm, of X_βr KCS alone
/// (docs/estimates.md). R_0 is left 0. Valid for even keel; see merchant_ships.
///
/// @param x_G_prime  centre of gravity forward of midship over L
/// Source: [Yoshimura2012]
template <class S>
MmgHull<S> yoshimura_masumoto_hull(const HullDimensions<S>& h, const MmgAddedMass<S>& added,
                                   const S& x_G_prime = S(0.0), DriftSigns signs = DriftSigns::consistent) {
  const S f = fullness(h), k = wing_aspect(h), l = h.L / h.B, C_B = h.C_B;
  const double flip = signs == DriftSigns::consistent ? -1.0 : 1.0;
  return {
      .R_0 = S(0.0),
      .X_vv = 1.15 * f - 0.18,
      .X_vr = flip * (added.m_y - 1.91 * f + 0.08),
      .X_rr = -0.085 * f + 0.008 - x_G_prime * added.m_y,
      .X_vvvv = -6.68 * f + 1.1,
      .Y_v = -(0.5 * pi * k + 1.4 * f),
      .Y_r = added.m_x + 0.5 * f,
      .Y_vvv = -0.185 * l + flip * 0.48,
      .Y_vvr = S(-0.75),
      .Y_vrr = -(0.26 * (1.0 - C_B) * l + 0.11),
      .Y_rrr = S(-0.051),
      .N_v = -k,
      .N_r = -0.54 * k + k * k,
      .N_vvv = 0.69 * C_B - 0.66,
      .N_vvr = 1.55 * f - 0.76,
      .N_vrr = -0.075 * (1.0 - C_B) * l - flip * 0.098,
      .N_rrr = 0.25 * f - 0.056,
  };
}

/// How hull, propeller and rudder act on each other: the numbers of MmgRudder that no drawing shows.
template <class S = double>
struct RudderInteraction {
  S t_R;      ///< steering resistance deduction
  S a_H;      ///< rudder force increase factor
  S x_H;      ///< x_H', where the induced hull force acts
  S l_R;      ///< l_R', effective lever of the yaw rate
  S gamma_R;  ///< flow straightening, both sides
  S epsilon;  ///< (1 − w_R)/(1 − w_P)
  S kappa;    ///< race increase factor
};

/// t_R = 0.39, a_H = 3.6 f, x_H' = −0.4, l_R' = −0.9, gamma_R = 2.06 f + 0.14, epsilon = 2.26 − 1.82 (1 − w_P0), kappa
/// = 0.55/epsilon.
///
/// a_H and kappa stand in one public program only, the others in two or more. Source: [Yoshimura2012]
template <class S>
RudderInteraction<S> yoshimura_masumoto_interaction(const HullDimensions<S>& h, const S& w_P0) {
  const S f = fullness(h);
  const S epsilon = 2.26 - 1.82 * (1.0 - w_P0);
  return {.t_R = S(0.39),
          .a_H = 3.6 * f,
          .x_H = S(-0.4),
          .l_R = S(-0.9),
          .gamma_R = 2.06 * f + 0.14,
          .epsilon = epsilon,
          .kappa = 0.55 / epsilon};
}

/// t_R = 0.45 − 0.28 C_B, a_H = 0.6784 − 1.3374 C_B + 1.8891 C_B², x_H' = −(0.4 + 0.1 C_B), l_R' = −1,
/// gamma_R = −22.2 f² + 0.02 f + 0.68, epsilon = −156.2 f² + 41.6 f − 1.76, kappa = 0.6/epsilon.
///
/// epsilon is a parabola that is below 0.5 for f < 0.075 and f > 0.19. Source: [Kijima1990] as public programs have it;
/// where a_H, x_H and kappa first stood could not be told
template <class S>
RudderInteraction<S> kijima_interaction(const HullDimensions<S>& h) {
  const S f = fullness(h), C_B = h.C_B;
  const S epsilon = -156.2 * f * f + 41.6 * f - 1.76;
  return {
      .t_R = 0.45 - 0.28 * C_B,
      .a_H = 0.6784 - 1.3374 * C_B + 1.8891 * C_B * C_B,
      .x_H = -(0.4 + 0.1 * C_B),
      .l_R = S(-1.0),
      .gamma_R = -22.2 * f * f + 0.02 * f + 0.68,
      .epsilon = epsilon,
      .kappa = 0.6 / epsilon,
  };
}

/// Where zhou_added_mass and yoshimura_masumoto_hull are used without a warning. The papers' own ranges were not at
/// hand; this one is chosen about the ships on which the formulas were checked: KVLCC2, KCS, Seiun Maru, Nawigator XXI.
inline constexpr HullRange merchant_ships{.C_B = {0.50, 0.85},
                                          .L_over_B = {4.5, 8.0},
                                          .B_over_d = {2.0, 4.5},
                                          .trim_over_d = {0.0, 0.0},
                                          .fineness_trimmed = {0.0, 1.0}};

}  // namespace swayaw::nonlinear
