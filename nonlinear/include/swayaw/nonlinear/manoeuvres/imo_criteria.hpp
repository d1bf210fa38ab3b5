#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "swayaw/nonlinear/manoeuvre.hpp"

/// The standards for ship manoeuvrability of [MSC.137(76)], section 5.3, as far as they are steering; stopping is not
/// simulated.
///
/// They are made for full-scale ships of 100 m and more, all chemical tankers and gas carriers, at a test speed of at
/// least 90 % of that at 85 % of the engine's largest output, in deep water and calm. A scale model has another L/V and
/// with it other limits.
namespace swayaw::inline nonlinear {

/// One number that must not be exceeded.
struct Criterion {
  std::string_view name;        ///< as in JSON, "tactical_diameter"
  Side side;                    ///< turned to first
  std::optional<double> value;  ///< in `unit`; nothing where the manoeuvre did not come so far
  double limit;                 ///< in `unit`
  std::string_view unit;        ///< "L", ship lengths, or "deg"
  std::optional<bool> pass;     ///< nothing without a value
};

/// Limit of the first overshoot of a 10/10 zigzag [rad]; L/V in s.
///
///     10 deg for L/V < 10 s,   5 + ½ L/V in between,   20 deg from 30 s
double first_overshoot_limit(double L_over_V);

/// The same of the second overshoot.
///
///     25 deg for L/V < 10 s,   17.5 + 0.75 L/V in between,   40 deg from 30 s
double second_overshoot_limit(double L_over_V);

/// Rudder angle of the turning circle: 35 deg, or the largest of the ship [rad].
double turning_rudder(const Ship& ship);

/// What a zigzag tells: of a 10/10 initial turning and both overshoots, of a 20/20 the first overshoot, of others
/// nothing.
std::vector<Criterion> criteria_of(const Zigzag& zigzag, const ZigzagOrder& order, double L);

/// What a turning circle tells: advance and tactical diameter at `turning_rudder`, initial turning at 10 deg.
std::vector<Criterion> criteria_of(const TurningCircle& circle, const TurnOrder& order, double L,
                                   double turning_rudder);

struct ImoCriteria {
  std::vector<Criterion> criteria;  ///< first of manoeuvres to starboard, then to port
  double L;                         ///< [m]
  double speed;                     ///< test speed V [m/s]
  Controls<double> propulsion;      ///< held during the manoeuvres
};

/// Turning circle and the zigzags 10/10 and 20/20, to both sides. What is not reached in 100 or 200 ship lengths does
/// not pass.
///
/// `duration` of the options is not used.
/// @throws as zigzag does
ImoCriteria imo_criteria(const Ship& ship, const ManoeuvreOptions& options = {});

}  // namespace swayaw::nonlinear
