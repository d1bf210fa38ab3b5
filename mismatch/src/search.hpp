#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "swayaw/mismatch/diagnose.hpp"
#include "trial.hpp"

/// The search for effects that a ship lacks: all are screened, the best are fitted until they converge, runs that were not used decide. Not installed.
namespace swayaw {

/// A candidate, fitted beside the effects that are accepted already.
struct Tried {
  const EffectForm* form;
  MapFit fit;
  double gain;    ///< in log evidence, the terms that it does better without left out
  Effect effect;
  bool trace;     ///< too small to matter
};

/// An effect that was accepted.
struct Accepted {
  const EffectForm* form;
  double gain;
  double probability;               ///< against the others that were tried with it, and against nothing
  bool trace;
  std::vector<Tried> rivals;        ///< whose evidence is as good, one for each effect
};

struct Search {
  MapFit null, now;
  Screen screen;                    ///< of the baseline alone
  std::vector<Accepted> accepted;   ///< in the order of acceptance, traces with them
  std::vector<Tried> first;         ///< all that were tried alone, best first
  std::deque<EffectForm> reduced;   ///< forms made by the search

  Hypothesis hypothesis(std::size_t count) const;
  Hypothesis hypothesis() const { return hypothesis(accepted.size()); }
};

/// @param unused  the same trial with the held-out runs; without runs, each of the trial's runs is left out in turn
Search search(const Trial& trial, const Trial& unused, std::span<const EffectForm> forms, const DiagnosisOptions& options,
              const std::function<bool(std::string_view)>& goes_on);

/// Probabilities of all that were tried, by effect, best first; they add up to less than 1, the rest is for nothing.
///
/// Evidence of models that are all a little wrong says too much; its logarithm is divided by `evidence_excess` first. Nothing counts as the gain that is
/// needed, so what just reaches it has one half. A trace has none.
std::vector<Candidate> ranked(std::span<const Tried> tried, double needed);

inline constexpr double evidence_excess = 3.0;

}  // namespace swayaw
