#pragma once

#include <optional>

#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/settling.hpp"

/// Pull-out: what is left of a turn once the rudder is amidships. docs/manoeuvres.md tells definitions.
namespace swayaw::inline nonlinear {

struct PullOutOrder {
  double rudder;      ///< of the turn [rad], positive
  Settling settling;  ///< of the turn, and once more after it
};

/// Pull-out from a turn to one side.
struct PullOutSide {
  double execute;                    ///< when the rudder is ordered amidships [s]
  double turning;                    ///< yaw rate then [rad/s]
  bool turning_settled;              ///< the turn was steady
  double residual;                   ///< yaw rate at the end [rad/s]: 0 for a course-stable ship
  bool settled;                      ///< the end was steady
  std::optional<double> fall_time;   ///< from the order until 1/e of the change of yaw rate is left [s]
  std::optional<double> decay_time;  ///< T of exp(−t/T), from the last 1e-3 to the last 1e-4 of the change left [s];
                                     ///< nothing where the end was not steady
  std::optional<double>
      T1;  ///< slower time constant of sway and yaw about the steady motion near straight ahead, towards this side [s]
  Recording run;
};

struct PullOut {
  Sides<PullOutSide> sides;     ///< by the side of the turn
  double approach_speed;        ///< [m/s]
  Controls<double> propulsion;  ///< held during the manoeuvre
};

/// Turns with the rudder held, then puts it amidships, to both sides. Both motions last until they are steady.
///
/// A course-stable ship comes back to a straight course, and decay_time to T1. What remains of an unstable ship's yaw
/// rates differs between the sides by the height of her loop at rudder amidships. T1 is negative then, and nothing for
/// complex poles.
///
/// `duration` of the options is not used.
/// @throws std::domain_error  as zigzag does
/// @throws Refusal            as zigzag does, or for a ship in wind
/// Source: [MSC/Circ.1053] appendix 4
PullOut pull_out(const Ship& ship, const PullOutOrder& order, const ManoeuvreOptions& options = {});

}  // namespace swayaw::nonlinear
