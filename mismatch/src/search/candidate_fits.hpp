#pragma once

#include <deque>
#include <vector>

#include "screening.hpp"
#include "search.hpp"

/// Converged fits of candidates, with those of their terms that the evidence keeps. Not installed.
namespace swayaw::inline mismatch::detail {

/// Which terms of the last effect the evidence keeps, and what it gains without the others.
struct Pruned {
  std::vector<std::size_t> kept;
  double gain = 0.0;
};

/// Terms are taken in one by one, that first by which the evidence grows most, as long as it grows by what tells terms
/// apart; one that the others make needless goes again. Evidence of a subset S, its prior about 0 with precision P and
/// the information I, h of the data counted as for `widened`:
///
///     ln E = ½ h_Sᵀ (I_S + P_S)⁻¹ h_S − ½ ln det(I_S + P_S) + ½ ln det P_S
Pruned pruned(const EffectForm& form, const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance);

/// Converged fits of candidates, best first.
std::vector<FittedCandidate> confirmed(const Search& s, const Hypothesis& accepted, const LinearizedFit& linear,
                                       const std::vector<Screened>& candidates);

/// The effect with those of its terms that the evidence keeps, fitted anew until it keeps all.
FittedCandidate reduced(const Trial& trial, const Hypothesis& accepted, FittedCandidate tried,
                        std::deque<EffectForm>& forms);

}  // namespace swayaw::mismatch::detail
