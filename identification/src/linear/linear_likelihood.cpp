#include "linear_likelihood.hpp"

#include <algorithm>

namespace swayaw::inline identification::detail {

double first_heading(const LinearRun& run) {
  const auto known = std::ranges::find_if(run, [](const LinearSample& x) { return !std::isnan(x.psi); });
  return known == run.end() ? 0.0 : known->psi;
}

double log_likelihood(const LinearProblem& problem, const Parameters& p) {
  double sum = 0.0;
  const auto seen = [&](const LinearInnovation<double>& e, int, double) {
    sum -= 0.5 * (e.error * e.error / e.variance + std::log(e.variance));
  };
  filter_all(problem, p, seen, [] {});
  return sum;
}

LikelihoodSlope slope(const LinearProblem& problem, const Parameters& p) {
  using ByPlace = Dual<places>;
  Eigen::Matrix<ByPlace, places, 1> dual;
  for (int i = 0; i < places; ++i) dual[i] = ByPlace(p[i]);
  for (const int i : problem.free) dual[i].v[i] = 1.0;
  LikelihoodSlope sum;
  const auto seen = [&](const LinearInnovation<ByPlace>& now, int, double) {
    // ∂/∂p of −½ (e²/S + ln S) is −e e_p/S + ½ (e²/S − 1) S_p/S; its variance e_p e_pᵀ/S + ½ S_p S_pᵀ/S²
    const double over = 1.0 / now.variance.a, e = now.error.a;
    const Parameters de = now.error.v, dS = now.variance.v * over;
    sum.by_sample.back() += -e * over * de + 0.5 * (e * e * over - 1.0) * dS;
    sum.information += over * de * de.transpose() + 0.5 * dS * dS.transpose();
  };
  filter_all(problem, dual, seen, [&] { sum.by_sample.push_back(Parameters::Zero()); });
  for (const auto& score : sum.by_sample) sum.gradient += score;
  return sum;
}

}  // namespace swayaw::identification::detail
