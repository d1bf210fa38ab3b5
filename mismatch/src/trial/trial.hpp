#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
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
  std::vector<Parameter> parameters;  ///< of the baseline that may be a little wrong
  std::vector<EffectForm> ordinary;   ///< what every ship and every instrument has a little of; part of the baseline
  Eigen::VectorXd mean;               ///< of the baseline's coordinates
  Eigen::MatrixXd precision;
  std::vector<PreparedRun> runs;
  /// Of a run that is alone, if each is long enough to tell what the other predicts.
  std::vector<PreparedRun> halves{};
  bool calibrated = false;      ///< on reference runs, which tell the form: then its size is no question
  double reference_heel = 0.0;  ///< root mean square heel of the reference runs [rad], 0 where none is recorded

  Eigen::Index baseline_size() const {
    auto size = std::ssize(parameters);
    for (const auto& form : ordinary) size += std::ssize(form.coordinates);
    return size;
  }

  /// What a fit to all others but one may be asked to predict: the runs, or the halves of one; or nothing.
  std::span<const PreparedRun> parts() const { return runs.size() > 1 ? runs : halves; }
};

/// The prior of a trial anew: coefficients in their deviations from the ship file, what is ordinary about its mean.
void put_prior(Trial& trial);

/// Effects that act together.
using Hypothesis = std::vector<const EffectForm*>;

/// One more effect.
Hypothesis with(Hypothesis hypothesis, const EffectForm& form);

/// Where the coordinates of one of the effects begin in a point.
Eigen::Index place_in_point(const Trial& trial, const Hypothesis& hypothesis, std::size_t effect);

/// The trial with parameters of the baseline that are known so many times less well, but no worse than theory tells.
Trial with_inflated_prior(Trial trial, double factor);

/// The precision matrix of a prior whose deviations are wider by these factors, one for each coordinate.
Eigen::MatrixXd with_wider_prior(const Eigen::MatrixXd& precision, const Eigen::VectorXd& factors);

/// What the log evidence of a converged fit gains by another prior of the first coordinates, its data as they are,
/// linear about the point; what stands at an end of its range stays there.
double gain_by_prior(const EstimationProblem& problem, const MapFit& fit, const Eigen::MatrixXd& precision);

/// Root mean square of the heel that runs record [rad], 0 where they record none.
double heel_of(std::span<const PreparedRun> runs);

/// Whether an effect explains a heel that was recorded.
bool explains_heel(const Trial& trial, const EffectForm& form);

Trial trial_of(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels);

/// The trial of a ship on board of whom nothing is exact: the form of her forces, her instruments, and the light air
/// and stream of every day are part of the baseline, each with a prior of ordinary size.
Trial as_on_board(Trial trial, std::span<const Recording> runs, std::span<const Channel> channels);

