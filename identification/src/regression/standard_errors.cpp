#include "standard_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace swayaw::inline identification::detail {
namespace {

constexpr double correlation_length = 1.0;  ///< over which residuals count as correlated [ship lengths]
constexpr double least_pieces = 8.0;        ///< that a run is cut into, however short
constexpr double least_freedom = 0.25;      ///< share that the unknowns leave at least, where they are many

double pieces_of(const RunScores& run) { return std::max(run.lengths / correlation_length, least_pieces); }

/// Σ over moving sums of the scores of a piece, divided by its samples.
Eigen::MatrixXd covariance_of_sum(const RunScores& run, Eigen::Index n) {
  const auto& scores = run.by_sample;
  const auto length = static_cast<std::size_t>(std::max(static_cast<double>(scores.size()) / pieces_of(run), 1.0));
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

void enlarge_for_correlation(Eigen::MatrixXd& C, std::span<const RunScores> runs, const Eigen::VectorXd& prior,
                             double unknowns) {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(C.rows(), C.cols());
  double pieces = 0.0;
  for (const auto& run : runs) B += covariance_of_sum(run, C.rows()), pieces += pieces_of(run);
  const double freedom = std::max(1.0 - unknowns / pieces, least_freedom);
  const Eigen::MatrixXd sandwich = C * (B / freedom + Eigen::MatrixXd(prior.asDiagonal())) * C;
  const Eigen::VectorXd larger = (sandwich.diagonal().array() / C.diagonal().array().max(1e-300)).max(1.0).sqrt();
  C = (larger.asDiagonal() * C * larger.asDiagonal()).eval();
}

double student_quantile(double share, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), share);
}

std::string combination_words(std::span<const std::string> names, const Eigen::VectorXd& powers,
                              double relative_error) {
  constexpr double small = 0.2;
  std::string text;
  for (Eigen::Index i = 0; i < powers.size(); ++i)
    if (std::abs(powers[i]) > small) text += fmt::format("|{}|^{:.2f} ", names[static_cast<std::size_t>(i)], powers[i]);
  return text + (std::isfinite(relative_error) ? fmt::format("to {:.2g} %", 100.0 * relative_error) : "not at all");
}

}  // namespace swayaw::identification::detail
