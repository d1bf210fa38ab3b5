#include "linear_ascent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification::detail {
namespace {

/// p + (I + mu diag I)⁻¹ gradient. A noise changes by no more than a factor of 7 at once.
Parameters stepped(const LinearProblem& problem, const Parameters& p, const LikelihoodSlope& at, double mu) {
  Eigen::MatrixXd I = of_free(problem, at.information);
  const Eigen::VectorXd scale = (I.diagonal().array() + 1e-12).rsqrt();
  I = (scale.asDiagonal() * I * scale.asDiagonal()).eval();
  I.diagonal().array() += mu + 1e-12;
  const Eigen::VectorXd step =
      scale.asDiagonal() * core::detail::solve_symmetric(I, scale.asDiagonal() * of_free(problem, at.gradient));
  Parameters next = p;
  for (std::size_t k = 0; k < problem.free.size(); ++k) {
    const int place = problem.free[k];
    const double by = step[static_cast<Eigen::Index>(k)];
    next[place] += place >= noise_psi ? std::clamp(by, -2.0, 2.0) : by;
    if (place >= noise_psi) next[place] = std::max(next[place], -25.0);
  }
  return next;
}

/// Gain of log likelihood that an undamped step predicts.
double predicted_gain(const LinearProblem& problem, const Parameters& p, const LikelihoodSlope& at) {
  return std::abs(at.gradient.dot(stepped(problem, p, at, 0.0) - p));
}

/// Highest of half the step, the step and twice the step: where residuals are not white the expected curvature is not
/// the true one.
LinearAscent highest_along(const LinearProblem& problem, const Parameters& from, const Parameters& step) {
  LinearAscent highest{from, -std::numeric_limits<double>::infinity()};
  for (const double share : {1.0, 0.5, 2.0}) {
    const Parameters there = from + share * step;
    const double value = log_likelihood(problem, there);
    if (value > highest.log_likelihood) highest = {there, value};  // false for NaN
  }
  return highest;
}

/// The first better place on the way from the undamped step to the gradient, with the damping that led there.
std::optional<LinearAscent> climbed(const LinearProblem& problem, const LinearAscent& from, const LikelihoodSlope& at,
                                    double& mu) {
  for (; mu < 1e10; mu *= 10.0) {
    const auto highest = highest_along(problem, from.p, stepped(problem, from.p, at, mu) - from.p);
    if (highest.log_likelihood > from.log_likelihood) return highest;
  }
  return std::nullopt;
}

}  // namespace

LinearAscent climb(const LinearProblem& problem, const Parameters& start) {
  LinearAscent best{start, log_likelihood(problem, start)};
  double mu = 1e-3;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const auto at = slope(problem, best.p);
    const double predicted = predicted_gain(problem, best.p, at);
    best.converged = predicted < 1e-6;
    if (best.converged) return best;
    const auto better = climbed(problem, best, at, mu);
    if (!better) {
      best.converged = predicted < 1e-3;
      return best;
    }
    best = *better;
    mu = std::max(0.1 * mu, 1e-12);
  }
  return best;
}

}  // namespace swayaw::identification::detail
