#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "swayaw/identification/segment_simulator.hpp"
#include "swayaw/identification/trajectory_fit.hpp"

/// What a trajectory fit works on. Not installed.
namespace swayaw::inline identification::detail {

struct TrajectoryProblem {
  std::vector<SampledRun> runs;
  std::vector<double> unit;       ///< time in which each run makes one ship length [s]
  std::vector<Channel> channels;  ///< measured in some run and used
  std::vector<Parameter> parameters;
  std::vector<double> low, high;  ///< of the parameters, SI
  std::unique_ptr<SegmentSimulator> simulator;
  double L, U;  ///< of the ship
  unsigned threads;
};

/// A segment with its state at the beginning. A joined one is to end where the next begins.
struct ShootingSegment {
  RunSegment part;
  std::size_t run;
  Eigen::VectorXd start;  ///< of the first segment of a run the six states of her motion, of others all
  bool joined;
};

/// What residuals are worth.
struct Weights {
  std::array<double, channel_count> noise{};  ///< standard deviation
  std::optional<double> robust;
};

/// @throws Refusal, std::domain_error  as fit_trajectories does
TrajectoryProblem problem_of(const Ship& ship, std::span<const Recording> runs, const TrajectoryFitOptions& options);

/// The runs cut into segments of about that many ship lengths, each beginning at its recorded state.
std::vector<ShootingSegment> segments_of(const TrajectoryProblem& problem, const Ship& ship,
                                         std::span<const Recording> runs, double lengths);

/// Residuals over their noise, and in the robust case
///
///     r = e for |e| ≤ k,   sign(e) √(2k|e| − k²) beyond,   so that ½r² is Huber's loss
struct Weighted {
  Eigen::VectorXd residual;
  RowMatrix slope;  ///< empty if the response has none
};
Weighted weighted(const SegmentResponse& response, const RunSegment& segment, const Weights& weights);

/// Ship units of x, y, psi, u, v, r, and of the hidden states of effects: L, 1, U and U/L.
Eigen::VectorXd state_units(const TrajectoryProblem& problem);

}  // namespace swayaw::identification::detail