/// How large the form of her forces may be wrong, over its usual size: along, across, of the moment, a constant force
/// from side to side, what the rudder differs by from side to side, and along, straight ahead at service speed.
using FormSizes = std::array<double, 6>;
inline constexpr FormSizes usual_sizes{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

/// The trial with a form of these sizes in place of the usual ones.
Trial with_form_sizes(Trial usual, const FormSizes& sizes);

/// Sizes of the form that make a converged fit likeliest, and what its log evidence gains by them.
struct LikelyForm {
  FormSizes sizes;
  double gain;
};

/// @param usual  the trial with a form of usual size
/// @param now    the trial of the fit
LikelyForm likely_form(const Trial& usual, const Trial& now, const FormSizes& sizes, const Hypothesis& hypothesis,
                       const MapFit& fit);

/// The same effect, of the same channel if it is of one, whatever its scope.
bool is_same_effect(const EffectForm& a, const EffectForm& b);

/// Whether an effect stands in the place of something ordinary: it is the same, or takes the lift of the rudder as that
/// does, or is a lag where that is a delay.
bool stands_for(const EffectForm& form, const EffectForm& ordinary);

/// What is ordinary, and where its coordinates begin in the baseline.
struct OrdinaryPlace {
  const EffectForm* form;
  Eigen::Index first;

  Eigen::Index size() const { return std::ssize(form->coordinates); }

  std::span<const double> coordinates(const Point& point) const {
    return {point.data() + first, form->coordinates.size()};
  }
};

/// All that is ordinary, in the order of the baseline.
std::vector<OrdinaryPlace> ordinary_places(const Trial& trial);

/// Coordinates of the baseline in whose place an effect would stand: then they change nothing.
std::vector<Eigen::Index> replaced_by(const Trial& trial, const EffectForm& form);

/// What is ordinary, as it was found, in the place of which an effect would stand; nothing if there is none.
std::optional<Effect> in_whose_place(const Trial& trial, const EffectForm& form, const Point& point);

/// How many coordinates of the baseline come first that are of the ship and not of a day or an instrument.
Eigen::Index ship_size(const Trial& trial);

/// Coordinates of the baseline that are of the form of her forces, by their place in `FormSizes`; −1 for others.
std::vector<int> form_axes(const Trial& trial);

/// Unknowns: coordinates of the baseline, then of each effect. The trial must outlive the problem.
EstimationProblem problem_of(const Trial& trial, const Hypothesis& hypothesis);

/// The same of a ship in which nothing is unknown, for likelihoods of her.
EstimationProblem problem_of(const Trial& trial, const Ship& ship);

/// The ship with the coefficients of a point, without what is ordinary and without the effects of a hypothesis.
Ship bare_ship_at(const Trial& trial, const Point& point);

/// @param run  that she sails; without one, effects that differ from run to run are as in the mean of all
Ship ship_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const Recording* run = nullptr);

/// Which effects a ship is to have, of those that are ordinary and of those of a hypothesis.
using WantedEffect = std::function<bool(const Effect& effect, bool ordinary)>;

/// The same with some of what is ordinary and of the effects alone.
Ship ship_with(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const Recording* run,
               const WantedEffect& wanted);

/// The same without what is ordinary of a day or an instrument: what a ship file is to hold.
Ship model_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point);

/// How large the ordinary error is in the place of which an effect stands, in its first parameter that decides; 0 where
/// it stands in the place of none. What was found holds both, and nothing tells them apart.
double ordinary_size(const Trial& trial, const EffectForm& form);

/// How many ordinary deviations an effect is from null that stands in the place of something ordinary, in the part of
/// the runs where it is largest; infinity for others, and for what does more by further parameters: a gear that is
/// slow, too, is more than one of an ordinary lag.
double ordinary_deviations(const Trial& trial, const EffectForm& form, std::span<const double> coordinates);

/// Something ordinary as a fit found it.
struct OrdinaryEstimate {
  Effect effect;
  double value, standard_error;  ///< of its only parameter, from null
  std::string_view key;
};

/// Errors of instruments that are part of the baseline and that no effect stands for.
std::vector<OrdinaryEstimate> ordinary_instruments(const Trial& trial, const Hypothesis& hypothesis, const MapFit& fit);

/// A point with the coordinates of one more effect.
Point with_start(const Point& before, std::span<const double> last_start);

/// Converged fit.
MapFit fit(const Trial& trial, const Hypothesis& hypothesis, const Point& start, const Noise& noise,
           const FitOptions& options = {});

/// A fitted hypothesis, linear about its most probable point.
LinearizedFit linearized(const Trial& trial, const Hypothesis& accepted, const MapFit& fit);

/// Gain in log evidence that a further effect predicts.
PredictedGain predicted_gain(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& before,
                             const EffectForm& form, std::span<const double> start, int iterations = 5);

/// What the runs tell of the coordinates of an effect about null, after the coefficients of the baseline took what they
/// can: JᵀMJ.
Eigen::MatrixXd information(const Trial& trial, const LinearizedFit& baseline, const EffectForm& form);

}  // namespace swayaw::mismatch::detail
