#pragma once

#include <memory>

#include "../filter/run_filter.hpp"
#include "swayaw/identification/map_fit.hpp"

/// All runs of a problem under the filter, whatever the model. Not installed.
namespace swayaw::inline identification {

struct FilteredRuns {
  std::vector<detail::FilteredRun<9>> runs;

  double log_likelihood() const;
};

/// @param before  passes whose controls are used again where the ship takes them alike
/// @throws Refusal  where a ship cannot sail her run
std::shared_ptr<const FilteredRuns> filtered(const EstimationProblem& problem, const Point& point, const Noise& noise,
                                             const FilteredRuns* before = nullptr);

/// Slopes of the log likelihood of passes by the logarithms of the variances: of the white noise of each channel, of
/// what positions wander, of the process noise.
detail::FilterNoise log_likelihood_slope(const EstimationProblem& problem, const Point& point, const Noise& noise,
                                         const FilteredRuns& passes);

/// How many noises of each kind the passes show: of a channel (R/S)² in each sample, with its variance R in that of the
/// innovation S; of the process, and of what positions wander, one in the time that the ship takes to follow it.
detail::FilterNoise noises_seen(const EstimationProblem& problem, const Noise& noise, const FilteredRuns& passes);

/// Residuals of all runs at a point with the gains of passes.
/// @throws Refusal  where a ship cannot sail her run
Eigen::VectorXd residuals(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes);

/// The same, huge where a ship cannot sail or her motion runs away.
Eigen::VectorXd residuals_if_any(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes);

/// Columns of d(residuals)/d(point) by differences over the steps of their unknowns. @param here  residuals at the
/// point
void difference(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes,
                const Eigen::VectorXd& here, std::span<const Eigen::Index> columns, Eigen::MatrixXd& slopes);

/// Columns of d(residuals)/d(point) from `first` on: by the tangent of the filter where they are many, which is exact;
/// by differences where they are few, and those of unknowns in which the residuals are not smooth.
void renew_slopes(const EstimationProblem& problem, const Point& point, const FilteredRuns& passes,
                  const Eigen::VectorXd& here, Eigen::Index first, Eigen::MatrixXd& slopes);

namespace detail {

/// The same as `best_noise` of problems that follow each other.
/// @param covariance  of the logarithms of all sizes, as the search before showed it; empty at first
Likelihood best_noise(const EstimationProblem& problem, const Point& point, const Noise& start, bool every_channel,
                      Eigen::MatrixXd& covariance);

}  // namespace detail

}  // namespace swayaw::identification
