#include "swayaw/identification/linear_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "../regression/spectrum.hpp"
#include "../regression/standard_errors.hpp"
#include "linear_ascent.hpp"
#include "linear_estimates.hpp"
#include "linear_run.hpp"
#include "linear_start.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

// ---------------------------------------------------------------- start

bool measured(const LinearProblem& problem, double LinearSample::*channel) {
  const auto known = [&](const LinearSample& x) { return !std::isnan(x.*channel); };
  return std::ranges::any_of(problem.runs, [&](const LinearRun& run) { return std::ranges::any_of(run, known); });
}

/// ln of the noise of a channel, known or guessed from second differences; 0 for a channel that was not measured.
double log_noise(const LinearProblem& problem, double LinearSample::*channel, std::optional<double> known,
                 double floor) {
  if (!measured(problem, channel)) return 0.0;
  return std::log(known ? require_positive(*known, "known noise") : noise_of(problem.runs, channel) + floor);
}

/// Regressed constants, noise known or guessed, and disturbances large enough for the filter to follow the
/// measurements.
Parameters start(const LinearProblem& problem, const LinearFitOptions& options, double width) {
  Parameters p = Parameters::Zero();
  if (problem.with_drift) {
    const auto m = regressed_coefficients(problem.runs, width);
    p.head<6>() << m.a1, m.b1, m.c1, m.a2, m.b2, m.c2;
  } else {
    const auto h = regressed_yaw(problem.runs, width);
    p.head<4>() << h.e0, h.e1, h.nw0, h.nw1;
  }
  const auto known = [&](double ChannelNoise::*channel) {
    return options.noise ? std::optional((*options.noise).*channel) : std::nullopt;
  };
  p[noise_psi] = log_noise(problem, &LinearSample::psi, known(&ChannelNoise::psi), 1e-5);
  p[noise_r] = log_noise(problem, &LinearSample::r, known(&ChannelNoise::r), 1e-5 * problem.mean_rate);
  p[noise_beta] = log_noise(problem, &LinearSample::beta, known(&ChannelNoise::beta), 1e-5);
  p[disturbance_beta] = p[disturbance_omega] = std::log(0.01);
  return p;
}

std::vector<int> free_places(const LinearProblem& problem, const LinearFitOptions& options) {
  std::vector<int> free;
  const auto add = [&](int place, bool wanted) {
    if (wanted) free.push_back(place);
  };
  const bool psi = measured(problem, &LinearSample::psi), r = measured(problem, &LinearSample::r);
  for (int i = 0; i < problem.constant_count(); ++i) add(i, true);
  add(rudder_offset, options.rudder_offset);
  add(yaw_rate_offset, options.yaw_rate_offset && r && psi);
  add(drift_offset, options.drift_offset && problem.with_drift);
  add(noise_psi, !options.noise && psi);
  add(noise_r, !options.noise && r);
  add(noise_beta, !options.noise && problem.with_drift);
  add(disturbance_beta, options.disturbances);
  add(disturbance_omega, options.disturbances);
  return free;
}

std::size_t measurements(const LinearSample& x) { return !std::isnan(x.psi) + !std::isnan(x.r) + !std::isnan(x.beta); }

std::size_t measurements(const LinearProblem& problem) {
  std::size_t count = 0;
  for (const auto& run : problem.runs)
    for (const auto& x : run) count += measurements(x);
  return count;
}

std::size_t samples_used(const LinearProblem& problem) {
  std::size_t count = 0;
  for (const auto& run : problem.runs)
    count +=
        static_cast<std::size_t>(std::ranges::count_if(run, [](const LinearSample& x) { return measurements(x) > 0; }));
  return count;
}

LinearProblem problem_of(std::span<const Recording> runs, const LinearFitOptions& options) {
  if (runs.empty()) throw Refusal("no recording to fit to");
  LinearProblem problem{};
  for (const auto& run : runs) {
    problem.runs.push_back(linear_run(run, options));
    if (problem.runs.back().size() < 2) throw Refusal(fmt::format("{}: no samples in the interval to fit", run.name));
  }
  if (!measured(problem, &LinearSample::psi) && !measured(problem, &LinearSample::r))
    throw Refusal(fmt::format("{}: neither heading nor yaw rate to fit to", runs.front().name));
  if (measurements(problem) < 20)
    throw Refusal(fmt::format("{}: fewer than 20 measurements to fit to", runs.front().name));
  double sum = 0.0, count = 0.0;
  for (const auto& run : problem.runs)
    for (const auto& x : run) sum += x.rate, count += 1.0;
  problem.mean_rate = sum / count;
  problem.with_drift = measured(problem, &LinearSample::beta);
  problem.with_disturbances = options.disturbances;
  problem.free = free_places(problem, options);
  return problem;
}

