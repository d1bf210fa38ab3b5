#pragma once

#include <optional>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

/// Williamson turn: back along the own track. docs/manoeuvres.md tells the definition.
namespace swayaw::inline nonlinear {

struct WilliamsonOrder {
  double rudder = radians(35.0);   ///< both ways [rad], positive
  double heading = radians(60.0);  ///< change of heading at which the rudder goes to the other side [rad]
  double before = radians(20.0);   ///< rudder amidships that much before the reciprocal heading [rad]
  Side first = Side::starboard;    ///< side turned to first: that of the casualty
};

/// Where the ship is on the original track, a line along the approach course through the place of the first order.
struct TrackPlace {
  double time;    ///< [s]
  double along;   ///< ahead of that place [m]
  double offset;  ///< beside the track, positive on the side turned to first [m]
};

struct WilliamsonTurn {
  std::optional<TrackPlace> shifted;    ///< rudder ordered to the other side
  std::optional<TrackPlace> amidships;  ///< rudder ordered amidships
  std::optional<TrackPlace>
      reciprocal;               ///< heading opposite to the approach; nothing where the swing does not carry her there
  std::optional<double> way;    ///< made from the first order until then [m]; nothing without samples
  double heading;               ///< change of heading at the end, positive to the side turned to first [rad]
  double yaw_rate;              ///< at the end, positive to starboard [rad/s]
  double approach_speed;        ///< [m/s]
  Controls<double> propulsion;  ///< held during the manoeuvre
  Recording run;
};

/// Rudder hard over to one side until the heading has changed by 60 deg, hard over to the other until it is 20 deg
/// short of the reciprocal, then amidships. Ends at the reciprocal heading, or where the swing dies out before it,
/// unless a duration is given; nobody steers after that. All headings are of the ship, places over ground.
///
/// @throws std::domain_error  as zigzag does, or if `before` is not smaller than half a turn
/// @throws Refusal            as zigzag does
/// Source: [IAMSAR] volume III, section on recovery of a person overboard
WilliamsonTurn williamson_turn(const Ship& ship, const WilliamsonOrder& order = {},
                               const ManoeuvreOptions& options = {});

}  // namespace swayaw::nonlinear
