#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/identification/noise.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Unknowns of any kind estimated together from recorded runs: coefficients of a ship, effects, surroundings,
/// instruments. Maximum of the posterior of all of them under a Kalman filter that carries what no model gets right,
/// and its evidence. docs/estimation.md describes the method.
namespace swayaw::inline identification {

/// A recorded run made ready once for many fits.
struct PreparedRun {
  std::shared_ptr<const Recording> run;               ///< without outliers, and without samples between fixes
  std::vector<Channel> channels;                      ///< that are compared
  std::array<double, channel_count> deviation{};      ///< of their white noise, where third differences and the step of
                                                      ///< rounding tell all of it
  ShipState<double> start;                            ///< recorded; little is known of it
  Eigen::Index measurements;                          ///< samples of these channels that are there
  double longest_step;                                ///< of the filter, in ship lengths of way
  double heel = 0.0;                                  ///< root mean square of what was recorded [rad]
  std::shared_ptr<const Recording> finer_controls{};  ///< the same run with more rows, where they are too few in `run`
                                                      ///< to tell rudder and propulsion between them

  Eigen::Index rows() const { return measurements; }
};

/// The oscillations by which waves move a ship along a run, as her yaw rate shows them.
class WaveMotion {
 public:
  /// One that is fitted beside a parabola and left out.
  struct Oscillation {
    double period = 0.0;  ///< [s]; 0 where there is none
    double half = 0.0;    ///< of a window that tells the two apart, no longer than a parabola follows the ship [s]
  };

  /// @param run        need not outlive this
  /// @param time_unit  L/U [s]
  WaveMotion(const Recording& run, double time_unit);

  /// Whether waves move her.
  bool exists() const { return !times_.empty(); }

  /// What they add to a channel, root mean square in its unit: the channel less parabolas beside the oscillations; of
  /// waves of most of L/U less parabolas over one and a half, which follow the ship but in the first moments of a turn.
  /// 0 where no waves move her.
  ///
  /// @param values  a number for each sample of the run
  double size_in(std::span<const double> values) const;

 private:
  double half_ = 0.0;          ///< of parabolas, where waves are too long to be told from the ship's motion [s]; or 0
  std::vector<double> times_;  ///< of as few samples as tell them
  std::size_t every_ = 1;      ///< of so many samples of the run
  std::vector<Oscillation> oscillations_;  ///< at every few of the times
};

/// With all samples, but of a heel one in four L/U: what its equation leaves out lasts as long as the motion.
std::vector<PreparedRun> prepared_runs(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels);

/// The same with as few samples as tell what they tell: parabolas over an eighth of L/U, as
/// many in that time; where waves move her over one and a half of their periods, if she is steady for so long, with an
/// oscillation beside it that is left out, and fewer; rows of controls three times as many.
std::vector<PreparedRun> lean_runs(const Ship& ship, std::span<const Recording> runs,
                                   std::span<const Channel> channels);

/// Prepared runs, those of more than 48 rows in L/U thinned to half as many values, each of a parabola through all
/// samples about it.
std::vector<PreparedRun> thinned_runs(const Ship& ship, std::span<const Recording> runs,
                                      std::span<const Channel> channels);

/// One unknown: its value is `mean` where nothing is known, and stays between its bounds.
struct Unknown {
  std::string name;
  double mean = 0.0;
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  double step = 0.2;  ///< of differences, over which residuals are about linear
};

/// Values of all unknowns, in their order.
using Point = Eigen::VectorXd;

/// What is unknown, what is known of it before, and the runs that are to tell.
///
/// An unknown has the scope of the runs whose ship it changes: `ship_in` is asked for each run.
struct EstimationProblem {
  std::vector<Unknown> unknowns;
  Eigen::MatrixXd precision;  ///< of the normal prior about the means
  std::span<const PreparedRun> runs;
  std::function<Ship(const Point& point, std::size_t run)> ship_in;  ///< the ship that sailed a run
  const Ship& scale;                                                 ///< whose length and speed give units of noise

  Eigen::Index size() const { return static_cast<Eigen::Index>(unknowns.size()); }
  Eigen::Index rows() const;
  Eigen::VectorXd mean() const { return of_each(&Unknown::mean); }
  Eigen::VectorXd low() const { return of_each(&Unknown::low); }
  Eigen::VectorXd high() const { return of_each(&Unknown::high); }
  Point within_bounds(const Point& point) const { return point.cwiseMax(low()).cwiseMin(high()); }

  /// (p − mean)ᵀ Λ (p − mean)
  double prior(const Point& point) const;

