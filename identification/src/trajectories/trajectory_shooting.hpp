#pragma once

#include "trajectory_problem.hpp"

/// Multiple shooting: segments that need not fit together while the parameters are looked for. Not installed.
namespace swayaw::inline identification::detail {

/// Information over the largest that counts as none.
inline constexpr double no_information = 1e-12;

/// Where a fit is.
struct Iterate {
  std::vector<double> values;           ///< of the parameters
  std::vector<Eigen::VectorXd> starts;  ///< of the segments
};

/// From an iterate to another.
struct Step {
  Eigen::VectorXd values;
  std::vector<Eigen::VectorXd> starts;
};

Iterate moved(const Iterate& from, const Step& move, double share);

/// Responses of all segments, with or without slopes.
std::vector<SegmentResponse> simulated(const TrajectoryProblem& problem, const std::vector<ShootingSegment>& segments,
                                       const Iterate& iterate, bool with_slopes);
bool finite(std::span<const SegmentResponse> responses);

/// Segments linearized about an iterate, with the starts of all but the first segment of each run eliminated.
///
/// The start of segment i follows from what begins the run and from the parameters, δs_i = A_i δz + a_i with z = (s_0,
/// parameters):
///
///     A_{i+1} = Φ_i A_i + Γ_i,   a_{i+1} = Φ_i a_i + (end_i − s_{i+1})
///
/// so that the normal equations hold the start of each run, and the parameters, only. With all defects closed these are
/// the equations of single shooting. Source: [Bock1981], condensing
class Linearization {
 public:
  Linearization(const TrajectoryProblem& problem, const std::vector<ShootingSegment>& segments, Iterate iterate,
                std::vector<SegmentResponse> responses, const Weights& weights, const Eigen::VectorXd& prior);

  /// The move of Gauss and Newton from here, with `damping` added to the information of the parameters, which stay in
  /// their range.
  Step step(const Eigen::VectorXd& damping) const { return step(at_, responses_, damping); }

  /// The move from another iterate with the derivatives of this one.
  Step step(const Iterate& iterate, const std::vector<SegmentResponse>& responses,
            const Eigen::VectorXd& damping) const;

  /// How much likelier the linearized segments are after a move, as a square of standard deviations.
  double gain(const Step& move) const;

  const Iterate& iterate() const { return at_; }
  const std::vector<SegmentResponse>& responses() const { return responses_; }
  const Eigen::VectorXd& prior() const { return prior_; }

  /// Of the parameters, the starts being unknown.
  const Eigen::MatrixXd& information() const { return information_; }

  /// Scores of the parameters for each run, sample by sample, with what the starts take from them.
  std::vector<std::vector<Eigen::VectorXd>> scores() const;

 private:
  struct Run {
    std::size_t first, beyond;             ///< its segments
    RowMatrix rows;                        ///< weighted residuals by (start, parameters)
    std::vector<Eigen::MatrixXd> A;        ///< of each segment
    std::vector<RowMatrix> by_start;       ///< weighted residuals of each segment by its start
    Eigen::MatrixXd start_inverse, mixed;  ///< information of the start, inverted; of start and parameters
    Eigen::MatrixXd taken;                 ///< mixedᵀ start_inverse
  };

  Run run_of(std::size_t first, std::size_t beyond) const;
  std::vector<Eigen::VectorXd> drifts(const Run& run, const Iterate& iterate,
                                      const std::vector<SegmentResponse>& responses) const;
  Eigen::VectorXd residual(const Run& run, const Iterate& iterate, const std::vector<SegmentResponse>& responses) const;

  const TrajectoryProblem& problem_;
  const std::vector<ShootingSegment>& segments_;
  Iterate at_;
  std::vector<SegmentResponse> responses_;
  Weights weights_;
  Eigen::VectorXd prior_;  ///< weight of the parameters as given
  Eigen::Index n_;         ///< parameters
  std::vector<Run> runs_;
  Eigen::MatrixXd information_;
};

}  // namespace swayaw::identification::detail
