#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

/// Velocities forward and to starboard are measured in axes that are turned about those of the ship: a log mounted
/// askew, or velocities over ground taken apart with a heading that is wrong.
///
///     u_rec = u cos ε + v sin ε,   v_rec = v cos ε − u sin ε
template <class S = double>
struct VelocityAxes {
  S angle{};  ///< ε, of the measuring axes to starboard of those of the ship [rad]

  static constexpr std::string_view id = "velocity_axes";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< a log is mounted once, a compass is set once a day
  static constexpr EffectText text{.phrase = "velocity axes that are turned",
                                   .label = "angle of the velocity axes",
                                   .law =
                                       "(u, v), through the water and over ground, in axes turned by ε = `angle_rad` "
                                       "to starboard: u cos ε + v sin ε, v cos ε − u sin ε",
                                   .confused_with = "wind, waves, current → headings all round"};

  /// Recorded v/u of R/V Gunnerus is 1.5 to 3.4 deg on every heading, her axes turned by 2 deg. A log can be mounted to
  /// a degree: a trace.
  static constexpr auto parameters() {
    return std::array{ParameterOf<VelocityAxes, S>{.key = "angle_rad",
                                                   .member = &VelocityAxes::angle,
                                                   .unit = "rad",
                                                   .range = {-pi, pi},
                                                   .prior = radians(2.0),
                                                   .floor = radians(1.0),
                                                   .law = 0.0}};
  }

  /// The quantity that it shows wrong.
  std::string_view shows_wrong() const { return "drift"; }
};

template <class S>
void put_on(Instruments<S>& instruments, const VelocityAxes<S>& e) {
  instruments.velocity_axes = e.angle;
}

}  // namespace swayaw::nonlinear
