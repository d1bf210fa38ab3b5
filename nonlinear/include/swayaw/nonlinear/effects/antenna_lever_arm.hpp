#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

/// The recorded position is not that of midship but of a point of the ship, p + R(psi) l; so is the velocity over
/// ground.
template <class S = double>
struct AntennaLeverArm {
  S x{};  ///< forward of midship [m]
  S y{};  ///< to starboard [m]

  static constexpr std::string_view id = "antenna_lever_arm";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< an antenna is put up once a day
  static constexpr EffectText text{.phrase = "an antenna off midship",
                                   .label = "antenna off midship",
                                   .law = "position and velocity over ground of the point (x, y) of the ship",
                                   .confused_with = "delay of the position: with U, not with r"};

  static constexpr auto parameters() {
    using P = ParameterOf<AntennaLeverArm, S>;
    return std::array{P{.key = "x_m",
                        .member = &AntennaLeverArm::x,
                        .unit = "m",
                        .prior = 0.3,
                        .floor = 0.02,
                        .law = 0.0,
                        .scale = ShipUnit::length},
                      P{.key = "y_m",
                        .member = &AntennaLeverArm::y,
                        .unit = "m",
                        .required = false,
                        .prior = 0.05,
                        .floor = 0.02,
                        .law = 0.0,
                        .scale = ShipUnit::length}};
  }

  /// The quantity that it shows wrong.
  std::string_view shows_wrong() const { return "position"; }
};

template <class S>
void put_on(Instruments<S>& instruments, const AntennaLeverArm<S>& e) {
  instruments.antenna_x = e.x;
  instruments.antenna_y = e.y;
}

}  // namespace swayaw::nonlinear
