#pragma once

#include <optional>
#include <span>
#include <vector>

#include "swayaw/nonlinear/ship.hpp"
#include "swayaw/nonlinear/surroundings/wind.hpp"

/// Straight runs in steady wind: the drift and the helm that keep a course. docs/manoeuvres.md tells the equations.
namespace swayaw::inline nonlinear {

/// What is kept: the heading, or the course over ground.
enum class Kept { heading, course };

struct WindRunOrder {
  double direction = 0.0;  ///< heading or course, clockwise from north [rad]
  Kept kept = Kept::course;
  std::optional<Controls<double>>
      propulsion{};  ///< held; that of self-propulsion at service speed without wind unless given
};

/// A straight run, r = 0, on which nothing changes but the place.
struct WindRun {
  PlanarMotion<double> motion;     ///< through the water; r = 0
  double psi;                      ///< heading [rad]
  double delta;                    ///< helm, positive to port [rad]
  double course;                   ///< over ground [rad]
  double speed_over_ground;        ///< [m/s]
  PlanarForce<double> wind_force;  ///< [N], [N m]
  bool holds;                      ///< the helm is within the largest rudder angle; else she cannot hold the course

  double leeway() const {
    return -drift_angle(motion);
  }  ///< of the track through the water, positive to starboard of the heading [rad]
};

/// The straight run of a ship in that wind and in the current of her surroundings, whose own wind is not looked at:
/// sway, surge and helm, and the heading where the course is kept, from
///
///     (du/dt, dv/dt, dr/dt)(u, v, 0, delta; F_ship + F_wind) = 0,   r = 0
///
/// by Newton's method with exact derivatives. The wind is raised from none in steps, so the run is the one that grows
/// out of the run in still air. A ship with superstructure in `windage` feels the air of her own way too.
///
/// @return nothing where no such run ahead was found: no helm whatever balances that wind, or she no longer makes way
/// or keeps the course
///         over ground
/// @throws std::domain_error  if the wind speed is negative
/// @throws Refusal            as self_propulsion
std::optional<WindRun> steady_run_in_wind(const Ship& ship, const Windage<double>& windage, const Wind<double>& wind,
                                          const WindRunOrder& order = {});

/// A row of a table over wind directions.
struct WindRunRow {
  double relative;  ///< where the true wind comes from, clockwise from the heading or course kept [rad]
  std::optional<WindRun> run;
};

/// Runs in a true wind of that speed [m/s] from each direction relative to the heading or course.
/// @throws as steady_run_in_wind
std::vector<WindRunRow> steady_runs_in_wind(const Ship& ship, const Windage<double>& windage, double wind_speed,
                                            std::span<const double> relative, const WindRunOrder& order = {});

}  // namespace swayaw::nonlinear
