#include "screening.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "../trial/track_course.hpp"
#include "significance.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/parallel.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

constexpr int screening_iterations = 5;      ///< of a form with one or two starts; with more, one from each, then 4
constexpr std::size_t goes_on_from = 2;      ///< starts of a form that go on after a first iteration
constexpr std::size_t most_of_one_kind = 2;  ///< forms of one effect that are fitted: a delay has one for each channel

/// A form and where its search begins.
struct Job {
  const EffectForm* form;
  std::vector<double> start;
  int iterations;
  PredictedGain predicted_gain{};
};

using Besides = std::map<const EffectForm*, Beside>;

Besides besides(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& linear,
                std::span<const EffectForm> forms) {
  std::vector<std::optional<Beside>> each(forms.size());
  in_parallel(forms.size(), 0, [&](std::size_t i) { each[i] = beside(trial, accepted, linear, forms[i]); });
  Besides all;
  for (std::size_t i = 0; i < forms.size(); ++i)
    if (each[i]) all.emplace(&forms[i], *std::move(each[i]));
  return all;
}

void work_on(std::vector<Job>& jobs, const Trial& trial, const Hypothesis& accepted, const LinearizedFit& linear,
             const Besides& besides) {
  in_parallel(jobs.size(), 0, [&](std::size_t i) {
    try {
      const auto other = besides.find(jobs[i].form);
      jobs[i].predicted_gain = predicted_gain(trial, accepted, other == besides.end() ? linear : other->second.linear,
                                              *jobs[i].form, jobs[i].start, jobs[i].iterations);
      if (other != besides.end()) jobs[i].predicted_gain.gain += other->second.gain;
    } catch (const std::exception&) {  // the ship cannot sail with such an effect
    }
  });
}

/// Of each form with many starts the two that gain most after a first step go on from there.
std::vector<Job> worth_more(const std::vector<Job>& first) {
  std::vector<Job> chosen;
  for (auto job = first.begin(); job != first.end();) {
    const auto end = std::find_if(job, first.end(), [&](const Job& j) { return j.form != job->form; });
    std::vector<const Job*> of_form;
    for (; job != end; ++job)
      if (std::isfinite(job->predicted_gain.gain)) of_form.push_back(&*job);
    std::ranges::stable_sort(of_form, std::greater{}, [](const Job* j) { return j->predicted_gain.gain; });
    for (std::size_t i = 0; i < std::min(goes_on_from, of_form.size()); ++i)
      chosen.push_back({of_form[i]->form, of_form[i]->predicted_gain.values, screening_iterations - 1});
  }
  return chosen;
}

std::vector<Screened> screened(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& linear,
                               std::span<const EffectForm> forms) {
  std::vector<Job> jobs, many;
  const auto replacing = besides(trial, accepted, linear, forms);
  for (const auto& form : forms) {
    if (std::ranges::any_of(accepted, [&](const EffectForm* a) { return a->id == form.id; })) continue;
    if (const auto ordinary = in_whose_place(trial, form, linear.point))
      if (const auto there = coordinates_of(trial.ship, form, *ordinary))
        jobs.push_back({&form, *there, screening_iterations});
    for (const auto& start : form.starts)
      (form.starts.size() > 2 ? many : jobs)
          .push_back({&form, start, form.starts.size() > 2 ? 1 : screening_iterations});
  }
  work_on(many, trial, accepted, linear, replacing);
  std::ranges::move(worth_more(many), std::back_inserter(jobs));
  work_on(jobs, trial, accepted, linear, replacing);
  std::map<const EffectForm*, PredictedGain> best;
  for (auto& job : jobs)
    if (job.predicted_gain.gain > best[job.form].gain) best[job.form] = std::move(job.predicted_gain);
  std::vector<Screened> result;
  for (const auto& form : forms)  // in the order of the catalogue, so that the answer does not hang on addresses
    if (const auto found = best.find(&form); found != best.end() && std::isfinite(found->second.gain))
      result.push_back({&form, found->second});
  std::ranges::stable_sort(result, std::greater{}, [](const Screened& s) { return s.predicted_gain.gain; });
  return result;
}

/// The same candidates beside another baseline, each from where it was.
std::vector<Screened> screened_again(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& linear,
                                     std::span<const EffectForm> forms, std::vector<Screened> candidates) {
  std::vector<Job> jobs;
  for (const auto& c : candidates) jobs.push_back({c.form, c.predicted_gain.values, screening_iterations});
  work_on(jobs, trial, accepted, linear, besides(trial, accepted, linear, forms));
  for (std::size_t i = 0; i < jobs.size(); ++i) candidates[i].predicted_gain = std::move(jobs[i].predicted_gain);
  std::erase_if(candidates, [](const Screened& c) { return !std::isfinite(c.predicted_gain.gain); });
  return candidates;
}

// ---------------------------------------------------------------- where fits begin

