#include "swayaw/identification/regression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "gram.hpp"
#include "least_squares.hpp"
#include "residual_noise.hpp"
#include "spectrum.hpp"
#include "standard_errors.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int most_iterations = 50;

// ---------------------------------------------------------------- the question

Index place_of(const Design& design, std::string_view name) {
  const auto found = std::ranges::find(design.names, name);
  if (found == design.names.end()) throw Refusal(fmt::format("the regression has no coefficient {}", name));
  return found - design.names.begin();
}

void require(bool holds, const char* what) {
  if (!holds) throw std::domain_error(what);
}

void check(const Design& d, const RegressionOptions& options) {
  const Index n = d.X.rows(), p = d.X.cols();
  require(p > 0 && static_cast<Index>(d.names.size()) == p, "a regression needs a name for each column");
  require(d.y.size() == n, "a regression needs a y for each row");
  require(d.variance.size() == 0 || d.variance.size() == n, "a regression needs a variance for each row, or none");
  require(d.variance.size() == 0 || d.variance.minCoeff() > 0.0, "variances must be positive");
  require(d.runs.empty() ||
              (d.runs.front() == 0 && std::ranges::adjacent_find(d.runs, std::greater_equal<>{}) == d.runs.end() &&
               d.runs.back() < n),
          "runs begin at row 0 and ascend");
  for (const auto& prior : options.priors) require_positive(prior.deviation, "standard deviation of a prior");
  require(options.order > 0 && options.ridge >= 0.0, "order of autoregression must be positive, ridge not negative");
  const auto& covariance = options.feature_errors.covariance;
  require(covariance.size() <= 1 || static_cast<Index>(covariance.size()) == n,
          "covariances of features are one, or one for each row");
  for (const auto& c : covariance)
    require(c.rows() == p + 1 && c.cols() == p + 1, "covariances of features are of (x, y)");
  require(covariance.empty() || options.residuals == Residuals::independent,
          "errors in features go with independent residuals");
}

std::vector<RowRange> runs_of(const Design& design) {
  std::vector<RowRange> runs;
  for (const Index first : design.runs) {
    if (!runs.empty()) runs.back().count = first - runs.back().first;
    runs.push_back({first, 0});
  }
  if (runs.empty()) runs.push_back({0, 0});
  runs.back().count = design.X.rows() - runs.back().first;
  return runs;
}

Freedom freedom_of(const Design& design, const RegressionOptions& options) {
  const auto rows = static_cast<Index>(options.constraints.size());
  MatrixXd C = MatrixXd::Zero(rows, design.X.cols());
  VectorXd d(rows);
  for (Index i = 0; i < rows; ++i) {
    const auto& constraint = options.constraints[static_cast<std::size_t>(i)];
    for (const auto& [name, weight] : constraint.terms) C(i, place_of(design, name)) += weight;
    d[i] = constraint.sum;
  }
  return freedom(C, d, design.X.cols());
}

/// Weights of the rows, 1 on the average unless the variances are the true ones.
VectorXd weights_of(const Design& design, const RegressionOptions& options) {
  const VectorXd weights = design.variance.cwiseInverse();
  return options.variance_known ? weights : VectorXd(weights / weights.mean());
}

// ---------------------------------------------------------------- one solution

/// Rows of equal and independent residuals.
struct Rows {
  MatrixXd X;
  VectorXd y;
};

/// Sum of the covariances of (x, y), weighted as the rows are.
MatrixXd sum_of_errors(const FeatureErrors& errors, const VectorXd& weights, Index n) {
  if (errors.covariance.empty()) return {};
  if (errors.covariance.size() == 1)
    return errors.covariance[0] * (weights.size() > 0 ? weights.sum() : static_cast<double>(n));
  MatrixXd sum = MatrixXd::Zero(errors.covariance[0].rows(), errors.covariance[0].cols());
  for (Index i = 0; i < n; ++i)
    sum += (weights.size() > 0 ? weights[i] : 1.0) * errors.covariance[static_cast<std::size_t>(i)];
  return sum;
}

