#include "swayaw/mismatch/diagnose.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"
#include "trial.hpp"

namespace swayaw {
namespace {

constexpr double ordinary = 1.5;  ///< largest scale of the imperfection that an adequate model leaves

// ---------------------------------------------------------------- search

/// A candidate, fitted beside the effects that are accepted already.
struct Tried {
  const EffectForm* form;
  MapFit fit;
  double gain;
  Effect effect;
  bool trace;
};

double duration_of(std::span<const Recording> runs) {
  double longest = 0.0;
  for (const auto& run : runs) longest = std::max(longest, run.time.back());
  return longest;
}

Effect last_effect(const Trial& trial, const Hypothesis& hypothesis, const Point& point) {
  Eigen::Index from = trial.baseline_size();
  for (std::size_t i = 0; i + 1 < hypothesis.size(); ++i) from += static_cast<Eigen::Index>(hypothesis[i]->coordinates.size());
  return hypothesis.back()->at({point.data() + from, hypothesis.back()->coordinates.size()});
}

/// The best start of every form, by what it promises; best first.
struct Screened {
  const EffectForm* form;
  Promise promise;
};

std::vector<Screened> screened(const Trial& trial, const Hypothesis& accepted, const MapFit& now, std::span<const EffectForm> forms) {
  const auto screen = screen_of(trial, accepted, now);
  struct Job {
    const EffectForm* form;
    const std::vector<double>* start;
    Promise promise{};
  };
  std::vector<Job> jobs;
  for (const auto& form : forms) {
    if (std::ranges::any_of(accepted, [&](const EffectForm* a) { return a->id == form.id; })) continue;
    for (const auto& start : form.starts) jobs.push_back({&form, &start});
  }
  in_parallel(jobs.size(), 0, [&](std::size_t i) {
    try {
      jobs[i].promise = promise(trial, accepted, screen, *jobs[i].form, *jobs[i].start);
    } catch (const Refusal&) {  // the ship cannot sail with such an effect
    }
  });
  std::map<const EffectForm*, Promise> best;
  for (auto& job : jobs)
    if (job.promise.gain > best[job.form].gain) best[job.form] = std::move(job.promise);
  std::vector<Screened> result;
  for (auto& [form, found] : best)
    if (std::isfinite(found.gain)) result.push_back({form, std::move(found)});
  std::ranges::sort(result, std::greater{}, [](const Screened& s) { return s.promise.gain; });
  return result;
}

/// Converged fits of the most promising candidates, best first.
std::vector<Tried> confirmed(const Trial& trial, const Hypothesis& accepted, const MapFit& now, std::vector<Screened> candidates, std::size_t most) {
  candidates.resize(std::min(most, candidates.size()));
  std::vector<std::optional<Tried>> fits(candidates.size());
  in_parallel(candidates.size(), 0, [&](std::size_t i) {
    Hypothesis hypothesis = accepted;
    hypothesis.push_back(candidates[i].form);
    try {
      auto found = fit(trial, hypothesis, with_start(trial, hypothesis, now.point, candidates[i].promise.coordinates), now.noise);
      const auto effect = last_effect(trial, hypothesis, found.point);
      const double gain = found.log_evidence - now.log_evidence;
      if (!std::isfinite(gain)) return;
      fits[i] = Tried{candidates[i].form, std::move(found), gain, effect, !is_finding(trial.ship, effect)};
    } catch (const Refusal&) {
    }
  });
  std::vector<Tried> result;
  for (auto& tried : fits)
    if (tried) result.push_back(std::move(*tried));
  std::ranges::sort(result, std::greater{}, &Tried::gain);
  return result;
}

/// Runs in which nothing is hidden tell the baseline.
void calibrate(Trial& trial, const Ship& ship, std::span<const Recording> reference, std::span<const Channel> channels) {
  if (reference.empty()) return;
  const auto calm = trial_of(ship, reference, channels);
  const auto found = fit(calm, {}, calm.mean, Noise{});
  trial.mean = found.point;
  trial.precision = (2.0 * found.covariance).inverse();  // a little wider: no two days are alike
}

// ---------------------------------------------------------------- answers

std::vector<EffectParameterEstimate> estimates(const Trial& trial, const EffectForm& form, const MapFit& found, Eigen::Index from) {
  const auto size = static_cast<Eigen::Index>(form.coordinates.size());
  const Point c = found.point.segment(from, size);
  const auto values_at = [&](const Point& p) {
    std::vector<double> values;
    for (const auto& n : numbers_of(trial.ship, form.at({p.data(), static_cast<std::size_t>(size)}))) values.push_back(n.value);
    return values;
  };
  const auto numbers = numbers_of(trial.ship, form.at({c.data(), static_cast<std::size_t>(size)}));
  Eigen::MatrixXd slopes(static_cast<Eigen::Index>(numbers.size()), size);
  for (Eigen::Index k = 0; k < size; ++k) {
    Point up = c, down = c;
    up[k] += 1e-4, down[k] -= 1e-4;
    const auto a = values_at(up), b = values_at(down);
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) slopes(i, k) = wrapped(a[static_cast<std::size_t>(i)] - b[static_cast<std::size_t>(i)]) / 2e-4;
  }
  const Eigen::MatrixXd covariance = slopes * found.covariance.block(from, from, size, size) * slopes.transpose();
  std::vector<EffectParameterEstimate> result;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    if (!std::isfinite(numbers[i].value) || !(covariance(place, place) > 0.0)) continue;
    const bool direction = numbers[i].key.ends_with("from_rad") || numbers[i].key.ends_with("to_rad");
    const double value = direction && numbers[i].value < 0.0 ? numbers[i].value + 2.0 * pi : numbers[i].value;
    result.push_back({std::string(numbers[i].key), value, std::sqrt(covariance(place, place))});
  }
  return result;
}

