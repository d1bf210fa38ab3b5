#include "candidate_fits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "../trial/other_values.hpp"
#include "ranking.hpp"
#include "significance.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/parallel.hpp"

namespace swayaw::inline mismatch::detail {
using namespace core::detail;
namespace {

constexpr double worth_of_a_term = 5.0;   ///< log evidence by which a further term of an effect must gain
constexpr double worth_of_a_name = 20.0;  ///< log evidence by which a force without a name must beat an effect that has
                                          ///< one: what a further effect must bring, for it has terms as many
constexpr double worth_of_waves =
    10.0;  ///< log evidence by which waves must beat a wind: they come with one, and a wind
           ///< often without them; where waves were hidden they gained 58 to 104 more
constexpr double stopped_early = 15.0;  ///< log evidence below that without the effect, of a fit that is begun anew
constexpr double smaller_start = 0.1;   ///< of what was predicted, where a fit stopped early

/// Ordinary deviations of a size that stands and of one that is predicted, below which an effect is not fitted.
constexpr double surely_ordinary = 1.25;

// ---------------------------------------------------------------- terms

Pruned pruned(const EffectForm& form, const MapFit& fit) {
  const auto size = static_cast<Eigen::Index>(form.coordinates.size());
  return pruned(form, fit.point.tail(size), fit.covariance.bottomRightCorner(size, size));
}

/// How much an effect differs from run to run, over what was taken for it, and what the log evidence gains by that.
struct LikelySpread {
  double factor = 1.0, gain = 0.0;
};

/// The spread that makes a converged fit likeliest; its effect is the last.
LikelySpread likely_spread(const EstimationProblem& problem, const EffectForm& form, const MapFit& fit) {
  LikelySpread best;
  const auto own = std::ssize(form.coordinates) - static_cast<std::ptrdiff_t>(form.common());
  if (own == 0) return best;
  for (double factor = 1.0 / 64.0; factor <= 4.0; factor *= 2.0) {
    Eigen::VectorXd factors = Eigen::VectorXd::Ones(problem.size());
    factors.tail(own).setConstant(factor);
    const double gain = gain_by_prior(problem, fit, with_wider_prior(problem.precision, factors));
    if (gain > best.gain) best = {factor, gain};
  }
  return best;
}

// ---------------------------------------------------------------- converged fits

std::span<const double> last_coordinates(const EffectForm& last, const Point& point) {
  const auto size = last.coordinates.size();
  return {point.data() + point.size() - static_cast<Eigen::Index>(size), size};
}

/// In the mean of all runs.
Effect last_effect(const Trial& trial, const EffectForm& last, const Point& point) {
  return effect_beside(trial, last.at(mean_of_parts(last, last_coordinates(last, point))), bare_ship_at(trial, point));
}

const MapFit& likelier(const MapFit& a, const MapFit& b) { return b.log_evidence > a.log_evidence ? b : a; }

/// A fit that comes out far below the hypothesis without the effect stopped too early; from a small effect it begins
/// once more; and where something is known of it. What comes and goes is fitted where most force is
/// missing too, with no more than the ordinary process noise: beside that which it makes necessary its edges cannot be
/// seen.
MapFit fit_beside(const Trial& trial, const Hypothesis& hypothesis, MapFit now, const LinearizedFit& linear,
                  const std::vector<double>& predicted) {
  const auto known = beside(trial, Hypothesis(hypothesis.begin(), hypothesis.end() - 1), linear, *hypothesis.back());
  if (known)
    for (const auto i : replaced_by(trial, *hypothesis.back())) now.point[i] = known->linear.point[i];
  const bool refined_later = now.noise.with_memory;
  const auto found = fit(trial, hypothesis, with_start(now.point, predicted), now.noise,
                         {.known = known ? &known->linear.slopes : &linear.slopes, .to_rank = refined_later});
  if (const auto& told = hypothesis.back()->told; !told.empty()) {
    auto anew = now.point;
    anew.head(trial.baseline_size()) = trial.mean;
    const auto from = [&](const Point& point, const Noise& noise) {
      try {
        return fit(trial, hypothesis, with_start(point, told), noise);
      } catch (const std::exception&) {  // she cannot sail from there
        return found;
      }
    };
    const auto beside_given = from(anew, Noise::on_board());
    if (hypothesis.back()->told_beside_given) return likelier(found, beside_given);
    return likelier(found, likelier(from(now.point, now.noise), beside_given));
  }
  auto other = predicted;
  if (const auto& window = hypothesis.back()->window; !window.empty() && now.noise.largest_scale() > ordinary_scale) {
    std::ranges::copy(window, other.end() - 2);
    auto quiet = now.noise;
    quiet.scale = ordinary_scale, quiet.axes.fill(1.0), quiet.memory = 1.0;
    return likelier(found, fit(trial, hypothesis, with_start(now.point, other), quiet, {.to_rank = refined_later}));
  }
  if (found.log_evidence > now.log_evidence - stopped_early) return found;
  for (double& c : other) c *= smaller_start;
  return likelier(found, fit(trial, hypothesis, with_start(now.point, other), now.noise, {.to_rank = refined_later}));
}

/// Whether she heels no more than in the reference runs, which hold what her heel does to her: other manoeuvres heel
/// her by up to so many times more, and where a smaller stability was hidden it was 2.5 and 9 times.
bool heels_as_before(const Trial& trial) {
  constexpr double other_manoeuvres = 1.5;
  return heel_of(trial.runs) < other_manoeuvres * trial.reference_heel;
}

/// Whether she heels so far that it turns her, told or not: 10 deg of heel turned the container ship of [Son1982], the
/// only one whose forces by heel are published, about as one degree of rudder.
bool heels_far(const Trial& trial) {
  constexpr double far = radians(10.0);
  return std::numbers::sqrt2 * heel_of(trial.runs) > far;
}

/// What an effect gains in log evidence by acting, where it can be seen without: the ratio of Savage and Dickey, of the
/// density of no action before the runs to that after them.
double gained_by_acting(const EffectForm& form, const MapFit& found) {
  const auto from = found.point.size() - std::ssize(form.coordinates);
  std::vector<Eigen::Index> acting;
  double before = 0.0;
  for (std::size_t i = 0; i < form.coordinates.size(); ++i)
    if (form.coordinates[i].acts)
      acting.push_back(from + static_cast<Eigen::Index>(i)), before += 2.0 * std::log(form.coordinates[i].deviation);
  const Eigen::MatrixXd C = found.covariance(acting, acting);
  const Eigen::VectorXd c = found.point(acting);
  return 0.5 * (c.dot(solve_symmetric(C, c)) + log_determinant(C) - before);
}

/// Whether nothing but a drag can stand for more resistance: a model without a resistance of its own has the balance of
/// thrust and resistance about service speed. Runs slower than that, with the engine slowed, look like a drag, too, but
/// not beside reference runs. Of eight such ships with weed at one bow four, where a drag gained 56 to 82 and its
/// moment nothing, were not told; of 23 with nothing hidden none gained by a drag (cases as on board, seeds 71 and 73).
bool drags_alone(const Trial& trial) {
  return trial.calibrated && !cannot_act(trial.ship.model, AddedResistance<>{}).empty();
}

/// Whether an effect acts, which some can be seen without: a drag at one side is more resistance but for its moment,
/// which is to tell the one name from the other (its gain was -2.2 to -0.4 in eight ships as on board with more
/// resistance, 5.6 to 52 in 18 of 22 with weed at one bow, seed 52), and a heel that is recorded is explained by
/// rolling alone. One that is not recorded gains by acting alone, but nobody saw it: it gained 23 to 51 on ships of
/// another structure in which nothing was hidden, 220 and 236 on two where it was (seed 34; what Savage and Dickey's
/// ratio told of it there, 6 and 7, holds for small errors only, and of moment by heel and stability these runs tell
/// the ratio).
bool acts(const Trial& trial, const EffectForm& form, const MapFit& found, double gain) {
  // as much as any effect must gain. Where a container ship rolled as her file did not say it was 6 to 13, where a
  // smaller stability was hidden 88 and 143
  const double acts_clearly = DiagnosisOptions{}.detection;
  if (std::ranges::none_of(form.coordinates, &Coordinate::acts)) return true;
  if (is_drag(form)) return drags_alone(trial) || gained_by_acting(form, found) > as_good;
  if (!(heel_of(trial.runs) > 0.0)) return gain > clearly * acts_clearly;
  if (heels_as_before(trial)) return false;
  return heels_far(trial) || gained_by_acting(form, found) > acts_clearly;
}

/// Whether it is too small to matter, or no more than what explains a heel, or not told from nothing, or larger than it
/// can be, by its fit and what it gains.
void put_trace(const Trial& trial, FittedCandidate& tried) {
  const auto at = last_coordinates(*tried.form, tried.fit.point);
  tried.too_large = is_at_its_end(*tried.form, at);
  tried.trace = tried.too_large || !is_finding(trial.ship, *tried.form, at) ||
                !acts(trial, *tried.form, tried.fit, tried.gain) || !is_told(trial.ship, *tried.form, tried.fit) ||
                !is_told_from_file(trial, *tried.form, tried.fit, tried.fit.point.size() - std::ssize(at));
}

/// Whether an effect need not be fitted, for both what stands in its place and what is predicted of it are ordinary.
/// Far off a prediction alone says little: rudders recorded 4 to 8 s late, 3 s of it taken up by ordinary errors at
/// their end, were predicted as ordinary (three of 300 cases as on board), and gain 47 to 340.
bool is_surely_ordinary(const Trial& trial, const EffectForm& form, const Point& now,
                        std::span<const double> predicted) {
  const auto ordinary = in_whose_place(trial, form, now);
  const auto stands = ordinary ? coordinates_of(trial.ship, form, *ordinary) : std::nullopt;
  return stands && ordinary_deviations(trial, form, *stands) < surely_ordinary &&
         ordinary_deviations(trial, form, predicted) < surely_ordinary;
}

/// The effect with the spread from run to run that the evidence prefers.
FittedCandidate with_likely_spread(const Trial& trial, const Hypothesis& accepted, FittedCandidate tried,
                                   std::deque<EffectForm>& forms) {
  const auto likely = likely_spread(problem_of(trial, with(accepted, *tried.form)), *tried.form, tried.fit);
  if (likely.factor == 1.0) return tried;
  forms.push_back(with_spread(*tried.form, likely.factor));
  auto found = fit(trial, with(accepted, forms.back()), tried.fit.point, tried.fit.noise, {.rounds = 3});
  if (!std::isfinite(found.log_evidence)) return tried;
  tried.form = &forms.back();
  tried.effect = last_effect(trial, forms.back(), found.point);
  tried.fit = std::move(found);
  put_trace(trial, tried);
  return tried;
}

}  // namespace

Pruned pruned(const EffectForm& form, const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance) {
  Pruned result;
  const auto size = form.coordinates.size();
  for (std::size_t i = 0; i < size; ++i) result.kept.push_back(i);
  if (!form.with_terms) return result;
  const auto precision = precision_of(form);
  const Eigen::MatrixXd A = widened_precision(form, covariance);
  const Eigen::VectorXd h = inverse(covariance) * mean / evidence_excess;
  const auto evidence = [&](const std::vector<std::size_t>& subset) {
    const std::vector<Eigen::Index> s(subset.begin(), subset.end());
    const Eigen::MatrixXd A_s = A(s, s);
    const Eigen::VectorXd h_s = h(s);
    return 0.5 * (h_s.dot(solve_symmetric(A_s, h_s)) - log_determinant(A_s) + precision(s).array().log().sum());
  };
  struct Subset {
    std::vector<std::size_t> terms;
    double evidence;
  };
  // the likeliest of the subsets with one term more, or one less.
  const auto next = [&](const std::vector<std::size_t>& from, bool more) {
    Subset best{{}, -HUGE_VAL};
    for (std::size_t i = 0; i < size; ++i) {
      auto terms = from;
      if ((std::ranges::count(from, i) > 0) == more) continue;
      if (more) terms.insert(std::ranges::upper_bound(terms, i), i);
      else std::erase(terms, i);
      if (const double there = evidence(terms); there > best.evidence) best = {std::move(terms), there};
    }
    return best;
  };
  auto now = next({}, true);
  if (now.terms.empty()) return result;
  for (auto larger = next(now.terms, true); larger.evidence > now.evidence + worth_of_a_term;
       larger = next(now.terms, true)) {
    now = std::move(larger);
    if (auto smaller = next(now.terms, false); smaller.evidence > now.evidence - worth_of_a_term)
      now = std::move(smaller);
  }
  const double whole = evidence(result.kept);
  return {std::move(now.terms), now.evidence - whole};
}

std::vector<FittedCandidate> confirmed(const Search& s, const Hypothesis& accepted, const LinearizedFit& linear,
                                       const std::vector<Screened>& candidates) {
  const auto& now = s.now;
  const Trial usual = trial_with(s, usual_sizes);
  // a form of another size may be likelier without any of them, too
  const double gain_without = s.on_board ? likely_form(usual, s.trial, s.sizes, accepted, now).gain : 0.0;
  std::vector<std::optional<FittedCandidate>> fits(candidates.size());
  in_parallel(candidates.size(), 0, [&](std::size_t i) {
    const auto& form = *candidates[i].form;
    const auto hypothesis = with(accepted, form);
    try {
      const auto trial = trial_with(s, candidates[i].sizes);
      if (form.told.empty() && is_surely_ordinary(trial, form, now.point, candidates[i].predicted_gain.values)) return;
      const auto found = fit_beside(trial, hypothesis, now, linear, candidates[i].predicted_gain.values);
      double gain = found.log_evidence - now.log_evidence;
      if (!std::isfinite(gain)) return;
      LikelyForm likely{candidates[i].sizes, 0.0};
      if (s.on_board) likely = likely_form(usual, trial, likely.sizes, hypothesis, found);
      gain += likely.gain - gain_without;
      if (is_as_ordinary(trial, form, found.point, found.point.size() - std::ssize(form.coordinates))) return;
      if (is_drag(form) && !acts(trial, form, found, gain)) return;
      gain += pruned(form, found).gain + likely_spread(problem_of(trial, hypothesis), form, found).gain;
      if (is_unknown(form) && !is_drag(form)) gain -= worth_of_a_name;
      if (form.id == WaveDrift<>::id) gain -= worth_of_waves;
      fits[i] = FittedCandidate{&form, found, gain, last_effect(trial, form, found.point)};
      fits[i]->sizes = likely.sizes;
      put_trace(trial, *fits[i]);
    } catch (const std::exception&) {}
  });
  std::vector<FittedCandidate> result;
  for (auto& tried : fits)
    if (tried) result.push_back(std::move(*tried));
  std::ranges::stable_sort(result, std::greater{}, &FittedCandidate::gain);
  return result;
}

FittedCandidate reduced(const Trial& trial, const Hypothesis& accepted, FittedCandidate tried,
                        std::deque<EffectForm>& forms) {
  if (!tried.form->parts.empty()) return with_likely_spread(trial, accepted, std::move(tried), forms);
  for (;;) {
    const auto kept = pruned(*tried.form, tried.fit).kept;
    if (kept.size() == tried.form->coordinates.size()) return tried;
    const auto base = tried.fit.point.size() - std::ssize(tried.form->coordinates);
    std::vector<double> start;
    for (const auto i : kept) start.push_back(tried.fit.point[base + static_cast<Eigen::Index>(i)]);
    forms.push_back(tried.form->with_terms(kept));
    const auto hypothesis = with(accepted, forms.back());
    auto found = fit(trial, hypothesis, with_start(tried.fit.point.head(base), start), tried.fit.noise);
    if (!std::isfinite(found.log_evidence)) return tried;
    std::vector<double> widening;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const auto before = base + static_cast<Eigen::Index>(kept[i]), now = base + static_cast<Eigen::Index>(i);
      const double so_far = tried.widening.empty() ? 1.0 : tried.widening[kept[i]];
      widening.push_back(so_far *
                         std::max(1.0, std::sqrt(tried.fit.covariance(before, before) / found.covariance(now, now))));
    }
    tried.form = &forms.back();
    tried.effect = last_effect(trial, forms.back(), found.point);
    tried.widening = std::move(widening);
    tried.fit = std::move(found);
    put_trace(trial, tried);
  }
}

}  // namespace swayaw::mismatch::detail