/// Ridge and priors as a penalty on the sum of squares: a prior counts as noise variance over its own.
Penalty penalty_of(const Design& design, const RegressionOptions& options, const VectorXd& squares,
                   double noise_variance) {
  Penalty penalty{options.ridge / static_cast<double>(design.X.rows()) * squares, VectorXd::Zero(squares.size())};
  for (const auto& prior : options.priors) {
    const Index j = place_of(design, prior.name);
    const double weight = noise_variance / (prior.deviation * prior.deviation);
    const double sum = penalty.weight[j] + weight;
    penalty.centre[j] = sum > 0.0 ? (penalty.weight[j] * penalty.centre[j] + weight * prior.mean) / sum : prior.mean;
    penalty.weight[j] = sum;
  }
  return penalty;
}

/// Coefficients with what belongs to them.
struct Found {
  Solution solution;
  VectorXd squares;       ///< of the columns that were solved
  VectorXd white;         ///< residuals of the rows that were solved
  double freedom;         ///< rows less coefficients that the data determine
  double noise_variance;  ///< of the white residuals
  double error_size = 1.0;
  bool settled = true;
  int iterations = 1;
};

/// Least squares of rows with equal and independent residuals. Priors need the size of the noise, so that both are
/// found in turns.
Found found(const Design& design, const RegressionOptions& options, const MatrixXd& X, const VectorXd& y,
            const MatrixXd& errors, const Freedom& free) {
  Moments moments{gram_of(X, y), errors};
  if (!moments.rows.diagonal().allFinite()) throw Refusal("the regression has numbers that are not finite");
  Found f{};
  if (errors.size() > 0 && !options.feature_errors.size_known) {
    f.error_size = largest_errors(moments, free);
    moments.errors *= f.error_size;
  }
  f.squares = moments.rows.diagonal().head(X.cols());
  f.noise_variance = options.variance_known ? 1.0 : 0.0;
  for (f.iterations = 1;; ++f.iterations) {
    f.solution = solve(X, y, moments, free, penalty_of(design, options, f.squares, f.noise_variance));
    f.white = y - X * f.solution.b;
    f.freedom = static_cast<double>(X.rows()) - f.solution.used;
    if (options.variance_known) return f;
    if (f.freedom <= 0.5)
      throw Refusal(fmt::format("{} samples do not tell {} coefficients and the noise", X.rows(), X.cols()));
    const double before = std::exchange(f.noise_variance, f.white.squaredNorm() / f.freedom);
    f.settled = options.priors.empty() || std::abs(f.noise_variance - before) <= 1e-9 * before;
    if (f.settled || f.iterations == most_iterations) return f;
  }
}

/// Correlated residuals: autoregression and coefficients in turns.
struct Correlated {
  Found found;
  Autoregression noise;
};

Correlated found_with_autoregression(const Design& design, const RegressionOptions& options, const Rows& rows,
                                     const std::vector<RowRange>& runs, const Freedom& free) {
  Correlated c{found(design, options, rows.X, rows.y, {}, free), {}};
  VectorXd phi = VectorXd::Zero(options.order);
  for (int i = 1;; ++i) {
    c.noise = autoregression_of(rows.y - rows.X * c.found.solution.b, runs, options.order);
    const double change = (c.noise.of_full_order() - phi).cwiseAbs().maxCoeff();
    phi = c.noise.of_full_order();
    c.found.settled = change < 1e-8;
    c.found.iterations = i;
    if (c.found.settled || i == most_iterations) return c;
    c.found = found(design, options, whitened(c.noise, rows.X, runs), whitened(c.noise, rows.y, runs), {}, free);
  }
}

// ---------------------------------------------------------------- covariance

/// x_i e_i, and with errors in features the part that makes their mean zero: x_i e_i + Σ_xx b − Σ_xy.
MatrixXd scores(const MatrixXd& X, const Found& f, const RegressionOptions& options, const VectorXd& weights) {
  MatrixXd g = X.array().colwise() * f.white.array();
  const auto& covariance = options.feature_errors.covariance;
  const Index p = X.cols();
  for (Index i = 0; i < g.rows() && !covariance.empty(); ++i) {
    const auto& C = covariance[covariance.size() == 1 ? 0 : static_cast<std::size_t>(i)];
    const double size = f.error_size * (weights.size() > 0 ? weights[i] : 1.0);
    g.row(i) += size * (C.topLeftCorner(p, p) * f.solution.b - C.col(p).head(p)).transpose();
  }
  return g;
}

