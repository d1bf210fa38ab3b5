#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/identification/measurement.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Where a recorded ship really was, how she moved, and what pushed her besides the model: extended Kalman filter with
/// the ship as predictor, and smoother. docs/state_estimation.md describes the method.
namespace swayaw::inline identification {

/// What acts on the ship besides the model: random accelerations a of surge, sway and yaw.
///
///     coloured, with a memory tau    da/dt = −a/tau + noise; size is the standard deviation of a [m/s², m/s², rad/s²]
///     coloured, memory infinite      da/dt = noise;          size is what a gains over one second [m/s², m/s², rad/s²]
///     white                          a = noise;              size is what a velocity gains over one second [m/s, m/s,
///     rad/s]
struct ProcessNoise {
  PlanarAcceleration<double> size;
};

struct EstimationOptions {
  std::vector<Channel> channels;              ///< to be used; empty: all that the run has
  MeasurementNoise noise{};                   ///< known noise
  std::optional<ProcessNoise> process_noise;  ///< known size; otherwise estimated
  bool coloured = true;                       ///< carry the unmodelled acceleration as states; otherwise it is white
  double memory = 1.0;                        ///< tau in ship lengths at service speed, or infinity
  bool smooth = true;                         ///< use the future of a sample too
  int most_iterations = 100;                  ///< of the noise estimation
};

/// Covariance of x, y, psi, u, v, r and the unmodelled accelerations of surge, sway and yaw, in this order.
class StateCovariance {
 public:
  double operator()(std::size_t i, std::size_t k) const { return lower_[place(i, k)]; }
  double& operator()(std::size_t i, std::size_t k) { return lower_[place(i, k)]; }

  /// That of N of them, from one on.
  template <int N>
  Eigen::Matrix<double, N, N> of(std::size_t first) const {
    return Eigen::Matrix<double, N, N>::NullaryExpr([&](Eigen::Index i, Eigen::Index k) {
      return (*this)(first + static_cast<std::size_t>(i), first + static_cast<std::size_t>(k));
    });
  }

 private:
  static std::size_t place(std::size_t i, std::size_t k) { return i < k ? place(k, i) : i * (i + 1) / 2 + k; }

  std::array<double, 45> lower_{};
};

/// The estimate at one sample.
struct EstimatedState {
  double time;
  ShipState<double> state;
  PlanarAcceleration<double> unmodelled;  ///< of a white process noise its mean until the next sample
  StateCovariance covariance;
};

/// How well the prediction of a channel from the past agreed with it.
struct ChannelInnovation {
  Channel channel;
  double noise;            ///< standard deviation, known or estimated
  double rms;              ///< of prediction errors over their expected size: 1 for a right filter
  double autocorrelation;  ///< of successive ones: 0 for a right filter
  std::size_t count;
};

/// Noise that makes recorded runs most likely.
struct NoiseEstimate {
  MeasurementNoise noise;      ///< of the channels used, known or estimated
  ProcessNoise process_noise;  ///< known or estimated
  double log_likelihood;       ///< of all runs
  int iterations;
  bool converged;  ///< true where nothing had to be estimated
};

struct StateEstimate {
  std::vector<EstimatedState> states;  ///< one for each sample
  std::vector<ChannelInnovation> innovations;
  NoiseEstimate noise;

  /// The estimated motion as a recording; rudder and propulsion as in the run it came from.
  Recording recording(const Recording& run) const;
};

/// Estimates the states of a recorded ship.
///
/// Channels may miss samples, sampling may be irregular; heading and course are compared as directions. What is not
/// known of noise and process noise is estimated from the run itself.
///
/// @throws Refusal            if the run has no rudder angle, or none of the channels tells position or speed, or the
/// ship does
///                            not make way through the water
/// @throws std::domain_error  if a known noise or the memory is not positive
StateEstimate estimate_states(const Ship& ship, const Recording& run, const EstimationOptions& options = {});

/// Estimates what is not known of noise and process noise from several runs at once, for instance calm reference runs.
///
/// @throws  as estimate_states
NoiseEstimate estimate_noise(const Ship& ship, std::span<const Recording> runs, const EstimationOptions& options = {});

}  // namespace swayaw::identification
