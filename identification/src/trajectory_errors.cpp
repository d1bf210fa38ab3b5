#include "trajectory_errors.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace swayaw::trajectory {
namespace {

/// Residuals count as correlated over this time, in ship lengths.
constexpr double correlation_length = 1.0;

/// Covariance of the sum of correlated scores: Σ over moving sums over `length` samples, divided by their length.
Eigen::MatrixXd score_covariance(const std::vector<Eigen::VectorXd>& scores, std::size_t length, Eigen::Index n) {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
  for (std::size_t k = 0; k < scores.size() + length - 1; ++k) {
    if (k < scores.size()) sum += scores[k];
    if (k >= length) sum -= scores[k - length];
    B += sum * sum.transpose();
  }
  return B / static_cast<double>(length);
}

}  // namespace

NumberErrors number_errors(const TrajectoryProblem& problem, const Linearization& at, const Eigen::VectorXd& prior) {
  const auto n = prior.size();
  const Axes axes(at.information());
  NumberErrors result{axes.inverse(), at.information(), axes.full_rank()};
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n, n);
  const auto scores = at.scores();
  double all_pieces = 0.0;
  for (std::size_t j = 0; j < scores.size(); ++j) {
    const auto& time = problem.runs[j].time;
    const double pieces = std::max((time.back() - time.front()) / problem.unit[j] / correlation_length, 8.0);
    B += score_covariance(scores[j],
                          static_cast<std::size_t>(std::max(static_cast<double>(scores[j].size()) / pieces, 1.0)), n);
    all_pieces += pieces;
  }
  auto& C = result.covariance;
  // C B C + C P C, with B enlarged for the degrees of freedom that the numbers took from the independent pieces
  const double freedom = std::max(1.0 - static_cast<double>(n) / all_pieces, 0.25);
  const Eigen::MatrixXd sandwich = C * (B / freedom + Eigen::MatrixXd(prior.asDiagonal())) * C;
  const Eigen::VectorXd larger = (sandwich.diagonal().array() / C.diagonal().array().max(1e-300)).max(1.0).sqrt();
  C = (larger.asDiagonal() * C * larger.asDiagonal()).eval();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (axes.untold(i) < 1e-6) continue;
    C.row(i).setConstant(missing);
    C.col(i).setConstant(missing);
    C(i, i) = std::numeric_limits<double>::infinity();
  }
  return result;
}

// ---------------------------------------------------------------- combinations

namespace {

/// "|Y_v|^0.71 |N_v|^-0.70 to 0.4 %", factors with small powers left out.
std::string combination(const NumberList& numbers, const Eigen::VectorXd& powers, double relative_error) {
  std::string text;
  for (Eigen::Index i = 0; i < powers.size(); ++i)
    if (std::abs(powers[i]) > 0.2)
      text += fmt::format("|{}|^{:.2f} ", numbers[static_cast<std::size_t>(i)].name, powers[i]);
  return text + (std::isfinite(relative_error) ? fmt::format("to {:.2g} %", 100.0 * relative_error) : "not at all");
}

}  // namespace

/// Principal axes of the information of the logarithms, x_i x_k I_ik; enlarged errors enlarge it back. A number that
/// may be zero counts as its standard error.
Combinations combinations_of(const NumberList& numbers, std::span<const double> values, const NumberErrors& errors) {
  const auto n = static_cast<Eigen::Index>(values.size());
  Eigen::VectorXd size(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = values[static_cast<std::size_t>(i)], error = std::sqrt(errors.covariance(i, i));
    size[i] = std::copysign(std::isfinite(error) ? std::max(std::abs(x), error) : std::max(std::abs(x), 1e-12), x);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(size.asDiagonal() * errors.information * size.asDiagonal());
  const double longest = axes.eigenvalues()[n - 1];
  Combinations result{
      .condition_number = std::sqrt(longest / std::max(axes.eigenvalues()[0], 0.0)), .best = {}, .undetermined = {}};
  result.best = combination(numbers, axes.eigenvectors().col(n - 1), 1.0 / std::sqrt(longest));
  for (Eigen::Index i = 0; i < n; ++i) {
    const double length = axes.eigenvalues()[i],
                 error = length > 1e-13 * longest ? 1.0 / std::sqrt(length) : std::numeric_limits<double>::infinity();
    if (error >= 0.5) result.undetermined.push_back(combination(numbers, axes.eigenvectors().col(i), error));
  }
  return result;
}

}  // namespace swayaw::trajectory
