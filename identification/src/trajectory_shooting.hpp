#pragma once

#include "trajectory_problem.hpp"

/// Multiple shooting: legs that need not fit together while the numbers are looked for. Not installed.
namespace swayaw::trajectory {

/// A symmetric matrix by its axes, measured in units that make its diagonal 1.
class Axes {
 public:
  explicit Axes(const Eigen::MatrixXd& A);

  /// A⁻¹ on the axes that are not nothing.
  Eigen::MatrixXd inverse() const;

  bool full_rank() const { return told(0); }

  /// Share of a coordinate that lies on axes of length 0.
  double untold(Eigen::Index coordinate) const;

 private:
  bool told(Eigen::Index i) const { return length_[i] > 1e-11; }

  Eigen::VectorXd unit_;    ///< multiplies coordinates
  Eigen::VectorXd length_;  ///< in increasing order
  Eigen::MatrixXd axis_;
};

/// Where a fit is.
struct Place {
  std::vector<double> values;               ///< of the numbers
  std::vector<StateVector<double>> starts;  ///< of the legs
  std::vector<Eigen::Vector<double, 6>>
      pushes;  ///< at the end of each leg, in standard deviations; zero without disturbance
};

/// A change of place.
struct Move {
  Eigen::VectorXd values;
  std::vector<Eigen::Vector<double, 6>> starts, pushes;
};

Place moved(const Place& from, const Move& move, double share);

/// Courses of all legs, all in numbers or none.
std::vector<Course> sail_legs(const TrajectoryProblem& problem, const std::vector<Leg>& legs, const Place& place,
                              bool with_slopes);
bool finite(std::span<const Course> courses);

/// Legs linearized about a place, with the starts of all but the first leg of each run eliminated.
///
/// The start of leg i follows from what begins the run and from the numbers, δs_i = A_i δz + a_i with z = (s_0, pushes,
/// numbers):
///
///     A_{i+1} = Φ_i A_i + Γ_i + F_i,   a_{i+1} = Φ_i a_i + (end_i + F_i w_i − s_{i+1})
///
/// so that the normal equations hold the starts and pushes of each run, and the numbers, only. With all defects closed
/// these are the equations of single shooting. Source: [Bock1981], condensing
class Linearization {
 public:
  /// @param disturbance  F of each leg; empty without
  Linearization(const TrajectoryProblem& problem, const std::vector<Leg>& legs, Place place,
                std::vector<Course> courses, const Weights& weights, std::vector<Matrix6> disturbance,
                const Eigen::VectorXd& prior);

  /// The move of Gauss and Newton from here, with `damping` added to the information of the numbers. Numbers whose
  /// place in `held` is finite move by that much.
  Move step(const Eigen::VectorXd& damping, const Eigen::VectorXd& held) const {
    return step(place_, courses_, damping, held);
  }

  /// The move from another place with the derivatives of this one.
  Move step(const Place& place, const std::vector<Course>& courses, const Eigen::VectorXd& damping,
            const Eigen::VectorXd& held) const;

  /// How much likelier the linearized legs are after a move, as a square of standard deviations.
  double gain(const Move& move) const;

  const Place& place() const { return place_; }
  const std::vector<Course>& courses() const { return courses_; }
  const Eigen::VectorXd& prior() const { return prior_; }
  const Eigen::MatrixXd& information() const {
    return information_;
  }  ///< of the numbers, starts and pushes being unknown

  /// Scores of the numbers for each run, sample by sample, with what starts and pushes take from them.
  std::vector<std::vector<Eigen::VectorXd>> scores() const;

 private:
  struct Run {
    std::size_t first, beyond;           ///< its legs
    RowMatrix rows;                      ///< weighted residuals by (start, pushes, numbers)
    std::vector<Eigen::MatrixXd> A;      ///< of each leg
    std::vector<RowMatrix> by_start;     ///< weighted residuals of each leg by its start
    Eigen::MatrixXd own_inverse, mixed;  ///< information of start and pushes, inverted; of these and the numbers
    Eigen::MatrixXd taken;               ///< mixedᵀ own_inverse
  };

  Run run_of(std::size_t first, std::size_t beyond) const;
  Eigen::Index own(const Run& run) const;
  bool pushed() const { return !disturbance_.empty(); }
  std::vector<Eigen::Vector<double, 6>> drifts(const Run& run, const Place& place,
                                               const std::vector<Course>& courses) const;
  Eigen::VectorXd residual(const Run& run, const Place& place, const std::vector<Course>& courses) const;
  Eigen::VectorXd push_gradient(const Run& run, const Place& place, const Eigen::VectorXd& gradient) const;

  const TrajectoryProblem& problem_;
  const std::vector<Leg>& legs_;
  Place place_;
  std::vector<Course> courses_;
  Weights weights_;
  std::vector<Matrix6> disturbance_;
  Eigen::VectorXd prior_;  ///< weight of the numbers as given
  Eigen::Index n_;         ///< numbers
  std::vector<Run> runs_;
  Eigen::MatrixXd information_;
};

}  // namespace swayaw::trajectory