/// From the better of two regressions. Disturbances are always allowed at first: with them the filter follows the
/// measurements and the likelihood has one hill, also for an unstable ship and poor starting values.
LinearAscent best_ascent(const LinearProblem& problem, const LinearFitOptions& options) {
  LinearProblem forgiving = problem;
  if (!options.disturbances) {
    forgiving.with_disturbances = true;
    forgiving.free.insert(forgiving.free.end(), {disturbance_beta, disturbance_omega});
  }
  LinearAscent best{Parameters::Zero(), -std::numeric_limits<double>::infinity()};
  for (const double width : {2.0, 5.0}) {
    const auto p = start(problem, options, width);
    const double there = log_likelihood(forgiving, p);
    if (there > best.log_likelihood) best = {p, there};
  }
  if (!std::isfinite(best.log_likelihood)) throw Refusal("no starting values for the fit: the recording hardly moves");
  best = climb(forgiving, best.p);
  return options.disturbances ? best : climb(problem, best.p);
}

// ---------------------------------------------------------------- standard errors

struct Covariance {
  Eigen::MatrixXd of_free;
  bool full_rank;
};

/// I⁻¹, where no direction is less known than one in 1e12 of the best.
Covariance inverse_information(const LinearProblem& problem, const LikelihoodSlope& at) {
  constexpr double nothing = 1e-12;
  auto axes = spectrum_of(of_free(problem, at.information), 10.0 * nothing);
  const bool full_rank = axes.full();
  axes.lambda = axes.lambda.cwiseMax(nothing), axes.least = 0.0;
  return {axes.inverse(), full_rank};
}

/// Disturbances and noises that came out as nothing tell nothing about the other parameters.
void drop_what_vanished(LinearProblem& problem, const LikelihoodSlope& at) {
  std::erase_if(problem.free, [&](int place) { return place >= noise_psi && at.information(place, place) < 1e-3; });
}

/// I⁻¹, with standard errors enlarged where residuals are correlated. Constants and rudder offset take degrees of
/// freedom.
Covariance covariance(const LinearProblem& problem, const LikelihoodSlope& at) {
  auto result = inverse_information(problem, at);
  std::vector<RunScores> scores;
  auto next = at.by_sample.begin();
  for (const auto& run : problem.runs) {
    auto& of_run = scores.emplace_back(RunScores{{}, run.back().s}).by_sample;
    for (std::size_t k = 0; k < run.size(); ++k) of_run.push_back(of_free(problem, *next++));
  }
  auto& C = result.of_free;
  enlarge_for_correlation(C, scores, Eigen::VectorXd::Zero(C.rows()), problem.constant_count() + 1.0);
  result.full_rank = result.full_rank && C.allFinite();
  return result;
}

// ---------------------------------------------------------------- starts and residuals

/// State at the first sample given all measurements: the filter carries its correlation with the present state along.
LinearState<Estimate> smoothed_start(const LinearModel<double>& model, const LinearRun& run) {
  using Filter = LinearFilter<double>;
  Filter filter(model, first_heading(run));
  Eigen::Matrix3d P = Eigen::Matrix3d::Identity(), C = P;  // of the start; of start and present
  Eigen::Vector3d x(0.0, 0.0, first_heading(run));
  const auto seen = [&](const LinearInnovation<double>& now, int i, double factor) {
    const Eigen::Vector3d gain = C.col(i) * (factor / now.variance);
    x += gain * now.error;
    P -= gain * now.variance * gain.transpose();
    C -= gain * now.variance * filter.gain().transpose();
  };
  filter_run(filter, run, seen, [&] { C = (C * filter.transition().transpose()).eval(); });
  const auto at = [&](int i) { return Estimate{x[i], std::sqrt(std::max(P(i, i), 0.0))}; };
  return {at(Filter::beta), at(Filter::omega), at(Filter::psi)};
}

/// Sum of squares over the samples of a channel.
struct MeanSquare {
  double sum = 0.0, count = 0.0;

  void add(double error) {
    if (std::isnan(error)) return;
    sum += error * error;
    count += 1.0;
  }
  double root() const { return count > 0.0 ? std::sqrt(sum / count) : missing; }
};

/// The first three samples of a run tell its start and are left out.
LinearResiduals one_step_residuals(const LinearProblem& problem, const Parameters& p) {
  using Filter = LinearFilter<double>;
  const auto model = model_of(problem, p);
  MeanSquare by_index[3];
  for (const auto& run : problem.runs) {
    Filter filter(model, first_heading(run));
    int sample = 0;
    const auto seen = [&](const LinearInnovation<double>& e, int i, double) {
      if (sample >= 3) by_index[i].add(e.error);
    };
    filter_run(filter, run, seen, [&] { ++sample; });
  }
  return {by_index[Filter::psi].root(), by_index[Filter::omega].root(), by_index[Filter::beta].root()};
}

