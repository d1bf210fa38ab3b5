#pragma once

#include <optional>
#include <span>
#include <vector>

#include "held_out.hpp"
#include "search.hpp"

/// Which of the candidates is accepted, and how probable each of them is. Not installed.
namespace swayaw::inline mismatch::detail {

inline constexpr double as_good = 5.0;  ///< log evidence: a smaller difference does not tell effects apart

/// In log evidence of runs used and held out.
double whole_gain(const FittedCandidate& tried);

/// Candidates beside the same baseline, and the gain in log evidence that one of them needs.
struct Ranking {
  std::span<const FittedCandidate> tried;
  std::span<const UnfittedCandidate> unfitted;
  double needed;

  /// Against nothing, all others, and what has another name.
  double probability(const FittedCandidate& one) const;
  double probability(const UnfittedCandidate& one) const;
};

/// A wind is as sure as the wind of all runs and that of each of them together: they are no rivals.
Accepted accepted_as(const FittedCandidate& best, const Ranking& ranking);

/// Probabilities of all candidates, by effect, those that were fitted first; they add up to less than 1, the rest is
/// for nothing.
///
/// Evidence of models that are all a little wrong says too much; its logarithm is divided by `evidence_excess` first.
/// Nothing counts as the gain that is needed, so what just reaches it has one half. What the runs do not tell keeps its
/// share, exp(−needed/excess) of that of nothing, unless they show that it is too small to matter. A trace has none.
std::vector<Candidate> ranked(std::span<const FittedCandidate> tried, std::span<const UnfittedCandidate> unfitted,
                              double needed);

/// What the runs used must tell by themselves, in log evidence: of a first effect all that is needed, for what a ship
/// file leaves of the true hull is in all runs of a ship, and held-out runs gain by it too. Of 264 simulated ships with
/// nothing hidden (`swayaw_concealed`, plan clean, seed 2026) five gained 17 to 34 with held-out runs, 8 to 13 of it by
/// the runs used; of 64 hidden effects the least gained 49 by the runs used. Of 90 with nothing hidden as on board
/// (seed 39) four gained 9 to 13 by the runs used, and 4 to 290 by those held out. A further effect beside an inexact
/// form, which takes the hull up, may reach what is needed with their help, where something is known to be missing:
/// beside more than a trace or what held-out runs refute.
double least_gain(const HeldOutRuns& held_out, const Search& s, double needed);

/// The best by runs used and held out that gains enough and that no other run speaks against; a trace only where
/// nothing that matters is nearly as good. All that may lead are asked for held-out runs; where there are none, one
/// after the other until one holds in each run by a fit to the others.
std::optional<FittedCandidate> chosen(HeldOutRuns& held_out, Search& s, std::span<FittedCandidate> tried, double needed,
                                      bool trace_may);

}  // namespace swayaw::mismatch::detail