/// Of the model, s² A⁻¹; else A⁻¹ cov(Σ scores) A⁻¹, enlarged for the coefficients found.
MatrixXd covariance_of(const MatrixXd& inverse, const MatrixXd& X, const Found& f, const RegressionOptions& options,
                       const VectorXd& weights, const std::vector<RowRange>& runs) {
  const bool correlated = options.standard_errors == StandardErrors::newey_west;
  if (!correlated && options.feature_errors.covariance.empty()) return f.noise_variance * inverse;
  const MatrixXd g = scores(X, f, options, weights);
  const MatrixXd of_sum = correlated ? covariance_of_sum(g, runs) : MatrixXd(g.transpose() * g);
  return static_cast<double>(X.rows()) / f.freedom * (inverse * of_sum * inverse);
}

// ---------------------------------------------------------------- report

/// Changes of the contributions b_j × size_j, largest 1, small ones left out.
Combination combination(const Design& design, const VectorXd& weights, double error) {
  Index largest = 0;
  weights.cwiseAbs().maxCoeff(&largest);
  Combination c{{}, error};
  for (Index j = 0; j < weights.size(); ++j)
    if (const double w = weights[j] / weights[largest]; std::abs(w) >= 0.1)
      c.terms.emplace_back(design.names[static_cast<std::size_t>(j)], w);
  return c;
}

/// Combinations whose own force may be half of all measured force: standard error of Σ weight b × rms beyond half the
/// rms of y.
constexpr double half_of_all = 0.5;

/// First those that change nothing at all, then the principal axes of what the data tell of the contributions.
std::vector<Combination> undetermined(const Design& design, const VectorXd& size, const MatrixXd& null,
                                      const MatrixXd& covariance) {
  std::vector<Combination> list;
  for (Index k = 0; k < null.cols(); ++k) list.push_back(combination(design, size.cwiseProduct(null.col(k)), infinite));
  const auto axes = core::detail::principal_axes(size.asDiagonal() * covariance * size.asDiagonal());
  const double rms_y = std::sqrt(design.y.squaredNorm() / static_cast<double>(design.y.size()));
  for (Index k = 0; k < axes.size.size(); ++k)
    if (const double error = std::sqrt(std::max(axes.size[k], 0.0)) / rms_y; error > half_of_all)
      list.push_back(combination(design, axes.axis.col(k), error));
  return list;
}

double R2(const VectorXd& y, const VectorXd& residuals) {
  return 1.0 - residuals.squaredNorm() / (y.array() - y.mean()).square().sum();
}

bool in_null(const MatrixXd& null, Index j) { return null.cols() > 0 && null.row(j).norm() > 1e-7 * null.norm(); }

void tell_coefficients(const Design& design, const Found& f, const VectorXd& size, const MatrixXd& by_data,
                       const VectorXd& naive, Regression& fit) {
  const double t = student_quantile(0.975, std::max(fit.degrees_of_freedom, 1.0));
  const double rms_y = std::sqrt(design.y.squaredNorm() / static_cast<double>(design.y.size()));
  for (Index j = 0; j < size.size(); ++j) {
    const bool told = !in_null(f.solution.null, j);
    const double error = std::sqrt(fit.covariance(j, j));
    const Estimate e = told ? Estimate{f.solution.b[j], error} : Estimate{};
    const bool by_data_told =
        !in_null(f.solution.null_of_data, j) && std::sqrt(by_data(j, j)) * size[j] <= half_of_all * rms_y;
    fit.coefficients.push_back({.name = design.names[static_cast<std::size_t>(j)],
                                .estimate = e,
                                .low = told ? e.value - t * error : -infinite,
                                .high = told ? e.value + t * error : infinite,
                                .variance_inflation = f.solution.variance_inflation[j],
                                .attenuation = naive.size() > 0 ? naive[j] - e.value : 0.0,
                                .undetermined = !by_data_told});
    if (!told) fit.covariance.row(j).setConstant(missing), fit.covariance.col(j).setConstant(missing);
  }
}

}  // namespace