/// The run simulated from its start without looking at the measurements again.
LinearResiduals whole_run_residuals(const LinearProblem& problem, const Parameters& p,
                                    std::span<const LinearState<Estimate>> starts) {
  const auto model = model_of(problem, p);
  const LinearResponse<double> ship(model.ship);
  MeanSquare psi, r, beta;
  for (std::size_t j = 0; j < problem.runs.size(); ++j) {
    const auto& run = problem.runs[j];
    LinearState<double> x{starts[j].beta.value, starts[j].omega.value, starts[j].psi.value};
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (k > 0) {
        const double s = run[k].s - run[k - 1].s;
        x = state_after(ship, x, {run[k - 1].delta + model.rudder_offset, (run[k].delta - run[k - 1].delta) / s}, s);
      }
      psi.add(run[k].psi - x.psi);
      r.add(run[k].r - x.omega * run[k].rate - model.yaw_rate_offset);
      beta.add(run[k].beta - x.beta - model.drift_offset);
    }
  }
  return {psi.root(), r.root(), beta.root()};
}

LinearAmplitude amplitude(const LinearProblem& problem) {
  LinearAmplitude largest{0.0, problem.with_drift ? 0.0 : missing, 0.0};
  for (const auto& run : problem.runs) {
    for (const auto& x : run) {
      largest.rudder = std::max(largest.rudder, std::abs(x.delta));
      if (!std::isnan(x.beta)) largest.drift = std::max(largest.drift, std::abs(x.beta));
      if (!std::isnan(x.r)) largest.omega = std::max(largest.omega, std::abs(x.r / x.rate));
    }
  }
  return largest;
}

// ---------------------------------------------------------------- report

Estimate estimate_at(const LinearProblem& problem, const Covariance& covariance, const Parameters& p, int place,
                     bool asked) {
  const auto found = std::ranges::find(problem.free, place);
  if (found == problem.free.end()) return asked ? Estimate{} : Estimate{0.0, 0.0};
  const auto k = found - problem.free.begin();
  return {p[place], std::sqrt(covariance.of_free(k, k))};
}

LinearFit report(LinearProblem problem, const LinearFitOptions& options, const LinearAscent& end) {
  const auto at = slope(problem, end.p);
  drop_what_vanished(problem, at);
  const auto C = covariance(problem, at);
  const auto model = model_of(problem, end.p);
  const int n = problem.constant_count();
  LinearFit fit{};
  fit.status = !C.full_rank    ? FitStatus::rank_deficient
               : end.converged ? FitStatus::converged
                               : FitStatus::iteration_limit;
  fit.scale = {options.L, problem.mean_rate * options.L};
  tell_constants({end.p.head(n), C.of_free.topLeftCorner(n, n)}, fit);
  fit.rudder_offset = estimate_at(problem, C, end.p, rudder_offset, options.rudder_offset);
  fit.yaw_rate_offset = estimate_at(problem, C, end.p, yaw_rate_offset, options.yaw_rate_offset);
  fit.drift_offset = estimate_at(problem, C, end.p, drift_offset, options.drift_offset);
  const auto noise_if = [&](double LinearSample::*channel, double variance) {
    return measured(problem, channel) ? std::sqrt(variance) : missing;
  };
  fit.noise = {noise_if(&LinearSample::psi, model.var_psi), noise_if(&LinearSample::r, model.var_r),
               noise_if(&LinearSample::beta, model.var_beta)};
  fit.disturbance = {problem.with_drift ? std::sqrt(model.q_beta) : missing, std::sqrt(model.q_omega)};
  std::vector<LinearState<Estimate>> starts;
  for (const auto& run : problem.runs) starts.push_back(smoothed_start(model, run));
  fit.one_step = one_step_residuals(problem, end.p);
  fit.whole_run = whole_run_residuals(problem, end.p, starts);
  if (!problem.with_drift)
    for (auto& start_of_run : starts) start_of_run.beta = {};  // x of `yaw_only_ship`, no drift
  fit.starts = std::move(starts);
  fit.amplitude = amplitude(problem);
  fit.samples = samples_used(problem);
  return fit;
}

}  // namespace

LinearFit fit_linear(std::span<const Recording> runs, const LinearFitOptions& options) {
  const auto problem = problem_of(runs, options);
  return report(problem, options, best_ascent(problem, options));
}

LinearFit fit_linear(const Recording& run, const LinearFitOptions& options) {
  return fit_linear(std::span(&run, 1), options);
}

}  // namespace swayaw::identification
