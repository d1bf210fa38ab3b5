#include "swayaw/linear/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "lifted.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/dual.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

using D = Dual<6>;
using Vector = Eigen::Vector<double, 6>;

Vector vector_of(const SteeringIndices<double>& i) {
  return (Vector() << i.T1T2, i.T1_plus_T2, i.T3b, i.T3w, i.Kb, i.Kw).finished();
}

SteeringIndices<double> indices_of(const Vector& x) { return {x[0], x[1], x[2], x[3], x[4], x[5]}; }

Vector vector_of(const SwayYawCoefficients<double>& m) {
  return (Vector() << m.a1, m.b1, m.c1, m.a2, m.b2, m.c2).finished();
}

SteeringIndices<D> varied(const SteeringIndices<double>& i) {
  return {D(i.T1T2, 0), D(i.T1_plus_T2, 1), D(i.T3b, 2), D(i.T3w, 3), D(i.Kb, 4), D(i.Kw, 5)};
}

template <int Rows>
Eigen::Matrix<double, Rows, 6> jacobian_of(const std::array<D, Rows>& values) {
  Eigen::Matrix<double, Rows, 6> jacobian;
  for (int row = 0; row < Rows; ++row) jacobian.row(row) = values[static_cast<std::size_t>(row)].v.transpose();
  return jacobian;
}

/// A matrix F with F Fᵀ = C, for a covariance that may be singular.
IndexCovariance factor_of(const IndexCovariance& covariance) {
  const auto axes = core::detail::principal_axes(covariance);
  return axes.axis * axes.size.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Eigen::Vector<double, 7> vector_of(const LinearParts<double>& ship) {
  const auto& [hull, rudder] = ship;
  return (Eigen::Vector<double, 7>() << rudder.a_H, rudder.c_Ry, rudder.x_Reff, hull.Y_b, hull.Y_w, hull.N_b, hull.N_w)
      .finished();
}

/// What `result_of` makes of indices drawn with that covariance.
template <int Count, class ResultOf>
Sampled<Count> sample(const SteeringIndices<double>& indices, const IndexCovariance& covariance, std::size_t samples,
                      std::uint64_t seed, ResultOf&& result_of) {
  using Result = Eigen::Vector<double, Count>;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const IndexCovariance factor = factor_of(covariance);
  const Vector centre = vector_of(indices);
  std::array<std::vector<double>, static_cast<std::size_t>(Count)> columns;
  std::vector<Result> results;
  Sampled<Count> all{Result::Zero(), Eigen::Matrix<double, Count, Count>::Zero(), Result::Zero(), Result::Zero(), 0.0};
  for (std::size_t k = 0; k < samples; ++k) {
    const Vector z = Vector::NullaryExpr([&] { return normal(engine); });
    const auto i = indices_of(centre + factor * z);
    all.crossed += (i.T3b - i.T3w > 0.0) != (indices.T3b - indices.T3w > 0.0) ? 1.0 : 0.0;
    const Result x = result_of(i);
    results.push_back(x);
    all.mean += x;
    for (int j = 0; j < Count; ++j) columns[static_cast<std::size_t>(j)].push_back(x[j]);
  }
  const auto n = static_cast<double>(samples);
  all.mean /= n;
  for (const auto& x : results) all.covariance += (x - all.mean) * (x - all.mean).transpose() / n;
  all.crossed /= n;
  for (int j = 0; j < Count; ++j) {
    all.low[j] = quantile(columns[static_cast<std::size_t>(j)], 0.025);
    all.high[j] = quantile(columns[static_cast<std::size_t>(j)], 0.975);
  }
  return all;
}

}  // namespace

IndexCovariance independent(const SteeringIndices<double>& indices, const SteeringIndices<double>& relative_deviation) {
  const Vector deviation = vector_of(indices).cwiseProduct(vector_of(relative_deviation));
  return deviation.cwiseAbs2().asDiagonal();
}

IndexCovariance covariance_of(const SteeringIndices<double>& i, const Confidence& confidence) {
  const auto of = [&](std::string_view key) { return confidence.of(key); };
  auto covariance = independent(i, {of("T1T2"), of("T1_plus_T2"), of("T3b"), of("T3w"), of("Kb"), of("Kw")});
  const auto T = time_constants(transfer_functions(i));
  if (!T) return covariance;
  // product and sum of independent T1 and T2
  Eigen::Matrix2d J;
  J << T->T2, T->T1, 1.0, 1.0;
  const Eigen::Vector2d deviation(of("T1") * T->T1, of("T2") * T->T2);
  covariance.topLeftCorner<2, 2>() = J * deviation.cwiseAbs2().asDiagonal() * J.transpose();
  return covariance;
}

CoefficientCovariance coefficient_covariance(const SteeringIndices<double>& indices,
                                             const IndexCovariance& covariance) {
  const auto m = coefficients_from(varied(indices));
  const auto J = jacobian_of<6>({m.a1, m.b1, m.c1, m.a2, m.b2, m.c2});
  return J * covariance * J.transpose();
}

PartCovariance part_covariance(const SteeringIndices<double>& indices, const IndexCovariance& covariance,
                               const LinearParts<double>& formal, KnownPart known) {
  const auto [hull, rudder] = parts_from(coefficients_from(varied(indices)), lifted<D>(formal), known);
  const auto J = jacobian_of<7>({rudder.a_H, rudder.c_Ry, rudder.x_Reff, hull.Y_b, hull.Y_w, hull.N_b, hull.N_w});
  return J * covariance * J.transpose();
}

SampledCoefficients sample_coefficients(const SteeringIndices<double>& indices, const IndexCovariance& covariance,
                                        std::size_t samples, std::uint64_t seed) {
  return sample<6>(indices, covariance, samples, seed, [](const auto& i) { return vector_of(coefficients_from(i)); });
}

SampledParts sample_parts(const SteeringIndices<double>& indices, const IndexCovariance& covariance,
                          const LinearParts<double>& formal, KnownPart known, std::size_t samples, std::uint64_t seed) {
  return sample<7>(indices, covariance, samples, seed,
                   [&](const auto& i) { return vector_of(parts_from(coefficients_from(i), formal, known)); });
}

double separation(const SteeringIndices<double>& indices, const IndexCovariance& covariance) {
  const double variance = covariance(2, 2) + covariance(3, 3) - 2.0 * covariance(2, 3);  // of T3b − T3w
  return std::abs(indices.T3b - indices.T3w) / std::sqrt(variance);
}

std::optional<std::string> separation_warning(const SteeringIndices<double>& indices,
                                              const IndexCovariance& covariance) {
  const double distance = separation(indices, covariance);
  if (!(distance < 3.0)) return std::nullopt;
  if (distance < 1.0)
    return fmt::format(
        "T3b and T3w cannot be told apart ({:.1f} standard errors): these indices determine no coefficients", distance);
  return fmt::format(
      "T3b and T3w are only {:.1f} standard errors apart: the coefficients are far less certain than their standard "
      "errors say",
      distance);
}

}  // namespace swayaw::linear