/// An error of the compass begins its fit where the track tells one, too. A fit that had none may have turned it into
/// sway, with hardly any force left that holds her against it: from there a compass 4.2 deg off, plain from the track
/// on five courses, was predicted as 1.2 deg to the other side, and gained 2 in log evidence in place of 150 (seed 34).
void begin_where_the_track_tells(std::vector<EffectForm>& forms, const Trial& trial) {
  constexpr double clearly_off = radians(1.0);  // five times an ordinary error
  const auto compass = std::ranges::find(forms, HeadingBias<>::id, &EffectForm::id);
  if (compass == forms.end()) return;
  const auto off = heading_off_track(trial.runs, time_unit_of(trial.ship));
  if (!off || std::abs(*off) < clearly_off) return;
  if (const auto start = coordinates_of(trial.ship, *compass, HeadingBias<>{*off})) compass->told = *start;
}

/// What stands in the place of an ordinary error that has come to its end begins there, too: it is larger than
/// ordinary. A linear prediction does not see it where others have come to theirs with it: a rudder recorded 4.2 s late
/// (2.5 s as its own ordinary delay, and 1.2 s each as clocks of heading and yaw rate that are early) was predicted to
/// gain 3 in log evidence and gains 140, one of 7.8 s nothing and 420 (seed 34).
void begin_where_the_ordinary_ends(std::vector<EffectForm>& forms, const Trial& trial, const Point& point) {
  constexpr double near = 0.02;  // of an ordinary deviation
  for (const auto& place : ordinary_places(trial)) {
    const auto& ordinary = *place.form;
    if (ordinary.id == form_id || place.size() != 1) continue;
    const auto c = place.coordinates(point);
    const auto& range = ordinary.coordinates.front();
    if (range.low + near < c.front() && c.front() < range.high - near) continue;
    for (auto& form : forms) {
      if (!form.told.empty() || form.id != ordinary.id || !stands_for(form, ordinary)) continue;
      const auto start = coordinates_of(trial.ship, form, ordinary.at(c));
      const auto& room = form.coordinates.front();
      if (start && room.low + near < start->front() && start->front() < room.high - near) form.told = *start;
    }
  }
}

/// Where the baseline stands far from the ship as given, what predicts most beside that ship begins there, too.
/// Coefficients that went far hold the ship in a valley of its own, which tells nothing of the other: a shaft that
/// slows by a fifth was predicted to gain nothing beside a straightening of a fifth, a sixth less thrust and a rudder
/// of another form, and gains 133 in log evidence; a rudder 43 % weak 2, and gains 53 (seed 35).
void begin_at_the_given_ship(std::vector<EffectForm>& forms, const Search& s, double needed) try {
  constexpr double far = 3.0;  // deviations of a coefficient: chance takes one in 400 there
  const auto& trial = s.trial;
  if (s.now.point.head(std::ssize(trial.parameters)).lpNorm<Eigen::Infinity>() < far) return;
  auto given = s.now;
  given.point.head(trial.baseline_size()) = trial.mean;
  const auto hypothesis = s.hypothesis();
  const auto found = screened(trial, hypothesis, linearized(trial, hypothesis, given), forms);
  if (found.empty() || !(found.front().predicted_gain.gain > needed)) return;
  auto& form = *std::ranges::find(forms, found.front().form, [](const EffectForm& f) { return &f; });
  if (form.told.empty()) form.told = found.front().predicted_gain.values, form.told_beside_given = true;
} catch (const std::exception&) {  // as given she cannot sail these runs
}

// ---------------------------------------------------------------- choice

/// Whether an effect is larger than its practical floor somewhere within two deviations of each coordinate.
/// @param covariance  of its coordinates
bool may_matter(const Ship& ship, const EffectForm& form, std::span<const double> coordinates,
                const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd reach = 2.0 * widened(form, covariance).diagonal().cwiseMax(0.0).cwiseSqrt();
  std::vector<double> c(coordinates.begin(), coordinates.end());
  if (is_finding(ship, form, c)) return true;
  for (std::size_t i = 0; i < c.size(); ++i)
    for (const double sign : {1.0, -1.0}) {
      const double moved = coordinates[i] + sign * reach[static_cast<Eigen::Index>(i)];
      c[i] = std::clamp(moved, form.coordinates[i].low, form.coordinates[i].high);
      if (is_finding(ship, form, c)) return true;
      c[i] = coordinates[i];
    }
  return false;
}

}  // namespace

std::optional<Beside> beside(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& linear,
                             const EffectForm& form) {
  const auto replaced = replaced_by(trial, form);
  if (replaced.empty()) return std::nullopt;
  const auto problem = problem_of(trial, accepted);
  auto other = linear, held = linear;
  const auto hold = [](LinearizedFit& fit, Eigen::Index i) {
    fit.slopes.col(i).setZero();
    fit.information.row(i).setZero(), fit.information.col(i).setZero();
  };
  for (const auto i : replaced) {
    const auto& unknown = problem.unknowns[static_cast<std::size_t>(i)];
    if (!(unknown.low < linear.point[i] && linear.point[i] < unknown.high))
      hold(held, i);  // at its end it gains no more
    hold(other, i), other.point[i] = unknown.mean;
  }
  other = with_prior_of(problem, std::move(other));
  const double gain = linear_evidence(problem, other) - linear_evidence(problem, held);
  return Beside{std::move(other), gain};
}

