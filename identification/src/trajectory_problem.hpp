#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "course.hpp"
#include "swayaw/identification/trajectory_fit.hpp"

/// What a trajectory fit works on. Not installed.
namespace swayaw::trajectory {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct TrajectoryProblem {
  std::vector<CourseRun> runs;
  std::vector<double> unit;       ///< time in which each run makes one ship length [s]
  std::vector<Channel> channels;  ///< measured in some run and used
  NumberList numbers;
  std::vector<double> low, high;  ///< of the numbers, SI
  std::unique_ptr<Sailor> sailor;
  double L, U;  ///< of the ship
  unsigned threads;
};

/// A stretch with its state at the beginning. A joined one is to end where the next begins.
struct Leg {
  Stretch stretch;
  std::size_t run;
  StateVector<double> start;
  bool joined;
};

/// What residuals are worth.
struct Weights {
  std::array<double, channel_count> noise{};  ///< standard deviation
  std::optional<double> robust;
};

/// @throws Refusal, std::domain_error  as fit_trajectories does
TrajectoryProblem problem_of(const Ship& ship, std::span<const Recording> runs, const TrajectoryFitOptions& options);

/// The runs cut into legs of about that many ship lengths, each beginning at its recorded state.
std::vector<Leg> legs_of(const TrajectoryProblem& problem, const Ship& ship, std::span<const Recording> runs,
                         double lengths);

/// Residuals over their noise, and in the robust case
///
///     r = e for |e| ≤ k,   sign(e) √(2k|e| − k²) beyond,   so that ½r² is Huber's loss
struct Weighted {
  Eigen::VectorXd residual;
  RowMatrix slope;  ///< empty if the course has none
};
Weighted weighted(const Course& course, const Stretch& stretch, const Weights& weights);

/// Ship units of x, y, psi, u, v, r: L, 1, U and U/L.
Eigen::Vector<double, 6> state_units(const TrajectoryProblem& problem);

/// F with F Fᵀ the covariance that white random accelerations add along a leg, P⁺ = Φ P Φᵀ + Q Δt from sample to
/// sample.
Matrix6 disturbance_factor(const TrajectoryProblem& problem, const Leg& leg, std::span<const double> values,
                           const PlanarAcceleration<double>& size);

}  // namespace swayaw::trajectory
