#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/identification/fit_report.hpp"
#include "swayaw/identification/measurement.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// The parameters of a nonlinear ship with which her simulation runs through recordings. docs/trajectory_fit.md
/// describes the method.
namespace swayaw::inline identification {

/// What a fit tells while it works.
struct TrajectoryProgress {
  int iteration;
  double log_likelihood;           ///< of the segments as they are, which may not fit together yet
  double change;                   ///< of numbers and starts in the last step, relative to their size
  std::span<const double> values;  ///< of the parameters fitted, SI
};

struct TrajectoryFitOptions {
  std::vector<std::string> parameters;  ///< to be fitted, by name as in parameters_of: "N_v", "rudder.x_prime"
  std::vector<Channel> channels = {};   ///< to fit to, of measured_channels; empty: all that a run has
  MeasurementNoise noise = {};          ///< known noise; otherwise estimated
  double segment = 0.5;  ///< length of the segments in which the runs are sailed [ship lengths], shorter where the ship
                         ///< that is given leaves the recording before; infinite: none, single shooting
  bool priors = false;   ///< the parameters as given, with the ship's confidence, count as measurements
  std::optional<double> robust =
      {};              ///< residuals beyond so many standard deviations count with their size, not its square: 1.345
  double step = 0.04;  ///< longest step of the integration [ship lengths]
  int most_iterations = 100;
  unsigned threads = 0;  ///< that simulate segments side by side; 0 for one on each core
  std::function<bool(const TrajectoryProgress&)> progress =
      {};  ///< after each iteration; false ends the fit with the best so far
};

enum class TrajectoryFitStatus {
  converged,
  iteration_limit,  ///< the parameters are the best found
  stopped,          ///< by `progress`; the parameters are the best found
  rank_deficient,   ///< some combination of the parameters does not show in the recordings at all
};

struct FittedParameter {
  std::string name;
  double before;      ///< value in the ship that was given, SI
  Estimate estimate;  ///< SI
  bool at_bound;      ///< the value is the last one that her model accepts
};

/// What a run leaves unexplained in a channel.
struct ChannelResiduals {
  Channel channel;
  std::size_t count;
  double before;           ///< rms with the ship that was given, from the recorded start
  double after;            ///< rms with the fitted ship
  double autocorrelation;  ///< of successive residuals: near 0 where the model and the noise are right
  double effective_count;  ///< number of independent residuals that tell as much: count (1 − autocorrelation)/(1 +
                           ///< autocorrelation)
};

struct FittedRun {
  std::string name;
  ShipState<double> start;  ///< fitted, at the first sample
  std::vector<ChannelResiduals> channels;
};

struct TrajectoryFit {
  Ship ship;  ///< with the fitted parameters
  TrajectoryFitStatus status;
  std::vector<FittedParameter> parameters;  ///< in the order of the options
  std::vector<std::vector<double>>
      covariance;  ///< of the parameters; not a number where the recordings do not tell them
  std::vector<std::vector<double>> correlation;
  double condition_number;       ///< largest over smallest relative standard error of combinations of the parameters
  std::string best_combination;  ///< which product of powers is known best, "|Y_v|^0.71 |N_v|^-0.70 to 0.4 %"
  std::vector<std::string> undetermined;  ///< those with a relative error of 50 % and more, worst first
  MeasurementNoise noise;                 ///< of the channels used: known or estimated
  double log_likelihood;
  std::vector<FittedRun> runs;
  int iterations;
  double sensitivities;  ///< how often all runs were simulated with derivatives
};

/// Parameters of a ship fitted to recordings by multiple shooting; each run starts from a state that is fitted too.
///
/// Maximum likelihood of white measurement noise around the simulated run (output errors), with exact derivatives of
/// the simulation by start and parameters. Rudder, propulsion and measured wind are those of the recording; parameters
/// are those of the depth in which it was sailed. Effects of the ship act as they do in replays. Standard errors allow
/// for residuals that are correlated over a part of a ship length.
///
/// @throws Refusal            if there is nothing to fit or to fit to, a number does not exist, a run has no rudder
/// angle or does not tell
///                            its speed, or the ship that was given cannot be simulated
/// @throws std::domain_error  if a known noise, the segment, the step or `robust` is not positive
TrajectoryFit fit_trajectories(const Ship& ship, std::span<const Recording> runs, const TrajectoryFitOptions& options);

/// The same for one recording.
TrajectoryFit fit_trajectories(const Ship& ship, const Recording& run, const TrajectoryFitOptions& options);

}  // namespace swayaw::identification
