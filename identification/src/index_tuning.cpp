#include "swayaw/identification/index_tuning.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bounded_step.hpp"
#include "index_trials.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/index_slopes.hpp"

namespace swayaw {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }
Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

std::vector<std::vector<double>> rows_of(const Matrix& m) {
  std::vector<std::vector<double>> rows(at(m.rows()));
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j) rows[at(i)].push_back(m(i, j));
  return rows;
}

// ---------------------------------------------------------------- the measured numbers in one row

struct Measured {
  Vector value, deviation;
  std::vector<std::size_t> trial;
  std::vector<bool> of_turn;
};

Measured flat(const MeasuredIndices& measured) {
  std::vector<double> value, deviation;
  Measured result;
  for (std::size_t t = 0; t < measured.trials.size(); ++t)
    for (const auto& i : measured.trials[t].indices) {
      value.push_back(i.value);
      deviation.push_back(i.deviation);
      result.trial.push_back(t);
      result.of_turn.push_back(std::holds_alternative<TurnOrder>(measured.trials[t].manoeuvre));
    }
  result.value = Eigen::Map<Vector>(value.data(), index(value.size()));
  result.deviation = Eigen::Map<Vector>(deviation.data(), index(deviation.size()));
  return result;
}

TuningError error_of(const Measured& m, const Vector& indices) {
  TuningError error{0.0, 0.0};
  for (Eigen::Index k = 0; k < indices.size(); ++k) {
    const double part = 1.0 - indices[k] / m.value[k];
    (m.of_turn[at(k)] ? error.turns : error.zigzags) += part * part;
  }
  return error;
}

// ---------------------------------------------------------------- a ship and what she does

/// A ship of changed numbers, theta = theta_0 (1 + z), who sailed all manoeuvres.
struct Candidate {
  Vector z;
  Ship ship;
  std::vector<SailedTrial> sailed;
  Vector indices;
};

std::vector<double> values_at(std::span<const Parameter> numbers, const Vector& z) {
  std::vector<double> values(numbers.size());
  for (std::size_t j = 0; j < numbers.size(); ++j) values[j] = numbers[j].value * (1.0 + z[index(j)]);
  return values;
}

/// @throws Refusal  that names the manoeuvre
SailedTrial sailed_or_told(IndexTrials& trials, const Ship& ship, const MeasuredTrial& trial) {
  try {
    return trials.sail(ship, trial);
  } catch (const Refusal& trouble) {
    throw Refusal(fmt::format("{}: {}", name_of(trial.manoeuvre), trouble.what()));
  }
}

/// Sails all manoeuvres.
Candidate sailed(IndexTrials& trials, const Ship& start, std::span<const Parameter> numbers, const Vector& z) {
  Candidate c{.z = z, .ship = with_values(start, numbers, values_at(numbers, z)), .sailed = {}, .indices = {}};
  for (const auto& trial : trials.trials()) {
    c.sailed.push_back(sailed_or_told(trials, c.ship, trial));
    const auto& now = c.sailed.back().indices;
    const auto before = c.indices.size();
    c.indices.conservativeResize(before + now.size());
    c.indices.tail(now.size()) = now;
  }
  return c;
}

/// dI/dz.
Matrix slopes(IndexTrials& trials, const Candidate& c, std::span<const Parameter> numbers) {
  Matrix J(c.indices.size(), index(numbers.size()));
  Eigen::Index row = 0;
  for (std::size_t t = 0; t < c.sailed.size(); ++t) {
    const auto rows = c.sailed[t].indices.size();
    J.middleRows(row, rows) = trials.slopes(c.ship, trials.trials()[t], c.sailed[t], numbers);
    row += rows;
  }
  for (std::size_t j = 0; j < numbers.size(); ++j) J.col(index(j)) *= numbers[j].value;
  return J;
}

