#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "swayaw/core/confidence.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/ship_parts.hpp"

/// How errors of the steering indices travel through the inverse formulas.
namespace swayaw::inline linear {

/// Order of the indices in a covariance: T1T2, T1_plus_T2, T3b, T3w, Kb, Kw.
using IndexCovariance = Eigen::Matrix<double, 6, 6>;

/// Order of the coefficients: a1, b1, c1, a2, b2, c2.
using CoefficientCovariance = Eigen::Matrix<double, 6, 6>;

/// Order of the seven empirical numbers: a_H, c_Ry, x_Reff, Y_b, Y_w, N_b, N_w.
using PartCovariance = Eigen::Matrix<double, 7, 7>;

/// Covariance of independent indices with relative standard deviations.
IndexCovariance independent(const SteeringIndices<double>& indices, const SteeringIndices<double>& relative_deviation);

/// Covariance of independent T1, T2, T3b, T3w, Kb and Kw, or for complex poles T1T2 and T1_plus_T2 in place of T1 and
/// T2, with the relative standard deviations of a ship file.
IndexCovariance covariance_of(const SteeringIndices<double>& indices, const Confidence& confidence);

/// Covariance of the coefficients to first order, J C Jᵀ with the exact Jacobian J = d(a1 … c2)/d(indices).
CoefficientCovariance coefficient_covariance(const SteeringIndices<double>& indices, const IndexCovariance& covariance);

/// Covariance of the seven empirical numbers to first order; the known one is taken as exact.
/// @throws std::domain_error  as parts_from does
PartCovariance part_covariance(const SteeringIndices<double>& indices, const IndexCovariance& covariance,
                               const LinearParts<double>& formal, KnownPart known);

/// Results of normally distributed indices, by sampling.
template <int Count>
struct Sampled {
  Eigen::Vector<double, Count> mean;
  Eigen::Matrix<double, Count, Count> covariance;
  Eigen::Vector<double, Count> low, high;  ///< 2.5 and 97.5 % quantiles
  double crossed;  ///< share of the samples in which T3b − T3w has the other sign: no inverse lies between
};

using SampledCoefficients = Sampled<6>;
using SampledParts = Sampled<7>;

/// @param seed     same seed, same samples
SampledCoefficients sample_coefficients(const SteeringIndices<double>& indices, const IndexCovariance& covariance,
                                        std::size_t samples = 20'000, std::uint64_t seed = 1);

/// The seven empirical numbers alike; the known one is taken as exact.
SampledParts sample_parts(const SteeringIndices<double>& indices, const IndexCovariance& covariance,
                          const LinearParts<double>& formal, KnownPart known, std::size_t samples = 20'000,
                          std::uint64_t seed = 1);

/// T3b − T3w in units of its own standard error. The inverse formulas divide by it: below 1 they say nothing, and below
/// about 3 the first-order covariance is too small.
double separation(const SteeringIndices<double>& indices, const IndexCovariance& covariance);

/// A sentence when the separation is below 3, nothing otherwise.
std::optional<std::string> separation_warning(const SteeringIndices<double>& indices,
                                              const IndexCovariance& covariance);

}  // namespace swayaw::linear
