#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swayaw/nonlinear/estimate.hpp"

/// A ship that can sail, from her main dimensions.
namespace swayaw::inline nonlinear {

enum class HullFormula {
  yoshimura_masumoto,  ///< yoshimura_masumoto_hull; even keel only
  kijima,              ///< kijima_hull; any trim by the stern
};

/// What is known beyond the main dimensions; the rest is assumed, see estimated_mmg_ship.
struct EstimateOptions {
  HullFormula hull = HullFormula::yoshimura_masumoto;
  double rho = 1025.0;                  ///< density of the water [kg/m^3]
  double nu = 1.19e-6;                  ///< kinematic viscosity of the water [m^2/s], sea water of 15 °C unless given
  double x_G = 0.0;                     ///< centre of gravity forward of midship [m]
  double k_zz_prime = 0.25;             ///< yaw radius of gyration over L
  std::optional<double> rudder_area;    ///< movable area of all rudders together [m^2]
  std::optional<double> rudder_height;  ///< span of each [m]
  std::optional<double> propeller_diameter;  ///< of each [m]
  std::optional<double> wake_fraction;       ///< w_P0
  std::optional<double> thrust_deduction;    ///< t_P
  std::optional<double> resistance;          ///< R_0'
  int screws = 1;                            ///< 1 or 2, which turn together
  int rudders = 1;                           ///< 1 or 2, which turn together
};

/// A ship, what was assumed about her, and in which ratios she lies outside the range of the formulas.
struct EstimatedShip {
  MmgShip<double> ship;
  std::vector<std::string> assumptions;
  std::vector<std::string> warnings;
};

/// Rudder area by the rule of Det Norske Veritas for a rudder behind the propeller [m^2].
///
///     A_R = (L d/100) (1 + 25 (B/L)²)
///
/// No public program was found to confirm the 25; KVLCC2's 112.5 m² it overestimates by 8 %.
/// Source: [DNV1975]
double dnv_rudder_area(const HullDimensions<double>& hull);

/// Slope of the normal force of a rudder with aspect ratio H_R²/A_R, f_alpha = 6.13 Λ/(Λ + 2.25) [1/rad].
/// Source: [Fujii1961]
double fujii_slope(double aspect_ratio);

/// Resistance straight ahead over ½ρLdU², friction with form factor and allowance. Waves are left out: too low for fast
/// ships.
///
///     R_0' = ((1 + k) C_F + 0.0004) S/(L d)
///     C_F = 0.075/(log₁₀(U L/ν) − 2)²,    k = −0.095 + 25.6 C_B / ((L/B)² sqrt(B/d)),    S = 1.025 L (C_B B + 1.7 d)
///
/// Source: [ITTC1957], k after Watanabe, S after Mumford, allowance as usual for new ships
double estimated_resistance(const HullDimensions<double>& hull, double speed, double nu = 1.19e-6);

/// A ship with one rudder in the race of one propeller, in sea water, complete, mirror-symmetric, her shaft able to
/// hold the service speed.
///
/// Hull: the formula chosen; added masses zhou_added_mass; interaction yoshimura_masumoto_interaction.
/// Propeller: K_T curve of KVLCC2 [Yasukawa2015], stretched over J by the pitch factor p as K_T = k_0 p + k_1 J + k_2
/// J²/p, p such that J is two thirds of the J without thrust at the service speed, within 1 to 1.6; diameter 0.7 d up
/// to C_B 0.65, falling to 0.5 d at C_B 0.8; w_P0 = C_B/2 − 0.05 (Taylor), t_P = 0.6 w_P0; wake change of KVLCC2, mean
/// of both sides; x_P' = −0.48. Rudder: dnv_rudder_area, span 0.75 d but not less than the propeller's diameter, x_R' =
/// −0.5, fujii_slope; 35 deg, and 65 deg in 28 s (SOLAS II-1/29). Every assumption that was used stands in
/// `assumptions`, with its number.
///
/// Two screws that turn together become one propeller of the same disc area, thrust and race at the same shaft speed
/// n: diameter sqrt(2) D, K_T(J) = ½ k_0 + k_1/sqrt(2) J + k_2 J². Two rudders become one of their total area with the
/// slope of each and the same share of its span in the race. What differs between the sides, the couple of two thrusts
/// among it, is left out. Two screws have w_P0 = 0.55 C_B − 0.20 [Taylor1943] and together the disc area of the one
/// screw above.
///
/// @throws std::domain_error  if a dimension, the speed or a given number is not positive
/// @throws Refusal            if a trimmed ship is asked of formulas for even keel, the propeller cannot hold the
/// speed, there are other than one or two screws or rudders, or one rudder between two screws, outside their races
EstimatedShip estimated_mmg_ship(const HullDimensions<double>& hull, double service_speed,
                                 const EstimateOptions& options = {});

}  // namespace swayaw::nonlinear
