#pragma once

#include <optional>
#include <vector>

#include "swayaw/core/motion.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/side.hpp"
#include "swayaw/nonlinear/manoeuvres/manoeuvre_step.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Standard manoeuvres. Each begins at t = 0, where the first rudder order is given, at the origin on heading 0
/// straight ahead through the water, with the propulsion held that carries the ship at the approach speed, unless
/// another is given.
namespace swayaw::inline nonlinear {

struct ManoeuvreOptions {
  std::optional<double> speed;     ///< approach speed [m/s]; the service speed unless given
  std::optional<double> rev;       ///< shaft speed [1/s]; that of self-propulsion at the approach speed unless given
  std::optional<double> thrust;    ///< thrust of all propellers [N], in place of a shaft speed
  std::optional<double> duration;  ///< [s]; else until the indices are known
  std::optional<double> step;  ///< between samples of the time series [s]; a round number near 0.02 L/U unless given
  double tolerance = 1e-9;     ///< error of an integration step: lengths over L, speeds over U, angles in rad
  bool sampled = true;         ///< keep the time series; without it `run` is empty and no way is measured
  bool traced = false;         ///< keep the steps, from which index_slopes.hpp takes derivatives
};

// ---------------------------------------------------------------- zigzag

/// Rudder D and heading H of a zigzag D/H, and the side turned to first.
struct ZigzagOrder {
  double rudder;   ///< [rad], positive
  double heading;  ///< [rad], positive
  Side first = Side::starboard;
};

/// A rudder reversal and the heading peak that follows.
struct Reversal {
  double time;                      ///< when the heading reaches the switch angle [s]
  std::optional<double> peak_time;  ///< when the yaw rate passes zero [s]
  std::optional<double> overshoot;  ///< heading peak beyond the switch angle [rad]
};

/// Source of the indices: IMO resolution MSC.137(76)
struct Zigzag {
  std::vector<Reversal> reversals;
  std::optional<double> period;           ///< of the last full cycle, reversal to the next but one [s]
  std::optional<double> initial_turning;  ///< way made when the heading first reaches H [m]
  double approach_speed;                  ///< [m/s]
  Controls<double> propulsion;            ///< held during the manoeuvre
  Recording run;
  std::vector<ManoeuvreStep> steps;  ///< of the integration, if traced
};

/// Zigzag: the rudder is put to D; whenever the heading reaches H on the side of the turn it is reversed.
/// Ends after the fourth overshoot unless a duration is given.
///
/// @throws std::domain_error  if an angle is not positive, or the rudder order beyond the ship's largest angle
/// @throws Refusal            if the ship cannot propel herself at the approach speed
Zigzag zigzag(const Ship& ship, const ZigzagOrder& order, const ManoeuvreOptions& options = {});

// ---------------------------------------------------------------- turning circle

struct TurnOrder {
  double rudder;  ///< [rad], positive
  Side side = Side::starboard;
};

/// Source of the indices: IMO resolution MSC.137(76). Lengths from the place of the rudder order,
/// along and across the approach course; nothing for what was not reached or does not exist.
struct TurningCircle {
  std::optional<double> advance;               ///< forward way at 90 deg change of heading [m]
  std::optional<double> transfer;              ///< sideways way at 90 deg [m]
  std::optional<double> time_90;               ///< [s]
  std::optional<double> tactical_diameter;     ///< sideways way at 180 deg [m]
  std::optional<double> time_180;              ///< [s]
  std::optional<double> initial_turning;       ///< way made at 10 deg change of heading [m]
  std::optional<double> final_diameter;        ///< 2U/|r| of the steady turn [m]
  std::optional<PlanarMotion<double>> steady;  ///< the steady turn, if the ship settles in one
  std::optional<double> way_lost;              ///< when the ship ceased to move ahead, which ended the turn [s]
  double approach_speed;                       ///< [m/s]
  Controls<double> propulsion;                 ///< held during the manoeuvre
  Recording run;
  std::vector<ManoeuvreStep> steps;  ///< of the integration, if traced
};

/// Turning circle with the rudder held at the ordered angle. Ends after 540 deg, or where the ship no longer moves
/// ahead, unless a duration is given.
/// @throws as zigzag does
TurningCircle turning_circle(const Ship& ship, const TurnOrder& order, const ManoeuvreOptions& options = {});

}  // namespace swayaw::nonlinear
