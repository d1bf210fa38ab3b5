#include "search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

constexpr double as_good = 5.0;      ///< difference in log evidence that does not tell effects apart
constexpr std::size_t most_traces = 2;

// ---------------------------------------------------------------- all candidates

/// The best start of a form, by what it promises.
struct Screened {
  const EffectForm* form;
  Promise promise;
};

std::vector<Screened> screened(const Trial& trial, const Hypothesis& accepted, const Screen& screen, std::span<const EffectForm> forms) {
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
  for (const auto& form : forms)  // in the order of the catalogue, so that the answer does not hang on addresses
    if (const auto found = best.find(&form); found != best.end() && std::isfinite(found->second.gain)) result.push_back({&form, found->second});
  std::ranges::stable_sort(result, std::greater{}, [](const Screened& s) { return s.promise.gain; });
  return result;
}

// ---------------------------------------------------------------- terms

/// Which terms of the last effect the evidence keeps, and what it gains without the others.
struct Pruned {
  std::vector<std::size_t> kept;
  double gain = 0.0;
};

/// Savage–Dickey: without a term the evidence grows by posterior over prior density of the term at 0. The worst is dropped first, and the
/// others take the values that they have without it.
Pruned pruned(const EffectForm& form, const MapFit& fit) {
  const auto size = static_cast<Eigen::Index>(form.coordinates.size());
  Pruned result;
  for (std::size_t i = 0; i < form.coordinates.size(); ++i) result.kept.push_back(i);
  if (!form.with_terms) return result;
  Eigen::VectorXd mean = fit.point.tail(size);
  Eigen::MatrixXd C = fit.covariance.bottomRightCorner(size, size);
  while (result.kept.size() > 1) {
    const Eigen::VectorXd growth = -0.5 * mean.array().square() / C.diagonal().array() - 0.5 * C.diagonal().array().log();
    Eigen::Index worst = 0;
    if (!(growth.maxCoeff(&worst) > 0.0)) break;
    result.gain += growth[worst];
    const Eigen::VectorXd slope = C.col(worst) / C(worst, worst);
    mean -= slope * mean[worst];
    C -= (slope * C.row(worst)).eval();
    const auto rest = mean.size() - 1;
    std::vector<Eigen::Index> others;
    for (Eigen::Index i = 0; i <= rest; ++i)
      if (i != worst) others.push_back(i);
    mean = mean(others).eval();
    C = C(others, others).eval();
    result.kept.erase(result.kept.begin() + worst);
  }
  return result;
}

// ---------------------------------------------------------------- converged fits

Effect last_effect(const Hypothesis& hypothesis, const Point& point) {
  const auto size = hypothesis.back()->coordinates.size();
  return hypothesis.back()->at({point.data() + point.size() - static_cast<Eigen::Index>(size), size});
}

Hypothesis with(Hypothesis hypothesis, const EffectForm& form) {
  hypothesis.push_back(&form);
  return hypothesis;
}

/// A fit that comes out far below the hypothesis without the effect stopped too early; from a small effect it begins once more.
MapFit fit_beside(const Trial& trial, const Hypothesis& hypothesis, const MapFit& now, const std::vector<double>& promised) {
  auto found = fit(trial, hypothesis, with_start(now.point, promised), now.noise);
  if (found.log_evidence > now.log_evidence - 15.0) return found;
  auto small = promised;
  for (double& c : small) c *= 0.1;
  const auto again = fit(trial, hypothesis, with_start(now.point, small), now.noise);
  return again.log_evidence > found.log_evidence ? again : found;
}

/// A heel that is recorded is explained by rolling alone; it is coupled only where sway force or yaw moment show it.
bool acts(const EffectForm& form, const MapFit& found) {
  if (form.id != "roll_coupling") return true;
  const auto from = found.point.size() - static_cast<Eigen::Index>(form.coordinates.size());
  for (std::size_t i = 0; i < form.coordinates.size(); ++i) {
    const auto k = from + static_cast<Eigen::Index>(i);
    if (form.coordinates[i].name.ends_with("_phi") && std::abs(found.point[k]) > 2.0 * std::sqrt(found.covariance(k, k))) return true;
  }
  return false;
}