std::string_view in_words(Solver solver) {
  switch (solver) {
    case Solver::normal_equations: return "normal equations";
    case Solver::qr: return "QR";
    case Solver::svd: return "SVD";
  }
  return "";
}

std::string in_words(const Combination& combination) {
  std::string text;
  for (const auto& [name, weight] : combination.terms) {
    const auto sign = weight < 0.0 ? (text.empty() ? "-" : " - ") : text.empty() ? "" : " + ";
    text += std::abs(weight) > 0.995 ? fmt::format("{}{}", sign, name)
                                     : fmt::format("{}{:.2f} {}", sign, std::abs(weight), name);
  }
  return text;
}

const Coefficient& Regression::operator[](std::string_view name) const {
  const auto found = std::ranges::find(coefficients, name, &Coefficient::name);
  if (found == coefficients.end()) throw Refusal(fmt::format("the regression has no coefficient {}", name));
  return *found;
}

MatrixXd correlation(const Regression& fit) {
  const VectorXd over = fit.covariance.diagonal().cwiseSqrt().cwiseInverse();
  return over.asDiagonal() * fit.covariance * over.asDiagonal();
}

Regression regress(const Design& design, const RegressionOptions& options) {
  check(design, options);
  const auto runs = runs_of(design);
  const auto free = freedom_of(design, options);
  const VectorXd weights = design.variance.size() > 0 ? weights_of(design, options) : VectorXd();
  const bool autoregressive = options.residuals == Residuals::autoregressive;
  const bool as_given = weights.size() == 0 && !autoregressive;
  Rows rows;  // made only where they differ from those of the design
  if (!as_given) rows = {design.X, design.y};
  if (weights.size() > 0) rows = {weights.cwiseSqrt().asDiagonal() * rows.X, weights.cwiseSqrt().cwiseProduct(rows.y)};
  const auto errors = sum_of_errors(options.feature_errors, weights, design.X.rows());

  Regression fit{};
  Found f{};
  if (autoregressive) {
    const auto c = found_with_autoregression(design, options, rows, runs, free);
    f = c.found;
    fit.autoregression = c.noise.of_full_order();
    fit.samples = static_cast<double>(design.y.size()) / c.noise.rows_for_one();
    rows = {whitened(c.noise, rows.X, runs), whitened(c.noise, rows.y, runs)};
  } else {
    f = found(design, options, as_given ? design.X : rows.X, as_given ? design.y : rows.y, errors, free);
    fit.samples = effective_samples(f.white, runs);
  }
  const auto& X = as_given ? design.X : rows.X;
  const auto& s = f.solution;
  fit.status = s.null.cols() > 0 ? FitStatus::rank_deficient
               : f.settled       ? FitStatus::converged
                                 : FitStatus::iteration_limit;
  fit.solver = s.solver;
  fit.covariance = covariance_of(s.inverse, X, f, options, weights, runs);
  fit.residuals = as_given ? f.white : VectorXd(design.y - design.X * s.b);
  fit.residual_rms = std::sqrt(fit.residuals.squaredNorm() / static_cast<double>(design.y.size()));
  fit.R2 = R2(design.y, fit.residuals);
  fit.degrees_of_freedom = options.variance_known ? infinite : f.freedom;
  if (options.standard_errors == StandardErrors::newey_west)
    fit.degrees_of_freedom = std::min(fit.degrees_of_freedom, fit.samples - s.used);
  fit.condition_number = s.condition_number;
  fit.error_size = f.error_size;
  fit.iterations = f.iterations;

  const VectorXd squares = as_given ? f.squares : VectorXd(design.X.colwise().squaredNorm());
  const VectorXd size = (squares / static_cast<double>(design.X.rows())).cwiseSqrt();
  const bool alone = options.priors.empty() && options.ridge == 0.0;
  const MatrixXd by_data = alone ? fit.covariance : covariance_of(s.by_data, X, f, options, weights, runs);
  fit.undetermined = undetermined(design, size, s.null_of_data, by_data);
  VectorXd naive;
  if (errors.size() > 0) naive = found(design, options, X, as_given ? design.y : rows.y, {}, free).solution.b;
  tell_coefficients(design, f, size, by_data, naive, fit);
  return fit;
}

}  // namespace swayaw::identification
