#include "trajectory_errors.hpp"

#include <algorithm>
#include <cmath>

#include "../regression/spectrum.hpp"
#include "../regression/standard_errors.hpp"
#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification::detail {

ParameterErrors parameter_errors(const TrajectoryProblem& problem, const Linearization& at,
                                 const Eigen::VectorXd& prior) {
  const auto n = prior.size();
  const auto axes = spectrum_of(at.information(), no_information);
  ParameterErrors result{axes.inverse(), at.information(), axes.full()};
  std::vector<RunScores> scores;
  for (auto& of_run : at.scores()) {
    const auto& time = problem.runs[scores.size()].time;
    scores.push_back({std::move(of_run), (time.back() - time.front()) / problem.unit[scores.size()]});
  }
  auto& C = result.covariance;
  enlarge_for_correlation(C, scores, prior, static_cast<double>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    if (axes.untold(i) < 1e-6) continue;
    C.row(i).setConstant(missing);
    C.col(i).setConstant(missing);
    C(i, i) = std::numeric_limits<double>::infinity();
  }
  return result;
}

/// Principal axes of the information of the logarithms, x_i x_k I_ik; enlarged errors enlarge it back. A number that
/// may be zero counts as its standard error.
Combinations combinations_of(const std::vector<Parameter>& parameters, std::span<const double> values,
                             const ParameterErrors& errors) {
  const auto n = static_cast<Eigen::Index>(values.size());
  Eigen::VectorXd size(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = values[static_cast<std::size_t>(i)], error = std::sqrt(errors.covariance(i, i));
    size[i] = std::copysign(std::isfinite(error) ? std::max(std::abs(x), error) : std::max(std::abs(x), 1e-12), x);
  }
  const auto axes = core::detail::principal_axes(size.asDiagonal() * errors.information * size.asDiagonal());
  const double longest = axes.size[0];
  std::vector<std::string> names;
  for (const auto& parameter : parameters) names.push_back(parameter.name);
  Combinations result{.condition_number = std::sqrt(longest / std::max(axes.size[n - 1], 0.0)),
                      .best = combination_words(names, axes.axis.col(0), 1.0 / std::sqrt(longest)),
                      .undetermined = {}};
  constexpr double rounding = 1e-13, not_told = 0.5;  // shares: of the longest axis, of the combination itself
  for (Eigen::Index i = n; i-- > 0;) {
    const double error =
        axes.size[i] > rounding * longest ? 1.0 / std::sqrt(axes.size[i]) : std::numeric_limits<double>::infinity();
    if (error >= not_told) result.undetermined.push_back(combination_words(names, axes.axis.col(i), error));
  }
  return result;
}

}  // namespace swayaw::identification::detail