/// @throws Refusal  naming the first measured index that the ship does not come to
void require_all(const MeasuredIndices& measured, const Candidate& c) {
  for (std::size_t t = 0; t < c.sailed.size(); ++t) {
    const auto& trial = measured.trials[t];
    for (std::size_t k = 0; k < trial.indices.size(); ++k)
      if (std::isnan(c.sailed[t].indices[index(k)]))
        throw Refusal(fmt::format("{} has no {} in the {} to begin with{}", c.ship.name, trial.indices[k].name,
                                  name_of(trial.manoeuvre),
                                  asks_for_steady_turn(trial) ? ": no steady turn was found" : ""));
  }
}

// ---------------------------------------------------------------- the fit

class Tuner {
 public:
  Tuner(const Ship& ship, const MeasuredIndices& measured, const TuningOptions& options)
      : start_(ship),
        measured_(measured),
        flat_(flat(measured)),
        options_(options),
        numbers_(tuned_numbers(ship, options)),
        trials_(measured) {
    const auto n = index(numbers_.size());
    weight_ = Vector::Zero(n);
    low_ = Vector::Constant(n, -infinity);
    high_ = Vector::Constant(n, infinity);
    for (Eigen::Index j = 0; j < n; ++j) bound(j);
  }

  Tuning run() {
    auto best = sailed(trials_, start_, numbers_, Vector::Zero(index(numbers_.size())));
    require_all(measured_, best);
    const auto before = best;
    const Matrix first = slopes(trials_, best, numbers_);
    Matrix J = first;
    const auto status = descend(best, J);
    return report(status, before, first, best, J);
  }

 private:
  /// Prior and bounds of a number.
  void bound(Eigen::Index j) {
    const auto& n = numbers_[at(j)];
    const double prior = prior_of(n), most = prior > 0.0 ? options_.most_change.value_or(infinity) : 0.0,
                 to_z = 1.0 / n.value;
    weight_[j] = prior > 0.0 ? 1.0 / (prior * prior) : 0.0;
    const double a = n.range.low * to_z - 1.0, b = n.range.high * to_z - 1.0;
    low_[j] = std::max(-most, std::min(a, b));
    high_[j] = std::min(most, std::max(a, b));
    if (n.range.above_low) (to_z > 0.0 ? low_[j] : high_[j]) *= 1.0 - 1e-9;  // never at the limit itself
  }

  double prior_of(const Parameter& n) const { return options_.prior.value_or(n.deviation / std::abs(n.value)); }

  Vector residuals(const Candidate& c) const { return (c.indices - flat_.value).cwiseQuotient(flat_.deviation); }

  /// Σ residual² + Σ (z/prior)²
  double cost(const Candidate& c) const { return residuals(c).squaredNorm() + c.z.dot(weight_.cwiseProduct(c.z)); }

  /// Whether every measured index is there and every steady turn lasts well enough.
  bool holds(const Candidate& c, const Candidate& from) const {
    if (!c.indices.allFinite()) return false;
    for (std::size_t t = 0; t < c.sailed.size(); ++t) {
      const double decay = c.sailed[t].decay, before = from.sailed[t].decay;
      if (asks_for_steady_turn(measured_.trials[t]) &&
          !(decay >= std::max(0.1 * before, std::min(options_.least_decay, before))))
        return false;
    }
    return true;
  }

  std::optional<Candidate> tried(const Vector& z, const Candidate& from) {
    try {
      auto c = sailed(trials_, start_, numbers_, z);
      if (holds(c, from)) return c;
    } catch (const Refusal&) {  // the motion has no end, or nothing propels the ship
    }
    return std::nullopt;
  }

  bool may_go_on(const Candidate& best) const {
    return !options_.watch || options_.watch({trials_.voyages(), error_of(flat_, best.indices)});
  }

