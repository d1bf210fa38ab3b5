#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "location.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "trial.hpp"

/// The search for effects that a ship lacks: all are screened, the best are fitted until they converge, runs that were
/// not used decide. Not installed.
namespace swayaw::inline mismatch::detail {

/// A candidate, fitted beside the effects that are accepted already.
struct FittedCandidate {
  const EffectForm* form;
  MapFit fit;
  double gain;  ///< in log evidence, the terms that it does better without left out; less where it has no name
  Effect effect;
  bool trace;                            ///< too small to matter, not told from nothing, or larger than it can be
  std::optional<double> held_out{};      ///< gain in log likelihood of held-out runs, where they were asked
  std::optional<double> as_elsewhere{};  ///< the gain in log evidence with the likelihood that those gain, or each run
                                         ///< by a fit to the others, for as many rows; beside an inexact form alone
  bool refuted = false;                  ///< by runs that were not used
  bool as_form = false;                  ///< accepted, and then no more than an error in the form of her forces
  bool leads = false;                    ///< a trace that was accepted: its share of the probability is that of nothing
  FormSizes sizes = usual_sizes;         ///< of the form beside it
  std::vector<double>
      widening{};  ///< of the deviation of each coordinate, for terms that were tried with it and dropped
};

/// A candidate that promised too little to be fitted.
struct UnfittedCandidate {
  const EffectForm* form;
  double predicted_gain;  ///< in log evidence
  bool may_matter;        ///< within two deviations of what was predicted it is larger than its practical floor
  double least_odds = 0;  ///< to nothing, whatever was predicted
};

/// Whether an effect explains a heel that was recorded.
bool explains_heel(const Trial& trial, const EffectForm& form);

/// Factor on the prior deviations of the baseline's coefficients where the runs speak against them.
inline constexpr double inflation_step = 3.0;

/// An effect that was accepted.
struct Accepted : FittedCandidate {
  double probability;                   ///< against the others that were tried with it, and against nothing
  std::vector<FittedCandidate> rivals;  ///< whose evidence is as good, one for each effect
};

struct Search {
  Trial usual;                    ///< with the prior that was said, and a form of usual size
  Trial trial;                    ///< with the prior that it ended with
  bool on_board = false;          ///< whether form and instruments are taken for inexact
  FormSizes sizes = usual_sizes;  ///< of the form, where it is
  MapFit null{}, now{};
  double prior_inflation =
      1.0;  ///< factor on what the coefficients of the baseline are known to, where the runs speak against it
  double named_scale = 0.0;                         ///< of the process noise beside all effects that have names
  Located located{};                                ///< where the baseline alone lacks force
  std::vector<EffectForm> forms{};                  ///< that were tried
  std::vector<Accepted> accepted{};                 ///< in the order of acceptance, traces with them
  std::vector<FittedCandidate> first{};             ///< all that were tried alone, best first by runs used and held out
  std::vector<UnfittedCandidate> first_unfitted{};  ///< the others, beside the baseline alone
  std::deque<EffectForm> reduced{};                 ///< forms made by the search
  std::vector<std::string> troubles{};  ///< what ended the search early, in words; what was found before stands

  Hypothesis hypothesis(std::size_t count) const;
  Hypothesis hypothesis() const { return hypothesis(accepted.size()); }
};

/// A trial with the runs used, and with those held out; where there are none, each run used is left out in turn.
struct Trials {
  Trial used, unused;
};

/// @param exact     the ship file with its confidence, instruments without errors
/// @param on_board  makes the same with a form and instruments that are a little wrong; its answer stands where errors
///                  of positions have a memory
Search search(const Trials& exact, const std::function<Trials()>& on_board, std::span<const EffectForm> forms,
              const DiagnosisOptions& options, const std::function<bool(std::string_view)>& goes_on);

/// Probabilities of all candidates, by effect, those that were fitted first; they add up to less than 1, the rest is
/// for nothing.
///
/// Evidence of models that are all a little wrong says too much; its logarithm is divided by `evidence_excess` first.
/// Nothing counts as the gain that is needed, so what just reaches it has one half. What the runs do not tell keeps its
/// share, exp(−needed/excess) of that of nothing, unless they show that it is too small to matter. A trace has none.
std::vector<Candidate> ranked(std::span<const FittedCandidate> tried, std::span<const UnfittedCandidate> unfitted,
                              double needed);

inline constexpr double evidence_excess = 3.0;

/// Of the process noise beside an inexact form, from which on something is missing, named or not, if replays show it.
/// Of simulated ships of another structure with nothing hidden it was 0.3 to 2.8; where a tug, a bank, a wind or a weak
/// rudder found no name, 6.9 to 17.
inline constexpr double unexplained_scale = 5.0;

/// Covariance of the coordinates of an effect where the data count evidence_excess times less: (Λ + (C⁻¹ − Λ)/excess)⁻¹
/// with the prior's precision Λ.
Eigen::MatrixXd widened(const EffectForm& form, const Eigen::MatrixXd& covariance);

/// Whether the parameters that decide are told from those of no effect, zᵀC⁻¹z > 4 with their covariance C: a gust that
/// kicked her for an instant may gain much, and yet be of any size. The effect is the last of the fit.
bool is_told(const Ship& ship, const EffectForm& form, const MapFit& found);

/// Whether an effect in the place of an ordinary error of an instrument, a rudder or a day is no larger than such
/// errors are. Its coordinates begin at `first`.
bool is_as_ordinary(const Trial& trial, const EffectForm& form, const Point& point, Eigen::Index first);

/// A ship of this search without one of the effects that were accepted, which are the last of hers.
Ship without_accepted(Ship ship, const Search& s, std::size_t accepted);

/// Whether an effect gains what is needed beside the baseline alone, too, or much more where it was accepted.
bool is_told_by_itself(const Search& s, const Accepted& accepted, double needed);

/// When an effect that was accepted begins and ends to act, in the time of the runs.
struct ActiveTime {
  std::optional<double> onset, end;  ///< [s]; nothing where it acts from the first, to the last
};

/// By likelihood ratio: without the effect the samples before the onset, or after the end, are likelier by more than
/// `needed`. Neither lies within two ship lengths of way of the ends of the longest run, where the filter settles.
ActiveTime active_time(const Trial& trial, const Search& s, std::size_t accepted, double needed);

}  // namespace swayaw::mismatch::detail
