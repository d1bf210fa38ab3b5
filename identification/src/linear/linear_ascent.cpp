#include "linear_ascent.hpp"

#include "../estimation/descent.hpp"

namespace swayaw::inline identification::detail {

LinearAscent climb(const LinearProblem& problem, const Parameters& start) {
  using Eigen::VectorXd;
  // parameters count in their standard errors at the start, noises in factors of e if these are wider
  VectorXd unit = (of_free(problem, slope(problem, start).information).diagonal().array() + 1e-12).rsqrt();
  VectorXd low = VectorXd::Constant(unit.size(), -HUGE_VAL);
  for (Eigen::Index k = 0; k < unit.size(); ++k) {
    if (const int place = problem.free[static_cast<std::size_t>(k)]; place >= noise_psi) {
      unit[k] = std::min(unit[k], 1.0);
      low[k] = (-25.0 - start[place]) / unit[k];
    }
  }
  const auto at = [&](const VectorXd& z) {
    Parameters p = start;
    for (std::size_t k = 0; k < problem.free.size(); ++k)
      p[problem.free[k]] += unit[static_cast<Eigen::Index>(k)] * z[static_cast<Eigen::Index>(k)];
    return p;
  };
  const auto scoring = [&](const Descent& here, int = 0) {
    const auto there = slope(problem, at(here.point));
    NormalEquations normal{unit.asDiagonal() * of_free(problem, there.information) * unit.asDiagonal(),
                           unit.cwiseProduct(of_free(problem, there.gradient))};
    normal.A.diagonal().array() += 1e-12;
    return normal;
  };
  const auto cost = [&](const VectorXd& z, const VectorXd&) { return -2.0 * log_likelihood(problem, at(z)); };
  Descent here{.point = VectorXd::Zero(unit.size()),
               .residuals = {},
               .cost = cost(VectorXd::Zero(unit.size()), {}),
               .low = low.cwiseMin(0.0),
               .high = VectorXd::Constant(unit.size(), HUGE_VAL)};
  descend(
      here, {.iterations = 100, .attempts = 30, .worth = 2e-6, .radius = 10.0}, scoring,
      [](const VectorXd&) { return VectorXd(); }, cost);
  const auto end = scoring(here);
  const VectorXd step = bounded_step(end.A, -end.b, here.low - here.point, here.high - here.point, HUGE_VAL);
  return {at(here.point), -0.5 * here.cost, step.dot(2.0 * end.b - end.A * step) < 2e-3};
}

}  // namespace swayaw::identification::detail
