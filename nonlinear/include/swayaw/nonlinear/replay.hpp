#pragma once

#include <optional>
#include <span>
#include <string>

#include "swayaw/core/motion.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"
#include "swayaw/nonlinear/simulation/rudder_track.hpp"
#include "swayaw/nonlinear/surroundings/recorded_surroundings.hpp"

/// Simulation with the rudder and shaft speed of a recording, beside that recording.
namespace swayaw::inline nonlinear {

/// Where a replay takes its shaft speed or thrust from.
enum class Shaft {
  recorded,         ///< the recording; self-propulsion where it has neither
  self_propulsion,  ///< what carries the model at the recorded starting speed
};

struct ReplayOptions {
  Shaft shaft = Shaft::recorded;
  double tolerance = 1e-8;
};

/// Whether a run tells what propels the ship: her shaft speed, where her model takes one, or a thrust. The polynomial
/// of an Abkowitz ship holds her propulsion.
bool tells_propulsion(const Ship& ship, const Recording& run);

/// What is assumed of those runs that do not tell it, in words for the user; empty where all do.
std::string assumed_propulsion(const Ship& ship, std::span<const Recording> runs);

/// Recorded state at a time, of the ship through the water, from least-squares parabolas through the samples within
/// 0.25 L/U of it, or at the start of the run from straight lines through the samples before the rudder moves, within
/// 0.5 L/U.
///
/// The first of these that was recorded tells; from what is over ground the current of the ship is taken off, at the
/// recorded heading:
///
///     u      u, log, u over ground, track, speed and course over ground, speed over ground
///     v      v, v over ground, track, speed and course over ground; else 0
///     r      r, heading
///     x, y   position; else 0
///
/// The track is followed along the recorded heading, so a ship that turns already is told too. What the instruments of
/// the ship did to the recording is undone first. Where her positions or heading are late by more than 0.05 L/U, or her
/// compass is off by more than 1 deg, the track tells in place of velocities over ground: a receiver makes them of its
/// positions, in axes of the heading that was shown.
///
/// @throws Refusal  if no channel tells the speed of the ship
ShipState<double> recorded_state(const Ship& ship, const Recording& run, double time);

/// The same at several times.
std::vector<ShipState<double>> recorded_states(const Ship& ship, const Recording& run, std::span<const double> times);

/// Rudder and propulsion of a recording as functions of time, joined by straight lines; wind and depth as measured.
/// An ordered rudder angle passes through the steering gear of the ship first; then any passes through what the effects
/// of the ship put between the indicator and the rudder. Thrust is taken where the recording or the ship does not tell
/// the shaft speed.
class RecordedControls {
 public:
  /// @throws Refusal  if the run has no rudder angle
  RecordedControls(const Ship& ship, const Recording& run, const ReplayOptions& options = {});

  /// With the angle of the rudder, and the shaft speed as recorded.
  Controls<double> at(double time) const;

  /// The same at times in order.
  std::vector<Controls<double>> at(std::span<const double> times) const;

  /// Angle of the rudder [rad].
  double rudder(double time) const { return track_ ? track_->at(time) : rudder_(time); }

  /// The angle as the indicator shows it.
  const Interpolant& shown() const { return rudder_; }

  /// The rudder piece by piece, where it is not as the indicator shows.
  const std::optional<RudderTrack>& track() const { return track_; }

  /// When the recorded shaft turns astern first between two times, if it does.
  std::optional<double> shaft_astern(double from, double to) const;

  /// What carries a ship at the speed with which the run starts, where nothing else tells her propulsion. The run is
  /// taken to begin settled: all that acts on her then is carried, wind and waves, too.
  /// @param run  that the controls are of
  Controls<double> propulsion_of(const Ship& ship, const Recording& run) const;

  /// Propulsion where none was recorded.
  const Controls<double>& constant() const { return constant_; }
  void propel(const Controls<double>& constant) { constant_ = constant; }

  /// Times at which the slope of a control changes, in order.
  std::span<const double> knots() const { return knots_; }

  /// Measured wind; empty where there is none or the ship shows it nothing.
  std::span<const WindPiece> wind() const { return wind_; }

  /// Measured depth of the water [m].
  const std::optional<double>& depth() const { return depth_; }

 private:
  /// The speed through the water with which the run starts, and all of a ship that it depends on.
  struct Start {
    Instruments<> instruments;
    Current<double> current;
    double time_unit;  ///< L/U [s]
    double speed;      ///< [m/s]

    Start(const Ship& ship, const Recording& run);
    bool is_of(const Ship& ship, double begin) const;
  };

  Controls<double> with_angle(double delta, double time) const;

  Interpolant rudder_;
  std::optional<RudderTrack> track_;
  std::optional<Interpolant> rev_;
  std::optional<Interpolant> thrust_;
  Controls<double> constant_{};  ///< where nothing is recorded
  std::optional<Start> start_;   ///< the same
  std::vector<double> knots_;
  std::vector<WindPiece> wind_;
  std::optional<double> depth_;
};

/// Simulated run from a state at times.front() on, sampled at those times, as the instruments of the ship would record
/// it. Heel and memory begin as in a steady motion. Measured wind blows on top of that of her effects; measured depth
/// acts where it makes a difference (in_depth).
///
/// @throws Refusal  if no force model holds for the start, or for the shaft on the way (validity.hpp)
Recording replay_from(const Ship& ship, const RecordedControls& controls, const ShipState<double>& start,
                      std::span<const double> times, const ReplayOptions& options = {});

/// A state that a simulation takes up at a sample.
struct ReplayStart {
  std::size_t sample;
  ShipState<double> state;
};

/// The same, taken up anew at several samples, in order, the first of them 0, none the last of the run. What effects
/// remember goes on as it was simulated: heel, and the motion that the water knows, are in no recorded state and rarely
/// steady.
Recording replay_anew(const Ship& ship, const RecordedControls& controls, std::span<const ReplayStart> starts,
                      std::span<const double> times, const ReplayOptions& options = {});

/// The whole run simulated from its recorded start, sampled at the recorded times, in the wind and depth that were
/// measured; what acted of them is among its columns and facts again.
///
/// @throws Refusal  if the run does not tell rudder or speed
Recording replay(const Ship& ship, const Recording& run, const ReplayOptions& options = {});

}  // namespace swayaw::nonlinear