/// exp(gain) shared out among nothing (gain 0) and the candidates; a scale that stays large leaves room for the unknown.
std::vector<Candidate> ranked(std::span<const Tried> tried, bool adequate) {
  double most = 0.0, sum = 0.0;
  for (const auto& t : tried) most = std::max(most, t.gain);
  for (const auto& t : tried) sum += std::exp(t.gain - most);
  sum += std::exp(-most);
  std::vector<Candidate> result;
  for (const auto& t : tried) {
    const double probability = std::exp(t.gain - most) / sum;
    const auto same = std::ranges::find(result, t.form->id, &Candidate::effect);
    if (same != result.end()) same->probability += adequate ? probability : 0.5 * probability;
    else result.push_back({t.form->id, adequate ? probability : 0.5 * probability, t.gain, t.trace});
  }
  return result;
}

std::vector<RunErrors> errors_of(const Ship& before, const Ship& refitted, const Ship& after, std::span<const Recording> runs) {
  std::vector<RunErrors> result;
  const auto errors = [](const Ship& ship, const Recording& run) -> std::vector<QuantityError> {
    try {
      return compare(ship, run).errors;
    } catch (const Refusal&) {
      return {};
    }
  };
  for (const auto& run : runs) result.push_back({run.name, errors(before, run), errors(refitted, run), errors(after, run)});
  return result;
}

/// Mean relative fall of heading and yaw rate error over the refitted baseline.
double gain_of(std::span<const RunErrors> runs) {
  double sum = 0.0;
  int count = 0;
  for (const auto& run : runs)
    for (const auto quantity : {Quantity::heading, Quantity::yaw_rate, Quantity::speed, Quantity::position}) {
      const auto a = std::ranges::find(run.refitted, quantity, &QuantityError::quantity), b = std::ranges::find(run.after, quantity, &QuantityError::quantity);
      if (a == run.refitted.end() || b == run.after.end() || !(a->window_rms > 0.0)) continue;
      sum += 1.0 - b->window_rms / a->window_rms;
      ++count;
    }
  return count ? sum / count : 0.0;
}

/// Part of a run with most of the unexplained acceleration of a kind.
std::optional<MismatchPlace> place_of(const PreparedRun& run, const FilterPass& pass, int axis) {
  constexpr std::array names{"surge_force", "sway_force", "yaw_moment"};
  const auto& time = run.run->time;
  std::vector<double> energy;
  for (const auto& x : pass.filtered) energy.push_back(x[6 + axis] * x[6 + axis]);
  const double sum = std::accumulate(energy.begin(), energy.end(), 0.0), mean = sum / static_cast<double>(energy.size());
  // the interval with the largest sum above the mean
  double best = 0.0, now = 0.0;
  std::size_t start = 0, from = 0, to = 0;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    if (now <= 0.0) now = 0.0, start = i;
    now += energy[i] - mean;
    if (now > best) best = now, from = start, to = i;
  }
  if (!(best > 0.0)) return std::nullopt;
  const double inside = std::accumulate(energy.begin() + static_cast<std::ptrdiff_t>(from), energy.begin() + static_cast<std::ptrdiff_t>(to) + 1, 0.0);
  return MismatchPlace{run.run->name, names[static_cast<std::size_t>(axis)], time[from], time[to], inside / sum, {}};
}

/// The axis on which most force is missing, over what is ordinary, in each run.
std::vector<MismatchPlace> location_of(const Trial& trial, const std::vector<FilterPass>& passes) {
  const double U = service_speed(trial.ship), L = length(trial.ship);
  const std::array unit{0.3 * U * U / L, U * U / L, 1.5 * U * U / (L * L)};
  std::vector<MismatchPlace> places;
  for (std::size_t i = 0; i < trial.runs.size(); ++i) {
    std::array<double, 3> size{};
    for (const auto& x : passes[i].filtered)
      for (int axis = 0; axis < 3; ++axis) size[static_cast<std::size_t>(axis)] += std::pow(x[6 + axis] / unit[static_cast<std::size_t>(axis)], 2);
    const auto axis = static_cast<int>(std::ranges::max_element(size) - size.begin());
    if (auto place = place_of(trial.runs[i], passes[i], axis)) places.push_back(std::move(*place));
  }
  return places;
}

