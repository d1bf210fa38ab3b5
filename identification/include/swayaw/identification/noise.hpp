#pragma once

#include <algorithm>
#include <array>

#include "swayaw/core/channel.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::inline identification {

/// What no model and no instrument gets right, found by likelihood: process noise and the noise of the channels.
struct Noise {
  double scale = 1.5;                         ///< of the ordinary process noise
  bool apart = false;                         ///< whether each axis has a scale and the noise a memory of its own
  std::array<double, 3> axes{1.0, 1.0, 1.0};  ///< factors on the scale in surge, sway and yaw
  double memory = 1.0;                        ///< of the process noise, over L/U
  bool with_memory =
      false;          ///< whether errors of positions have one, as receivers have it: all sizes are found together
  double walk = 0.0;  ///< standard deviation of what the error of a position wanders in the time L/U, over L
  std::array<double, channel_count>
      factor{};  ///< on the noise of each channel, 1 where third differences tell all of it

  Noise() { factor.fill(1.0); }

  /// Where a search begins on a ship whose instruments are not perfect.
  static Noise on_board() {
    Noise noise;
    noise.with_memory = true, noise.scale = 1.0, noise.walk = 1e-3;
    return noise;
  }

  /// Of the axis that is worst.
  double largest_scale() const { return scale * std::ranges::max(axes); }

  bool operator==(const Noise&) const = default;
};

/// Largest scale of the process noise that an adequate model leaves.
inline constexpr double ordinary_scale = 1.5;

/// What the variance of the error of a position gains [m²/s].
double position_walk(const Ship& ship, const Noise& noise);

/// Standard deviation of the accelerations that the model leaves out: 0.002 U²/L times the scale in sway, 0.3 of that
/// in surge, and 1.5/L of that in yaw.
PlanarAcceleration<double> process_noise(const Ship& ship, const Noise& noise);

}  // namespace swayaw::identification
