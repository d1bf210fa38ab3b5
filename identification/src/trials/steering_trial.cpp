#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/identification/nomoto_zigzag.hpp"
#include "swayaw/linear/response.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "trial_run.hpp"

namespace swayaw::inline identification::detail {
namespace {

using D = Dual<5>;

/// Unknowns of the first-order fit: dr/dt = −a r + b (delta + offset), r and psi at the first sample.
struct FirstOrderFit {
  Eigen::Matrix<double, 5, 1> x;  ///< a, b, offset, r_0, psi_0
  double squares = forever;
};

/// Samples of heading and rudder in the time of the manoeuvre.
struct Part {
  std::vector<double> time, psi, delta;
};

Part part_of(const TrialRun& run, double from, double to) {
  Part part;
  const Interpolant rudder(*run.recording, run.recording->has(Channel::delta) ? Channel::delta : Channel::delta_order);
  // two thousand samples tell two numbers
  const auto first = run.psi.index_at(from), last = run.psi.index_at(to);
  const std::size_t stride = std::max<std::size_t>(1, (last - first) / 2000);
  for (std::size_t i = first; i < last; i += stride) {
    part.time.push_back(run.psi.time[i]);
    part.psi.push_back(run.psi.value[i]);
    part.delta.push_back(rudder(run.psi.time[i]));
  }
  return part;
}

/// Heading at the samples: exact for a rudder that moves in straight lines.
std::vector<D> headings(const Part& part, const Eigen::Matrix<double, 5, 1>& x) {
  const D a(x[0], 0), b(x[1], 1), offset(x[2], 2);
  const LinearResponse<D> ship(
      SwayYawCoefficients<D>{.a1 = D(-1.0), .b1 = D(0.0), .c1 = D(0.0), .a2 = D(0.0), .b2 = -a, .c2 = b});
  LinearState<D> state{D(0.0), D(x[3], 3), D(x[4], 4)};
  std::vector<D> result{state.psi};
  for (std::size_t i = 1; i < part.time.size(); ++i) {
    const D h(part.time[i] - part.time[i - 1]);
    state = state_after(ship, state,
                        RudderLine<D>{D(part.delta[i - 1]) + offset, (part.delta[i] - part.delta[i - 1]) / h}, h);
    result.push_back(state.psi);
  }
  return result;
}

struct NormalEquations {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  double squares = 0.0, neighbours = 0.0;
};

NormalEquations equations(const Part& part, const Eigen::Matrix<double, 5, 1>& x) {
  NormalEquations e;
  const auto psi = headings(part, x);
  double before = 0.0;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const double off = part.psi[i] - psi[i].a;
    e.normal += psi[i].v * psi[i].v.transpose();
    e.right += off * psi[i].v;
    e.squares += off * off;
    e.neighbours += off * before;
    before = off;
  }
  return e;
}

/// Levenberg's steps from a start.
FirstOrderFit descended(const Part& part, Eigen::Matrix<double, 5, 1> x) {
  auto e = equations(part, x);
  double damping = 1e-3;
  for (int k = 0; k < 60 && damping < 1e12; ++k) {
    Eigen::MatrixXd damped = e.normal;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::Matrix<double, 5, 1> next = x + core::detail::solve_symmetric(damped, e.right);
    const auto tried = equations(part, next);
    if (!(tried.squares < e.squares)) {
      damping *= 10.0;
      continue;
    }
    const bool done = e.squares - tried.squares < 1e-12 * e.squares;
    x = next;
    e = tried;
    damping *= 0.1;
    if (done) break;
  }
  return {x, e.squares};
}

/// Best of descents from three time constants.
FirstOrderFit fitted(const Part& part, double time_unit) {
  FirstOrderFit best;
  for (const double T : {0.3, 1.0, 3.0}) {
    const double a = 1.0 / (T * time_unit);
    for (const double sign : {-1.0, 1.0}) {
      Eigen::Matrix<double, 5, 1> x;
      x << a, sign * a / time_unit, 0.0, 0.0, part.psi.front();
      const auto fit = descended(part, x);
      if (fit.squares < best.squares) best = fit;
    }
  }
  return best;
}

/// K = b/a and T = 1/a, rudder positive to starboard; errors by the first derivatives. Residuals that stay on one side
/// count for as many samples as they are independent, (1 − rho)/(1 + rho) of all.
std::optional<NomotoTold> by_least_squares(const TrialRun& run, double from, double to, double time_unit, double psi0) {
  const auto part = part_of(run, from, to);
  if (part.time.size() < 12) return std::nullopt;
  const auto fit = fitted(part, time_unit);
  if (!std::isfinite(fit.squares)) return std::nullopt;
  const auto e = equations(part, fit.x);
  const double n = static_cast<double>(part.time.size());
  const double rho = e.squares > 0.0 ? std::clamp(e.neighbours / e.squares, 0.0, 0.999) : 0.0;
  const double variance = e.squares / (n - 5.0) * (1.0 + rho) / (1.0 - rho);
  const Eigen::MatrixXd covariance = variance * core::detail::inverse(e.normal);
  const double a = fit.x[0], b = fit.x[1];
  Eigen::Vector2d dK(-b / (a * a), 1.0 / a);
  NomotoTold told{.K = {-b / a, std::sqrt(dK.dot(covariance.topLeftCorner<2, 2>() * dK))},
                  .T = {1.0 / a, std::sqrt(covariance(0, 0)) / (a * a)},
                  .offset = {-fit.x[2], std::sqrt(covariance(2, 2))},
                  .residual = std::sqrt(e.squares / n),
                  .time = part.time,
                  .heading = {}};
  for (const auto& psi : headings(part, fit.x)) told.heading.push_back(psi.a - psi0);
  return told;
}

std::optional<NomotoTold> by_nomoto(const TrialRun& run, double from, double to) {
  // the analysis takes the heading of the first sample for that of the approach, and runs with a rudder column
  Recording part;
  part.name = run.recording->name;
  const Interpolant rudder(*run.recording, run.recording->has(Channel::delta) ? Channel::delta : Channel::delta_order);
  for (std::size_t i = run.psi.index_at(from); i < run.psi.size() && run.psi.time[i] <= to; ++i)
    part.time.push_back(run.psi.time[i]);
  if (part.time.size() < 10) return std::nullopt;
  const auto psi = part.fill(Channel::psi), delta = part.fill(Channel::delta);
  for (std::size_t i = 0; i < part.time.size(); ++i) {
    psi[i] = run.psi.value[run.psi.index_at(part.time[i])];
    delta[i] = rudder(part.time[i]);
  }
  if (run.recording->has(Channel::r)) {
    const Interpolant rate(*run.recording, Channel::r);
    const auto r = part.fill(Channel::r);
    for (std::size_t i = 0; i < part.time.size(); ++i) r[i] = rate(part.time[i]);
  }
  try {
    const auto n = nomoto_zigzag_analysis(part);
    return NomotoTold{.K = {-n.K, missing},
                      .T = {n.T, missing},
                      .offset = {-n.delta_r, missing},
                      .residual = n.residual,
                      .time = {},
                      .heading = {}};
  } catch (const Refusal&) {
    return std::nullopt;  // fewer than three peaks
  }
}

bool told(const Told& x) { return std::abs(x.value) > 2.0 * x.standard_error; }

/// How long the noise of a channel remembers [s].
double memory_of(const Samples& s) {
  if (s.size() < 2) return 0.0;
  return s.noise.memory * (s.time.back() - s.time.front()) / static_cast<double>(s.size() - 1);
}

/// The second-order equation of yaw from heading, yaw rate where recorded, and rudder, at constant speed.
std::optional<SecondOrderTold> second_order(const TrialRun& run, double from, double to, double time_unit) {
  // one ship length is one time unit
  LinearFitOptions options{.L = 1.0, .U = 1.0 / time_unit, .use_drift = false, .from = from, .to = to};
  const double memory = std::max(memory_of(run.psi), memory_of(samples_of(*run.recording, Channel::r)));
  options.spacing = std::max(options.spacing, memory / time_unit);
  const auto named = [&](const Estimate& e, double unit) { return Told{e.value * unit, e.standard_error * unit}; };
  try {
    const auto fit = fit_linear(*run.recording, options);
    const auto& i = fit.indices;
    SecondOrderTold result{.K = named(i.Kw, 1.0 / time_unit),
                           .T1T2 = named(i.T1T2, time_unit * time_unit),
                           .T1_plus_T2 = named(i.T1_plus_T2, time_unit),
                           .T1 = {},
                           .T2 = {},
                           .T3 = named(i.T3w, time_unit),
                           .K_told = false,
                           .T1_told = false,
                           .T2_told = false,
                           .T3_told = false};
    result.K.value = -result.K.value;
    if (fit.time_constants) {
      result.T1 = named(fit.time_constants->T1, time_unit);
      result.T2 = named(fit.time_constants->T2, time_unit);
    }
    if (!std::isfinite(result.K.value) || !std::isfinite(result.T3.value)) return std::nullopt;
    result.K_told = told(result.K);
    result.T1_told = result.T1 && told(*result.T1);
    result.T2_told = result.T2 && told(*result.T2);
    result.T3_told = told(result.T3);
    return result;
  } catch (const Refusal&) {
    return std::nullopt;
  }
}

/// Norrbin's P: heading change per rudder angle when the ship has made one length, if the rudder was held so far.
MaybeTold norrbin(const TrialRun& run, const Approach& approach, double L, double held_until, double largest) {
  if (!approach.speed) return std::nullopt;
  const double t0 = approach.execute.value;
  double way = 0.0, t = t0;
  const double step = 0.02 * L / approach.speed->value;
  if (run.speed.size() >= 5) {
    const auto& s = run.speed;
    const auto U = [&](double time) { return value_at(s, time)->value; };
    for (double a = U(t0); way < L && t < held_until; t += step) {
      const double b = U(t + step);
      way += 0.5 * (a + b) * step;
      a = b;
    }
    t -= (way - L) / U(t);
  } else {
    t = t0 + L / approach.speed->value;
  }
  if (t >= held_until) return std::nullopt;
  const auto psi = value_at(run.psi, t);
  if (!psi) return std::nullopt;
  const double change = std::abs(psi->value - approach.heading.value);
  const auto slope = local_cubic(run.psi, t)->slope(t);
  const double error =
      together(psi->standard_error, approach.heading.standard_error, slope.value * approach.execute.standard_error);
  return Told{change / largest, error / largest};
}

}  // namespace

