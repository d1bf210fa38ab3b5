#pragma once

namespace swayaw::inline nonlinear {

/// One value on each side of the ship.
template <class S = double>
struct Sides {
  S port;
  S starboard;

  bool operator==(const Sides&) const = default;
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

  bool operator==(const Controls&) const = default;
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

/// Controls on the straight way from a to b; the share of it may be a dual.
template <class T>
Controls<T> between(const Controls<double>& a, const Controls<double>& b, const T& share) {
  const auto mix = [&](double x, double y) { return x + share * (y - x); };
  return {mix(a.delta, b.delta),
          mix(a.rev, b.rev),
          {mix(a.thrust.port, b.thrust.port), mix(a.thrust.starboard, b.thrust.starboard)},
          a.by_thrust};
}

}  // namespace swayaw::nonlinear
