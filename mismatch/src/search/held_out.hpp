#pragma once

#include <map>
#include <span>
#include <vector>

#include "../missing_force/budget.hpp"
#include "search.hpp"

/// What runs that were not used say of an effect. Not installed.
namespace swayaw::inline mismatch::detail {

/// A fit to all parts of the runs used but one, and the likelihood of the one.
struct LeftOut {
  MapFit fit{};  ///< of no point where she cannot sail the others
  Likelihood alone{};
};

/// Held-out runs, if any, and what is known of them, or of parts of the runs used, as things stand.
struct HeldOutRuns {
  const Trial& unused;
  Likelihood now;  ///< of these runs
  double used;     ///< log likelihood of the runs used; asked beside an inexact form alone
  std::map<FormSizes, std::vector<LeftOut>> parts{};  ///< of the runs used, with what is accepted beside a form of
                                                      ///< these sizes; where they were asked

  bool is_empty() const { return unused.runs.empty(); }
};

HeldOutRuns held_out_runs(const Trial& unused, const Search& s);

/// A fit with these coordinates at their means.
MapFit at_mean(MapFit fit, const Trial& trial, std::span<const Eigen::Index> coordinates);

/// Gain in log likelihood of held-out runs, or of each run by a fit to the others, or of each half of one by a fit to
/// the other half.
/// @param sizes  of the form in the trial
double held_out_gain(const Trial& trial, const FormSizes& sizes, HeldOutRuns& held_out, const Hypothesis& before,
                     const MapFit& a, const Hypothesis& after, const MapFit& b);

/// What an effect gains in log evidence if its likelihood counts as it shows in runs that were not used. Evidence is
/// gained by likelihood, and by coefficients that need not be strained any longer; only the first shows in other runs,
/// and there it is as large, row by row, where the effect is what it is taken for.
/// @param gain       in log evidence, of the runs used
/// @param elsewhere  what those others gain in log likelihood
double gain_as_elsewhere(const HeldOutRuns& held_out, const Trial& trial, const Hypothesis& after, const MapFit& found,
                         double gain, double elsewhere);

/// Whether runs that were not used bear out what gains in those used; beside an inexact form.
///
/// What is fixed to the earth is large on some courses and small on others: of a wind and of the waves of two cases as
/// on board (seed 34) runs held out kept a quarter, and gained 22 to 115 in log likelihood all the same. Runs used that
/// are left out in turn gain in sum, and are no such witness: winds of single turns of the Esso Osaka, one 60 deg off.
bool is_borne_out(const HeldOutRuns& held_out, Follows kind, double gain, double elsewhere, double as_elsewhere,
                  double needed);

/// What runs that were not used say of an effect that was tried. Of a single run that is short nothing is known. No
/// form of her forces heels a ship, so an effect that explains a heel that was recorded is asked as beside an exact
/// one: by her roll a turn of KCS that was not used gained 9 in log likelihood, too little for as many rows as of
/// zigzags.
void ask(HeldOutRuns& held_out, const Trial& trial, const Search& s, FittedCandidate& tried, double needed);

}  // namespace swayaw::mismatch::detail
