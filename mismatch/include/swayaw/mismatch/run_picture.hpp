#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/motion.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// A recorded run as people look at it: which force is missing and when, and what each ship makes of the run.
namespace swayaw::inline mismatch {

/// What drives a ship beyond her model at a time, given the whole run: mean and standard deviation.
struct MissingForce {
  PlanarMotion<double> motion;              ///< through the water, as estimated along with it
  PlanarAcceleration<double> acceleration;  ///< [m/s², m/s², rad/s²]
  PlanarAcceleration<double> acceleration_deviation;
  PlanarForce<double> force;  ///< that accelerates ship and entrained water so [N, N, N m]
  PlanarForce<double> force_deviation;
};

/// Force that a ship lacks in a run, sample after sample.
///
/// An extended Kalman filter carries the accelerations that the model leaves out beside position and motion,
///
///     d(a)/dt = −a/T + noise,   T = L/U,   standard deviation of a: the scale times that of an adequate model,
///
/// and a smoother goes back through the run, so that the force is not seen late (Rauch, Tung & Striebel 1965). F = M a,
/// M of the model with added mass. Where the recording has a gap the mean fades and the deviation grows.
///
/// @throws Refusal  if the run tells neither rudder nor speed
std::vector<MissingForce> missing_force(const Ship& ship, const Recording& run, const Noise& noise);

/// The same of a run that is ready for fits.
std::vector<MissingForce> missing_force(const Ship& ship, const PreparedRun& run, const Noise& noise);

/// Standard deviation of the force that an adequate model leaves out: the scale 1.
PlanarForce<double> ordinary_force(const Ship& ship);

/// At most 500 points of a run, all series of one length.
struct RunPicture {
  std::string run;
  Recording recorded;
  std::vector<MissingForce> missing_before;         ///< of the refitted ship; empty where the run does not tell it
  std::vector<MissingForce> missing_after;          ///< of the ship with the effects found
  std::optional<Recording> given, refitted, after;  ///< replays by the three ships from the start of the run to its end
};

/// @param noise  one for both ships, so that what shrinks is the force and not the allowance for it
RunPicture run_picture(const Ship& given, const Ship& refitted, const Ship& after, const Recording& run,
                       const Noise& noise);

/// A ship as she was in a run: wind, stream and instruments may differ from run to run.
using ShipInRun = std::function<Ship(const Recording& run)>;

std::vector<RunPicture> run_pictures(const Ship& given, const ShipInRun& refitted, const ShipInRun& after,
                                     std::span<const Recording> runs, const Noise& noise);

}  // namespace swayaw::mismatch