SteeringTrial steering_trial(const TrialRun& run, const TrialResult& result, const TrialOptions& options) {
  SteeringTrial steering;
  if (result.manoeuvre.kind == TrialKind::steady || result.manoeuvre.kind == TrialKind::spiral || run.legs.size() < 2)
    return steering;
  const double execute = result.approach.execute.value;
  const double leg = run.legs[1].to - run.legs[1].from;
  if (result.manoeuvre.kind == TrialKind::zigzag) {
    const double end = result.zigzag->end;
    steering.worked = by_nomoto(run, execute, end);
    steering.least_squares = by_least_squares(run, execute, end, leg, result.approach.heading.value);
    const double unit = options.L && result.approach.speed ? *options.L / result.approach.speed->value : leg;
    steering.second = second_order(run, execute, end, unit);
  }
  if (!options.L || !result.approach.speed) return steering;
  const double time_unit = *options.L / result.approach.speed->value;
  steering.P =
      norrbin(run, result.approach, *options.L, run.legs[1].to, std::abs(run.legs[1].level - run.rudder_before));
  if (!steering.least_squares) return steering;
  const auto& k = *steering.least_squares;
  const double K = k.K.value * time_unit, T = k.T.value / time_unit;
  steering.K_prime = Told{K, k.K.standard_error * time_unit};
  steering.T_prime = Told{T, k.T.standard_error / time_unit};
  // psi(1)/delta of a step: K' (1 − T' + T' exp(−1/T'))
  steering.P_of_fit = K * (1.0 - T + T * std::exp(-1.0 / T));
  return steering;
}

}  // namespace swayaw::identification::detail
