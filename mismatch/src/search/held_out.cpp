#include "held_out.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/parallel.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// Held-out runs that lose no more than this share of what an effect gains do not refute it, if it gains
/// `clearly` times what is needed: of 400 concealed cases none without an effect came near.
constexpr double small_loss = 0.05;

constexpr double least_held_out = 1.0;  ///< log likelihood that held-out runs must gain otherwise: more than rounding

/// Beside an inexact form, the least share of its gain that an effect must keep with the likelihood that runs not used
/// gain.
constexpr double least_kept = 1.0 / 3.0;

/// At the noise that suits these runs: other manoeuvres leave other things unexplained.
Likelihood likelihood_of(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const Noise& start) {
  return best_noise(problem_of(trial, hypothesis), point, start, true);
}

const Likelihood& likelier(const Likelihood& a, const Likelihood& b) {
  return b.log_likelihood > a.log_likelihood ? b : a;
}

/// Of runs that both hypotheses predict, what the second gains in log likelihood. Likelihood has several summits by the
/// sizes of noise: a motion is process noise or an error of instruments. Each hypothesis stands on the highest of those
/// that either was led to.
///
/// @param from_a  the likelihood of the first, at the noise that suits it from its own on
double gain_of_likelihood(const Trial& trial, const Hypothesis& before, const MapFit& a, const Likelihood& from_a,
                          const Hypothesis& after, const MapFit& b) {
  auto with = likelihood_of(trial, after, b.point, b.noise);
  if (from_a.noise != b.noise) with = likelier(with, likelihood_of(trial, after, b.point, from_a.noise));
  auto without = from_a;
  if (with.noise != a.noise) without = likelier(without, likelihood_of(trial, before, a.point, with.noise));
  return with.log_likelihood - without.log_likelihood;
}

/// What was ordinary, in the place of which stands what is new.
std::vector<Eigen::Index> replaced_by_new(const Trial& trial, const Hypothesis& before, const Hypothesis& after) {
  std::vector<Eigen::Index> replaced;
  for (std::size_t i = before.size(); i < after.size(); ++i)
    std::ranges::copy(replaced_by(trial, *after[i]), std::back_inserter(replaced));
  return replaced;
}

/// The rows of all runs but one.
Eigen::MatrixXd rows_of_others(const Eigen::MatrixXd& slopes, std::span<const PreparedRun> runs, std::size_t one) {
  Eigen::Index before = 0;
  for (std::size_t i = 0; i < one; ++i) before += runs[i].rows();
  const auto after = slopes.rows() - before - runs[one].rows();
  Eigen::MatrixXd others(before + after, slopes.cols());
  others << slopes.topRows(before), slopes.bottomRows(after);
  return others;
}

/// Fits to all parts of the runs but one at the noise of a fit to all, each a round from there; its slopes are those of
/// the others, too.
std::vector<MapFit> fits_to_others(const Trial& trial, const Hypothesis& hypothesis, const MapFit& from) {
  const auto parts = trial.parts();
  const bool by_run = trial.runs.size() > 1;
  const auto slopes = by_run ? linearized(trial, hypothesis, from).slopes : Eigen::MatrixXd();
  std::vector<MapFit> fits(parts.size());
  in_parallel(parts.size(), 0, [&](std::size_t i) {
    Trial others = trial;
    others.runs.assign(parts.begin(), parts.end());
    others.runs.erase(others.runs.begin() + static_cast<std::ptrdiff_t>(i));
    const auto known = by_run ? rows_of_others(slopes, trial.runs, i) : Eigen::MatrixXd();
    fits[i] = fit(others, hypothesis, from.point, from.noise,
                  {.known = by_run ? &known : nullptr, .rounds = 1, .noise_stays = true});
  });
  return fits;
}

/// The runs of one part alone.
Trial one_part(const Trial& trial, std::size_t i) {
  Trial one = trial;
  one.runs = {trial.parts()[i]};
  return one;
}

/// Each part of the runs by a fit to the others.
std::vector<LeftOut> each_left_out(const Trial& trial, const Hypothesis& hypothesis, const MapFit& from) {
  auto fits = fits_to_others(trial, hypothesis, from);
  std::vector<LeftOut> parts(fits.size());
  in_parallel(parts.size(), 0, [&](std::size_t i) {
    if (fits[i].point.size() > 0)
      parts[i].alone = likelihood_of(one_part(trial, i), hypothesis, fits[i].point, fits[i].noise);
    parts[i].fit = std::move(fits[i]);
  });
  return parts;
}

/// Gain in log likelihood of each part of the runs by fits to the others.
double gain_by_others(const Trial& trial, const Hypothesis& before, std::span<const LeftOut> without,
                      const Hypothesis& after, std::span<const MapFit> with) {
  std::vector<double> gains(with.size());
  in_parallel(gains.size(), 0, [&](std::size_t i) {
    const auto& [fit, alone] = without[i];
    if (with[i].point.size() == 0) gains[i] = -HUGE_VAL;
    else if (fit.point.size() == 0) gains[i] = HUGE_VAL;
    else gains[i] = gain_of_likelihood(one_part(trial, i), before, fit, alone, after, with[i]);
  });
  double sum = 0.0;
  for (const double gain : gains) sum += gain;
  return sum;
}