/// The most promising, of one effect not more than two: a delay comes in as many forms as there are channels.
std::vector<Screened> most_promising(const std::vector<Screened>& candidates, std::size_t most) {
  std::vector<Screened> chosen;
  for (const auto& c : candidates)
    if (chosen.size() < most && std::ranges::count_if(chosen, [&](const Screened& s) { return s.form->id == c.form->id; }) < 2) chosen.push_back(c);
  return chosen;
}

/// Converged fits of the most promising candidates, best first.
std::vector<Tried> confirmed(const Trial& trial, const Hypothesis& accepted, const MapFit& now, const std::vector<Screened>& screening, std::size_t most) {
  const auto candidates = most_promising(screening, most);
  std::vector<std::optional<Tried>> fits(candidates.size());
  in_parallel(candidates.size(), 0, [&](std::size_t i) {
    const auto& form = *candidates[i].form;
    const auto hypothesis = with(accepted, form);
    try {
      const auto found = fit_beside(trial, hypothesis, now, candidates[i].promise.coordinates);
      const double gain = found.log_evidence - now.log_evidence;
      if (!std::isfinite(gain)) return;
      const auto effect = last_effect(hypothesis, found.point);
      const double without = pruned(form, found).gain;
      fits[i] = Tried{&form, found, gain + without, effect, !is_finding(trial.ship, effect) || !acts(form, found)};
    } catch (const Refusal&) {
    }
  });
  std::vector<Tried> result;
  for (auto& tried : fits)
    if (tried) result.push_back(std::move(*tried));
  std::ranges::stable_sort(result, std::greater{}, &Tried::gain);
  return result;
}

/// The effect with those of its terms that the evidence keeps.
Tried reduced(const Trial& trial, const Hypothesis& accepted, Tried tried, std::deque<EffectForm>& forms) {
  const auto terms = pruned(*tried.form, tried.fit);
  if (terms.kept.size() == tried.form->coordinates.size()) return tried;
  forms.push_back(tried.form->with_terms(terms.kept));
  const auto base = tried.fit.point.size() - static_cast<Eigen::Index>(tried.form->coordinates.size());
  std::vector<double> start;
  for (const auto i : terms.kept) start.push_back(tried.fit.point[base + static_cast<Eigen::Index>(i)]);
  const auto hypothesis = with(accepted, forms.back());
  auto found = fit(trial, hypothesis, with_start(tried.fit.point.head(base), start), tried.fit.noise, 2);
  if (!std::isfinite(found.log_evidence)) return tried;
  tried.form = &forms.back();
  tried.effect = last_effect(hypothesis, found.point);
  tried.trace = !is_finding(trial.ship, tried.effect);
  tried.fit = std::move(found);
  return tried;
}

// ---------------------------------------------------------------- runs that were not used

/// At the noise that suits these runs: other manoeuvres leave other things unexplained.
double log_likelihood_of(const Trial& trial, const Hypothesis& hypothesis, const MapFit& found) {
  return best_noise(trial, ship_at(trial, hypothesis, found.point), found.noise, true).log_likelihood;
}

/// Gain in log likelihood of held-out runs, or of each run by a fit to the others.
double held_out_gain(const Trial& trial, const Trial& unused, const Hypothesis& before, const MapFit& a, const Hypothesis& after, const MapFit& b) {
  if (!unused.runs.empty()) return log_likelihood_of(unused, after, b) - log_likelihood_of(unused, before, a);
  std::vector<double> gains(trial.runs.size());
  in_parallel(trial.runs.size(), 0, [&](std::size_t i) {
    Trial others = trial, one = trial;
    others.runs.erase(others.runs.begin() + static_cast<std::ptrdiff_t>(i));
    one.runs = {trial.runs[i]};
    const auto of = [&](const Hypothesis& h, const MapFit& from) {
      MapFit found = fit(others, h, from.point, from.noise, 1);
      found.noise = from.noise;
      return found.point.size() == 0 ? -HUGE_VAL : log_likelihood_of(one, h, found);
    };
    gains[i] = of(after, b) - of(before, a);
  });
  double sum = 0.0;
  for (const double gain : gains) sum += gain;
  return sum;
}

