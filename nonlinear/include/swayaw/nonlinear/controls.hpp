#pragma once

namespace swayaw {

/// One value on each side of the ship.
template <class S = double>
struct Sides {
  S port;
  S starboard;
};

/// What the bridge and the engine room do to the ship.
///
/// The propeller is driven either at a shaft speed, or, where thrust was measured, by that thrust.
template <class S = double>
struct Controls {
  S delta;  ///< rudder angle, positive to port [rad]
  S rev{};  ///< shaft speed [1/s]
  Sides<S>
      thrust{};  ///< thrust of the propellers, in place of the shaft speed [N]; of a single propeller the sum counts
  bool by_thrust = false;
};

/// Controls that change with the rudder only.
template <class S>
Controls<S> with_rudder(Controls<S> controls, const S& delta) {
  controls.delta = delta;
  return controls;
}

/// The same controls with another scalar.
template <class To, class From>
Controls<To> cast(const Controls<From>& c) {
  return {To(c.delta), To(c.rev), {To(c.thrust.port), To(c.thrust.starboard)}, c.by_thrust};
}

}  // namespace swayaw
