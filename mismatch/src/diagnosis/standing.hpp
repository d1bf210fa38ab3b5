#pragma once

#include <functional>
#include <span>

#include "../search/held_out.hpp"
#include "../search/search.hpp"

/// Whether an effect that was accepted stands, or is no more than a form of her forces that is a little wrong. Not
/// installed.
namespace swayaw::inline mismatch::detail {

/// Some of the effects that were accepted, and the fit with them and no others.
struct Standing {
  Hypothesis effects;
  MapFit fit;  ///< empty where she cannot sail like that
};

/// Whether a force might as well be a form of her forces that is a little wrong: it follows the motion at once or a
/// little late, not a heel that was recorded, and reference runs have not told it.
bool could_be_form(const Trial& trial, const EffectForm& form, const Effect& effect);

/// Whether it is asked of an effect that was accepted: of any with instruments as on board, else of drag of the hull.
bool asks_for_form(const Trial& trial, const Search& s, std::size_t accepted);

/// Whether a force that follows the motion late does: a share of the damping below none comes early, and stands for
/// added masses, form and instruments that are off. It was −0.6 to −1.9 in five of 1,050 simulated cases, in none of
/// which forces had a memory; where they had one it was 0.2 to 0.7.
bool comes_late(const Effect& effect);

/// All fitted once more from where it is, with these of the effects that were accepted. Where she cannot sail so with
/// the coefficients that she has beside the others, from those of the baseline: a cross-flow drag that was none was the
/// first of three effects, since coefficients fitted beside it made a ship in shallow water run away without it.
/// @param which  in their order
Standing refitted_with(const Search& s, std::span<const std::size_t> which);

/// The same with all but one.
Standing refitted_without(const Search& s, std::size_t accepted);

/// What the log evidence of the whole lacks without one of the effects that were accepted; infinite where she cannot
/// sail without it.
double worth(const Search& s, const Standing& without);

/// The same with what runs held out lose in log likelihood. What is fixed to the earth may stand for another force on
/// the courses used: a wind for half of the waves of a case as on board, which were larger on those held out.
double whole_worth(HeldOutRuns& held_out, const Search& s, const Standing& without);

/// Whether an effect that follows the motion is more than a form that is wrong by a few per cent: without it, all else
/// fitted once more, replays of all runs err by more, and those of runs that were not used do not err less with the
/// coefficients alone; or the form is larger than any and with it is not, or she cannot sail them at all; or it is
/// late, and the evidence with what runs held out gain tells that clearly.
/// @param without  all else, fitted once more
/// @param in_all   `whole_worth` of an accepted effect, asked of one that is late alone
/// @param budget   with all effects
/// @param alone    the coefficients alone refitted
bool is_more_than_form(const Trial& trial, const Search& s, std::size_t accepted, const Standing& without,
                       const std::function<double(std::size_t)>& in_all, std::span<const ForceBudget> budget,
                       const ShipInRun& alone, std::span<const Recording> runs, std::span<const Recording> holdout);

/// Whether a force changes no replay by more than a hundredth of the variation when it is taken away and nothing else:
/// then it matters to nobody. Of 1,000 simulated ships with nothing hidden seven had a rudder that stalls in its last
/// degree, by 0.6 to 0.9 %; a loss of speed in turns, the smallest force that was hidden in labelled cases, made 2.6 %.
bool changes_little(const Trial& trial, const Search& s, std::size_t accepted, std::span<const Recording> runs,
                    std::span<const Recording> holdout);

/// Whether drag of the hull is more than the polynomial of her model in other terms: without it, all else fitted once
/// more, some replay changes by more than 2 % of the variation. Exact recordings tell the polynomial of a hull from
/// her strips: of simulated ships with nothing hidden, or something else, ten were told a cross-flow drag of 0.13 to
/// 0.24, which changed no replay by more than 0.6 to 1.4 %; the smallest that was hidden, 0.2, made 2.6 %.
/// @param without  all else, fitted once more
bool is_more_than_polynomial(const Trial& trial, const Search& s, const Standing& without,
                             std::span<const Recording> runs, std::span<const Recording> holdout);

}  // namespace swayaw::mismatch::detail
