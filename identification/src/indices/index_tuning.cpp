#include "swayaw/identification/index_tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../estimation/descent.hpp"
#include "../regression/spectrum.hpp"
#include "index_trials.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }
Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

// ---------------------------------------------------------------- the measured indices in one row

struct Measured {
  Vector value, deviation;
  std::vector<bool> of_turn;
};

Measured flat(const MeasuredIndices& measured) {
  std::vector<double> value, deviation;
  Measured result;
  for (const auto& trial : measured.trials)
    for (const auto& i : trial.indices) {
      value.push_back(i.value);
      deviation.push_back(i.deviation);
      result.of_turn.push_back(std::holds_alternative<TurnOrder>(trial.manoeuvre));
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

/// A ship of changed parameters, theta = theta_0 (1 + z), who sailed all manoeuvres.
struct Candidate {
  Vector z;
  Ship ship;
  std::vector<SimulatedTrial> simulated;
  Vector indices;
};

std::vector<double> values_at(std::span<const Parameter> parameters, const Vector& z) {
  std::vector<double> values(parameters.size());
  for (std::size_t j = 0; j < parameters.size(); ++j) values[j] = parameters[j].value * (1.0 + z[index(j)]);
  return values;
}

/// @throws Refusal  that names the manoeuvre
SimulatedTrial simulated_or_told(IndexTrials& trials, const Ship& ship, const MeasuredTrial& trial) {
  try {
    return trials.simulate(ship, trial);
  } catch (const Refusal& trouble) {
    throw Refusal(fmt::format("{}: {}", name_of(trial.manoeuvre), trouble.what()));
  }
}

/// Sails all manoeuvres.
Candidate simulated(IndexTrials& trials, const Ship& start, std::span<const Parameter> parameters, const Vector& z) {
  Candidate c{.z = z, .ship = with_values(start, parameters, values_at(parameters, z)), .simulated = {}, .indices = {}};
  for (const auto& trial : trials.trials()) {
    c.simulated.push_back(simulated_or_told(trials, c.ship, trial));
    const auto& now = c.simulated.back().indices;
    const auto before = c.indices.size();
    c.indices.conservativeResize(before + now.size());
    c.indices.tail(now.size()) = now;
  }
  return c;
}

/// dI/dz.
Matrix slopes(IndexTrials& trials, const Candidate& c, std::span<const Parameter> parameters) {
  Matrix J(c.indices.size(), index(parameters.size()));
  Eigen::Index row = 0;
  for (std::size_t t = 0; t < c.simulated.size(); ++t) {
    const auto rows = c.simulated[t].indices.size();
    J.middleRows(row, rows) = trials.slopes(c.ship, trials.trials()[t], c.simulated[t], parameters);
    row += rows;
  }
  for (std::size_t j = 0; j < parameters.size(); ++j) J.col(index(j)) *= parameters[j].value;
  return J;
}

/// @throws Refusal  naming the first measured index that the ship does not come to
void require_all(const MeasuredIndices& measured, const Candidate& c) {
  for (std::size_t t = 0; t < c.simulated.size(); ++t) {
    const auto& trial = measured.trials[t];
    for (std::size_t k = 0; k < trial.indices.size(); ++k)
      if (std::isnan(c.simulated[t].indices[index(k)]))
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
        parameters_(tuned_parameters(ship, options)),
        trials_(measured) {
    const auto n = index(parameters_.size());
    weight_ = Vector::Zero(n);
    low_ = Vector::Constant(n, -infinity);
    high_ = Vector::Constant(n, infinity);
    for (Eigen::Index j = 0; j < n; ++j) bound(j);
  }

  Tuning run() {
    auto best = simulated(trials_, start_, parameters_, Vector::Zero(index(parameters_.size())));
    require_all(measured_, best);
    const auto before = best;
    const Matrix first = slopes(trials_, best, parameters_);
    Matrix J = first;
    const auto status = descend_to(best, J);
    return report(status, before, first, best, J);
  }

 private:
  /// Prior and bounds of a number.
  void bound(Eigen::Index j) {
    const auto& n = parameters_[at(j)];
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
  double cost(const Vector& z, const Vector& residual) const {
    return residual.squaredNorm() + z.dot(weight_.cwiseProduct(z));
  }

  /// Whether every measured index is there and every steady turn lasts well enough.
  bool holds(const Candidate& c, const Candidate& from) const {
    if (!c.indices.allFinite()) return false;
    for (std::size_t t = 0; t < c.simulated.size(); ++t) {
      const double decay = c.simulated[t].decay, before = from.simulated[t].decay;
      if (asks_for_steady_turn(measured_.trials[t]) &&
          !(decay >= std::max(0.1 * before, std::min(options_.least_decay, before))))
        return false;
    }
    return true;
  }

  std::optional<Candidate> tried(const Vector& z, const Candidate& from) {
    try {
      auto c = simulated(trials_, start_, parameters_, z);
      if (holds(c, from)) return c;
    } catch (const Refusal&) {  // the motion has no end, or nothing propels the ship
    }
    return std::nullopt;
  }

  bool may_go_on(const Candidate& best) const {
    return !options_.watch || options_.watch({trials_.simulations(), error_of(flat_, best.indices)});
  }

  /// @param best  the start, and where the descent ended  @param J  slopes there, but for a last small step
  TuningStatus descend_to(Candidate& best, Matrix& J) {
    constexpr DescentOptions options{
        .iterations = 1000, .attempts = 1000, .worth = 1e-14, .worth_share = 1e-6, .radius = 0.5};
    Descent here{best.z, residuals(best), cost(best.z, residuals(best)), low_, high_};
    auto status = TuningStatus::converged;
    Candidate latest = best;  // that sailed all manoeuvres
    const auto renew = [&](const Descent&, int iteration) -> NormalEquations {
      if (iteration > 0) best = latest, J = slopes(trials_, best, parameters_);
      if (!may_go_on(best)) status = TuningStatus::interrupted;
      if (status != TuningStatus::converged) return {};
      const Matrix A = flat_.deviation.cwiseInverse().asDiagonal() * J;
      return {A.transpose() * A + Matrix(weight_.asDiagonal()),
              -A.transpose() * residuals(best) - weight_.cwiseProduct(best.z)};
    };
    const auto at = [&](const Vector& z) -> Vector {
      if (trials_.simulations().turns + 2 * trials_.turns() > options_.most_turns)
        status = TuningStatus::simulation_limit;
      else if (auto c = tried(z, best)) return residuals(latest = *std::move(c));
      return Vector::Constant(flat_.value.size(), 1e6);
    };
    descend(here, options, renew, at, [&](const Vector& z, const Vector& e) { return cost(z, e); });
    if (here.point == latest.z) best = latest;
    return status;
  }

  // -------------------------------------------------------------- report

  /// d ln I / d ln theta over the relative tolerance is dI/dz over the tolerance.
  std::vector<IndexCombination> combinations(const Matrix& J) const {
    return determined_combinations(core::detail::rows_of(J),
                                   {flat_.deviation.data(), flat_.deviation.data() + flat_.deviation.size()});
  }

  /// Relative standard deviations from indices and prior together, the roots of the diagonal of (AᵀA + W)⁻¹.
  Vector deviations(const Matrix& J) const {
    const Matrix A = flat_.deviation.cwiseInverse().asDiagonal() * J;
    const auto axes = spectrum_of(A.transpose() * A + Matrix(weight_.asDiagonal()), 1e-14);
    Vector variance = axes.inverse().diagonal();
    for (Eigen::Index j = 0; j < J.cols(); ++j)
      if (axes.untold(j) > 1e-12) variance[j] = infinity;
    return variance.cwiseSqrt();
  }

  std::vector<TunedParameter> tuned(const Candidate& best, const Matrix& J,
                                    const std::vector<IndexCombination>& combinations) const {
    const auto values = values_at(parameters_, best.z);
    const Vector deviation = deviations(J);
    std::vector<TunedParameter> result;
    for (std::size_t j = 0; j < parameters_.size(); ++j) {
      double told = 0.0;
      for (const auto& c : combinations)
        if (c.determined) told += c.weights[j] * c.weights[j];
      const double z = best.z[index(j)], edge = 1e-9;
      const double prior = prior_of(parameters_[j]);
      result.push_back({.number = parameters_[j],
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
             .parameters = {},
             .indices = {},
             .before = error_of(flat_, before.indices),
             .after = error_of(flat_, best.indices),
             .simulations = trials_.simulations(),
             .combinations = combinations(first),
             .decay = {}};
    t.parameters = tuned(best, J, t.combinations);
    Eigen::Index k = 0;
    for (std::size_t trial = 0; trial < measured_.trials.size(); ++trial)
      for (const auto& i : measured_.trials[trial].indices) {
        t.indices.push_back({trial, i, before.indices[k], best.indices[k]});
        ++k;
      }
    for (const auto& s : best.simulated) t.decay.push_back(s.decay);
    return t;
  }

  const Ship& start_;
  const MeasuredIndices& measured_;
  Measured flat_;
  const TuningOptions& options_;
  std::vector<Parameter> parameters_;
  IndexTrials trials_;
  Vector weight_;      ///< 1/prior²
  Vector low_, high_;  ///< of z
};

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
    case TuningStatus::simulation_limit: return "voyage limit";
    case TuningStatus::interrupted: break;
  }
  return "interrupted";
}

std::vector<Parameter> tuned_parameters(const Ship& ship, const TuningOptions& options) {
  if (!options.parameters.empty()) {
    auto parameters = parameters_of(ship, options.parameters);
    for (const auto& n : parameters)
      if (n.value == 0.0) throw Refusal(fmt::format("{} is 0 and has no relative change to be tuned by", n.name));
    return parameters;
  }
  auto parameters = coefficients_of(ship, "hull");
  std::erase_if(parameters, [](const Parameter& n) { return n.value == 0.0 || is_resistance(n); });
  if (parameters.empty()) throw Refusal(fmt::format("{}: her model has no hull derivative to tune", ship.name));
  return parameters;
}

IndexSensitivity index_sensitivity(const Ship& ship, const MeasuredIndices& measured,
                                   const std::vector<Parameter>& parameters) {
  IndexTrials trials(measured);
  const Vector zero = Vector::Zero(index(parameters.size()));
  const auto base = simulated(trials, ship, parameters, zero);
  const Matrix J = slopes(trials, base, parameters);
  Matrix finite = Matrix::Constant(J.rows(), J.cols(), missing);
  for (Eigen::Index j = 0; j < J.cols(); ++j) {
    try {
      const auto changed = simulated(trials, ship, parameters, 0.1 * Vector::Unit(J.cols(), j));
      finite.col(j) = (changed.indices - base.indices).cwiseQuotient(base.indices);
    } catch (const Refusal&) {  // with that change she does not sail the manoeuvres
    }
  }
  return {.indices = {base.indices.data(), base.indices.data() + base.indices.size()},
          .exact = core::detail::rows_of(base.indices.cwiseInverse().asDiagonal() * J),
          .ten_per_cent = core::detail::rows_of(finite),
          .simulations = trials.simulations()};
}

std::vector<IndexCombination> determined_combinations(const std::vector<std::vector<double>>& sensitivity,
                                                      const std::vector<double>& tolerance) {
  if (sensitivity.empty() || sensitivity.size() != tolerance.size())
    throw std::domain_error("as many tolerances are needed as there are indices");
  Matrix A(index(sensitivity.size()), index(sensitivity.front().size()));
  for (Eigen::Index k = 0; k < A.rows(); ++k)
    for (Eigen::Index j = 0; j < A.cols(); ++j) A(k, j) = sensitivity[at(k)][at(j)] / tolerance[at(k)];
  const auto svd = core::detail::singular_values(A);
  std::vector<IndexCombination> result;
  for (Eigen::Index i = 0; i < A.cols(); ++i) {
    const double s = i < svd.size.size() ? svd.size[i] : 0.0;
    const Vector w = svd.V.col(i);
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

}  // namespace swayaw::identification
