#pragma once

#include <array>
#include <limits>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/channel.hpp"
#include "swayaw/nonlinear/effect_parameter.hpp"

/// Effects in what rudder and engine really did, and in what was really measured. docs/effects.md tells signs.
namespace swayaw {

// ---------------------------------------------------------------- actuators

/// Actual minus recorded rudder angle, positive to port.
template <class S = double>
struct RudderOffset {
  S offset{};  ///< [rad]

  static constexpr std::string_view id = "rudder_offset";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr auto parameters() {
    using P = EffectParameter<RudderOffset, S>;
    return std::array{P{.key = "offset_rad",
                        .member = &RudderOffset::offset,
                        .range = {-0.6, 0.6},
                        .prior = radians(2.0),
                        .floor = radians(0.3)}};
  }
};

/// The rudder follows the recorded angle late: d(delta)/dt = (delta_rec − delta)/T, at most the rate.
template <class S = double>
struct SteeringGearLag {
  S lag{};                                              ///< T [s]
  S rate = S(std::numeric_limits<double>::infinity());  ///< [rad/s]

  static constexpr std::string_view id = "steering_gear_lag";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr auto parameters() {
    using P = EffectParameter<SteeringGearLag, S>;
    constexpr double none = std::numeric_limits<double>::infinity();
    return std::array{
        P{.key = "lag_s",
          .member = &SteeringGearLag::lag,
          .range = non_negative,
          .prior = 0.2,
          .floor = 0.01,
          .scale = ShipUnit::time},
        P{.key = "rate_rad_s",
          .member = &SteeringGearLag::rate,
          .range = positive,
          .null = none,
          .prior = 0.05,
          .required = false,
          .fallback = none},
    };
  }
};

/// Play between the recorded angle and the rudder: she rests until the angle has come the width back.
template <class S = double>
struct SteeringGearBacklash {
  S width{};  ///< [rad]

  static constexpr std::string_view id = "steering_gear_backlash";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr auto parameters() {
    using P = EffectParameter<SteeringGearBacklash, S>;
    return std::array{P{.key = "width_rad",
                        .member = &SteeringGearBacklash::width,
                        .range = non_negative,
                        .prior = radians(3.0),
                        .floor = radians(0.3)}};
  }
};

/// The shaft turns slower than recorded where the ship has lost speed, n (1 − relative_drop (1 − u/U_0)): an engine at
/// its limit of torque.
template <class S = double>
struct ShaftSpeedDrop {
  S relative_drop{};

  static constexpr std::string_view id = "shaft_speed_drop";
  static constexpr EffectPlace place = EffectPlace::actuator;
  static constexpr auto parameters() {
    using P = EffectParameter<ShaftSpeedDrop, S>;
    return std::array{P{.key = "relative_drop",
                        .member = &ShaftSpeedDrop::relative_drop,
                        .range = {-1.0, 1.0},
                        .prior = 0.3,
                        .floor = 0.02}};
  }
};

// ---------------------------------------------------------------- sensors

/// Recorded minus true heading.
template <class S = double>
struct HeadingBias {
  S bias{};  ///< [rad]

  static constexpr std::string_view id = "heading_bias";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr auto parameters() {
    using P = EffectParameter<HeadingBias, S>;
    return std::array{P{.key = "bias_rad",
                        .member = &HeadingBias::bias,
                        .range = {-pi, pi},
                        .prior = radians(2.0),
                        .floor = radians(0.3),
                        .law = 0.0}};
  }
};

/// Recorded minus true yaw rate.
template <class S = double>
struct GyroBias {
  S bias{};  ///< [rad/s]

  static constexpr std::string_view id = "gyro_bias";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr auto parameters() {
    using P = EffectParameter<GyroBias, S>;
    return std::array{P{.key = "bias_rad_s",
                        .member = &GyroBias::bias,
                        .prior = 0.02,
                        .floor = 0.002,
                        .law = 0.0,
                        .scale = ShipUnit::yaw_rate}};
  }
};

/// Recorded over true speed through the water.
template <class S = double>
struct LogScale {
  S scale{1.0};

  static constexpr std::string_view id = "log_scale";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr auto parameters() {
    using P = EffectParameter<LogScale, S>;
    return std::array{P{.key = "scale",
                        .member = &LogScale::scale,
                        .range = positive,
                        .null = 1.0,
                        .prior = 0.05,
                        .floor = 0.01,
                        .law = 0.0}};
  }
};

/// The recorded position is not that of midship but of a point of the ship.
template <class S = double>
struct AntennaLeverArm {
  S x{};  ///< forward of midship [m]
  S y{};  ///< to starboard [m]

  static constexpr std::string_view id = "antenna_lever_arm";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr auto parameters() {
    using P = EffectParameter<AntennaLeverArm, S>;
    return std::array{
        P{.key = "x_m",
          .member = &AntennaLeverArm::x,
          .prior = 0.3,
          .floor = 0.02,
          .law = 0.0,
          .scale = ShipUnit::length},
        P{.key = "y_m",
          .member = &AntennaLeverArm::y,
          .prior = 0.05,
          .floor = 0.02,
          .law = 0.0,
          .scale = ShipUnit::length,
          .required = false},
    };
  }
};

/// A channel is recorded late. The two coordinates of a position are of one receiver: x stands for both.
template <class S = double>
struct ChannelDelay {
  Channel channel = Channel::delta;
  S delay{};  ///< [s], negative where the record is early

  static constexpr std::string_view id = "channel_delay";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr auto parameters() {
    using P = EffectParameter<ChannelDelay, S>;
    return std::array{
        P{.key = "delay_s", .member = &ChannelDelay::delay, .prior = 0.1, .floor = 0.01, .scale = ShipUnit::time}};
  }
};

}  // namespace swayaw
