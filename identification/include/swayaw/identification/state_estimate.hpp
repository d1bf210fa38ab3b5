#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Where a recorded ship really was, how she moved, and what pushed her besides the model: extended Kalman filter with the
/// ship as predictor, and Rauch–Tung–Striebel smoother. docs/state_estimation.md describes the method.
namespace swayaw {

/// The measured channels that the filter understands. Speed over ground and course are nonlinear in the state.
inline constexpr std::array<Channel, 11> filter_channels{
    Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::u_ground, Channel::v_ground, Channel::speed_through_water,
    Channel::speed_over_ground, Channel::course_over_ground, Channel::r};

/// Standard deviation of white measurement noise, channel by channel, SI; nothing where it is to be estimated.
using MeasurementNoise = std::array<std::optional<double>, channel_count>;

/// What acts on the ship besides the model: random accelerations of surge, sway and yaw.
///
/// White: standard deviation that a velocity gains over one second [m/s, m/s, rad/s].
/// Coloured: d(a)/dt = −a/tau + noise, with standard deviation a [m/s², m/s², rad/s²] in the long run; its estimate is the
/// unmodelled acceleration of the ship over time.
struct Imperfection {
  PlanarAcceleration<double> size;
};

struct EstimationOptions {
  std::vector<Channel> channels;               ///< to be used; empty: all that the run has
  MeasurementNoise noise{};                    ///< known noise
  std::optional<Imperfection> imperfection;    ///< known size; otherwise estimated
  bool coloured = true;                        ///< carry the unmodelled acceleration as states; otherwise it is white
  double memory = 1.0;                         ///< tau in ship lengths at service speed
  bool smooth = true;                          ///< use the future of a sample too
  int most_iterations = 30;                    ///< of the noise estimation
};

/// The estimate at one sample.
struct EstimatedState {
  double time;
  ShipState<double> state;
  PlanarAcceleration<double> unmodelled;  ///< 0 when the imperfection is white
  std::array<std::array<double, 9>, 9> covariance;  ///< of x, y, psi, u, v, r and the unmodelled accelerations
};

/// How well the prediction of a channel from the past agreed with it.
struct ChannelInnovation {
  Channel channel;
  double noise;              ///< standard deviation, known or estimated
  double rms;                ///< of prediction errors over their expected size: 1 for a right filter
  double autocorrelation;    ///< of successive ones: 0 for a right filter
  std::size_t count;
};

struct StateEstimate {
  std::vector<EstimatedState> states;  ///< one for each sample
  std::vector<ChannelInnovation> innovations;
  Imperfection imperfection;           ///< known or estimated
  double log_likelihood;
  int iterations;                      ///< of the noise estimation
  bool converged;

  /// The smoothed motion as a recording; rudder and propulsion as in the run it came from.
  Recording recording(const Recording& run) const;
};

/// Estimates the states of a recorded ship.
///
/// Channels may miss samples, sampling may be irregular; heading and course are compared as directions.
///
/// @throws Refusal            if the run has no rudder angle, or none of the channels tells position, heading or speed
/// @throws std::domain_error  if a known noise is not positive
StateEstimate estimate_states(const Ship& ship, const Recording& run, const EstimationOptions& options = {});

}  // namespace swayaw