 private:
  Eigen::VectorXd of_each(double Unknown::*value) const;
};

/// The most probable point of a problem.
struct MapFit {
  Point point;
  double log_evidence = -HUGE_VAL;  ///< Laplace: ln p(runs | point) + ln prior + ½ ln det of the posterior covariance
  Noise noise;
  Eigen::MatrixXd covariance;   ///< of the point
  Eigen::MatrixXd information;  ///< of the runs alone: the inverse of the covariance less the precision before them
};

struct FitOptions {
  const Eigen::MatrixXd* known = nullptr;  ///< slopes of the residuals by the first unknowns, near the start: good
                                           ///< enough for the first round
  int rounds = 6;
  bool to_rank = false;      ///< no closer than it takes to tell it from others: within 5 in log evidence
  bool noise_stays = false;  ///< as it was at the start
};

/// Converged fit, the gains of the filter and the noise renewed as often as they change.
/// @param fixed  how many unknowns come first whose slopes hardly change, worked out once a round
MapFit fit(const EstimationProblem& problem, const Point& start, Noise noise, Eigen::Index fixed,
           const FitOptions& options = {});

/// ln p(runs | point); −∞ where the ship cannot sail like that.
double log_likelihood(const EstimationProblem& problem, const Point& point, const Noise& noise);

/// The same by run and sample.
/// @throws Refusal  where the ship cannot sail like that
std::vector<std::vector<double>> log_likelihoods(const EstimationProblem& problem, const Point& point,
                                                 const Noise& noise);

/// The likelihood of a point, at the noise that suits it best.
struct Likelihood {
  double log_likelihood;
  Noise noise;
};

/// @param every_channel  whether channels whose noise was as expected so far may prove noisier
Likelihood best_noise(const EstimationProblem& problem, const Point& point, const Noise& start, bool every_channel);

// ---------------------------------------------------------------- further unknowns, linear in the first ones

struct FilteredRuns;  ///< gains of the filter in each run

/// A fitted problem, linear about its most probable point: what its own unknowns can explain of anything.
struct LinearizedFit {
  Point point;
  std::shared_ptr<const FilteredRuns> passes;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd slopes;       ///< J, of the residuals by the unknowns
  Eigen::MatrixXd information;  ///< JᵀJ
  Eigen::MatrixXd inverse;      ///< (JᵀJ + Λ)⁻¹ with the precision Λ of the prior
  Eigen::VectorXd pull;         ///< Λ (point − mean), by which the prior draws the unknowns back

  /// M e, what is left of columns of changes of the residuals after the unknowns took what they can:
  /// e − J (JᵀJ + Λ)⁻¹ Jᵀe.
  Eigen::MatrixXd projected(const Eigen::MatrixXd& e) const {
    return e - slopes * (inverse * (slopes.transpose() * e));
  }

  /// The same of the residuals themselves, of which the unknowns take the less the further they are from their mean:
  /// e − J (JᵀJ + Λ)⁻¹ (Jᵀe + pull).
  Eigen::VectorXd answered(const Eigen::VectorXd& e) const {
    return e - slopes * (inverse * (slopes.transpose() * e + pull));
  }

  /// Least sum of squares of residuals and prior that the unknowns can reach from residuals e, but for a constant:
  /// eᵀe − gᵀ (JᵀJ + Λ)⁻¹ g, g = Jᵀe + pull.
  double cost(const Eigen::VectorXd& e) const {
    const Eigen::VectorXd g = slopes.transpose() * e + pull;
    return e.squaredNorm() - g.dot(inverse * g);
  }
};

LinearizedFit linearized(const EstimationProblem& problem, const MapFit& fit);

/// The same linearization beside the prior of another problem.
LinearizedFit with_prior_of(const EstimationProblem& problem, LinearizedFit linear);

/// Log evidence of a problem's prior beside a linearization of the same runs; differences are what counts:
/// −½ (eᵀe + dᵀΛd − gᵀ(JᵀJ + Λ)⁻¹g) + ½ ln det Λ − ½ ln det(JᵀJ + Λ) with d = point − mean, g = Jᵀe + Λd.
double linear_evidence(const EstimationProblem& problem, const LinearizedFit& fit);

/// What further unknowns gain, gains of the filter and slopes of the first ones as they are.
struct PredictedGain {
  double gain = -HUGE_VAL;  ///< in log evidence
  std::vector<double> values;
  Eigen::MatrixXd covariance;  ///< of the further unknowns
};

/// @param problem  with the unknowns of the linearized fit first
/// @param start    of the further ones
PredictedGain predicted_gain(const EstimationProblem& problem, const LinearizedFit& before,
                             std::span<const double> start, int iterations = 5);

/// Changes of the residuals by the further unknowns from these values on, by differences of that step.
Eigen::MatrixXd further_slopes(const EstimationProblem& problem, const LinearizedFit& before,
                               std::span<const double> from, double step);

}  // namespace swayaw::identification
