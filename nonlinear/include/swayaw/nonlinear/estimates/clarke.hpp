#pragma once

#include "swayaw/nonlinear/estimates/hull_dimensions.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

/// Linear derivatives and added masses in the primes of SNAME, and the way between these and the primes of the MMG
/// standard.
namespace swayaw::inline nonlinear {

/// Primes of ½ρL²U² (force), ½ρL³U² (moment), ½ρL³ (mass), ½ρL⁴ and ½ρL⁵; v' = v/U, r' = rL/U; about midship.
template <class S = double>
struct ClarkeDerivatives {
  S Y_v, Y_r, N_v, N_r;
  S Y_vdot, Y_rdot, N_vdot, N_rdot;
};

/// Regression over rotating-arm and planar-motion tests. With s = π (d/L)²:
///
///     Y_vdot = −s (1 + 0.16 C_B B/d − 5.1 (B/L)²)     Y_rdot = −s (0.67 B/L − 0.0033 (B/d)²)
///     N_vdot = −s (1.1 B/L − 0.041 B/d)               N_rdot = −s (1/12 + 0.017 C_B B/d − 0.33 B/L)
///     Y_v = −s (1 + 0.40 C_B B/d)                     Y_r = −s (−1/2 + 2.2 B/L − 0.080 B/d)
///     N_v = −s (1/2 + 2.4 d/L)                        N_r = −s (1/4 + 0.039 B/d − 0.56 B/L)
///
/// Copies go about with 0.04 in N_vdot, 0.0033 B/L in N_rdot, +0.080 in Y_r or 0.24 in N_v; the above is the majority.
/// Valid for merchant ships on even keel. Source: [Clarke1983]
template <class S>
ClarkeDerivatives<S> clarke_derivatives(const HullDimensions<S>& h) {
  const S s = pi * (h.d / h.L) * (h.d / h.L);
  const S beam = h.B / h.L, flat = h.B / h.d;
  return {
      .Y_v = -s * (1.0 + 0.40 * h.C_B * flat),
      .Y_r = -s * (-0.5 + 2.2 * beam - 0.080 * flat),
      .N_v = -s * (0.5 + 2.4 * h.d / h.L),
      .N_r = -s * (0.25 + 0.039 * flat - 0.56 * beam),
      .Y_vdot = -s * (1.0 + 0.16 * h.C_B * flat - 5.1 * beam * beam),
      .Y_rdot = -s * (0.67 * beam - 0.0033 * flat * flat),
      .N_vdot = -s * (1.1 * beam - 0.041 * flat),
      .N_rdot = -s * (1.0 / 12.0 + 0.017 * h.C_B * flat - 0.33 * beam),
  };
}

/// A primed number of the MMG standard (½ρLd…) from one of SNAME (½ρL²…), and back. Forces, moments, masses and
/// inertias change alike, by L/d.
template <class S>
S mmg_prime(const S& sname_prime, const HullDimensions<S>& h) {
  return sname_prime * (h.L / h.d);
}
template <class S>
S sname_prime(const S& mmg_prime, const HullDimensions<S>& h) {
  return mmg_prime * (h.d / h.L);
}

/// Added masses of the MMG standard, m_y' = −Y_vdot L/d and J_z' = −N_rdot L/d. Surge is not of this source:
/// m_x' is the given one. The couplings Y_rdot and N_vdot have no place in that model.
template <class S>
MmgAddedMass<S> mmg_added_mass(const ClarkeDerivatives<S>& c, const HullDimensions<S>& h, const S& m_x) {
  return {.m_x = m_x, .m_y = mmg_prime(S(-c.Y_vdot), h), .J_z = mmg_prime(S(-c.N_rdot), h), .surge_coupling = {}};
}

/// The linear hull derivatives in the primes of the MMG standard; all others are 0.
///
/// In SNAME's form the forces of the added masses on a turning ship are part of Y_r and N_v; the MMG standard
/// keeps (m_x' u') r' on the other side, so that its Y_r' is larger by m_x'.
template <class S>
MmgHull<S> mmg_linear_hull(const ClarkeDerivatives<S>& c, const HullDimensions<S>& h, const S& m_x) {
  MmgHull<S> hull{};
  hull.Y_v = mmg_prime(c.Y_v, h);
  hull.Y_r = mmg_prime(c.Y_r, h) + m_x;
  hull.N_v = mmg_prime(c.N_v, h);
  hull.N_r = mmg_prime(c.N_r, h);
  return hull;
}

/// Where clarke_derivatives is used without a warning; chosen like merchant_ships.
inline constexpr HullRange clarke_ships{.C_B = {0.45, 0.85},
                                        .L_over_B = {4.5, 8.0},
                                        .B_over_d = {2.0, 4.6},
                                        .trim_over_d = {0.0, 0.0},
                                        .fineness_trimmed = {0.0, 1.0}};

}  // namespace swayaw::nonlinear
