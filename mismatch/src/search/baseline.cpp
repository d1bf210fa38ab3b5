#include "baseline.hpp"

#include <algorithm>
#include <cmath>

#include "ranking.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// Sizes of all noises and the ship pull each other along: a baseline that stopped after 6 rounds lacked 220 in log
/// evidence, and what was tried beside it seemed to gain that.
constexpr int until_it_stays = 30;

/// Where fits of a baseline begin: beside an inexact form with little process noise, and with much. Motion that is not
/// explained is process noise or an error of instruments, and each start leads to a summit of its own: of 52 cases as
/// on board the second was likelier by more than 5 in nine, by 2,200 in one, and the first in eleven; of seven zigzags
/// of a model of 3 m the second in three, by 83 in one.
std::vector<Noise> starts_of(const Noise& start) {
  constexpr double much = 10.0;  // times the ordinary process noise
  std::vector starts{start};
  if (start.with_memory) starts.emplace_back(start).axes.fill(much);
  return starts;
}

/// The likeliest fit of the baseline; an empty one where none follows the runs.
/// @param begun  of the first start, that goes on; or nothing
MapFit likeliest_baseline(const Trial& trial, const Noise& start, const MapFit& begun) {
  const auto starts = starts_of(start);
  std::vector<MapFit> fits(starts.size());
  in_parallel(starts.size(), 0, [&](std::size_t i) {
    const bool goes_on = i == 0 && begun.point.size() > 0;
    try {
      fits[i] = fit(trial, {}, goes_on ? begun.point : trial.mean, goes_on ? begun.noise : starts[i],
                    {.rounds = until_it_stays});
    } catch (const std::exception&) {  // with that noise she runs away
    }
  });
  const auto evidence = [](const MapFit& f) { return f.point.size() == 0 ? -HUGE_VAL : f.log_evidence; };
  return *std::ranges::max_element(fits, {}, evidence);
}

}  // namespace

void fit_form(Search& s, const FormSizes& sizes) {
  if (sizes == s.sizes && s.accepted.empty()) return;
  take_sizes(s, sizes);
  auto found = fit(s.trial, s.hypothesis(), s.now.point, s.now.noise, {.rounds = 3});
  if (found.point.size() > 0) s.now = std::move(found);
}

void stand_on_highest_summit(Search& s) {
  const auto hypothesis = s.hypothesis();
  const auto problem = problem_of(s.trial, hypothesis);
  const auto other = best_noise(problem, s.now.point, Noise::on_board(), true);
  if (!(other.log_likelihood > log_likelihood(problem, s.now.point, s.now.noise) + as_good)) return;
  auto found = fit(s.trial, hypothesis, s.now.point, other.noise, {.rounds = until_it_stays});
  if (found.log_evidence > s.now.log_evidence) s.now = std::move(found);
}

Search with_baseline(const Trial& trial, const Noise& start, const MapFit& begun) {
  const bool on_board = start.with_memory;
  Search s{.usual = trial, .trial = trial, .on_board = on_board};
  s.null = likeliest_baseline(s.trial, start, begun);
  if (s.null.point.size() == 0)  // far off: what nothing explains is large from the first
    s.null =
        fit(s.trial, {}, s.trial.mean, best_noise(problem_of(s.trial, Hypothesis{}), s.trial.mean, start, true).noise);
  if (s.null.point.size() == 0)
    throw Refusal("the model cannot follow these runs at all; look at them with compare first");
  s.now = s.null;
  if (!on_board) return s;
  stand_on_highest_summit(s);
  for (int i = 0; i < 2; ++i) fit_form(s, likely_form(s.usual, s.trial, s.sizes, {}, s.now).sizes);
  s.null = s.now;
  return s;
}

}  // namespace swayaw::mismatch::detail
