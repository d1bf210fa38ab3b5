#pragma once

#include "random_source.hpp"
#include "sea_trial.hpp"

/// Instruments as they are on board: fixes that err slowly, steps, factors, zeros, filters and clocks.
namespace swayaw::concealed {

/// A first-order Gauss–Markov error besides a white one.
struct FixErrors {
  double slow;    ///< standard deviation [m]
  double memory;  ///< [s]
  double white;   ///< standard deviation [m]
};

enum class Smoothing { none, symmetric, causal };
enum class SwayRecord { none, over_ground, through_water };

/// What the instruments of a ship do to all of her recordings. Errors are recorded less true; 0 of a step is none.
struct OnBoardInstruments {
  double rate = 1.0;                              ///< samples of a second
  FixErrors fix{};                                ///< once a second, joined by straight lines
  double fix_phase = 0.0;                         ///< of the fixes after whole seconds [s]
  double clock = 0.0;                             ///< by which positions are recorded late, negative where early [s]
  double compass_zero = 0.0, compass_step = 0.0;  ///< [rad]
  double rudder_zero = 0.0, rudder_step = 0.0;    ///< [rad]
  bool gyro = true;                               ///< else the yaw rate is made from the recorded heading
  double gyro_scale = 1.0;                        ///< recorded over true
  double gyro_zero = 0.0;                         ///< [rad/s]
  double slope_width = 1.0;  ///< standard deviation of the Gaussian that makes a yaw rate from headings [s]
  double log_scale = 1.0;    ///< recorded over true
  bool log = true;           ///< speed through the water where no velocity is recorded; else over ground
  SwayRecord sway = SwayRecord::none;
  Smoothing smoothing = Smoothing::none;  ///< of yaw rate, speeds and heel
  double smoothing_width = 0.0;           ///< standard deviation of the Gaussian, or time constant [s]
  bool shaft = true, heel = false;        ///< are recorded
  bool gaps = true;                       ///< one or two losses of the fixes in each run
  double scatter = 1.0;                   ///< times the white errors of everything but fixes; 0 for none
};

/// Those of a ship, by chance: every error below the practical floors of docs/effects.md but for two, the factor of the
/// log (1 to 2 %) and the clock of the positions (0.2 to 1 s in a quarter of the ships), which may reach beyond. What
/// an effect is hidden in has no other error of that kind.
OnBoardInstruments instruments_by_chance(RandomSource& random, const TrueShip& ship, const Concealment& hidden);

/// Without errors, sampled as those.
OnBoardInstruments faultless(OnBoardInstruments instruments);

/// Slow and white errors of fixes once a second.
std::vector<double> fix_errors(const FixErrors& errors, std::size_t fixes, RandomSource& random);

/// A series at the steps of a track, smoothed by a Gaussian or a first-order lag.
std::vector<double> smoothed(std::vector<double> values, double step, Smoothing kind, double width);

/// The recording of a track; with one wild fix if asked for.
Recording recorded_on_board(const TrueShip& ship, const Concealment& hidden, const Manoeuvre& manoeuvre,
                            const OnBoardInstruments& instruments, const TrueTrack& track, RandomSource& random,
                            bool wild_fix = false);

}  // namespace swayaw::concealed
