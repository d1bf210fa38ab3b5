#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "swayaw/nonlinear/surroundings/windage.hpp"

/// Where the numbers of a windage come from: ship types, profiles of merchant ships, tables of a wind tunnel.
namespace swayaw::inline nonlinear {

/// Drag and cross force of a type of ship.
struct BlendermannShip {
  std::string_view type;
  double C_Dt;        ///< transverse drag
  double C_Dl_bow;    ///< longitudinal drag in wind from ahead
  double C_Dl_stern;  ///< the same in wind from astern
  double delta;       ///< cross-force parameter
};

/// Source: [Blendermann1994], as tabled in [MSS] blendermann94.m; a printed range is taken at its middle.
inline constexpr std::array blendermann_ships{
    BlendermannShip{"car_carrier", 0.95, 0.55, 0.60, 0.80},
    BlendermannShip{"cargo_vessel_loaded", 0.85, 0.65, 0.55, 0.40},
    BlendermannShip{"cargo_vessel_containers_on_deck", 0.85, 0.55, 0.50, 0.40},
    BlendermannShip{"container_ship_loaded", 0.90, 0.55, 0.55, 0.40},
    BlendermannShip{"destroyer", 0.85, 0.60, 0.65, 0.65},
    BlendermannShip{"diving_support_vessel", 0.90, 0.60, 0.80, 0.55},
    BlendermannShip{"drilling_vessel", 1.00, 0.5 * (0.70 + 1.00), 0.5 * (0.75 + 1.10), 0.10},
    BlendermannShip{"ferry", 0.90, 0.45, 0.50, 0.80},
    BlendermannShip{"fishing_vessel", 0.95, 0.70, 0.70, 0.40},
    BlendermannShip{"gas_tanker", 0.70, 0.60, 0.65, 0.50},
    BlendermannShip{"offshore_supply_vessel", 0.90, 0.55, 0.80, 0.55},
    BlendermannShip{"passenger_liner", 0.90, 0.40, 0.40, 0.80},
    BlendermannShip{"research_vessel", 0.85, 0.55, 0.65, 0.60},
    BlendermannShip{"speed_boat", 0.90, 0.55, 0.60, 0.60},
    BlendermannShip{"tanker_loaded", 0.70, 0.90, 0.55, 0.40},
    BlendermannShip{"tanker_in_ballast", 0.70, 0.75, 0.55, 0.40},
    BlendermannShip{"tender", 0.85, 0.55, 0.55, 0.65},
};

/// @throws std::domain_error  naming the known types, if the type is not one of them
const BlendermannShip& blendermann_ship(std::string_view type);

/// What a ship file of the MMG model knows of the ship above water.
struct WindageAreas {
  double frontal;  ///< A_F [m^2]
  double lateral;  ///< A_L [m^2]
  double length;   ///< length over all [m], or between perpendiculars for want of it
};

/// Windage from areas alone: standard air, lateral area centred at midship, drag of the type of ship.
///
/// @return nothing when an area is 0, that is not known
/// @throws std::domain_error  if an area is negative, the length is not positive or the type is not known
std::optional<Windage<double>> windage_from(const WindageAreas& areas, std::string_view type = "tanker_loaded");

/// Whether a ship shows the wind anything: without areas above water no wind acts on her.
bool feels_wind(const Windage<double>& windage);

/// Coefficients at one angle of attack, in the axes of docs/notation.md.
struct WindRow {
  double angle;  ///< alpha, where the air comes from, clockwise from the bow [rad]
  double C_X;    ///< negative in wind from ahead
  double C_Y;    ///< negative in wind from starboard
  double C_N;    ///< about midship, positive for bow to starboard
};

using WindTable = std::vector<WindRow>;

/// Port and starboard exchanged: alpha, C_Y and C_N change sign. So a table is read that counts angles to port
/// and C_Y positive in wind from port.
WindTable mirrored(WindTable table);

/// The table of a symmetric ship from that of one side, 0 … 180 deg: C_X is even, C_Y and C_N are odd.
WindTable both_sides(const WindTable& one_side);

/// Periodic cubic splines through a table of the whole circle. Rows may come in any order and in any turn; 0 and
/// 360 deg may both be there.
///
/// @throws std::domain_error  if two rows of one angle differ, as they do when `both_sides` got a C_Y or C_N that is
/// not 0
///                            ahead or astern, or if fewer than three angles remain
WindSpline wind_spline(WindTable table);

/// Profile of a merchant ship, beside the areas of her windage.
struct IsherwoodProfile {
  double B;          ///< beam [m]
  double A_SS;       ///< lateral area of the superstructure [m^2]
  double perimeter;  ///< of the lateral projection without waterline, masts and ventilators [m]
  double masts;      ///< groups of masts or king posts seen from the side, those close before the bridge not counted
};

/// Coefficients every 10 deg on both sides, from regression over model tests of merchant ships.
///
///     −C_X = A_0 + A_1 2A_L/L² + A_2 2A_F/B² + A_3 L/B + A_4 S/L + A_5 C/L + A_6 M
///     −C_Y = B_0 + B_1 2A_L/L² + B_2 2A_F/B² + B_3 L/B + B_4 S/L + B_5 C/L + B_6 A_SS/A_L
///     −C_N = C_0 + C_1 2A_L/L² + C_2 2A_F/B² + C_3 L/B + C_4 S/L + C_5 C/L
///
/// for wind from starboard, with L = L_OA and the centroid C = L/2 − x_A from the bow.
/// Valid for merchant ships of the sixties; a regression is no guide far from them.
/// Source: [Isherwood1973] as tabled in [MSS] isherwood72.m, where the angle counts to port
///
/// @throws std::domain_error  if area, length or beam is not positive
WindTable isherwood_table(const Windage<double>& windage, const IsherwoodProfile& profile);

}  // namespace swayaw::nonlinear