  TuningStatus descend(Candidate& best, Matrix& J) {
    double radius = 0.5;
    while (true) {
      if (!may_go_on(best)) return TuningStatus::interrupted;
      const Matrix A = flat_.deviation.cwiseInverse().asDiagonal() * J;
      const Matrix H = A.transpose() * A + Matrix(weight_.asDiagonal());
      const Vector g = A.transpose() * residuals(best) + weight_.cwiseProduct(best.z);
      const Vector d = bounded_step(H, g, low_ - best.z, high_ - best.z, radius);
      const double here = cost(best), promised = -2.0 * g.dot(d) - d.dot(H * d);
      if (promised <= 1e-14 + 1e-6 * here || d.norm() < 1e-10) return TuningStatus::converged;
      if (trials_.voyages().turns + 2 * trials_.turns() > options_.most_turns) return TuningStatus::voyage_limit;
      const auto next = tried(best.z + d, best);
      const double gain = next ? (here - cost(*next)) / promised : -1.0;
      if (gain < 0.25) radius = 0.25 * d.norm();
      else if (gain > 0.75 && d.norm() > 0.9 * radius) radius *= 2.0;
      if (gain <= 1e-3) continue;
      best = *next;
      J = slopes(trials_, best, numbers_);
    }
  }

  // -------------------------------------------------------------- report

  /// d ln I / d ln theta over the relative tolerance is dI/dz over the tolerance.
  std::vector<IndexCombination> combinations(const Matrix& J) const {
    return determined_combinations(rows_of(J),
                                   {flat_.deviation.data(), flat_.deviation.data() + flat_.deviation.size()});
  }

  /// Relative standard deviations from indices and prior together, the roots of the diagonal of (AᵀA + W)⁻¹.
  Vector deviations(const Matrix& J) const {
    const Matrix A = flat_.deviation.cwiseInverse().asDiagonal() * J;
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(A.transpose() * A + Matrix(weight_.asDiagonal()));
    Vector variance = Vector::Zero(J.cols());
    for (Eigen::Index k = 0; k < J.cols(); ++k) {
      const double value = eigen.eigenvalues()[k], least = 1e-14 * eigen.eigenvalues()[J.cols() - 1];
      for (Eigen::Index j = 0; j < J.cols(); ++j) {
        const double share = eigen.eigenvectors()(j, k) * eigen.eigenvectors()(j, k);
        if (value > least) variance[j] += share / value;
        else if (share > 1e-12) variance[j] = infinity;
      }
    }
    return variance.cwiseSqrt();
  }

  std::vector<TunedNumber> tuned(const Candidate& best, const Matrix& J,
                                 const std::vector<IndexCombination>& combinations) const {
    const auto values = values_at(numbers_, best.z);
    const Vector deviation = deviations(J);
    std::vector<TunedNumber> result;
    for (std::size_t j = 0; j < numbers_.size(); ++j) {
      double told = 0.0;
      for (const auto& c : combinations)
        if (c.determined) told += c.weights[j] * c.weights[j];
      const double z = best.z[index(j)], edge = 1e-9;
      const double prior = prior_of(numbers_[j]);
      result.push_back({.number = numbers_[j],
                        .value = values[j],
                        .prior = prior,
                        .deviation = std::min(deviation[index(j)], prior),
                        .told = told,
                        .at_bound = z <= low_[index(j)] + edge || z >= high_[index(j)] - edge});
    }
    return result;
  }

  Tuning report(TuningStatus status, const Candidate& before, const Matrix& first, const Candidate& best,
                const Matrix& J) const {
    Tuning t{.status = status,
             .ship = best.ship,
             .numbers = {},
             .indices = {},
             .before = error_of(flat_, before.indices),
             .after = error_of(flat_, best.indices),
             .voyages = trials_.voyages(),
             .combinations = combinations(first),
             .decay = {}};
    t.numbers = tuned(best, J, t.combinations);
    Eigen::Index k = 0;
    for (std::size_t trial = 0; trial < measured_.trials.size(); ++trial)
      for (const auto& i : measured_.trials[trial].indices) {
        t.indices.push_back({trial, i, before.indices[k], best.indices[k]});
        ++k;
      }
    for (const auto& s : best.sailed) t.decay.push_back(s.decay);
    return t;
  }

  const Ship& start_;
  const MeasuredIndices& measured_;
  Measured flat_;
  const TuningOptions& options_;
  std::vector<Parameter> numbers_;
  IndexTrials trials_;
  Vector weight_;      ///< 1/prior²
  Vector low_, high_;  ///< of z
};

