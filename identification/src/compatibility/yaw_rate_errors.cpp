#include <algorithm>
#include <array>
#include <cmath>

#include "coloured_regression.hpp"
#include "relations.hpp"
#include "run_motion.hpp"

namespace swayaw::inline identification::detail {
namespace {

constexpr Eigen::Index zero = 0, scale = 1, delay = 2, smoothing = 3, start = 4, columns = 5;

/// psi − ∫ r dt and its columns where the heading was measured.
TimeSeries rows_of(const Recording& run) {
  constexpr double lost = 0.3;  // share of the usual yaw rate that a straight line across a gap is wrong by
  const auto r = filled(run, Channel::r);
  const auto turned = integral(run.time, r), r_dot = slope(run.time, r), gaps = gaps_of(run, Channel::r);
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

Eigen::VectorXd priors(const Recording& run, const InstrumentPriors& prior) {
  constexpr double heading = 1.0;  // [rad], of the first sample
  // a run that does not turn shows waves, which heading and gyro filter in their ways
  return Eigen::Vector<double, columns>{prior.rate_zero, is_straight(run) ? not_asked : prior.scale, prior.delay,
                                        0.5 * prior.smoothing * prior.smoothing, heading};
}

/// Of white noise of the heading and the walk that white noise of the gyro makes; of a heading that remembers.
std::array<ErrorModel, 2> first_guesses(const Recording& run) {
  const double gyro = std::max(white_noise_of(run[Channel::r]) * std::sqrt(usual_step(run.time)), 1e-8);
  const double white = std::max(white_noise_of(run[Channel::psi]), 1e-7);
  return {{{white, 0.1 * white, 20.0, gyro}, {0.3 * white, 3.0 * white, 3.0, 0.1 * gyro}}};
}

}  // namespace

std::vector<InstrumentError> yaw_rate_errors(const Recording& run) {
  if (!run.has(Channel::r)) return {};
  const auto fit = coloured_regression(rows_of(run), priors(run, {}), first_guesses(run));
  const auto error = [&](InstrumentErrorKind kind, Eigen::Index at, double value, double slope) {
    return InstrumentError{Channel::r, kind, value, std::abs(slope) * std::sqrt(fit.covariance(at, at))};
  };
  const double k = fit.beta[scale], one_more = 1.0 / (1.0 + k);  // 1 + s
  std::vector<InstrumentError> errors{error(InstrumentErrorKind::zero, zero, -fit.beta[zero] * one_more, one_more),
                                      error(InstrumentErrorKind::scale, scale, -k / (1.0 + k), 1.0),
                                      error(InstrumentErrorKind::delay, delay, fit.beta[delay] * one_more, one_more)};
  // half the second moment of the mean stands before dr/dt
  const double w = std::sqrt(2.0 * std::max(-fit.beta[smoothing], 0.0));
  if (w > 0.0) errors.push_back(error(InstrumentErrorKind::smoothing, smoothing, w, 1.0 / w));
  return errors;
}

}  // namespace swayaw::identification::detail