std::string words_of(const Diagnosis& d) {
  if (d.verdict == DiagnosisVerdict::nothing_missing) return "Nothing is missing: the model explains the runs within its confidence and their noise.";
  std::string names;
  for (const auto& e : d.effects) names += (names.empty() ? "" : " and ") + std::string(id_of(e.effect));
  if (d.verdict == DiagnosisVerdict::unexplained)
    return names.empty() ? "Something real is missing that no known effect explains." : fmt::format("Something real is missing; {} comes nearest and does not explain it all.", names);
  return fmt::format("The model leaves out {}.", names);
}

std::vector<std::string> rivals_of(std::span<const Tried> tried, const Tried& best) {
  std::vector<std::string> rivals;
  for (const auto& t : tried)
    if (t.form->id != best.form->id && best.gain - t.gain < 5.0 && t.gain > 5.0 && !t.trace && std::ranges::count(rivals, t.form->id) == 0) rivals.push_back(t.form->id);
  return rivals;
}

}  // namespace

std::string_view name_of(DiagnosisVerdict verdict) {
  switch (verdict) {
    case DiagnosisVerdict::missing_physics: return "missing_physics";
    case DiagnosisVerdict::nothing_missing: return "nothing_missing";
    case DiagnosisVerdict::unexplained: return "unexplained";
  }
  return {};
}

Diagnosis diagnose(const Ship& ship, std::span<const Recording> runs, std::span<const Recording> reference, std::span<const Recording> holdout,
                   const DiagnosisOptions& options) {
  if (runs.empty()) throw Refusal("there is no run to diagnose");
  const auto goes_on = [&](std::string_view what) { return !options.progress || options.progress(what); };
  const auto channels = seen_channels(runs);
  Trial trial = trial_of(ship, runs, channels);
  bool working = goes_on("calibrating on reference runs");
  if (working) calibrate(trial, ship, reference, channels);
  const auto forms = effect_forms(ship, channels, duration_of(runs));
  working = goes_on("fitting the baseline") && working;
  const MapFit null = fit(trial, {}, trial.mean, Noise{});
  if (null.point.size() == 0) throw Refusal("the model cannot follow these runs at all: look at them with compare first");
  MapFit now = null;
  Hypothesis accepted;
  std::vector<Tried> first;
  Diagnosis result{.verdict = DiagnosisVerdict::nothing_missing, .words = {}, .location = {}, .effects = {}, .candidates = {}, .train = {}, .holdout = {},
                   .refitted = ship_at(trial, {}, null.point), .improved = {}, .imperfection = null.noise.scale};
  std::vector<std::vector<std::string>> rivals;
  std::vector<double> gains;
  while (working && accepted.size() < options.most_effects && (accepted.empty() || now.noise.scale > 0.6)) {
    working = goes_on(accepted.empty() ? "trying every effect" : "trying a further effect");
    auto tried = confirmed(trial, accepted, now, screened(trial, accepted, now, forms), options.confirmed);
    const double needed = accepted.empty() ? options.detection : options.further;
    const auto best = std::ranges::find_if(tried, [&](const Tried& t) { return t.gain > needed && !t.trace; });
    if (accepted.empty()) first = tried;
    if (best == tried.end()) break;
    accepted.push_back(best->form);
    rivals.push_back(rivals_of(tried, *best));
    gains.push_back(best->gain);
    now = best->fit;
  }
  const bool adequate = now.noise.scale <= ordinary;
  result.imperfection = now.noise.scale;
  result.improved = ship_at(trial, accepted, now.point);
  result.candidates = ranked(first, adequate);
  Eigen::Index from = trial.baseline_size();
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    const auto size = accepted[i]->coordinates.size();
    FoundEffect found{.effect = accepted[i]->at({now.point.data() + from, size}), .probability = 1.0 / (1.0 + std::exp(-gains[i])), .onset = {}, .end = {},
                      .parameters = estimates(trial, *accepted[i], now, from), .indistinguishable_from = rivals[i]};
    if (!adequate) found.probability *= 0.5;
    if (const auto* gust = std::get_if<Gust<double>>(&found.effect)) found.onset = gust->onset, found.end = gust->end;
    result.effects.push_back(std::move(found));
    from += static_cast<Eigen::Index>(size);
  }
  if (!adequate) result.verdict = DiagnosisVerdict::unexplained;
  else if (!result.effects.empty()) result.verdict = DiagnosisVerdict::missing_physics;
  if (result.verdict != DiagnosisVerdict::nothing_missing) {
    goes_on("where");
    result.location = location_of(trial, filter_passes(trial, result.refitted, null.noise));
  }
  result.train = errors_of(ship, result.refitted, result.improved, runs);
  result.holdout = errors_of(ship, result.refitted, result.improved, holdout);
  (void)gain_of;
  if (options.pictures && goes_on("drawing the runs")) {
    result.train_pictures = run_pictures(ship, result.refitted, result.improved, runs, null.noise);
    result.holdout_pictures = run_pictures(ship, result.refitted, result.improved, holdout, null.noise);
  }
  result.words = words_of(result);
  return result;
}

}  // namespace swayaw