/// A force of a time in one run is not asked for in another.
bool is_of_a_time(const Effect& effect) { return acting_time(effect).has_value(); }

/// Whether runs that were not used speak against an effect: they gain nothing by it, or, where it gains several times
/// what is needed, lose clearly.
bool speaks_against(double held_out, double gain, double needed) {
  return !(held_out > least_held_out) && !(gain > clearly * needed && held_out > -small_loss * gain);
}

double rows_of(const Trial& trial) {
  double rows = 0.0;
  for (const auto& run : trial.runs) rows += static_cast<double>(run.rows());
  return rows;
}

/// Whether it acts for a time, and no more than one of several runs lasts then. What has no name is told where it
/// repeats: in three zigzags of R/V Gunnerus a push for 8 s of one, nothing to the runs held out, gained 51.
bool is_of_one_run(const Effect& effect, std::span<const PreparedRun> runs) {
  const auto time = acting_time(effect);
  return time && runs.size() > 1 && std::ranges::count_if(runs, [&](const PreparedRun& run) {
                                      return time->onset < run.run->time.back() && time->end > run.run->time.front();
                                    }) < 2;
}

}  // namespace

HeldOutRuns held_out_runs(const Trial& unused, const Search& s) {
  const auto hypothesis = s.hypothesis();
  return {unused, unused.runs.empty() ? Likelihood{} : likelihood_of(unused, hypothesis, s.now.point, s.now.noise),
          s.on_board ? log_likelihood(problem_of(s.trial, hypothesis), s.now.point, s.now.noise) : 0.0};
}

MapFit at_mean(MapFit fit, const Trial& trial, std::span<const Eigen::Index> coordinates) {
  for (const auto i : coordinates) fit.point[i] = trial.mean[i];
  return fit;
}

double held_out_gain(const Trial& trial, const FormSizes& sizes, HeldOutRuns& held_out, const Hypothesis& before,
                     const MapFit& a, const Hypothesis& after, const MapFit& b) {
  if (held_out.is_empty()) {
    auto& without = held_out.parts[sizes];
    if (without.empty()) without = each_left_out(trial, before, a);
    return gain_by_others(trial, before, without, after, fits_to_others(trial, after, b));
  }
  const auto& unused = held_out.unused;
  const auto replaced = replaced_by_new(trial, before, after);
  const bool moved = std::ranges::any_of(replaced, [&](Eigen::Index i) { return a.point[i] != trial.mean[i]; });
  if (!moved) return gain_of_likelihood(unused, before, a, held_out.now, after, b);
  const auto at_its_mean = at_mean(a, trial, replaced);
  return gain_of_likelihood(unused, before, at_its_mean, likelihood_of(unused, before, at_its_mean.point, a.noise),
                            after, b);
}

double gain_as_elsewhere(const HeldOutRuns& held_out, const Trial& trial, const Hypothesis& after, const MapFit& found,
                         double gain, double elsewhere) {
  const double here = log_likelihood(problem_of(trial, after), found.point, found.noise) - held_out.used;
  const double rows = rows_of(trial), other_rows = held_out.is_empty() ? rows : rows_of(held_out.unused);
  return gain - here + elsewhere * rows / other_rows;
}

bool is_borne_out(const HeldOutRuns& held_out, Follows kind, double gain, double elsewhere, double as_elsewhere,
                  double needed) {
  const bool tells_enough = !held_out.is_empty() && kind == Follows::earth && elsewhere > needed;
  return tells_enough || as_elsewhere > least_kept * gain;
}

void ask(HeldOutRuns& held_out, const Trial& trial, const Search& s, FittedCandidate& tried, double needed) {
  const bool of_a_time = is_of_a_time(tried.effect);
  if (is_unknown(*tried.form) && is_of_one_run(tried.effect, trial.runs)) {
    tried.refuted = true;
    return;
  }
  if (held_out.is_empty() && (of_a_time || trial.parts().empty())) return;
  const auto before = s.hypothesis(), after = with(before, *tried.form);
  const double gain = held_out_gain(trial, tried.sizes, held_out, before, s.now, after, tried.fit);
  if (!held_out.is_empty())
    tried.held_out =
        of_a_time ? std::max(0.0, gain) : gain;  // without held-out runs the same runs have told it already
  if (of_a_time) return;
  if (s.on_board) tried.as_elsewhere = gain_as_elsewhere(held_out, trial, after, tried.fit, tried.gain, gain);
  tried.refuted = s.on_board && !explains_heel(trial, *tried.form)
                      ? !is_borne_out(held_out, follows(tried.effect), tried.gain, gain, *tried.as_elsewhere, needed)
                      : speaks_against(gain, tried.gain, needed);
}

}  // namespace swayaw::mismatch::detail
