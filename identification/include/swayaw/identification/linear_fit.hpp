#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/identification/fit_report.hpp"
#include "swayaw/linear/dimensional.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/response.hpp"

/// The linear sway–yaw equations that explain a recording, and what the recording tells about them.
/// docs/linear_identification.md describes the method.
namespace swayaw::inline identification {

/// Standard deviations of white measurement noise.
struct ChannelNoise {
  double psi;   ///< [rad]
  double r;     ///< [rad/s]
  double beta;  ///< [rad]
};

struct LinearFitOptions {
  double L;                      ///< ship length [m]
  std::optional<double> U = {};  ///< constant speed [m/s]; otherwise the recorded speed, sample by sample
  bool use_heading = true;
  bool use_yaw_rate = true;
  bool use_drift = true;                                   ///< beta = atan2(−v, u), where u and v are recorded
  double from = -std::numeric_limits<double>::infinity();  ///< first recorded time to use [s]
  double to = std::numeric_limits<double>::infinity();     ///< last recorded time to use [s]
  double spacing = 0.1;  ///< least distance of the measurements used, ship lengths, so that filters in the sensors
                         ///< do no harm; 0 uses all. The rudder counts at every sample
  std::optional<ChannelNoise> noise = {};  ///< known; otherwise estimated
  bool disturbances =
      true;  ///< random forces act on the ship, of estimated size; otherwise only the measurements are noisy
  bool rudder_offset = true;     ///< the recorded rudder angle has an unknown zero
  bool yaw_rate_offset = false;  ///< so has the recorded yaw rate
  bool drift_offset = false;     ///< so has the recorded drift angle
};

/// Random forces, as growth of the standard deviation of an undisturbed state with the root of time.
struct Disturbance {
  double beta;   ///< rad per root of a ship length
  double omega;  ///< of omega', per root of a ship length
};

/// Rms of what the fit leaves unexplained.
struct LinearResiduals {
  double psi, r, beta;  ///< [rad], [rad/s], [rad]; not a number for a channel that is not used
};

/// Largest motions among the samples used. A verdict on stability holds for motions of this size.
struct LinearAmplitude {
  double rudder;  ///< [rad]
  double drift;   ///< [rad]; not a number without drift
  double omega;   ///< omega' = rL/U
};

/// Result of a fit. Where drift was not recorded, the transfer function of yaw (e0, e1, nw0, nw1) and its indices are
/// given; nb0, nb1, Kb, T3b and all of a1 … c2 are not determined.
struct LinearFit {
  FitStatus status;
  PrimeScale scale;  ///< L and the mean speed, to give the indices dimension
  SwayYawCoefficients<Estimate> coefficients;
  SwayYawTransfer<Estimate> transfer;
  SteeringIndices<Estimate> indices;
  std::optional<TimeConstants<Estimate>> time_constants;  ///< nothing when they are a complex pair
  Estimate rudder_offset;                                 ///< recorded angle plus this acts [rad]
  Estimate yaw_rate_offset;                               ///< recorded minus true [rad/s]
  Estimate drift_offset;                                  ///< recorded minus true [rad]
  std::vector<LinearState<Estimate>> starts;              ///< state at the first sample used, for each recording

  ChannelNoise noise;         ///< known or estimated
  Disturbance disturbance;    ///< estimated
  LinearResiduals one_step;   ///< of the prediction from one measurement to the next
  LinearResiduals whole_run;  ///< of the simulation of the whole run from its start

  std::array<std::array<double, 6>, 6> covariance;  ///< of a1, b1, c1, a2, b2, c2; not a number without drift
  double condition_number;  ///< largest over smallest relative standard error of combinations of the fitted constants
  std::string best_combination;   ///< which product of powers is known best, "|a1|^0.71 |b2|^-0.70 to 0.4 %"
  std::string worst_combination;  ///< and which worst

  bool stable;                ///< e0 > 0 and e1 > 0 at the estimate
  double probability_stable;  ///< that both are so, at least; errors taken as normal
  LinearAmplitude amplitude;
  std::size_t samples;  ///< with a measurement that is used
};

/// Both second-order equations, sway and yaw together, fitted to a recording of any ship, stable or not.
///
/// Maximum likelihood of the one-step prediction errors of a Kalman filter. The ship sails
///
///     d(beta)/ds' = a1 beta + b1 omega' + c1 (delta + offset) + disturbance,   likewise omega',   d(psi)/ds' = omega'
///
/// exactly from sample to sample under a rudder that moves in straight lines, in the time s' = ∫ U/L dt of the recorded
/// speed; heading, r = omega' U/L and drift are measured with white noise. The state at the start is unknown. Standard
/// errors allow for residuals that are correlated over a part of a ship length; noise that is correlated for longer
/// wants a `spacing` as long.
///
/// @throws Refusal            if the run does not tell rudder or speed, or neither heading nor yaw rate, or has fewer
/// than 20 measurements
/// @throws std::domain_error  if L, U or a known noise of a channel that is used is not positive
LinearFit fit_linear(const Recording& run, const LinearFitOptions& options);

/// The same equations and offsets for several recordings, each with a start of its own.
LinearFit fit_linear(std::span<const Recording> runs, const LinearFitOptions& options);

}  // namespace swayaw::identification
