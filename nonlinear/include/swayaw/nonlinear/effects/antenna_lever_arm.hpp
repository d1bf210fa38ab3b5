#pragma once

#include <cmath>

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw {

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
  static constexpr InstrumentStage stage = InstrumentStage::mounting;

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

/// Velocity over ground of a point of the ship: u − r y, v + r x.
inline void move_velocity(Recording& run, double x, double y) {
  if (!run.has(Channel::r)) return;
  const auto r = run[Channel::r];
  auto &u = run.channels[index_of(Channel::u_ground)], &v = run.channels[index_of(Channel::v_ground)];
  for (std::size_t i = 0; i < u.size(); ++i) u[i] -= r[i] * y;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += r[i] * x;
}

/// The same for speed and course.
inline void move_course(Recording& run, double x, double y) {
  if (!run.has(Channel::r) || !run.has(Channel::speed_over_ground) || !run.has(Channel::course_over_ground)) return;
  auto &speed = run.channels[index_of(Channel::speed_over_ground)],
       &course = run.channels[index_of(Channel::course_over_ground)];
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double c = std::cos(run[Channel::psi][i]), s = std::sin(run[Channel::psi][i]), r = run[Channel::r][i];
    const double north = speed[i] * std::cos(course[i]) - r * (y * c + x * s),
                 east = speed[i] * std::sin(course[i]) + r * (x * c - y * s);
    speed[i] = std::hypot(north, east);
    course[i] += std::remainder(std::atan2(east, north) - course[i], 2.0 * pi);
  }
}

/// Heading and yaw rate of the run are the true ones.
inline void record(const AntennaLeverArm<>& e, Recording& run, int sign) {
  const double x = sign * e.x, y = sign * e.y;
  auto &north = run.channels[index_of(Channel::x)], &east = run.channels[index_of(Channel::y)];
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double c = std::cos(run[Channel::psi][i]), s = std::sin(run[Channel::psi][i]);
    if (!north.empty()) north[i] += x * c - y * s;
    if (!east.empty()) east[i] += x * s + y * c;
  }
  move_velocity(run, x, y);
  move_course(run, x, y);
}

/// The position.
template <class S>
S shown(const AntennaLeverArm<S>& e, const ChannelReading<S>& reading, const S& value) {
  const auto [s, c] = sin_cos(reading.state.psi);
  if (reading.channel == Channel::x) return value + (e.x * c - e.y * s);
  if (reading.channel == Channel::y) return value + (e.x * s + e.y * c);
  return value;
}

}  // namespace swayaw
