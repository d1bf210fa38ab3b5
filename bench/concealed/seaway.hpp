#pragma once

#include <vector>

#include "random_source.hpp"
#include "sea_trial.hpp"

/// Waves that move a ship about her way: she yaws and sways with them, which is no manoeuvre.
namespace swayaw::concealed {

/// One regular wave and what it does to the ship abeam.
struct Wave {
  double frequency;   ///< that a ship at rest meets [rad/s]
  double yaw, sway;   ///< amplitudes [rad], [m/s]
  double phase, lag;  ///< of the sway, and of the yaw behind it [rad]
};

/// A long-crested sea, its energy within an eighth of its mean frequency.
struct Seaway {
  double to = 0.0;               ///< where its waves run [rad]
  double period = 0.0;           ///< [s]
  double yaw = 0.0, sway = 0.0;  ///< √2 of the root mean square, [rad] and [m/s]
  std::vector<Wave> waves{};
};

/// A sea of 7 to 11 s that yaws the ship by 0.12 to 0.35 deg, met from the quarter, and sways her by 0.05 to 0.12 m/s,
/// met abeam: what a ship sails her trials in. Nothing in three of five.
Seaway seaway_by_chance(RandomSource& random);

/// The track with the motion that waves add to it: frequencies of encounter ω − ω²/g U cos(ψ − to), the sway from
/// abeam, the yaw from the quarters.
TrueTrack in_waves(TrueTrack track, const Seaway& sea);

}  // namespace swayaw::concealed
