#pragma once

#include <array>
#include <optional>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/linear/sway_yaw.hpp"

/// The coefficients of the linear equations from hull and rudder, and back.
/// Source: [Artyszuk2016] eqs (2)–(14), (44)–(46), with radii of gyration squared and (13) with x'_Reff squared.
namespace swayaw::inline linear {

/// Hull of a ship in linear motion, dimensionless.
template <class S = double>
struct LinearHull {
  S L_over_B;  ///< length over beam
  S c_B;       ///< block coefficient
  S k_11;      ///< surge added mass over mass
  S k_22;      ///< sway added mass over mass
  S r_z;       ///< radius of gyration over length
  S r_66;      ///< added radius of gyration over length
  S Y_b;       ///< sway force by drift, per degree, ½ρLTV²
  S Y_w;       ///< sway force by omega', ½ρLTV²
  S N_b;       ///< yaw moment by drift, per degree, ½ρL²TV²
  S N_w;       ///< yaw moment by omega', ½ρL²TV²

  static constexpr auto parameters() {
    using P = ParameterOf<LinearHull, S>;
    constexpr auto coefficient = Role::coefficient;
    return std::array{
        P{"length_over_beam", &LinearHull::L_over_B, "-", positive},
        P{"block_coefficient", &LinearHull::c_B, "-", {.low = 0.0, .high = 1.0, .above_low = true}},
        P{"k_11", &LinearHull::k_11, "-", non_negative, coefficient},
        P{"k_22", &LinearHull::k_22, "-", non_negative, coefficient},
        P{"r_z_prime", &LinearHull::r_z, "-", positive},
        P{"r_66_prime", &LinearHull::r_66, "-", non_negative, coefficient},
        P{"Y_b_per_deg", &LinearHull::Y_b, "1/deg", any_number, coefficient},
        P{"Y_w", &LinearHull::Y_w, "-", any_number, coefficient},
        P{"N_b_per_deg", &LinearHull::N_b, "1/deg", any_number, coefficient},
        P{"N_w", &LinearHull::N_w, "-", any_number, coefficient},
    };
  }
};

/// Rudder of a ship in linear motion, dimensionless.
template <class S = double>
struct LinearRudder {
  S area_ratio;  ///< A_R/(LT)
  S w;           ///< wake fraction
  S c_Th;        ///< thrust loading 8 K_T/(π J²)
  S lift_slope;  ///< d(c_L)/d(alpha) on the race speed, per degree
  S a_H;         ///< hull's share of the rudder force
  S c_Ry;        ///< effective over geometric drift angle at the rudder
  S x_Reff;      ///< where the rudder force acts, forward of midship over length

  static constexpr auto parameters() {
    using P = ParameterOf<LinearRudder, S>;
    constexpr auto coefficient = Role::coefficient;
    return std::array{
        P{"area_ratio", &LinearRudder::area_ratio, "-", positive},
        P{"wake_fraction", &LinearRudder::w, "-", {-1.0, 1.0}, coefficient},
        P{"thrust_loading", &LinearRudder::c_Th, "-", non_negative, coefficient},
        P{"lift_slope_per_deg", &LinearRudder::lift_slope, "1/deg", positive, coefficient},
        P{"a_H", &LinearRudder::a_H, "-", any_number, coefficient},
        P{"c_Ry", &LinearRudder::c_Ry, "-", any_number, coefficient},
        P{"x_R_eff_prime", &LinearRudder::x_Reff, "-", {-1.0, 1.0}, coefficient},
    };
  }
};

/// A ship in linear motion, as hull and rudder.
template <class S = double>
struct LinearParts {
  LinearHull<S> hull;
  LinearRudder<S> rudder;
};

/// The coefficients split by what they come from; c1 and c2 belong to the rudder, the centrifugal force to b1.
template <class S = double>
struct SwayYawSplit {
  SwayYawCoefficients<S> hull;
  SwayYawCoefficients<S> rudder;
  SwayYawCoefficients<S> centrifugal;