/// Whether other runs gain too. An effect of a time in one run is not asked for it, nor is a single run.
bool holds_elsewhere(const Trial& trial, const Trial& unused, const Search& s, const Tried& tried) {
  if (std::holds_alternative<Gust<double>>(tried.effect) || (unused.runs.empty() && trial.runs.size() < 2)) return true;
  const auto before = s.hypothesis();
  return held_out_gain(trial, unused, before, s.now, with(before, *tried.form), tried.fit) > 1.0;
}

// ---------------------------------------------------------------- choice

/// Against nothing, which stands at the gain that is needed, and against the others that matter.
double probability_of(const Tried& one, std::span<const Tried> tried, double needed) {
  if (one.trace) return 0.0;
  double sum = std::exp((needed - one.gain) / evidence_excess);
  for (const auto& t : tried)
    if (!t.trace) sum += std::exp((t.gain - one.gain) / evidence_excess);
  return 1.0 / sum;
}

Accepted accepted_as(const Tried& best, std::span<const Tried> tried, double needed) {
  Accepted result{best.form, best.gain, probability_of(best, tried, needed), best.trace, {}};
  for (const auto& t : tried) {
    if (t.form->id == best.form->id || best.gain - t.gain > as_good || t.gain < as_good || t.trace) continue;
    if (std::ranges::none_of(result.rivals, [&](const Tried& r) { return r.form->id == t.form->id; })) result.rivals.push_back(t);
  }
  return result;
}

/// The best that matters, gains enough and holds elsewhere; a trace only where nothing that matters is nearly as good.
std::optional<Tried> chosen(const Trial& trial, const Trial& unused, Search& s, std::span<const Tried> tried, double needed, bool trace_may) {
  for (const auto& t : tried) {
    if (!(t.gain > needed)) break;
    if (t.trace) {
      const bool leads = std::ranges::none_of(tried, [&](const Tried& o) { return !o.trace && o.gain > needed && o.gain > t.gain - as_good; });
      if (trace_may && leads && holds_elsewhere(trial, unused, s, t)) return t;
      continue;
    }
    const auto whole = reduced(trial, s.hypothesis(), t, s.reduced);
    if (holds_elsewhere(trial, unused, s, whole)) return whole;
  }
  return std::nullopt;
}

}  // namespace

Hypothesis Search::hypothesis(std::size_t count) const {
  Hypothesis result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(accepted[i].form);
  return result;
}

std::vector<Candidate> ranked(std::span<const Tried> tried, double needed) {
  std::vector<Candidate> result;
  for (const auto& t : tried) {
    const double probability = probability_of(t, tried, needed);
    const auto same = std::ranges::find(result, t.form->id, &Candidate::effect);
    if (same != result.end()) same->probability += probability;
    else result.push_back({t.form->id, probability, t.gain, {}, t.trace});
  }
  return result;
}

Search search(const Trial& trial, const Trial& unused, std::span<const EffectForm> forms, const DiagnosisOptions& options,
              const std::function<bool(std::string_view)>& goes_on) {
  Search s;
  bool working = goes_on("fitting the baseline");
  s.null = fit(trial, {}, trial.mean, Noise{});
  if (s.null.point.size() == 0) throw Refusal("the model cannot follow these runs at all; look at them with compare first");
  s.now = s.null;
  std::size_t findings = 0, traces = 0;
  while (working && findings < options.most_effects && (s.accepted.empty() || s.now.noise.scale > 0.6)) {
    working = goes_on(s.accepted.empty() ? "trying every effect" : "trying a further effect");
    const auto before = s.hypothesis();
    const auto screen = screen_of(trial, before, s.now);
    if (s.accepted.empty()) s.screen = screen;
    const auto tried = confirmed(trial, before, s.now, screened(trial, before, screen, forms), options.confirmed);
    if (s.accepted.empty()) s.first = tried;
    const double needed = s.accepted.empty() ? options.detection : options.further;
    const auto best = chosen(trial, unused, s, tried, needed, traces < most_traces);
    if (!best) break;
    s.accepted.push_back(accepted_as(*best, tried, needed));
    s.now = best->fit;
    ++(best->trace ? traces : findings);
  }
  return s;
}

}  // namespace swayaw
