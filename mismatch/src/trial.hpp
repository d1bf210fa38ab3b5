#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "effect_forms.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "swayaw/nonlinear/coefficients.hpp"

/// A ship, her recorded runs, and the estimation of her parameters and of effects from them. Not installed.
namespace swayaw::inline mismatch::detail {

/// What is to be explained, and what is known before: the coefficients of the baseline as (value − mean)/deviation,
/// normal with a precision matrix.
struct Trial {
  Ship ship;
  std::vector<Parameter> parameters;    ///< of the baseline that may be a little wrong
  std::optional<EffectForm> lift_loss;  ///< of the rudder, part of the baseline
  Eigen::VectorXd mean;                 ///< of the baseline's coordinates
  Eigen::MatrixXd precision;
  std::vector<PreparedRun> runs;

  Eigen::Index baseline_size() const { return static_cast<Eigen::Index>(parameters.size()) + (lift_loss ? 1 : 0); }
};

/// The trial with parameters of the baseline that are known so many times less well.
Trial with_inflated_prior(Trial trial, double factor);

/// @param runs  must outlive the trial
Trial trial_of(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels);

/// Effects that act together.
using Hypothesis = std::vector<const EffectForm*>;

/// Unknowns: coordinates of the baseline, then of each effect. The trial must outlive the problem.
EstimationProblem problem_of(const Trial& trial, const Hypothesis& hypothesis);

/// The same of a ship in which nothing is unknown, for likelihoods of her.
EstimationProblem problem_of(const Trial& trial, const Ship& ship);

Ship ship_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point);

/// A point with the coordinates of one more effect.
Point with_start(const Point& before, std::span<const double> last_start);

/// Converged fit. @param known  slopes of the residuals by the first coordinates, near the start
MapFit fit(const Trial& trial, const Hypothesis& hypothesis, const Point& start, const Noise& noise,
           const Eigen::MatrixXd* known = nullptr, int rounds = 6);

/// A fitted hypothesis, linear about its most probable point.
LinearizedFit linearized(const Trial& trial, const Hypothesis& accepted, const MapFit& fit);

/// Gain in log evidence that a further effect predicts.
PredictedGain predicted_gain(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& before,
                             const EffectForm& form, std::span<const double> start, int iterations = 5);

/// What the runs tell of the coordinates of an effect about null, after the coefficients of the baseline took what they
/// can: JᵀMJ.
Eigen::MatrixXd information(const Trial& trial, const LinearizedFit& baseline, const EffectForm& form);

}  // namespace swayaw::mismatch::detail