  SwayYawCoefficients<S> total() const {
    const auto &h = hull, &r = rudder, &c = centrifugal;
    return {h.a1 + r.a1 + c.a1, h.b1 + r.b1 + c.b1, h.c1 + r.c1 + c.c1,
            h.a2 + r.a2 + c.a2, h.b2 + r.b2 + c.b2, h.c2 + r.c2 + c.c2};
  }
};

/// Factors of the coefficients that the seven empirical numbers do not enter.
template <class S = double>
struct LinearFactors {
  S h;       ///< 0.5 (L/B)/c_B = 1/m'
  S sway;    ///< 1 + k_22
  S yaw;     ///< r_z² + r_66²
  S race;    ///< (1 − w) sqrt(1 + c_Th): flow at the rudder over ship speed
  S rudder;  ///< R/(1 + a_H), eq. (5)
};

template <class S>
LinearFactors<S> factors(const LinearParts<S>& ship) {
  const auto& [hull, rudder] = ship;
  const S h = 0.5 * hull.L_over_B / hull.c_B;
  const S race = (1.0 - rudder.w) * sqrt(1.0 + rudder.c_Th);
  return {
      .h = h,
      .sway = 1.0 + hull.k_22,
      .yaw = hull.r_z * hull.r_z + hull.r_66 * hull.r_66,
      .race = race,
      .rudder = h * rudder.area_ratio * race * race * rudder.lift_slope * (180.0 / pi),
  };
}

/// Coefficients from hull and rudder. Source: [Artyszuk2016] eqs (3)–(14)
template <class S>
SwayYawSplit<S> coefficients(const LinearParts<S>& ship) {
  const auto& [hull, rudder] = ship;
  const auto f = factors(ship);
  const S zero(0.0);
  const S R = f.rudder * (1.0 + rudder.a_H);
  const S q = rudder.c_Ry / f.race;  // effective drift angle at the rudder over geometric, in the race
  const S x = rudder.x_Reff;
  const S a1R = -R * q / f.sway;
  return {
      .hull = {.a1 = -f.h / f.sway * hull.Y_b * (180.0 / pi),
               .b1 = -f.h / f.sway * hull.Y_w,
               .c1 = zero,
               .a2 = f.h / f.yaw * hull.N_b * (180.0 / pi),
               .b2 = f.h / f.yaw * hull.N_w,
               .c2 = zero},
      .rudder = {.a1 = a1R,
                 .b1 = -a1R * x,
                 .c1 = -R / f.sway,
                 .a2 = R * q * x / f.yaw,
                 .b2 = -R * q * x * x / f.yaw,
                 .c2 = R * x / f.yaw},
      .centrifugal = {.a1 = zero, .b1 = (1.0 + hull.k_11) / f.sway, .c1 = zero, .a2 = zero, .b2 = zero, .c2 = zero},
  };
}

/// Which of the seven empirical numbers is known beforehand. a_H and x'_Reff follow from c1 and c2 and cannot be it.
enum class KnownPart { Y_b, Y_w, N_b, N_w, c_Ry };

/// Hull and rudder that have given coefficients, the inverse of `coefficients`.
///
/// c1 gives a_H, c2/c1 gives x'_Reff; the known number closes a1, b1, a2, b2 for the other four.
///
/// @param ship   all numbers but the seven are taken from it, and the known one
/// @throws std::domain_error  if c1 = 0, or the known number does not determine c_Ry
/// Source: [Artyszuk2016] eqs (44)–(46)
template <class S>
LinearParts<S> parts_from(const SwayYawCoefficients<S>& m, LinearParts<S> ship, KnownPart known) {
  auto& [hull, rudder] = ship;
  const auto f = factors(ship);
  rudder.a_H = -m.c1 * f.sway / f.rudder - 1.0;
  rudder.x_Reff = -m.c2 / m.c1 * f.yaw / f.sway;
  const S x = rudder.x_Reff;
  const S per_q = f.rudder * (1.0 + rudder.a_H);  // R
  const S b1C = (1.0 + hull.k_11) / f.sway;
  const S Yb_scale = -f.h / f.sway * (180.0 / pi), Yw_scale = -f.h / f.sway;
  const S Nb_scale = f.h / f.yaw * (180.0 / pi), Nw_scale = f.h / f.yaw;
  // rudder's part of a1, b1, a2, b2 for q = 1
  const S a1q = -per_q / f.sway, b1q = per_q * x / f.sway, a2q = per_q * x / f.yaw, b2q = -per_q * x * x / f.yaw;
  S q = rudder.c_Ry / f.race;
  if (known == KnownPart::Y_b) q = (m.a1 - Yb_scale * hull.Y_b) / a1q;
  if (known == KnownPart::Y_w) q = (m.b1 - b1C - Yw_scale * hull.Y_w) / b1q;
  if (known == KnownPart::N_b) q = (m.a2 - Nb_scale * hull.N_b) / a2q;
  if (known == KnownPart::N_w) q = (m.b2 - Nw_scale * hull.N_w) / b2q;
  rudder.c_Ry = q * f.race;
  hull.Y_b = (m.a1 - a1q * q) / Yb_scale;
  hull.Y_w = (m.b1 - b1C - b1q * q) / Yw_scale;
  hull.N_b = (m.a2 - a2q * q) / Nb_scale;
  hull.N_w = (m.b2 - b2q * q) / Nw_scale;
  return ship;
}

}  // namespace swayaw::linear
