#include "swayaw/identification/map_fit.hpp"

#include <algorithm>
#include <cmath>

#include "descent.hpp"
#include "filtered_runs.hpp"
#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification {
using namespace detail;
using namespace core::detail;

// ---------------------------------------------------------------- problem

Eigen::Index EstimationProblem::rows() const {
  Eigen::Index sum = 0;
  for (const auto& run : runs) sum += run.rows();
  return sum;
}

Eigen::VectorXd EstimationProblem::of_each(double Unknown::*value) const {
  Eigen::VectorXd values(size());
  std::ranges::transform(unknowns, values.begin(), [&](const Unknown& unknown) { return unknown.*value; });
  return values;
}

double EstimationProblem::prior(const Point& point) const {
  const Eigen::VectorXd d = point - mean();
  return d.dot(precision * d);
}

// ---------------------------------------------------------------- fit

namespace {

/// Radius within which steps are trusted at first: unknowns are counted in about their prior deviations.
constexpr double wide = 10.0;

/// The start of a descent, its residuals and cost not worked out yet.
Descent descent_from(const EstimationProblem& problem, const Point& start) {
  return {.point = problem.within_bounds(start),
          .residuals = {},
          .cost = 0.0,
          .low = problem.low(),
          .high = problem.high()};
}

/// (JᵀJ + Λ) d = −Jᵀe − Λ (p − mean)
/// @param information  JᵀJ
NormalEquations normal_equations(const EstimationProblem& problem, const Eigen::MatrixXd& J,
                                 const Eigen::MatrixXd& information, const Descent& here) {
  return {information + problem.precision,
          -J.transpose() * here.residuals - problem.precision * (here.point - problem.mean())};
}

/// JᵀJ anew where only the columns from `first` on have changed.
void renew_gram(const Eigen::MatrixXd& J, Eigen::Index first, Eigen::MatrixXd& information) {
  if (first == 0) {
    information = gram(J);
    return;
  }
  const auto changed = J.cols() - first;
  information.rightCols(changed).noalias() = J.transpose() * J.rightCols(changed);
  information.bottomLeftCorner(changed, first) = information.topRightCorner(first, changed).transpose();
}

/// Whether no size of a noise differs by more than a tenth: the slopes of the one do for the other.
bool about_same(const Noise& a, const Noise& b) {
  constexpr double tenth = 0.1;
  const auto near = [](double x, double y) { return std::abs(x - y) <= tenth * y; };
  return near(a.scale, b.scale) && near(a.memory, b.memory) && near(a.walk, b.walk) &&
         std::ranges::equal(a.axes, b.axes, near) && std::ranges::equal(a.factor, b.factor, near);
}

}  // namespace

MapFit fit(const EstimationProblem& problem, const Point& start, Noise noise, Eigen::Index fixed,
           const FitOptions& wanted) {
  const auto* known = wanted.known;
  // a round ends where a step promises to gain less than half of this in log posterior density. With 0.2 to 0.4 fits
  // to be ranked take a fifth less time, but they decide what is found, too: a wind that gains 15.4 came to 14.4 and
  // 14.9 where 15 are needed (seven zigzags of the 3 m Esso Osaka)
  constexpr DescentOptions options{.iterations = 10, .attempts = 6, .worth = 0.05, .radius = wide};
  constexpr double worth_a_round = 0.5;    // of log posterior density
  constexpr double rough = 15.0;           // of the same: what follows gains less than a third of it
  constexpr double about_straight = 0.25;  // of what a step predicts: all slopes are worked out anew after less
  Descent here = descent_from(problem, start);
  Eigen::MatrixXd slopes(problem.rows(), problem.size()), information;
  MapFit best;
  double density = -HUGE_VAL;  // of the posterior, logarithm
  Eigen::MatrixXd of_noise;    // covariance
  for (int round = 0; round < wanted.rounds; ++round) {
    const auto passes = filtered(problem, here.point, noise);
    const auto cost = [&](const Point& p, const Eigen::VectorXd& e) { return e.squaredNorm() + problem.prior(p); };
    here.residuals = residuals(problem, here.point, *passes);
    here.cost = cost(here.point, here.residuals);
    const bool first_known = known && round == 0;
    if (first_known) slopes.leftCols(known->cols()) = *known;
    const auto renew = [&](const Descent& at, int iteration) {
      const bool straight = std::abs(at.kept - 1.0) < about_straight;
      const Eigen::Index first = iteration > 0 ? (straight ? fixed : 0) : first_known ? known->cols() : 0;
      renew_slopes(problem, at.point, *passes, at.residuals, first, slopes);
      renew_gram(slopes, iteration > 0 ? first : 0, information);
      auto normal = normal_equations(problem, slopes, information, at);
      normal.from_here = first == 0;
      return normal;
    };
    descend(
        here, options, renew, [&](const Point& p) { return residuals_if_any(problem, p, *passes); }, cost);
    const auto [log_likelihood, found] =
        wanted.noise_stays ? Likelihood{identification::log_likelihood(problem, here.point, noise), noise}
                           : detail::best_noise(problem, here.point, noise, problem.size() == fixed, of_noise);
    const Eigen::MatrixXd A = information + problem.precision;
    const double now = log_likelihood - 0.5 * problem.prior(here.point), gain = now - density;
    // the last round is the one whose slopes belong to the noise that was found, so it stands unless it is clearly
    // worse
    const double log_evidence = now + 0.5 * (log_determinant(problem.precision) - log_determinant(A));
    if (!std::isfinite(log_evidence)) break;  // the filter cannot follow, or slopes are no numbers
    if (gain > -worth_a_round) best = {here.point, log_evidence, found, inverse(A), information};
    if (wanted.to_rank ? !(gain > rough) : !(gain > worth_a_round) && about_same(found, noise)) break;
    density = std::max(density, now), noise = found;
  }
  return best;
}

