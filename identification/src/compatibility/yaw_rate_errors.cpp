#include <algorithm>
#include <array>
#include <cmath>

#include "coloured_regression.hpp"
#include "relations.hpp"
#include "run_motion.hpp"

namespace swayaw::inline identification::detail {
namespace {

enum Column : Eigen::Index { zero, scale, delay, smoothing, start, columns };

/// psi − ∫ r dt and its columns where the heading was measured.
TimeSeries rows_of(const Recording& run) {
  constexpr double lost = 0.3;  // share of the usual yaw rate that a straight line across a gap is wrong by
  const auto r = filled(run, Channel::r);
  const auto r_dot = slope(run.time, r), gaps = gaps_of(run, Channel::r);
  const auto turned = smooth_integral(run.time, r, r_dot);
  const auto psi = run[Channel::psi];
  const auto at = present(psi);
  TimeSeries s(at.size(), columns + 1);
  const double noise = white_noise_of(run[Channel::r]), across = lost * rms(r);
  for (std::size_t k = 0, i = 0; k < at.size(); ++k) {
    const std::size_t j = at[k];
    s.time[k] = run.time[j];
    for (; i <= j; ++i) s.bridge[k] = std::hypot(s.bridge[k], across * gaps[i], noise * step_before(run.time, i));
    s.Xy.row(static_cast<Eigen::Index>(k)) << run.time[j] - run.time[at[0]], turned[j] - turned[at[0]], r[j], r_dot[j],
        1.0, psi[j] - psi[at[0]] - (turned[j] - turned[at[0]]);
  }
  return s;
}

Eigen::VectorXd priors(const InstrumentPriors& prior, bool asks_scale) {
  constexpr double heading = 1.0;  // [rad], of the first sample
  return Eigen::Vector<double, columns>{prior.rate_zero, asks_scale ? prior.scale : not_asked, prior.delay,
                                        0.5 * prior.smoothing * prior.smoothing, heading};
}

/// Of white noise of the heading and the walk that white noise of the gyro makes; of a heading that remembers.
std::array<ErrorModel, 2> first_guesses(const Recording& run) {
  const double gyro = std::max(white_noise_of(run[Channel::r]) * std::sqrt(usual_step(run.time)), 1e-8);
  const double white = std::max(white_noise_of(run[Channel::psi]), 1e-7);
  return {{{white, 0.1 * white, 20.0, gyro}, {0.3 * white, 3.0 * white, 3.0, 0.1 * gyro}}};
}

/// A filter with the mean delay tau and a window of standard deviation w.
struct Filter {
  double tau, w2;   ///< [s], [s²]
  double w2_error;  ///< standard error of w² [s²]
};

/// r = r₀ − tau dr₀/dt + ½ (tau² + w²) d²r₀/dt², so that before dr/dt stands   g = ½ (tau² − w²)
Filter filter_of(double tau, double g, const Eigen::Matrix2d& C) {
  // dw² = 2 tau dtau − 2 dg
  const Eigen::Vector2d slope(2.0 * tau, -2.0);
  return {tau, tau * tau - 2.0 * g, std::sqrt(slope.dot(C * slope))};
}

/// What it may be: w² is 0 of a delay, tau²/3 of a mean over the last 2 tau, tau² of a first-order lag; in steps of h,
/// no longer than the recording's, larger by tau h of each tau²; a value that is held for a step adds h²/12.
std::vector<std::string_view> readings_of(const Filter& f, double step) {
  struct Kind {
    std::string_view name;
    double share;  ///< w²/tau²
  };
  constexpr std::array kinds{Kind{"delay", 0.0}, Kind{"one-sided mean", 1.0 / 3.0}, Kind{"first-order lag", 1.0}};
  constexpr double likely = 3.0;  // standard errors
  std::vector<std::string_view> may_be;
  for (const auto& [name, share] : kinds) {
    const double least = share * f.tau * f.tau, most = least + share * std::abs(f.tau) * step + step * step / 12.0;
    if (f.w2 > least - likely * f.w2_error && f.w2 < most + likely * f.w2_error) may_be.push_back(name);
  }
  return may_be;
}

}  // namespace

bool tells_scale_of_gyro(const Recording& run) { return !turns_like_a_zero(run, InstrumentPriors{}.rate_zero); }

std::vector<InstrumentError> yaw_rate_errors(const Recording& run) {
  if (!run.has(Channel::r)) return {};
  const bool asks_scale = tells_scale_of_gyro(run);
  const auto fit = coloured_regression(rows_of(run), priors({}, asks_scale), first_guesses(run));
  const auto error = [&](InstrumentErrorKind kind, Eigen::Index at, double value, double slope) {
    return InstrumentError{Channel::r, kind, value, std::abs(slope) * std::sqrt(fit.covariance(at, at))};
  };
  const double k = fit.beta[scale], one_more = 1.0 / (1.0 + k);  // 1 + s
  std::vector errors{error(InstrumentErrorKind::zero, zero, -fit.beta[zero] * one_more, one_more)};
  if (asks_scale) errors.push_back(error(InstrumentErrorKind::scale, scale, -k / (1.0 + k), 1.0));
  errors.push_back(error(InstrumentErrorKind::delay, delay, fit.beta[delay] * one_more, one_more));
  const Eigen::Matrix2d C = one_more * one_more * fit.covariance({delay, smoothing}, {delay, smoothing});
  const auto filter = filter_of(fit.beta[delay] * one_more, fit.beta[smoothing] * one_more, C);
  errors.back().readings = readings_of(filter, usual_step(run.time));
  if (filter.w2 <= 0.0) return errors;
  // dw = dw²/(2 w)
  const double w = std::sqrt(filter.w2);
  errors.push_back({Channel::r, InstrumentErrorKind::smoothing, w, 0.5 * filter.w2_error / w});
  return errors;
}

}  // namespace swayaw::identification::detail
