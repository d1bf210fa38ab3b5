#pragma once

#include "trajectory_shooting.hpp"

/// The search for the most likely parameters. Not installed.
namespace swayaw::inline identification::detail {

/// What a search works with.
struct SearchTask {
  const TrajectoryProblem& problem;
  const std::vector<ShootingSegment>& segments;
  const TrajectoryFitOptions& options;
  Eigen::VectorXd prior;  ///< weight of the parameters as given
  Eigen::VectorXd unit;   ///< size of a large change of each number
};

/// How a search ended, and where.
struct Found {
  Linearization at;
  Weights weights;
  Iterate iterate;
  TrajectoryFitStatus status;
  bool stuck;  ///< no step led nearer to where segments fit together
  int iterations;
  double sensitivities;  ///< how often all runs were simulated with derivatives
};

Found search_from(const SearchTask& task, const Iterate& start);

/// −½ Σ (e²/σ² + ln 2πσ²)
double log_likelihood(const std::vector<ShootingSegment>& segments, const std::vector<SegmentResponse>& responses,
                      const Weights& weights);

}  // namespace swayaw::identification::detail
