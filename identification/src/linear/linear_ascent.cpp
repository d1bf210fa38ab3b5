#include "linear_ascent.hpp"

#include "../estimation/descent.hpp"

namespace swayaw::inline identification::detail {

LinearAscent climb(const LinearProblem& problem, const Parameters& start) {
  using Eigen::VectorXd;
  constexpr double least_log = -25.0;            // of a noise: e⁻²⁵ is none
  constexpr double worth = 2e-6, little = 2e-3;  // of log likelihood, twice
  // parameters count in their standard errors at the start, noises in factors of e if these are wider
  VectorXd unit = (of_free(problem, slope(problem, start).information).diagonal().array() + 1e-12).rsqrt();
  VectorXd low = VectorXd::Constant(unit.size(), -HUGE_VAL);
  for (Eigen::Index k = 0; k < unit.size(); ++k) {
    if (const int place = problem.free[static_cast<std::size_t>(k)]; place >= noise_psi) {
      unit[k] = std::min(unit[k], 1.0);
      low[k] = std::min((least_log - start[place]) / unit[k], 0.0);
    }
  }
  const auto at = [&](const VectorXd& z) {
    Parameters p = start;
    for (std::size_t k = 0; k < problem.free.size(); ++k)
      p[problem.free[k]] += unit[static_cast<Eigen::Index>(k)] * z[static_cast<Eigen::Index>(k)];
    return p;
  };
  NormalEquations last;
  const auto scoring = [&](const Descent& here, int) {
    const auto there = slope(problem, at(here.point));
    last = {unit.asDiagonal() * of_free(problem, there.information) * unit.asDiagonal(),
            unit.cwiseProduct(of_free(problem, there.gradient))};
    last.A.diagonal().array() += 1e-12;
    return last;
  };
  const auto cost = [&](const VectorXd& z, const VectorXd&) { return -2.0 * log_likelihood(problem, at(z)); };
  Descent here{.point = VectorXd::Zero(unit.size()),
               .residuals = {},
               .cost = cost(VectorXd::Zero(unit.size()), {}),
               .low = low,
               .high = VectorXd::Constant(unit.size(), HUGE_VAL)};
  descend(
      here, {.iterations = 100, .attempts = 30, .worth = worth, .radius = 10.0}, scoring,
      [](const VectorXd&) { return VectorXd(); }, cost);
  const VectorXd step = bounded_step(last.A, -last.b, here.low - here.point, here.high - here.point, HUGE_VAL);
  return {at(here.point), -0.5 * here.cost, step.dot(2.0 * last.b - last.A * step) < little};
}

}  // namespace swayaw::identification::detail
