#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "search.hpp"

/// Which effects are worth a fit: what each promises beside what is accepted, by a linear prediction. Not installed.
namespace swayaw::inline mismatch::detail {

/// The best start of a form, by what it predicts.
struct Screened {
  const EffectForm* form;
  PredictedGain predicted_gain;
  FormSizes sizes = usual_sizes;  ///< of the form beside it
};

/// A linearized fit as it is where an effect stands in the place of what is ordinary, and what it gains by that: what
/// was ordinary is back at its mean and changes nothing.
struct Beside {
  LinearizedFit linear;
  double gain;
};

std::optional<Beside> beside(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& linear,
                             const EffectForm& form);

/// A record is late by any time, and early by no more than what is ordinary: nobody shows what is still to come.
void keep_from_early(std::vector<EffectForm>& forms, const Trial& trial);

/// What comes and goes begins its fits where most force is missing, too.
void begin_where_force_is_missing(std::vector<EffectForm>& forms,
                                  const std::optional<std::pair<double, double>>& interval, double time_unit);

/// What is known of effects besides what a fit without them predicts.
void begin_where_told(Search& s, double needed);

/// The same beside a form of its size and beside a smaller one: what a form of any size explains as well may be all
/// that is wrong with a smaller one.
std::vector<Screened> screened_beside_form(const Search& s, const Hypothesis& accepted, const LinearizedFit& linear);

/// Gain in log evidence that must be predicted of one more effect beside an inexact form, for it to be fitted at all:
/// of 77 for which less was predicted, in 39 labelled cases as on board, none gained more than 10 (15 are needed at
/// least), and each took some 0.3 s.
inline constexpr double least_of_one_more = 1.0;

/// The most promising, of one effect not more than two: a delay comes in as many forms as there are channels. What
/// comes and goes is among them wherever most runs lack force at the same time: under the process noise that this makes
/// necessary it predicts too little. So is what the track tells, and what gained enough when it was fitted last, for a
/// prediction beside a wider prior says less than that: a stall that gained 56 and then 98 had not been fitted again.
/// @param least   gain in log evidence that must be predicted
/// @param before  those that were fitted last beside the same effects
/// @param needed  gain in log evidence that was enough for these
std::vector<Screened> most_promising(const std::vector<Screened>& candidates, std::size_t most, double least,
                                     std::span<const FittedCandidate> before, double needed);

/// Those of the candidates that are not among the chosen.
std::vector<UnfittedCandidate> all_but(const std::vector<Screened>& chosen, const std::vector<Screened>& candidates,
                                       const Search& s);

}  // namespace swayaw::mismatch::detail