bool is_resistance(std::string_view key) {
  return key == "R_0" || key == "X_0" || key == "X_u" || key == "X_uu" || key == "X_uuu";
}

void require_options(const TuningOptions& options) {
  if (options.prior) require_positive(*options.prior, "prior");
  if (options.most_change) require_positive(*options.most_change, "largest change of a number");
  require_positive(options.least_decay, "least decay of a steady turn");
  if (options.most_turns < 1)
    throw std::domain_error(fmt::format("turning circles to be sailed must be positive, got {}", options.most_turns));
}

}  // namespace

std::string_view in_words(TuningStatus status) {
  switch (status) {
    case TuningStatus::converged: return "converged";
    case TuningStatus::voyage_limit: return "voyage limit";
    case TuningStatus::interrupted: break;
  }
  return "interrupted";
}

std::vector<Parameter> tuned_numbers(const Ship& ship, const TuningOptions& options) {
  if (!options.numbers.empty()) {
    auto numbers = parameters_of(ship, options.numbers);
    for (const auto& n : numbers)
      if (n.value == 0.0) throw Refusal(fmt::format("{} is 0 and has no relative change to be tuned by", n.name));
    return numbers;
  }
  auto numbers = coefficients_of(ship, "hull");
  std::erase_if(numbers, [](const Parameter& n) { return n.value == 0.0 || is_resistance(n.key); });
  if (numbers.empty()) throw Refusal(fmt::format("{}: her model has no hull derivative to tune", ship.name));
  return numbers;
}

IndexSensitivity index_sensitivity(const Ship& ship, const MeasuredIndices& measured,
                                   const std::vector<Parameter>& numbers) {
  IndexTrials trials(measured);
  const Vector zero = Vector::Zero(index(numbers.size()));
  const auto base = sailed(trials, ship, numbers, zero);
  const Matrix J = slopes(trials, base, numbers);
  Matrix finite = Matrix::Constant(J.rows(), J.cols(), missing);
  for (Eigen::Index j = 0; j < J.cols(); ++j) {
    try {
      const auto changed = sailed(trials, ship, numbers, 0.1 * Vector::Unit(J.cols(), j));
      finite.col(j) = (changed.indices - base.indices).cwiseQuotient(base.indices);
    } catch (const Refusal&) {  // with that change she does not sail the manoeuvres
    }
  }
  return {.indices = {base.indices.data(), base.indices.data() + base.indices.size()},
          .exact = rows_of(base.indices.cwiseInverse().asDiagonal() * J),
          .ten_per_cent = rows_of(finite),
          .voyages = trials.voyages()};
}

std::vector<IndexCombination> determined_combinations(const std::vector<std::vector<double>>& sensitivity,
                                                      const std::vector<double>& tolerance) {
  if (sensitivity.empty() || sensitivity.size() != tolerance.size())
    throw std::domain_error("as many tolerances are needed as there are indices");
  Matrix A(index(sensitivity.size()), index(sensitivity.front().size()));
  for (Eigen::Index k = 0; k < A.rows(); ++k)
    for (Eigen::Index j = 0; j < A.cols(); ++j) A(k, j) = sensitivity[at(k)][at(j)] / tolerance[at(k)];
  const Eigen::JacobiSVD<Matrix> svd(A, Eigen::ComputeFullV);
  std::vector<IndexCombination> result;
  for (Eigen::Index i = 0; i < A.cols(); ++i) {
    const double s = i < svd.singularValues().size() ? svd.singularValues()[i] : 0.0;
    const Vector w = svd.matrixV().col(i);
    result.push_back({.singular_value = s,
                      .standard_error = 1.0 / s,
                      .determined = s >= 2.0,
                      .weights = {w.data(), w.data() + w.size()}});
  }
  return result;
}

Tuning tune(const Ship& ship, const MeasuredIndices& measured, const TuningOptions& options) {
  require_options(options);
  return Tuner(ship, measured, options).run();
}

}  // namespace swayaw
