#pragma once

namespace swayaw {

/// What the bridge does to the ship.
template <class Scalar = double>
struct Controls {
  Scalar delta;  ///< rudder angle, positive to port [rad]
  Scalar rev;    ///< shaft speed [1/s]
};

}  // namespace swayaw
