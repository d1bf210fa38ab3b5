#include "standing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "../missing_force/budget.hpp"
#include "replay_errors.hpp"
#include "verdict.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// Whether a force grows faster than the motion, of which reference runs, gentler than the hardest of the others, tell
/// little; or goes with accelerations, which are small in them.
bool is_of_hard_manoeuvres(const Effect& effect) {
  constexpr std::array ids{AddedMass<>::id, CrossFlowDrag<>::id, HullNonlinearDamping<>::id, SpeedLossInTurn<>::id};
  return std::ranges::count(ids, id_of(effect)) > 0;
}

/// Whether reference runs tell little of a force that follows the motion: it is one of hard manoeuvres, or stands for
/// the lift that rudders lose, of which they tell the sum. Ships of another structure have all of these by themselves.
bool is_told_little(const Effect& effect) { return is_of_hard_manoeuvres(effect) || takes_rudder_lift(id_of(effect)); }

/// Drag of the hull, for which most models have a polynomial of their own.
bool is_hull_drag(const Effect& effect) {
  return id_of(effect) == CrossFlowDrag<>::id || id_of(effect) == HullNonlinearDamping<>::id;
}

/// Log evidence, with what runs held out gain, by which a force that follows the motion late is more than a form: no
/// form is late. Of simulated ships of another structure it was 25 at most where nothing was hidden, 67 and 83 where
/// errors of instruments were, and 74, 105, 194, 222, 230 and 516 where forces had a memory, of runs used alone; with
/// those held out 71 at most where nothing was hidden, and 131, 137, 148 and 152 in four ships with a memory that
/// gained 64 to 90 in runs used (cases as on board, seeds 46 to 50).
constexpr double clearly_late = 100.0;

/// Log evidence by which a force of hard manoeuvres is more than the form that reference runs told. The drag of the
/// cross flow, hidden, gained 130 and 430 beside them; of 78 ships with nothing hidden the most was 30.
constexpr double clearly_changed = 60.0;

}  // namespace

bool could_be_form(const Trial& trial, const EffectForm& form, const Effect& effect) {
  const auto kind = follows(effect);
  if (id_of(effect) == AddedResistance<>::id) return false;  // the form has little of it: it is told straight ahead
  if (place_of(effect) != EffectPlace::force || !(kind == Follows::form || kind == Follows::past)) return false;
  if (trial.calibrated && kind == Follows::form && !is_told_little(effect)) return false;
  return !explains_heel(trial, form);
}

bool asks_for_form(const Trial& trial, const Search& s, std::size_t accepted) {
  const auto& one = s.accepted[accepted];
  return s.on_board ? could_be_form(trial, *one.form, one.effect) : is_hull_drag(one.effect);
}

bool comes_late(const Effect& effect) {
  const auto* memory = std::get_if<FluidMemory<double>>(&effect);
  return memory == nullptr || memory->share > 0.0;
}

Standing refitted_with(const Search& s, std::span<const std::size_t> which) {
  Standing standing;
  const auto base = s.trial.baseline_size();
  std::vector<Eigen::Index> places(static_cast<std::size_t>(base));
  std::iota(places.begin(), places.end(), 0);
  const auto all = s.hypothesis();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::ranges::count(which, i) == 0) continue;
    standing.effects.push_back(all[i]);
    const auto from = place_in_point(s.trial, all, i);
    for (Eigen::Index k = 0; k < std::ssize(all[i]->coordinates); ++k) places.push_back(from + k);
  }
  for (const auto* baseline : {&s.now.point, &s.null.point}) try {
      Point start = s.now.point(places);
      start.head(base) = baseline->head(base);
      standing.fit = fit(s.trial, standing.effects, start, s.now.noise, {.rounds = 3});
      if (standing.fit.point.size() > 0) break;
    } catch (const std::exception&) {  // she runs away
    }
  return standing;
}

Standing refitted_without(const Search& s, std::size_t accepted) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < s.accepted.size(); ++i)
    if (i != accepted) others.push_back(i);
  return refitted_with(s, others);
}

double worth(const Search& s, const Standing& without) {
  return without.fit.point.size() == 0 ? HUGE_VAL : s.now.log_evidence - without.fit.log_evidence;
}

double whole_worth(HeldOutRuns& held_out, const Search& s, const Standing& without) {
  const double used = worth(s, without);
  if (held_out.is_empty() || without.fit.point.size() == 0) return used;
  return used - held_out_gain(s.trial, s.sizes, held_out, s.hypothesis(), s.now, without.effects, without.fit);
}

bool is_more_than_form(const Trial& trial, const Search& s, std::size_t accepted, const Standing& without,
                       const std::function<double(std::size_t)>& in_all, std::span<const ForceBudget> budget,
                       const ShipInRun& alone, std::span<const Recording> runs,
                       std::span<const Recording> holdout) try {
  constexpr double a_few_per_cent = 0.03;  // of the variation of a quantity
  if (without.fit.point.size() == 0) return true;
  const auto& effect = s.accepted[accepted].effect;
  if (follows(effect) == Follows::past && in_all(accepted) > clearly_late) return true;
  if (trial.calibrated && is_of_hard_manoeuvres(effect) && worth(s, without) > clearly_changed) return true;
  if (!has_large_form(budget) && has_large_form(budget_of(trial, without.effects, without.fit))) return true;
  const auto with_all = ships_at(trial, s.hypothesis(), s.now.point);
  const auto less = ships_at(trial, without.effects, without.fit.point);
  auto beside_alone = falls_of(alone, with_all, {holdout});
  return std::ranges::any_of(falls_of(less, with_all, {runs, holdout}), [&](const auto& fall) {
    return fall.second > a_few_per_cent && beside_alone[fall.first] > -a_few_per_cent;
  });
} catch (const std::exception&) {
  return true;
}

bool changes_little(const Trial& trial, const Search& s, std::size_t accepted, std::span<const Recording> runs,
                    std::span<const Recording> holdout) try {
  constexpr double matters = 0.01;
  if (place_of(s.accepted[accepted].effect) != EffectPlace::force) return false;
  const auto with = ships_at(trial, s.hypothesis(), s.now.point);
  const auto without = [&](const Recording& run) { return without_accepted(with(run), s, accepted); };
  return !differ_by_more(matters, with, without, {runs, holdout});
} catch (const std::exception&) {  // she cannot sail them without it
  return false;
}

bool is_more_than_polynomial(const Trial& trial, const Search& s, const Standing& without,
                             std::span<const Recording> runs, std::span<const Recording> holdout) try {
  constexpr double matters = 0.02;
  if (without.fit.point.size() == 0) return true;
  const auto with = ships_at(trial, s.hypothesis(), s.now.point);
  const auto less = ships_at(trial, without.effects, without.fit.point);
  return differ_by_more(matters, with, less, {runs, holdout});
} catch (const std::exception&) {
  return true;
}

}  // namespace swayaw::mismatch::detail
