#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../missing_force/location.hpp"
#include "../trial/trial.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// The search for effects that a ship lacks: all are screened (screening.hpp), the best are fitted until they converge
/// (candidate_fits.hpp), runs that were not used are asked (held_out.hpp), one is accepted (ranking.hpp). Not
/// installed.
///
/// Log evidence is counted by `evidence_excess` (significance.hpp): 5 is odds of e^(5/3), 5 to 1.
namespace swayaw::inline mismatch::detail {

/// A candidate, fitted beside the effects that are accepted already.
struct FittedCandidate {
  const EffectForm* form;
  MapFit fit;
  double gain;  ///< in log evidence, the terms that it does better without left out; less where it has no name
  Effect effect;
  bool trace = false;                    ///< too small to matter, not told from nothing, or larger than it can be
  bool too_large = false;                ///< larger than it can be
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

inline bool is_unknown(const EffectForm& form) { return form.id == UnknownForce<>::id; }

/// Whether it is what drags at one side, which has a law, if no name.
inline bool is_drag(const EffectForm& form) {
  return is_unknown(form) && !form.coordinates.empty() && form.coordinates.front().name == "drag";
}

/// Odds of what no candidate shows, to nothing, beside an inexact form: of 375 answers "nothing is missing" of 900
/// cases as on board (`swayaw_concealed`, seeds 44 and 46) 278 were right; in the others coefficients and form had
/// taken something up. With 0.15 they had been given 0.82 in the mean, with 0.35 0.70.
inline constexpr double odds_of_unseen = 0.28;

/// Whether it is the map of what has no name beside an inexact form: it keeps the odds of what no candidate shows,
/// fitted or not. Of 14 answers of nothing with 0.996, where it was fitted and gained too little, 11 were right (seed
/// 31).
inline bool stands_for_unseen(const EffectForm& form, bool on_board) {
  return on_board && is_unknown(form) && !is_drag(form);
}
inline bool stands_for_unseen(const FittedCandidate& tried) {
  return stands_for_unseen(*tried.form, tried.fit.noise.with_memory);
}

/// Times what is needed, that an effect gains which is clear.
inline constexpr double clearly = 3.0;

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

/// The trial as the search knows it, beside a form of these sizes and a prior so many times wider.
Trial trial_with(const Search& s, const FormSizes& sizes, double wider = 1.0);

/// From now on the form has these sizes.
void take_sizes(Search& s, const FormSizes& sizes);

/// A trial with the runs used, and with those held out; where there are none, each run used is left out in turn.
struct Trials {
  Trial used, unused;
};

/// @param exact     the ship file with its confidence, instruments without errors
/// @param on_board  makes the same with a form and instruments that are a little wrong; its answer stands where errors
///                  of positions have a memory
Search search(const Trials& exact, const std::function<Trials()>& on_board, std::span<const EffectForm> forms,
              const DiagnosisOptions& options, const std::function<bool(std::string_view)>& goes_on);

/// Once more from the baseline alone, where a form and instruments are taken for inexact.
/// @param s       the first search
/// @param unused  as in the first search
/// @param forms   those that are tried now
/// @throws Refusal  where the model cannot follow the runs
Search searched_anew(const Search& s, const Trial& unused, std::span<const EffectForm> forms,
                     const DiagnosisOptions& options, const std::function<bool(std::string_view)>& goes_on);

/// Of the process noise beside an inexact form, from which on something is missing, named or not, if replays show it.
/// Of simulated ships of another structure with nothing hidden it was 0.3 to 2.8; where a tug, a bank, a wind or a weak
/// rudder found no name, 6.9 to 17.
inline constexpr double unexplained_scale = 5.0;

/// Where the coordinates of an effect that was accepted begin in the point of the search.
Eigen::Index place_of_accepted(const Search& s, std::size_t accepted);

/// A ship of this search without one of the effects that were accepted, which are the last of hers.
Ship without_accepted(Ship ship, const Search& s, std::size_t accepted);

}  // namespace swayaw::mismatch::detail
