#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "effect_forms.hpp"
#include "prediction.hpp"
#include "swayaw/nonlinear/coefficients.hpp"

/// A ship, her recorded runs, and fits of her numbers and of effects to them. Not installed.
namespace swayaw {

/// What is to be explained, and what is known before: the baseline's numbers as (value − mean)/deviation, normal with a
/// precision matrix.
struct Trial {
  Ship ship;
  std::vector<Parameter> numbers;       ///< of the baseline that may be a little wrong
  std::optional<EffectForm> lift_loss;  ///< of the rudder, part of the baseline
  Eigen::VectorXd mean;                 ///< of the baseline's coordinates
  Eigen::MatrixXd precision;
  std::vector<PreparedRun> runs;

  Eigen::Index rows() const;
  Eigen::Index baseline_size() const { return static_cast<Eigen::Index>(numbers.size()) + (lift_loss ? 1 : 0); }
};

/// The trial with numbers of the baseline that are known so many times less well.
Trial doubted(Trial trial, double factor);

/// Largest scale of the imperfection that an adequate model leaves.
inline constexpr double ordinary_scale = 1.5;

/// Accelerations that no model has, as fractions of U²/L and U²/L².
OrdinaryImperfection imperfection(const Ship& ship, const Noise& noise);

/// @param runs  must outlive what is prepared of them
std::vector<PreparedRun> prepared_runs(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels);

/// @param runs  must outlive the trial
Trial trial_of(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels);

/// Channels of the runs that the diagnosis understands.
std::vector<Channel> seen_channels(std::span<const Recording> runs);

/// Effects that act together.
using Hypothesis = std::vector<const EffectForm*>;

/// Coordinates of the baseline, then of each effect.
using Point = Eigen::VectorXd;

/// The nearest point at which every coefficient of the baseline and every coordinate of the effects is in its range.
Point in_range(const Trial& trial, const Hypothesis& hypothesis, const Point& point);

Ship ship_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point);

/// A point with the coordinates of one more effect.
Point with_start(const Point& before, std::span<const double> last_start);

/// A hypothesis at its most probable point.
struct MapFit {
  Point point;
  double log_evidence = -HUGE_VAL;  ///< Laplace: ln p(runs | point) + ln prior + ½ ln det of the posterior covariance
  Noise noise;
  Eigen::MatrixXd covariance;  ///< of the point
};

/// Converged fit, the gains of the filter and the noise renewed as often as they change.
/// @param known  slopes of the residuals by the first coordinates, near the start: good enough for the first round
MapFit fit(const Trial& trial, const Hypothesis& hypothesis, const Point& start, Noise noise,
           const Eigen::MatrixXd* known = nullptr, int rounds = 6);

/// ln p(runs | ship); −∞ where the ship cannot sail like that.
double log_likelihood(const Trial& trial, const Ship& ship, const Noise& noise);

/// The same by run and sample.
/// @throws Refusal  where the ship cannot sail like that
std::vector<std::vector<double>> log_likelihoods(const Trial& trial, const Ship& ship, const Noise& noise);

/// The likelihood of a ship, at the noise that suits her best.
struct Likelihood {
  double log_likelihood;
  Noise noise;
};

/// @param every_channel  whether channels whose noise was as expected so far may prove noisier
Likelihood best_noise(const Trial& trial, const Ship& ship, const Noise& start, bool every_channel);

/// What a screening keeps of the fitted baseline: gains, residuals, and what its own numbers can explain.
struct Screen {
  Point baseline;
  std::vector<FilterPass> passes;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd slopes;   ///< J, of the residuals by the baseline
  Eigen::MatrixXd inverse;  ///< (JᵀJ + Λ)⁻¹ with the precision Λ of the prior
  Eigen::VectorXd pull;     ///< Λ (baseline − mean), by which the prior draws the baseline back

  /// M e, what is left of columns of changes of the residuals after the baseline's numbers took what they can: e − J
  /// (JᵀJ + Λ)⁻¹ Jᵀe.
  Eigen::MatrixXd projected(const Eigen::MatrixXd& e) const {
    return e - slopes * (inverse * (slopes.transpose() * e));
  }

  /// The same of the residuals themselves, of which the baseline takes the less the further it is from its mean: e − J
  /// (JᵀJ + Λ)⁻¹ (Jᵀe + pull).
  Eigen::VectorXd answered(const Eigen::VectorXd& e) const {
    return e - slopes * (inverse * (slopes.transpose() * e + pull));
  }

  /// Least sum of squares of residuals and prior that the baseline can reach from residuals e, but for a constant: eᵀe
  /// − gᵀ (JᵀJ + Λ)⁻¹ g, g = Jᵀe + pull.
  double cost(const Eigen::VectorXd& e) const {
    const Eigen::VectorXd g = slopes.transpose() * e + pull;
    return e.squaredNorm() - g.dot(inverse * g);
  }
};

Screen screen_of(const Trial& trial, const Hypothesis& accepted, const MapFit& null);

/// Log evidence of a trial's prior beside a screening of the same runs, its gains frozen and linear about its baseline;
/// differences are what counts: −½ (eᵀe + dᵀΛd − gᵀ(JᵀJ + Λ)⁻¹g) + ½ ln det Λ − ½ ln det(JᵀJ + Λ) with d = baseline −
/// mean, g = Jᵀe + Λd.
double linear_evidence(const Trial& trial, const Hypothesis& accepted, const Screen& screen);

/// What the runs tell of the coordinates of an effect about null, after the baseline's numbers took what they can:
/// JᵀMJ.
Eigen::MatrixXd information(const Trial& trial, const Screen& screen, const EffectForm& form);

/// Gain in log evidence that a further effect promises, with gains and baseline slopes frozen, and the coordinates
/// where it does.
struct Promise {
  double gain = -HUGE_VAL;
  std::vector<double> coordinates;
  Eigen::MatrixXd covariance;  ///< of the coordinates
};

Promise promise(const Trial& trial, const Hypothesis& accepted, const Screen& screen, const EffectForm& form,
                std::span<const double> start, int iterations = 5);

}  // namespace swayaw