// ---------------------------------------------------------------- further unknowns

LinearizedFit linearized(const EstimationProblem& problem, const MapFit& fit) {
  LinearizedFit result{.point = fit.point, .passes = filtered(problem, fit.point, fit.noise)};
  result.residuals = residuals(problem, fit.point, *result.passes);
  result.slopes.resize(problem.rows(), fit.point.size());
  renew_slopes(problem, fit.point, *result.passes, result.residuals, 0, result.slopes);
  result.information = gram(result.slopes);
  return with_prior_of(problem, std::move(result));
}

LinearizedFit with_prior_of(const EstimationProblem& problem, LinearizedFit linear) {
  linear.inverse = inverse(linear.information + problem.precision);
  linear.pull = problem.precision * (linear.point - problem.mean());
  return linear;
}

double linear_evidence(const EstimationProblem& problem, const LinearizedFit& fit) {
  const Eigen::MatrixXd A = fit.information + problem.precision;
  const Eigen::VectorXd g = fit.slopes.transpose() * fit.residuals + problem.precision * (fit.point - problem.mean());
  const double cost = fit.residuals.squaredNorm() + problem.prior(fit.point) - g.dot(solve_symmetric(A, g));
  return 0.5 * (log_determinant(problem.precision) - log_determinant(A) - cost);
}

namespace {

Point joined(const Point& first, std::span<const double> further) {
  Point point(first.size() + std::ssize(further));
  point << first, Eigen::Map<const Eigen::VectorXd>(further.data(), std::ssize(further));
  return point;
}

}  // namespace

PredictedGain predicted_gain(const EstimationProblem& problem, const LinearizedFit& before,
                             std::span<const double> start, int iterations) {
  const DescentOptions options{.iterations = iterations, .attempts = 4, .worth = 0.5, .radius = wide};
  const auto base = before.point.size(), size = problem.size() - base;
  const Eigen::MatrixXd Lambda = problem.precision.bottomRightCorner(size, size);
  const Eigen::VectorXd mean = problem.mean().tail(size);
  const auto cost = [&](const Point& p, const Eigen::VectorXd& e) {
    const Eigen::VectorXd d = p.tail(size) - mean;
    return before.cost(e) + d.dot(Lambda * d);
  };
  Descent here = descent_from(problem, joined(before.point, start));
  here.residuals = residuals(problem, here.point, *before.passes);
  here.cost = cost(here.point, here.residuals);
  Eigen::MatrixXd slopes(problem.rows(), problem.size()), A = Eigen::MatrixXd::Identity(size, size);
  // the step is of the further unknowns alone
  const auto renew = [&](const Descent& at, int) {
    renew_slopes(problem, at.point, *before.passes, at.residuals, base, slopes);
    const Eigen::MatrixXd J = slopes.rightCols(size);
    A = J.transpose() * before.projected(J) + Lambda;
    NormalEquations normal{Eigen::MatrixXd::Identity(problem.size(), problem.size()),
                           Eigen::VectorXd::Zero(problem.size())};
    normal.A.bottomRightCorner(size, size) = A;
    normal.b.tail(size) = -J.transpose() * before.answered(at.residuals) - Lambda * (at.point.tail(size) - mean);
    return normal;
  };
  const double at_first = before.cost(before.residuals);
  descend(
      here, options, renew, [&](const Point& p) { return residuals_if_any(problem, p, *before.passes); }, cost);
  const double occam = 0.5 * (log_determinant(Lambda) - log_determinant(A));
  const Eigen::VectorXd found = here.point.tail(size);
  return {0.5 * (at_first - here.cost) + occam, {found.begin(), found.end()}, inverse(A)};
}

Eigen::MatrixXd further_slopes(const EstimationProblem& problem, const LinearizedFit& before,
                               std::span<const double> from, double step) {
  const auto at = [&](std::span<const double> further) {
    return residuals(problem, joined(before.point, further), *before.passes);
  };
  // not those of the fit: a further unknown may stand in the place of one that the fit has moved
  const Eigen::VectorXd here = at(from);
  Eigen::MatrixXd J(problem.rows(), std::ssize(from));
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::vector<double> moved(from.begin(), from.end());
    moved[i] += step;
    J.col(static_cast<Eigen::Index>(i)) = (at(moved) - here) / step;
  }
  return J;
}

}  // namespace swayaw::identification
