#pragma once

#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "true_ship.hpp"

/// Trials of a true ship, sailed in short Runge–Kutta steps and recorded by instruments.
namespace swayaw::concealed {

/// What is done after a straight approach of one ship length of way.
struct Manoeuvre {
  enum class Kind { zigzag, turn, passage } kind;
  std::string name;       ///< of its file, "zz10_10_p"
  double rudder = 0.0;    ///< [rad]; positive begins to port
  double heading = 0.0;   ///< of a zigzag: change of heading at which the rudder is reversed [rad]
  double approach = 0.0;  ///< heading of the approach [rad]
  double lengths = 24.0;  ///< duration [L/U]
};

/// zz10_10_p and alike: angles in degrees, side of the first order.
Manoeuvre zigzag(int rudder_deg, int heading_deg, bool to_port, double approach);
Manoeuvre turn(int rudder_deg, bool to_port, double approach);

/// Small changes of course by an autopilot.
Manoeuvre passage(double approach, double first_change);

/// Deviations of the white noise of the instruments. At 1 those of good trials: 0.0007 L, 0.06 deg, 0.005 U/L, 0.01 U,
/// 0.03 deg.
struct TrialOptions {
  double noise = 1.0;        ///< times that
  double disturbance = 1.0;  ///< times accelerations of 0.0012 U²/L sway, with a memory of 0.7 L/U
  double sample = 0.04;      ///< time between samples [L/U]
  double turbulence = 0.08;  ///< standard deviation over mean of the wind speed
  double gust_memory = 2.0;  ///< of the wind [L/U]
  int steps = 4;             ///< of the integration between samples
  std::uint64_t seed = 1;
};

/// The truth at every step of the integration, from one ship length of way before the record begins.
struct TrueTrack {
  double from;  ///< [s], negative
  double step;  ///< [s]
  std::vector<States> states;
  std::vector<double> delta;  ///< that the indicator shows [rad]
};
TrueTrack true_track(const TrueShip& ship, const Concealment& hidden, const Manoeuvre& manoeuvre,
                     const TrialOptions& options = {});

/// A channel at every step of a track, as an instrument without noise shows it: with what is hidden, but no delay.
std::vector<double> shown(Channel channel, const TrueTrack& track, const Concealment& hidden);

/// A value of a track at a time of the run, by a straight line between steps.
double value_at(const TrueTrack& track, std::span<const double> values, double time);

/// Rounded to as many digits as instruments give.
double seven_digits(double value);

/// The recording of a manoeuvre.
Recording simulate(const TrueShip& ship, const Concealment& hidden, const Manoeuvre& manoeuvre,
                   const TrialOptions& options = {});

/// What a trial without noise shows of a ship.
struct Character {
  double overshoot_10, overshoot_20;  ///< first overshoots of zigzags 10/10 and 20/20 [rad]
  double tactical_diameter;           ///< of a turn with 35 deg [L]
  double speed_in_turn;               ///< over that of the approach
};
Character character_of(const TrueShip& ship);

}  // namespace swayaw::concealed