std::vector<Screened> screened_beside_form(const Search& s, const Hypothesis& accepted, const LinearizedFit& linear) {
  auto candidates = screened(s.trial, accepted, linear, s.forms);
  for (auto& c : candidates) c.sizes = s.sizes;
  if (!s.on_board || s.usual.calibrated) return candidates;
  constexpr double smaller = 0.125;
  auto sizes = s.sizes;
  for (double& size : sizes) size *= smaller;
  const auto narrow = trial_with(s, sizes);
  const auto beside = problem_of(narrow, accepted);
  const auto other = with_prior_of(beside, linear);
  const double cost = gain_by_prior(problem_of(s.trial, accepted), s.now, narrow.precision);
  for (auto& c : screened_again(narrow, accepted, other, s.forms, candidates)) {
    c.sizes = sizes, c.predicted_gain.gain += cost;
    const auto same = std::ranges::find(candidates, c.form, &Screened::form);
    if (c.predicted_gain.gain > same->predicted_gain.gain) *same = std::move(c);
  }
  std::ranges::stable_sort(candidates, std::greater{}, [](const Screened& c) { return c.predicted_gain.gain; });
  return candidates;
}

void keep_from_early(std::vector<EffectForm>& forms, const Trial& trial) {
  for (auto& form : forms) {
    if (form.id != ChannelDelay<>::id) continue;
    form.coordinates.front().low = 0.0;
    for (const auto& ordinary : trial.ordinary)
      if (stands_for(form, ordinary))
        if (const auto earliest =
                coordinates_of(trial.ship, form, ordinary.at(std::vector{ordinary.coordinates.front().low})))
          form.coordinates.front().low = earliest->front();
    std::erase_if(form.starts, [&](const auto& start) { return start.front() < form.coordinates.front().low; });
  }
}

void begin_where_force_is_missing(std::vector<EffectForm>& forms,
                                  const std::optional<std::pair<double, double>>& interval, double time_unit) {
  if (!interval) return;
  for (auto& form : forms) {
    if (std::ranges::none_of(form.coordinates, [](const Coordinate& c) { return c.name.starts_with("onset"); }))
      continue;
    form.window = {(interval->first - form.begin) / time_unit, (interval->second - form.begin) / time_unit};
    for (auto start : std::vector(form.starts)) {
      std::ranges::copy(form.window, start.end() - 2);
      if (std::ranges::count(form.starts, start) == 0) form.starts.push_back(std::move(start));
    }
  }
}

void begin_where_told(Search& s, double needed) {
  for (auto& form : s.forms) form.told.clear(), form.told_beside_given = false;
  begin_where_the_track_tells(s.forms, s.trial);
  begin_where_the_ordinary_ends(s.forms, s.trial, s.now.point);
  if (s.accepted.empty()) begin_at_the_given_ship(s.forms, s, needed);
}

std::vector<Screened> most_promising(const std::vector<Screened>& candidates, std::size_t most, double least,
                                     std::span<const FittedCandidate> before, double needed) {
  const auto gained = [&](const EffectForm* form) {
    return std::ranges::any_of(
        before, [&](const FittedCandidate& t) { return t.form == form && t.gain > needed && !t.refuted; });
  };
  std::vector<Screened> chosen;
  for (const auto& c : candidates) {
    const auto same = std::ranges::count_if(chosen, [&](const Screened& s) { return s.form->id == c.form->id; });
    const bool is_promising = chosen.size() < most && same < std::ptrdiff_t{most_of_one_kind};
    const bool is_to_be_fitted = !c.form->window.empty() || !c.form->told.empty() || gained(c.form);
    if ((is_promising && c.predicted_gain.gain > least) || is_to_be_fitted) chosen.push_back(c);
  }
  return chosen;
}

std::vector<UnfittedCandidate> all_but(const std::vector<Screened>& chosen, const std::vector<Screened>& candidates,
                                       const Search& s) {
  std::vector<UnfittedCandidate> result;
  for (const auto& c : candidates) {
    if (std::ranges::count(chosen, c.form, &Screened::form) > 0) continue;
    const auto& [gain, values, covariance] = c.predicted_gain;
    const bool unseen = stands_for_unseen(*c.form, s.on_board);
    result.push_back(
        {c.form, gain, unseen || may_matter(s.trial.ship, *c.form, values, covariance), unseen ? odds_of_unseen : 0.0});
  }
  return result;
}

}  // namespace swayaw::mismatch::detail
